// SPDX-License-Identifier: Apache-2.0
#include "core/memory.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <limits>

using namespace hexweave;

namespace {

/// A folder with files as /proc and /sys have them, gone at the end of the test.
class FakeSystem {
public:
    FakeSystem() : root_(std::filesystem::temp_directory_path() / "hexweave_memory_test") {
        std::filesystem::remove_all(root_);
        std::filesystem::create_directories(root_);
    }
    FakeSystem(const FakeSystem&) = delete;
    FakeSystem& operator=(const FakeSystem&) = delete;
    ~FakeSystem() { std::filesystem::remove_all(root_); }

    void write(const std::string& path, const std::string& text) const {
        const std::filesystem::path file = root_.string() + path;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << text;
    }
    std::size_t memory() const { return available_memory(root_.string()); }

private:
    std::filesystem::path root_;
};

}  // namespace

TEST_CASE("Memory is the machine's, or the least limit of its control groups") {
    const FakeSystem system;
    CHECK(system.memory() == std::numeric_limits<std::size_t>::max());
    system.write("/proc/meminfo", "MemFree: 5 kB\nMemTotal:       2000000 kB\nMemFree: 7 kB\n");
    CHECK(system.memory() == 2000000ULL * 1024);

    SECTION("version 2: a limit may be set on a group above") {
        system.write("/proc/self/cgroup", "0::/batch/job\n");
        system.write("/sys/fs/cgroup/batch/job/memory.max", "max\n");
        CHECK(system.memory() == 2000000ULL * 1024);
        system.write("/sys/fs/cgroup/batch/memory.max", "1000000\n");
        CHECK(system.memory() == 1000000);
    }
    SECTION("version 2 in a container, whose group is the root") {
        system.write("/proc/self/cgroup", "0::/\n");
        system.write("/sys/fs/cgroup/memory.max", "3000000\n");
        CHECK(system.memory() == 3000000);
    }
    SECTION("version 1") {
        system.write("/proc/self/cgroup", "5:cpu,memory:/job\n4:pids:/other\n");
        system.write("/sys/fs/cgroup/memory/job/memory.limit_in_bytes", "500000\n");
        CHECK(system.memory() == 500000);
    }
}

TEST_CASE("This machine has memory") {
    CHECK(available_memory() > 1000000);
}
