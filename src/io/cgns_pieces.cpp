// SPDX-License-Identifier: Apache-2.0
#include "io/cgns_pieces.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <deque>
#include <memory>
#include <string>

#include "core/errors.h"
#include "io/cgns_source.h"
#include "io/output_place.h"

namespace hexweave {
namespace {

constexpr int slots = 2;

/// What the reading process is asked for: the points of a box, put into a slot.
struct Request {
    int zone = 0;
    IndexBox box;
    int slot = 0;
};

/// Its answer: an empty text when it succeeded. Longer texts are cut.
struct Answer {
    std::array<char, 1000> text{};
};

/// Reads or writes a whole object; false at the end of the stream.
template <class T>
bool receive(int stream, T& object) {
    ssize_t size = 0;
    do {
        size = recv(stream, &object, sizeof(T), MSG_WAITALL);
    } while (size < 0 && errno == EINTR);
    return size == static_cast<ssize_t>(sizeof(T));
}

template <class T>
bool transmit(int stream, const T& object) {
    ssize_t size = 0;
    do {
        size = send(stream, &object, sizeof(T), MSG_NOSIGNAL);
    } while (size < 0 && errno == EINTR);
    return size == static_cast<ssize_t>(sizeof(T));
}

Answer answer_of(const std::string& text) {
    Answer answer;
    text.copy(answer.text.data(), answer.text.size() - 1);
    return answer;
}

/// Memory of both processes that is given back at the end.
class SharedSlots {
public:
    explicit SharedSlots(std::size_t piece_nodes)
        : piece_nodes_(piece_nodes), size_(std::size_t{slots} * 3 * piece_nodes * sizeof(double)) {
        memory_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory_ == MAP_FAILED) throw MachineError("out of memory; nothing was written");
    }
    SharedSlots(const SharedSlots&) = delete;
    SharedSlots& operator=(const SharedSlots&) = delete;
    ~SharedSlots() { munmap(memory_, size_); }

    std::array<double*, 3> values(int slot) const {
        double* first =
            static_cast<double*>(memory_) + static_cast<std::size_t>(slot) * 3 * piece_nodes_;
        return {first, first + piece_nodes_, first + 2 * piece_nodes_};
    }

private:
    std::size_t piece_nodes_;
    std::size_t size_;
    void* memory_ = nullptr;
};

/// The reading process: opens, answers, then serves until the other end is closed.
[[noreturn]] void serve(const std::filesystem::path& path, int stream, const SharedSlots& memory) {
    become_expendable();
    try {
        const CgnsSource source(path, OtherParts::left_out);
        const GridOutline outline = read_outline(source);
        static_cast<void>(find_other_nodes(source, outline));
        Request request;
        bool open = transmit(stream, Answer{});
        while (open && receive(stream, request)) {
            read_points(source, outline, request.zone, request.box, memory.values(request.slot));
            open = transmit(stream, Answer{});
        }
    } catch (const std::exception& error) {
        transmit(stream, answer_of(error.what()));
    }
    _exit(0);
}

/// This process's end.
class PieceReader {
public:
    PieceReader(const std::filesystem::path& path, std::size_t piece_nodes)
        : path_(path), memory_(piece_nodes) {
        std::array<int, 2> ends{};
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
            throw MachineError(fmt::format("cannot make a pipe: {}", error_reason(errno)));
        }
        stream_ = ends[0];
        process_ = fork();
        if (process_ == 0) {
            close(ends[0]);
            serve(path, ends[1], memory_);
        }
        close(ends[1]);
        if (process_ < 0) {
            close(stream_);
            throw MachineError(
                fmt::format("cannot start another process: {}", error_reason(errno)));
        }
    }
    PieceReader(const PieceReader&) = delete;
    PieceReader& operator=(const PieceReader&) = delete;
    ~PieceReader() {
        // Closing is not enough: a process that was started later holds this end as well.
        shutdown(stream_, SHUT_RDWR);
        close(stream_);
        while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
    }

    /// Waits until the reading process has done what it was asked first.
    void wait() const {
        Answer answer;
        if (!receive(stream_, answer)) {
            throw UsageError(fmt::format("cannot read '{}': it is damaged", path_.string()));
        }
        if (answer.text[0] != '\0') throw UsageError(answer.text.data());
    }

    void ask(int zone, const IndexBox& box) {
        const Request request{zone, box, next_slot_};
        next_slot_ = (next_slot_ + 1) % slots;
        asked_.push_back(request);
        // Where the process has ended, waiting says so.
        transmit(stream_, request);
    }

    Piece take() {
        const Request request = asked_.front();
        asked_.pop_front();
        wait();
        Piece piece{request.box, {}};
        const auto values = memory_.values(request.slot);
        std::copy(values.begin(), values.end(), piece.values.begin());
        return piece;
    }

private:
    std::filesystem::path path_;
    SharedSlots memory_;
    int stream_ = -1;
    pid_t process_ = -1;
    int next_slot_ = 0;
    std::deque<Request> asked_;
};

}  // namespace

PointSource open_cgns_pieces(const std::filesystem::path& path, std::size_t piece_nodes) {
    require_readable(path);
    const auto reader = std::make_shared<PieceReader>(path, piece_nodes);
    // The other process has read the outline before this one does: the file is sound that far.
    reader->wait();
    PointSource result;
    {
        const CgnsSource source(path, OtherParts::left_out);
        result.outline = read_outline(source);
        result.outline.others = find_other_nodes(source, result.outline);
    }
    result.piece_nodes = piece_nodes;
    result.ask = [reader](int zone, const IndexBox& box) { reader->ask(zone, box); };
    result.take = [reader] { return reader->take(); };
    return result;
}

}  // namespace hexweave
