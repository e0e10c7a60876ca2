// SPDX-License-Identifier: Apache-2.0
// What the parts of a comparison of outlines share.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "quality/outline_comparison.h"

namespace hexweave {

/// What both sides of a comparison share, and what has been found.
struct OutlineComparison {
    const GridOutline& candidate;
    const GridOutline& golden;
    const PointBox& golden_box;
    std::vector<std::optional<ZoneMatch>> of_candidate;  ///< by zone of the candidate
    std::vector<std::optional<ZoneMatch>> of_golden;     ///< by zone of the golden grid
    std::vector<Difference> found;

    void tell(const char* kind, std::string text) { found.push_back({kind, std::move(text)}); }
    /// Of the candidate.
    const ZoneOutline& zone(int index) const {
        return candidate.zones[static_cast<std::size_t>(index)];
    }
};

/// "3 x 4 x 5", of as many axes as cells have.
std::string to_text(const Extent& extent, int axes);

/// "[1, 1, 1]", "[1, 1, 1] to [3, 4, 1]": nodes counted from 1.
std::string to_text(const Node& node, int axes);
std::string to_text(const IndexBox& box, int axes);

/// What only the first and what only the second of two lists holds; equal ones cancel one by one.
template <class T>
void keep_unlike(std::vector<T>& first, std::vector<T>& second) {
    const auto before = [](const T& a, const T& b) { return a.key() < b.key(); };
    std::sort(first.begin(), first.end(), before);
    std::sort(second.begin(), second.end(), before);
    std::vector<T> only_first;
    std::vector<T> only_second;
    std::set_difference(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(only_first), before);
    std::set_difference(second.begin(), second.end(), first.begin(), first.end(),
                        std::back_inserter(only_second), before);
    first = std::move(only_first);
    second = std::move(only_second);
}

/// The first of `others` that `alike` accepts, taken out.
template <class T, class Alike>
std::optional<T> take(std::vector<T>& others, Alike&& alike) {
    const auto place = std::find_if(others.begin(), others.end(), alike);
    if (place == others.end()) return std::nullopt;
    T found = *place;
    others.erase(place);
    return found;
}

/// Tell what differs of boundaries; of interfaces.
void compare_boundaries(OutlineComparison& c);
void compare_interfaces(OutlineComparison& c);

}  // namespace hexweave
