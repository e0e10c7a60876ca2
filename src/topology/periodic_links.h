// SPDX-License-Identifier: Apache-2.0
// Which vertex or edge is to be made of which, where periodic interfaces link them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace hexweave {

/// `to` is the image of `from`.
struct PeriodicLink {
    int from = 0;
    int to = 0;
    bool reversed = false;
    int interface = 0;
};

/// Made of `of`, by the map of an interface, or by its inverse.
struct PeriodicStep {
    int of = 0;
    bool reversed = false;
    int interface = 0;
    bool back = false;
};

/// For every one of `count` entities the step that leads to it, or none where it stands on its own.
/// Of entities that links hold together, one stands on its own: one that is no image, where there
/// is one. Inverse maps are used only for what images do not lead to.
std::vector<std::optional<PeriodicStep>> periodic_steps(const std::vector<PeriodicLink>& links,
                                                        std::size_t count);

}  // namespace hexweave
