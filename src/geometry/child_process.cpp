// SPDX-License-Identifier: Apache-2.0
#include "geometry/child_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>

#include "core/errors.h"

namespace hexweave {

namespace {

constexpr int no_result = 2;

bool write_all(int descriptor, const std::string& bytes) {
    for (std::size_t written = 0; written < bytes.size();) {
        const ssize_t count = write(descriptor, bytes.data() + written, bytes.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        written += static_cast<std::size_t>(count);
    }
    return true;
}

std::string read_all(int descriptor) {
    std::string bytes;
    std::array<char, 65536> buffer{};
    while (true) {
        const ssize_t count = read(descriptor, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return bytes;
        bytes.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

void limit(__rlimit_resource resource, rlim_t most) {
    rlimit now{};
    if (getrlimit(resource, &now) != 0) return;
    now.rlim_cur = std::min(now.rlim_max, most);
    setrlimit(resource, &now);
}

/// What happens in the child; never returns.
[[noreturn]] void work_and_leave(const std::function<std::string()>& work, int most_seconds,
                                 int out) {
    limit(RLIMIT_CPU, static_cast<rlim_t>(most_seconds));
    limit(RLIMIT_CORE, 0);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }
    bool done = false;
    try {
        done = write_all(out, work());
    } catch (...) {
        done = false;
    }
    _exit(done ? 0 : no_result);
}

std::string fault_of(int status) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
    if (!WIFSIGNALED(status)) return "it failed";
    if (WTERMSIG(status) == SIGXCPU) return "it took too long";
    return strsignal(WTERMSIG(status));
}

}  // namespace

ChildResult run_in_child(const std::function<std::string()>& work, int most_seconds) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw MachineError(std::string("no pipe: ") + std::strerror(errno));
    }
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        work_and_leave(work, most_seconds, ends[1]);
    }
    const int error = errno;
    close(ends[1]);
    ChildResult result;
    if (child > 0) result.bytes = read_all(ends[0]);
    close(ends[0]);
    if (child < 0) throw MachineError(std::string("no process: ") + std::strerror(error));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    result.fault = fault_of(status);
    return result;
}

}  // namespace hexweave
