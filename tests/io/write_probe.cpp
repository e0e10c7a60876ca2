// SPDX-License-Identifier: Apache-2.0
// Writes a grid as the program does, in a process of its own that a test may limit or kill.
//
//   write_probe COUNT NODES PATH           a row of COUNT zones of NODES^3 nodes
//   write_probe COUNT NODES PATH LIMIT     no file may grow beyond LIMIT bytes
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

#include "core/errors.h"
#include "io/cgns.h"
#include "io/cgns_samples.h"
#include "io/output_files.h"

int main(int argc, char** argv) {
    using namespace hexweave;
    prepare_hdf5();
    remove_staged_files_on_signals();
    try {
        if (argc < 4) return 2;
        const MultiblockGrid grid = row_of_zones(std::atoi(argv[1]), std::atoi(argv[2]));
        if (argc > 4) {
            const auto bytes = static_cast<rlim_t>(std::atol(argv[4]));
            const rlimit limit{bytes, bytes};
            if (setrlimit(RLIMIT_FSIZE, &limit) != 0) return 2;
        }
        const std::filesystem::path path = argv[3];
        OutputFiles files;
        files.write(files.stage(path), [&grid](const auto& staged) { write_cgns(grid, staged); });
        files.commit();
        return static_cast<int>(ExitCode::done);
    } catch (const MachineError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return static_cast<int>(ExitCode::machine_failed);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "unexpected: %s\n", error.what());
        return static_cast<int>(ExitCode::wrong_input);
    }
}
