// SPDX-License-Identifier: Apache-2.0
// How work is spread over threads: all of it, once, and never on more threads than there are.
#include "core/parallel.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "core/largest_first.h"

using namespace hexweave;

namespace {

using Sizes = std::vector<std::size_t>;

/// Threads at work in one place at the same time: the most that were seen.
class Crowd {
public:
    void enter() {
        const int now = ++inside_;
        int seen = most_;
        while (now > seen && !most_.compare_exchange_weak(seen, now)) {
        }
    }
    void leave() { --inside_; }
    int most() const { return most_; }

private:
    std::atomic<int> inside_{0};
    std::atomic<int> most_{0};
};

class Threads {
public:
    explicit Threads(int count) : before_(threads()) { set_threads(count); }
    ~Threads() { set_threads(before_); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

private:
    int before_;
};

constexpr int dear = 1000000;

}  // namespace

TEST_CASE("ranges cover all indices once, whatever the count and the threads") {
    for (const int count_of_threads : {1, 2, 4, 7}) {
        const Threads set(count_of_threads);
        for (const int count : {0, 1, 2, 3, 6, 7, 8, 1000}) {
            std::vector<int> visits(static_cast<std::size_t>(count), 0);
            parallel_blocks(count, dear, [&](int begin, int end) {
                for (int n = begin; n < end; ++n) ++visits[static_cast<std::size_t>(n)];
            });
            CHECK(visits == std::vector<int>(static_cast<std::size_t>(count), 1));
        }
    }
}

TEST_CASE("small loops stay on one thread, and so do loops within parallel tasks") {
    const Threads set(4);
    const auto ranges = [](int count, int cost) {
        std::atomic<int> calls{0};
        parallel_blocks(count, cost, [&](int, int) { ++calls; });
        return calls.load();
    };
    CHECK(ranges(1000, 1) == 1);
    CHECK(ranges(1000, dear) == 4);
    CHECK(ranges(3, dear) == 3);
    std::vector<int> inside(4, 0);
    parallel_for(4, [&](std::size_t n) { inside[n] = ranges(1000, dear); });
    CHECK(inside == std::vector<int>(4, 1));
    // A single task leaves all threads to what is inside.
    parallel_for(1, [&](std::size_t) { CHECK(ranges(1000, dear) == 4); });
}

TEST_CASE("the first failure of several tasks is thrown when all are done") {
    const Threads set(4);
    std::atomic<int> ended{0};
    const auto fail = [&](std::size_t n) {
        ++ended;
        if (n == 3 || n == 7) throw std::runtime_error(n == 3 ? "three" : "seven");
    };
    CHECK_THROWS_WITH(parallel_for(10, fail), "three");
    CHECK(ended == 10);
}

TEST_CASE("grids larger than a thread's share are made alone, the rest at once") {
    CHECK(count_made_alone({}, 4) == 0);
    CHECK(count_made_alone({1000000}, 4) == 1);
    CHECK(count_made_alone({1000000}, 1) == 0);
    CHECK(count_made_alone({1000000, 1000000}, 2) == 0);
    CHECK(count_made_alone({1000000, 1000000}, 4) == 2);  // fewer than threads
    CHECK(count_made_alone({1000000, 900000}, 2) == 2);
    CHECK(count_made_alone({1000000, 100000, 100000, 100000}, 2) == 1);
    // Of five on four threads none has more than the others can match.
    CHECK(count_made_alone({500000, 500000, 500000, 500000, 500000}, 4) == 0);
    CHECK(count_made_alone({4000000, 1000000, 300000, 300000, 300000, 300000}, 4) == 2);
    // Too small for several threads inside, however few they are.
    CHECK(count_made_alone({5000, 5000}, 4) == 0);
    CHECK(count_made_alone({1000000, 5000, 5000}, 4) == 1);
}

TEST_CASE("every grid is made once, the largest first, on no more threads than there are") {
    for (const int count : {1, 2, 4, 7}) {
        const Threads set(count);
        const Sizes sizes{30, 2000000, 10, 40000, 700000, 20, 50000, 40000};
        std::vector<int> made(sizes.size(), 0);
        std::vector<int> ranges(sizes.size(), 0);
        std::vector<std::size_t> order;
        Crowd crowd;
        Crowd telling;
        std::size_t told = 0;
        const auto done = [&] {
            telling.enter();
            ++told;
            telling.leave();
        };
        std::mutex noting;
        largest_first(sizes, done, [&](std::size_t index) {
            {
                const std::lock_guard lock(noting);
                order.push_back(index);
            }
            ++made[index];
            std::atomic<int> parts{0};
            parallel_blocks(1000, dear, [&](int begin, int end) {
                crowd.enter();
                ++parts;
                volatile double work = 0;
                for (int n = 1000 * begin; n < 1000 * end; ++n) work = work + 1;
                crowd.leave();
            });
            ranges[index] = parts;
        });
        CHECK(made == std::vector<int>(sizes.size(), 1));
        CHECK(told == sizes.size());
        CHECK(telling.most() == 1);
        CHECK(crowd.most() <= count);
        CHECK(order.front() == 1);
        CHECK(ranges[1] == count);  // 2000000 of 2830060
        CHECK(ranges[0] == 1);
        CHECK(ranges[2] == 1);
    }
}
