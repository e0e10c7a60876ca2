// SPDX-License-Identifier: Apache-2.0
#include "topology/periodic_links.h"

#include <algorithm>

namespace hexweave {

namespace {

class Spreading {
public:
    Spreading(const std::vector<PeriodicLink>& links, std::size_t count)
        : links_(links), reached_(count), steps_(count) {}

    /// Reaches all that is linked with an entity that stands on its own.
    void spread_from(int root) {
        if (reached_[index(root)]) return;
        reached_[index(root)] = true;
        while (take_images() || take_one_origin()) {
        }
    }

    std::vector<std::optional<PeriodicStep>> steps() const { return steps_; }

private:
    static std::size_t index(int entity) { return static_cast<std::size_t>(entity); }

    bool take_images() {
        bool found = false;
        for (const PeriodicLink& link : links_) {
            if (!reached_[index(link.from)] || reached_[index(link.to)]) continue;
            reached_[index(link.to)] = true;
            steps_[index(link.to)] = {link.from, link.reversed, link.interface, false};
            found = true;
        }
        return found;
    }

    bool take_one_origin() {
        for (const PeriodicLink& link : links_) {
            if (!reached_[index(link.to)] || reached_[index(link.from)]) continue;
            reached_[index(link.from)] = true;
            steps_[index(link.from)] = {link.to, link.reversed, link.interface, true};
            return true;
        }
        return false;
    }

    const std::vector<PeriodicLink>& links_;
    std::vector<bool> reached_;
    std::vector<std::optional<PeriodicStep>> steps_;
};

}  // namespace

std::vector<std::optional<PeriodicStep>> periodic_steps(const std::vector<PeriodicLink>& links,
                                                        std::size_t count) {
    std::vector<bool> is_image(count);
    for (const PeriodicLink& link : links) {
        if (link.from != link.to) is_image[static_cast<std::size_t>(link.to)] = true;
    }
    Spreading spreading(links, count);
    for (const bool images : {false, true}) {
        for (std::size_t n = 0; n < count; ++n) {
            if (is_image[n] == images) spreading.spread_from(static_cast<int>(n));
        }
    }
    return spreading.steps();
}

}  // namespace hexweave
