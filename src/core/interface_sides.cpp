// SPDX-License-Identifier: Apache-2.0
#include "core/interface_sides.h"

#include <cstdlib>
#include <utility>

namespace hexweave {

Interface forwards(Interface interface) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (interface.box.begin[axis] <= interface.box.end[axis]) continue;
        const auto across =
            static_cast<std::size_t>(std::abs(interface.orientation.axes[axis]) - 1);
        std::swap(interface.box.begin[axis], interface.box.end[axis]);
        std::swap(interface.donor_box.begin[across], interface.donor_box.end[across]);
    }
    return interface;
}

Interface other_side(const Interface& interface) {
    std::optional<Periodicity> back;
    if (interface.periodic) back = backwards(*interface.periodic);
    return forwards({interface.name, interface.donor, interface.donor_box, interface.zone,
                     interface.box, inverse(interface.orientation), back});
}

}  // namespace hexweave
