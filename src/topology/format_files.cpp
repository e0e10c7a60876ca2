// SPDX-License-Identifier: Apache-2.0
// The table of the format: files to write.
#include "topology/format_parts.h"

namespace hexweave {

using namespace forms;

std::vector<MappingFormat> formats_of_files() {
    return {
        {"output",
         "Files to write: all of them, or none.",
         {{"cgns",
           {file()},
           "",
           "zones, one-to-one interfaces, families and units",
           "cgns: wing.cgns"},
          {"plot3d",
           {file(), mapping("plot3d_output")},
           "",
           "the points, and beside them a neutral map of interfaces and families",
           "plot3d: wing.xyz"},
          {"vtk",
           {file()},
           "",
           "a list of zones and boundaries, and a folder of them",
           "vtk: wing.vtm"},
          {"openfoam",
           {file()},
           "",
           "a folder, or FOLDER/NAME.foam: its constant/polyMesh",
           "openfoam: cases/wing"}}},
        {"plot3d_output",
         "A Plot3D file.",
         {{"file", {file()}, key_required, "its name", "file: wing.xyz"},
          {"form",
           {words({"text", "unformatted", "stream"})},
           "by the ending",
           "decimals, Fortran records, or bare bytes",
           "form: stream"},
          {"byte_order",
           {words({"little", "big"})},
           "little",
           "of the bytes of a number",
           "byte_order: big"}}},
    };
}

}  // namespace hexweave
