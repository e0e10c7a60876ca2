// SPDX-License-Identifier: Apache-2.0
#include "topology/read_spacing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexweave {

namespace {

/// Positions may miss their ends 0 and 1 by rounding.
constexpr double end_tolerance = 1e-12;

/// `start`, `end` and `ratio` of a law, as far as they are there; not sound after an error.
struct Sizes {
    std::optional<double> start;
    std::optional<double> end;
    std::optional<double> ratio;
    std::optional<double> natural;
    std::optional<double> within;
    bool sound = true;
};

Sizes read_sizes(Reading& reading, const YamlNode& node) {
    Sizes sizes;
    const auto read = [&](std::string_view key, std::optional<double>& value) {
        const YamlNode* given = find(reading, node, key);
        if (given == nullptr) return;
        value = read_positive(reading, *given, fmt::format("'{}'", key));
        sizes.sound = sizes.sound && value;
    };
    read("start", sizes.start);
    read("end", sizes.end);
    read("ratio", sizes.ratio);
    read("natural", sizes.natural);
    read("within", sizes.within);
    return sizes;
}

/// Tells that two keys contradict each other; always nothing.
std::optional<SpacingEntry> contradiction(Reading& reading, const YamlNode& second,
                                          std::string_view first, std::string_view hint) {
    reading.diagnostics.error(
        second.key_place, fmt::format("'{}' contradicts {}", second.key, first), std::string(hint));
    return std::nullopt;
}

std::optional<SpacingEntry> needs_size(Reading& reading, const YamlNode& node,
                                       std::string_view message, std::string_view hint) {
    reading.diagnostics.error(node.key_place, std::string(message), std::string(hint));
    return std::nullopt;
}

/// Whether values ascend from 0 to 1.
bool check_values(Reading& reading, const YamlNode& node, const std::vector<double>& values,
                  const std::string& what) {
    std::string fault;
    if (values.size() < 2) {
        fault = "at least two values, 0 and 1, are needed";
    } else if (std::abs(values.front()) > end_tolerance) {
        fault = fmt::format("the first value must be 0, not {}", values.front());
    } else if (std::abs(values.back() - 1) > end_tolerance) {
        fault = fmt::format("the last value must be 1, not {}", values.back());
    }
    for (std::size_t i = 1; i < values.size() && fault.empty(); ++i) {
        if (values[i] > values[i - 1]) continue;
        fault = fmt::format("the values must ascend, but {} follows {}", values[i], values[i - 1]);
    }
    if (!fault.empty())
        reading.diagnostics.error(node.place, fmt::format("in {}: {}", what, fault),
                                  "fractions of the edge ascend from 0 to 1: [0, 0.2, 0.5, 1]");
    return fault.empty();
}

std::optional<SpacingEntry> read_value_list(Reading& reading, const YamlNode& node,
                                            bool of_parameter, const std::string& what) {
    ExplicitLaw law;
    law.of_parameter = of_parameter;
    for (const YamlNode& item : node.children) {
        if (const auto value = read_number(reading, item, fmt::format("a value of {}", what))) {
            law.values.push_back(*value);
        }
    }
    if (law.values.size() != node.children.size()) return std::nullopt;
    if (!check_values(reading, node, law.values, what)) return std::nullopt;
    law.values.front() = 0;
    law.values.back() = 1;
    return law;
}

/// A formula is checked on a net; between its points it is trusted.
bool check_formula(Reading& reading, const YamlNode& node, const std::function<double(double)>& f) {
    constexpr int samples = 64;
    const auto fault = [&](const std::string& text) {
        reading.diagnostics.error(node.place, fmt::format("'{}' {}", shown(node.text), text),
                                  "positions ascend from 0 at t = 0 to 1 at t = 1");
        return false;
    };
    for (int i = 0; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        if (!std::isfinite(f(t))) return fault(fmt::format("is not finite at t = {}", t));
    }
    if (std::abs(f(0)) > end_tolerance) return fault(fmt::format("is {} at t = 0, not 0", f(0)));
    if (std::abs(f(1) - 1) > end_tolerance)
        return fault(fmt::format("is {} at t = 1, not 1", f(1)));
    for (int i = 1; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        if (!(f(t) > f(t - 1.0 / samples)))
            return fault(fmt::format("does not ascend at t = {}", t));
    }
    return true;
}

std::optional<SpacingEntry> read_explicit(Reading& reading, const YamlNode& node,
                                          std::string_view key) {
    const bool of_parameter = key == "parameters";
    const std::string what = fmt::format("'{}'", key);
    if (node.is_sequence()) return read_value_list(reading, node, of_parameter, what);
    if (!node.is_scalar()) {
        reading.diagnostics.error(
            node.place,
            fmt::format("{} must be a list or a formula of t, not {}", what, describe(node)),
            usage_of(reading, node));
        return std::nullopt;
    }
    auto formula = read_formula(reading, node, what);
    if (!formula || !check_formula(reading, node, *formula)) return std::nullopt;
    return ExplicitLaw{{}, std::move(*formula), of_parameter};
}

/// `like`, `positions` and `parameters`: each stands alone.
std::optional<SpacingEntry> read_alone(Reading& reading, const YamlNode& node,
                                       const YamlNode& alone, std::string_view key) {
    for (const YamlNode& child : node.children) {
        if (&child == &alone) continue;
        return contradiction(reading, child, fmt::format("'{}'", key),
                             fmt::format("'{}' stands alone", key));
    }
    if (key != "like") return read_explicit(reading, alone, key);
    SignedName edge = read_signed_name(reading, alone, "'like'");
    if (edge.value.empty()) return std::nullopt;
    return LikeLaw{std::move(edge)};
}

std::optional<SpacingEntry> read_tanh(Reading& reading, const YamlNode& node, const Sizes& sizes) {
    if (sizes.ratio) {
        return contradiction(reading, *find(reading, node, "ratio"), "the law tanh",
                             "a ratio belongs to the law geometric");
    }
    if (!sizes.start && !sizes.end) {
        return needs_size(reading, node, "the law tanh needs a size: 'start', 'end' or both",
                          "write {start: SIZE}, the length of the first cell, or uniform");
    }
    TanhLaw law{sizes.start, sizes.end};
    if (sizes.natural || sizes.within) {
        if (!sizes.natural || !sizes.within || (sizes.start && sizes.end)) {
            return needs_size(
                reading, node,
                "'natural' and 'within' stand together, beside 'start' or 'end' alone",
                "as in {start: 1e-5, natural: 1.2e-6, within: 0.03}");
        }
        law.natural = {*sizes.natural, *sizes.within};
    }
    return law;
}

std::optional<SpacingEntry> read_geometric(Reading& reading, const YamlNode& node,
                                           const Sizes& sizes) {
    const char* const one_of_three =
        "a geometric spacing follows from one of 'ratio', 'start' and 'end'";
    if (sizes.ratio && sizes.start)
        return contradiction(reading, *find(reading, node, "start"), "'ratio'", one_of_three);
    if (sizes.ratio && sizes.end)
        return contradiction(reading, *find(reading, node, "end"), "'ratio'", one_of_three);
    if (sizes.start && sizes.end)
        return contradiction(reading, *find(reading, node, "end"), "'start'", one_of_three);
    if (!sizes.ratio && !sizes.start && !sizes.end) {
        return needs_size(reading, node,
                          "the law geometric needs one of 'ratio', 'start' and 'end'",
                          "as in {law: geometric, ratio: 1.2}");
    }
    return GeometricLaw{sizes.ratio, sizes.start, sizes.end};
}

std::optional<SpacingEntry> read_law(Reading& reading, const YamlNode& node) {
    const Keys& laws = words_of("spacing", "law");
    const YamlNode* named = find(reading, node, "law");
    const auto law = named == nullptr ? std::optional<std::size_t>(0)
                                      : read_choice(reading, *named, "'law'", laws);
    const Sizes sizes = read_sizes(reading, node);
    if (!law || !sizes.sound) return std::nullopt;
    if (*law == 0) return read_tanh(reading, node, sizes);
    for (const std::string_view key : {"natural", "within"}) {
        if (const YamlNode* size = find(reading, node, key)) {
            return contradiction(reading, *size, fmt::format("the law {}", laws[*law]),
                                 "a natural cell belongs to the law tanh");
        }
    }
    if (*law == 1) return read_geometric(reading, node, sizes);
    for (const std::string_view key : {"start", "end", "ratio"}) {
        if (const YamlNode* size = find(reading, node, key)) {
            return contradiction(reading, *size, "the law uniform", "its cells are all equal");
        }
    }
    return UniformLaw{};
}

}  // namespace

std::optional<SpacingEntry> read_spacing(Reading& reading, const YamlNode& node) {
    if (node.is_scalar() && node.text == "uniform") return UniformLaw{};
    if (!node.is_mapping()) {
        reading.diagnostics.error(
            node.place,
            fmt::format("'spacing' must be 'uniform' or a mapping, not {}", describe(node)),
            "write {start: SIZE, end: SIZE} or {like: EDGE}");
        return std::nullopt;
    }
    expect_mapping(reading, node, "'spacing'",
                   {"spacing", "spacing_like", "spacing_positions", "spacing_parameters"},
                   {{"heights", "'heights' are held by faces and blocks, not by edges",
                     "give 'start', 'end', or 'positions' as fractions"}});
    for (const std::string_view key : {"like", "positions", "parameters"}) {
        if (const YamlNode* alone = find(reading, node, key))
            return read_alone(reading, node, *alone, key);
    }
    if (find(reading, node, "heights") != nullptr) return std::nullopt;
    return read_law(reading, node);
}

}  // namespace hexweave
