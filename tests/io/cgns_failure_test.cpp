// SPDX-License-Identifier: Apache-2.0
// Full disks, limits and signals while a file is being written: the former file stays, nothing is
// left behind, and the process ends as it should.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "core/errors.h"
#include "io/cgns.h"
#include "io/cgns_samples.h"
#include "io/scratch.h"

using namespace hexweave;
using Names = std::vector<std::string>;

namespace {

const std::string probe = HEXWEAVE_WRITE_PROBE;

/// Writes to a file system of its own, seen by this shell alone, that grows until the grid fits; a
/// line for every size.
constexpr const char* full_disk_script = R"(disk=$1; probe=$2
for size in 8 24 40 72 100 120 140 160 200 220 240 280 400 1000; do
    mount -t tmpfs -o size=${size}k tmpfs $disk || exit 77
    echo former > $disk/grid.cgns
    $probe 3 5 $disk/grid.cgns; status=$?
    set -- $(ls -A $disk)
    former=replaced; echo former | cmp -s - $disk/grid.cgns && former=stays
    echo size=$size status=$status files=$* $former
    umount $disk
done)";

/// Starts the probe with the given arguments.
pid_t start(const std::vector<std::string>& arguments) {
    std::vector<char*> argv{const_cast<char*>(probe.c_str())};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        execv(argv[0], argv.data());
        _exit(127);
    }
    return child;
}

/// Waits until a file whose name starts so has grown, or the child has ended; whether it has grown.
bool wait_for_file(const Scratch& scratch, const std::string& start_of_name, pid_t child) {
    siginfo_t ended{};
    while (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid == 0) {
        for (const std::string& name : scratch.names()) {
            std::error_code gone;
            const bool fits = name.substr(0, start_of_name.size()) == start_of_name;
            const auto size = std::filesystem::file_size(scratch.path(name), gone);
            if (fits && !gone && size > 0) return true;
        }
        usleep(500);
    }
    return false;
}

/// Kills the probe when a file whose name starts so has grown; the former file must survive.
void require_clean_end(const std::string& start_of_name, int signal_number) {
    const Scratch scratch;
    const std::string path = scratch.path("grid.cgns").string();
    put(path, "former");
    const pid_t child = start({"200", "4", path});
    CHECK(wait_for_file(scratch, start_of_name, child));
    kill(child, signal_number);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal_number);
    CHECK(contents(path) == "former");
    CHECK(scratch.names() == Names{"grid.cgns"});
}

}  // namespace

TEST_CASE("On a full disk the former file stays, at every size of the disk") {
    const Scratch scratch;
    const std::string disk = scratch.folder().string();
    const Outcome outcome =
        run(fmt::format("unshare -Urm sh -c '{}' sh {} {}", full_disk_script, disk, probe));
    INFO(outcome.output);
    if (outcome.output.find("size=") == std::string::npos) {
        WARN("skipped: no file system of one's own in a user namespace: " + outcome.output);
        return;
    }
    REQUIRE(outcome.status == 0);
    const std::string full = "cannot write '" + disk + "/grid.cgns': no space left on device\n";
    std::string rest = outcome.output;
    int failures = 0;
    int successes = 0;
    for (const int size : {8, 24, 40, 72, 100, 120, 140, 160, 200, 220, 240, 280, 400, 1000}) {
        const std::string failed =
            fmt::format("{}size={} status=3 files=grid.cgns stays\n", full, size);
        const std::string done = fmt::format("size={} status=0 files=grid.cgns replaced\n", size);
        if (rest.substr(0, failed.size()) == failed) {
            rest.erase(0, failed.size());
            ++failures;
        } else {
            INFO("at size " << size);
            REQUIRE(rest.substr(0, done.size()) == done);
            rest.erase(0, done.size());
            ++successes;
        }
    }
    CHECK(failures >= 8);
    CHECK(successes >= 1);
    CHECK(rest.empty());
}

TEST_CASE("At a limit of the file size the former file stays") {
    const Scratch scratch;
    const std::string path = scratch.path("grid.cgns").string();
    put(path, "former");
    int failures = 0;
    for (const int limit : {0, 100, 5000, 40000, 80000, 110000, 113000, 1000000}) {
        const Outcome outcome = run(fmt::format("{} 3 5 {} {}", probe, path, limit));
        INFO(limit << ": " << outcome.output);
        CHECK(scratch.names() == Names{"grid.cgns"});
        if (outcome.status == 0) break;
        ++failures;
        CHECK(outcome.status == 3);
        CHECK(outcome.output == "cannot write '" + path + "': file too large\n");
        CHECK(contents(path) == "former");
    }
    CHECK(failures == 7);
    CHECK(contents(path) != "former");
}

TEST_CASE("A signal in the middle of writing ends the process and leaves nothing behind") {
    for (const int signal_number : {SIGTERM, SIGINT, SIGHUP}) {
        require_clean_end("..grid.cgns.tmp.", signal_number);  // while libcgns writes the tree
    }
    require_clean_end(".grid.cgns.tmp.", SIGTERM);  // while the tree is copied
}

TEST_CASE("A process that ignores hang-ups, as under nohup, goes on") {
    const Scratch scratch;
    const std::string path = scratch.path("grid.cgns").string();
    const Outcome outcome = run("trap '' HUP; " + probe + " 60 6 " + path +
                                " & child=$!; while [ -z \"$(ls -A " + scratch.folder().string() +
                                ")\" ]; do sleep 0.01; done; kill -HUP $child; wait $child");
    INFO(outcome.output);
    CHECK(outcome.status == 0);
    CHECK(scratch.names() == Names{"grid.cgns"});
}

TEST_CASE("After a failure another grid can be written in the same process") {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path("folder"));
    CHECK_THROWS_AS(write_cgns(c_grid(), scratch.path("missing/c.cgns")), MachineError);
    CHECK_THROWS_AS(write_cgns(c_grid(), scratch.path("folder")), MachineError);
    CHECK_NOTHROW(write_cgns(c_grid(), scratch.path("c.cgns")));
    CHECK(scratch.names() == Names{"c.cgns", "folder"});
}

TEST_CASE("Names that CGNS cannot hold are refused before anything is written") {
    const Scratch scratch;
    const auto refused = [&](const MultiblockGrid& grid, const std::string& message) {
        CHECK_THROWS_AS(write_cgns(grid, scratch.path("g.cgns")), UsageError);
        CHECK_THROWS_WITH(write_cgns(grid, scratch.path("g.cgns")),
                          Catch::Matchers::Contains(message));
        CHECK(scratch.names().empty());
    };
    MultiblockGrid grid = c_grid();
    grid.zones[0].name = "foil";
    refused(grid, "the name of family 'foil' is taken; zones and families share one list");
    grid.zones[0].name = std::string(33, 'z');
    refused(grid, "must have 1 to 32 bytes");
    grid.zones[0].name = "DataClass";
    refused(grid, "the name of zone 'DataClass' is taken");
    grid = c_grid();
    grid.families[0].type = "BCWal";
    refused(grid, "family 'far' has the type 'BCWal', which CGNS does not know");
    grid = c_grid();
    grid.units = "furlong";
    refused(grid, "CGNS has no unit 'furlong'");
}
