// SPDX-License-Identifier: Apache-2.0
// `hexweave plot GRID -o PICTURE`: a picture of a finished grid.
#pragma once

#include <string>
#include <vector>

#include "core/errors.h"
#include "io/picture.h"

namespace hexweave {

/// The command line as it is written.
struct PlotArguments {
    std::string grid;
    std::string output;
    std::string size = "1200x900";
    std::vector<double> window;
    std::string view;
    std::string up;
    std::vector<std::string> planes;
    std::string colour = "zone";
    std::vector<std::string> families;
    bool no_boundary = false;
    std::string title;
};

/// What the arguments say to draw. Throws UsageError for one that cannot be read.
PictureOptions picture_options(const PlotArguments& arguments);

/// "wing:k=3", or "*:k=3" for every zone; nodes are counted from 1. Throws UsageError for anything
/// else.
IndexPlane read_plane(const std::string& text);

/// Reads the grid, writes the picture and prints one line that says what it shows.
ExitCode plot(const PlotArguments& arguments);

}  // namespace hexweave
