// SPDX-License-Identifier: Apache-2.0
#include "core/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

namespace hexweave {

namespace {

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

/// MemTotal of /proc/meminfo, there in kB.
std::size_t machine_memory(const std::string& root) {
    std::ifstream file(root + "/proc/meminfo");
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string key;
        std::size_t kilobytes = 0;
        if (words >> key >> kilobytes && key == "MemTotal:") return kilobytes * 1024;
    }
    return unlimited;
}

/// A number of bytes; "max" or no file at all is no limit.
std::size_t limit_in(const std::string& path) {
    std::ifstream file(path);
    std::size_t bytes = 0;
    return file >> bytes ? bytes : unlimited;
}

/// The least limit of a control group and the groups above it, whose files are in the folders of
/// `path` under `mount`.
std::size_t least_limit(const std::string& mount, std::string path, const std::string& name) {
    std::size_t least = limit_in(mount + "/" + name);
    while (!path.empty()) {
        std::string file = mount;
        file.append(path).append("/").append(name);
        least = std::min(least, limit_in(file));
        path.erase(path.rfind('/') == std::string::npos ? 0 : path.rfind('/'));
    }
    return least;
}

/// Lines of /proc/self/cgroup: "0::/path" (version 2), "5:memory:/path" (version 1).
std::size_t control_group_limit(const std::string& root) {
    const std::string mount = root + "/sys/fs/cgroup";
    std::size_t least = unlimited;
    std::ifstream file(root + "/proc/self/cgroup");
    std::string line;
    while (std::getline(file, line)) {
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const std::string path = line.substr(second + 1);
        if (controllers.empty()) {
            least = std::min(least, least_limit(mount, path, "memory.max"));
        } else if (("," + controllers + ",").find(",memory,") != std::string::npos) {
            least = std::min(least, least_limit(mount + "/memory", path, "memory.limit_in_bytes"));
        }
    }
    return least;
}

}  // namespace

std::size_t available_memory(const std::string& root) {
    return std::min(machine_memory(root), control_group_limit(root));
}

std::size_t available_memory() {
    return available_memory("");
}

}  // namespace hexweave
