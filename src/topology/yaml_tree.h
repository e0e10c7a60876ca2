// SPDX-License-Identifier: Apache-2.0
// A YAML file as a small tree in which every node knows its place. Stricter than YAML: what a
// parser would silently accept (duplicate keys, an open quote at the end of the file, a second
// document, tags) is an error here.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostics.h"

namespace hexweave {

struct InstanceScope;

struct YamlNode {
    enum class Kind { null, scalar, sequence, mapping };

    Kind kind = Kind::null;
    Place place;
    /// Scalars: the text; `text_column` is the column of its first character where the file holds
    /// it as it is (so that a caret can point into it), else 0.
    std::string text;
    int text_column = 0;
    bool quoted = false;
    /// Items of a sequence, values of a mapping.
    std::vector<YamlNode> children;
    /// Values of a mapping: the key.
    std::string key;
    Place key_place;
    /// That its names and expressions belong to; null: the case's own.
    std::shared_ptr<InstanceScope> scope;

    bool is_null() const { return kind == Kind::null; }
    bool is_scalar() const { return kind == Kind::scalar; }
    bool is_sequence() const { return kind == Kind::sequence; }
    bool is_mapping() const { return kind == Kind::mapping; }
    /// The value of a key, or null.
    const YamlNode* find(std::string_view wanted) const;
};

/// The one document of a file. Nothing where it is not YAML; the tree, and errors in `diagnostics`,
/// where only keys are repeated (the first of each is kept). An alias stands at its use, what is
/// inside of it at the anchor.
std::optional<YamlNode> read_yaml(const std::shared_ptr<const SourceFile>& source,
                                  Diagnostics& diagnostics);

}  // namespace hexweave
