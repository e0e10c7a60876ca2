// SPDX-License-Identifier: Apache-2.0
#include "bench/machine.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>

namespace hexweave::bench {

namespace {

/// A line "VmHWM:  1234 kB" of a process's status, in bytes; 0 where there is none.
double status_bytes(const std::string& process, const std::string& key) {
    std::ifstream status("/proc/" + process + "/status");
    for (std::string word; status >> word;) {
        if (word != key + ":") continue;
        double kilobytes = 0;
        status >> kilobytes;
        return 1024 * kilobytes;
    }
    return 0;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void become(const std::vector<std::string>& arguments) {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
}

}  // namespace

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    }
    return "unknown processor";
}

std::string build_description() {
    return fmt::format("{}, {}", HEXWEAVE_BENCH_COMPILER, HEXWEAVE_BENCH_FLAGS);
}

double triad_bandwidth(std::size_t working_set) {
    const std::size_t count = std::max<std::size_t>(working_set / 24, 1000);
    std::vector<double> a(count);
    std::vector<double> b(count, 1);
    std::vector<double> c(count, 2);
    double best = 0;
    for (int pass = 0; pass < 7; ++pass) {
        const auto begin = std::chrono::steady_clock::now();
        const double factor = 0.5 + pass;
        for (std::size_t n = 0; n < count; ++n) a[n] = b[n] + factor * c[n];
        b[count / 2] = a[count / 3];
        best = std::max(best, 24 * static_cast<double>(count) / seconds_since(begin));
    }
    return best;
}

PeakMemory::PeakMemory() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;
    before_ = status_bytes("self", "VmRSS");
}

double PeakMemory::bytes() const {
    return std::max(0.0, status_bytes("self", "VmHWM") - before_);
}

void return_freed_memory() {
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
}

ProgramRun run_program(const std::vector<std::string>& arguments) {
    ProgramRun run;
    const auto begin = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child == 0) become(arguments);
    int status = 0;
    // Looked at while it runs: the peak that wait4 reports counts the image before exec, which is
    // this very program.
    while (child > 0 && waitpid(child, &status, WNOHANG) == 0) {
        run.peak_bytes = std::max(run.peak_bytes, status_bytes(std::to_string(child), "VmHWM"));
        usleep(500);
    }
    if (child > 0 && WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
    run.seconds = seconds_since(begin);
    return run;
}

}  // namespace hexweave::bench
