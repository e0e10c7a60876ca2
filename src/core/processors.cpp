// SPDX-License-Identifier: Apache-2.0
#include "core/processors.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace hexweave {
namespace {

int scheduled_processors() {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof(set), &set) == 0) return CPU_COUNT(&set);
    return static_cast<int>(std::thread::hardware_concurrency());
}

int rounded_up(double quota, double period) {
    return static_cast<int>(std::ceil(quota / period));
}

/// The processors that the control group grants, or 0 when it sets no limit.
int control_group_processors() {
    std::ifstream v2("/sys/fs/cgroup/cpu.max");
    std::string quota;
    double period = 0;
    if (v2 >> quota >> period && quota != "max" && period > 0) {
        return rounded_up(std::strtod(quota.c_str(), nullptr), period);
    }
    std::ifstream quota_v1("/sys/fs/cgroup/cpu/cpu.cfs_quota_us");
    std::ifstream period_v1("/sys/fs/cgroup/cpu/cpu.cfs_period_us");
    double value = 0;
    if (quota_v1 >> value && period_v1 >> period && value > 0 && period > 0) {
        return rounded_up(value, period);
    }
    return 0;
}

int threads_from_environment() {
    const char* text = std::getenv("OMP_NUM_THREADS");
    return text == nullptr ? 0 : static_cast<int>(std::strtol(text, nullptr, 10));
}

}  // namespace

int available_processors() {
    const int scheduled = std::max(1, scheduled_processors());
    const int granted = control_group_processors();
    return granted > 0 ? std::min(scheduled, granted) : scheduled;
}

int choose_threads(int asked) {
    const int available = available_processors();
    const int wanted = asked > 0 ? asked : threads_from_environment();
    return wanted > 0 ? std::min(wanted, available) : available;
}

}  // namespace hexweave
