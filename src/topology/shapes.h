// SPDX-License-Identifier: Apache-2.0
// The curves and surfaces of a file. Each may be made of others, whatever the order in which they
// stand: a shape is read when it is first asked for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// A curve or surface of the file, read or not yet.
template <class Shape>
struct ShapeOfFile {
    enum class State { unread, being_read, read };

    const YamlNode* node = nullptr;
    State state = State::unread;
    std::shared_ptr<const Shape> shape{};  ///< null where it is faulty
    int descent = 0;                       ///< how many shapes it is made of, in a row
    bool used = false;                     ///< another shape is made of it
};

struct Shapes {
    /// A shape that is being read.
    struct Open {
        std::string what;  ///< "curve 'rim'"
        int descent = 0;
    };

    Reading& reading;
    std::vector<ShapeOfFile<Curve>> curves{};
    std::vector<ShapeOfFile<Surface>> surfaces{};
    std::vector<Open> open{};  ///< each is asked for by the one before
};

/// The shape whose name stands at a node of another shape. Null where there is none, it is faulty,
/// or it is made of the shape that asks for it: that is told, unless it was told before. `what`:
/// the words for the node.
std::shared_ptr<const Curve> use_curve(Shapes& shapes, const YamlNode& node,
                                       const std::string& what);
std::shared_ptr<const Surface> use_surface(Shapes& shapes, const YamlNode& node,
                                           const std::string& what);

/// Reads the sections `curves:` and `surfaces:`, either of which may be null. One entry for every
/// key, in order; without a shape where it is faulty.
void read_shapes(Reading& reading, const YamlNode* curves, const YamlNode* surfaces, Case& c);

}  // namespace hexweave
