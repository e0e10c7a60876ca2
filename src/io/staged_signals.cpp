// SPDX-License-Identifier: Apache-2.0
#include "io/staged_signals.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <string>
#include <thread>

#include "io/output_files.h"

namespace hexweave {
namespace {

constexpr int table_size = 64;
constexpr std::size_t longest_path = 4096;

struct Slot {
    std::atomic<bool> used{false};
    std::array<char, longest_path> path{};
};

// Static and fixed in size: the handler must neither allocate nor lock.
std::array<Slot, table_size> table;

// Who may touch the files: nobody is, a part of the program that must not be cut in two does, or
// the signal handler has begun to remove them and the process is about to end.
enum Phase : int { idle, held, removing };
std::atomic<int> phase{idle};
std::atomic<int> waiting_signal{0};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

/// Ends the process by `signal_number`, as if it had never been handled.
void end_by_signal(int signal_number) {
    std::signal(signal_number, SIG_DFL);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, signal_number);
    pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
    std::raise(signal_number);
}

// Any thread may run this, also while another one is inside SignalsHeld: the order "announce, then
// look at the phase" here and "release, then look for an announcement" there loses no signal.
extern "C" void remove_and_end(int signal_number) {
    waiting_signal.store(signal_number);
    int expected = idle;
    if (!phase.compare_exchange_strong(expected, removing)) return;
    for (Slot& slot : table) {
        if (slot.used.load()) unlink(slot.path.data());
    }
    end_by_signal(signal_number);
}

}  // namespace

SignalsHeld::SignalsHeld() {
    int expected = idle;
    while (!phase.compare_exchange_strong(expected, held)) {
        std::this_thread::yield();  // to the handler on another thread, which ends the process
        expected = idle;
    }
}

SignalsHeld::~SignalsHeld() {
    phase.store(idle);
    if (const int waiting = waiting_signal.exchange(0); waiting != 0) std::raise(waiting);
}

int register_temporary(const std::filesystem::path& absolute_path) {
    const std::string& text = absolute_path.native();
    if (text.size() >= longest_path) return -1;
    for (int index = 0; index < table_size; ++index) {
        Slot& slot = table[static_cast<std::size_t>(index)];
        if (slot.used.load()) continue;
        std::memcpy(slot.path.data(), text.c_str(), text.size() + 1);
        slot.used.store(true);
        return index;
    }
    return -1;
}

void forget_temporary(int slot) {
    if (slot >= 0) table[static_cast<std::size_t>(slot)].used.store(false);
}

void remove_staged_files_on_signals() {
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action = {};
        sigaction(signal_number, nullptr, &action);
        if (action.sa_handler == SIG_IGN) continue;
        action = {};
        action.sa_handler = remove_and_end;
        action.sa_flags = SA_RESTART;
        sigemptyset(&action.sa_mask);
        sigaction(signal_number, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace hexweave
