// SPDX-License-Identifier: Apache-2.0
// Files are damaged in ways that the libraries do not survive: a child process reads them first.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string>

#include "core/errors.h"
#include "io/cgns_source.h"
#include "io/output_place.h"

namespace hexweave {
namespace {

/// The child's part of `rehearse`: reads, writes the error there is to `answer`.
[[noreturn]] void read_and_answer(const std::function<void()>& reader, int answer) {
    become_expendable();
    try {
        reader();
    } catch (const UsageError& error) {
        const std::string text = error.what();
        if (write(answer, text.data(), text.size()) < 0) _exit(1);
    } catch (const std::exception&) {
        // The machine's failure (out of memory), not the file's: the parent will meet it as well.
    }
    _exit(0);
}

}  // namespace

void become_expendable() {
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGBUS, SIGABRT, SIGFPE}) {
        std::signal(signal_number, SIG_DFL);
    }
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
}

void require_readable(const std::filesystem::path& path) {
    const auto cannot_read = [&](const std::string& reason) {
        throw UsageError(fmt::format("cannot read '{}': {}", path.string(), reason));
    };
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0) {
        cannot_read(errno == ENOENT ? "no such file" : error_reason(errno));
    }
    if (S_ISDIR(status.st_mode)) cannot_read("it is a folder");
    if (!S_ISREG(status.st_mode)) cannot_read("it is not a regular file");
    if (access(path.c_str(), R_OK) != 0) cannot_read(error_reason(errno));
}

void rehearse(const std::filesystem::path& path, const std::function<void()>& reader) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw MachineError("cannot make a pipe");
    const pid_t child = fork();
    if (child == 0) read_and_answer(reader, ends[1]);
    close(ends[1]);
    std::string text;
    std::array<char, 4096> part{};
    ssize_t size = 0;
    do {
        size = read(ends[0], part.data(), part.size());
        if (size > 0) text.append(part.data(), static_cast<std::size_t>(size));
    } while (size > 0 || (size < 0 && errno == EINTR));
    close(ends[0]);
    if (child < 0) throw MachineError("cannot start another process");
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (!text.empty()) throw UsageError(text);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        throw UsageError(fmt::format("cannot read '{}': it is damaged", path.string()));
    }
}

}  // namespace hexweave
