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

constexpr int chunk_size = 64;
constexpr std::size_t longest_path = 4096;

struct Slot {
    std::atomic<bool> used{false};
    std::array<char, longest_path> path{};
};

/// A part of the table. The handler must neither allocate nor lock: chunks are added to the end and
/// stay there until the process ends.
struct Chunk {
    std::array<Slot, chunk_size> slots;
    std::atomic<Chunk*> next{nullptr};
};
Chunk first_chunk;

/// The chunk of that number; added to the table when it is the next one.
Chunk& chunk_at(int number) {
    Chunk* chunk = &first_chunk;
    for (; number > 0; --number) {
        Chunk* next = chunk->next.load();
        if (next == nullptr) {
            next = new Chunk;  // never freed: the handler may come at any time
            chunk->next.store(next);
        }
        chunk = next;
    }
    return *chunk;
}

// A folder may stand in another one: no more than three levels are made.
constexpr int folder_levels = 3;

void remove_all_temporaries() {
    for (int round = 0; round <= folder_levels; ++round) {
        for (Chunk* chunk = &first_chunk; chunk != nullptr; chunk = chunk->next.load()) {
            for (Slot& slot : chunk->slots) {
                if (!slot.used.load()) continue;
                if (round == 0) {
                    unlink(slot.path.data());  // does nothing to folders
                } else {
                    rmdir(slot.path.data());  // only where it is empty
                }
            }
        }
    }
}

// Who may touch the files: nobody is, a part of the program that must not be cut in two does, or
// the signal handler has begun to remove them and the process is about to end.
enum Phase : int { idle, held, removing };
std::atomic<int> phase{idle};
std::atomic<int> waiting_signal{0};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
              std::atomic<void*>::is_always_lock_free);

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
    remove_all_temporaries();
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
    for (int number = 0;; ++number) {
        Chunk& chunk = chunk_at(number);
        for (int index = 0; index < chunk_size; ++index) {
            Slot& slot = chunk.slots[static_cast<std::size_t>(index)];
            if (slot.used.load()) continue;
            std::memcpy(slot.path.data(), text.c_str(), text.size() + 1);
            slot.used.store(true);
            return number * chunk_size + index;
        }
    }
}

void forget_temporary(int slot) {
    if (slot < 0) return;
    chunk_at(slot / chunk_size)
        .slots[static_cast<std::size_t>(slot % chunk_size)]
        .used.store(false);
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
