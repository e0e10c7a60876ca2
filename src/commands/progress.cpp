// SPDX-License-Identifier: Apache-2.0
#include "commands/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace hexweave {
namespace {

constexpr std::size_t bar_width = 32;

void draw_bar(std::string_view stage, std::size_t done, std::size_t total) {
    const std::size_t filled = bar_width * done / total;
    const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
    fmt::print(stderr, "\r{:<7}[{}] {}/{}{}", stage, bar, done, total, done == total ? "\n" : "");
    std::fflush(stderr);
}

}  // namespace

Progress make_progress(bool quiet) {
    if (quiet) return [](std::string_view, std::size_t, std::size_t) {};
    if (isatty(STDERR_FILENO) != 0) {
        return [](std::string_view stage, std::size_t done, std::size_t total) {
            if (total > 0) draw_bar(stage, done, total);
        };
    }
    return [](std::string_view stage, std::size_t done, std::size_t total) {
        if (done == 0 && total > 0) fmt::print(stderr, "{}: {}\n", stage, total);
    };
}

}  // namespace hexweave
