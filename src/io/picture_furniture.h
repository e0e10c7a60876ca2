// SPDX-License-Identifier: Apache-2.0
// What stands around the grid: title, legend, axes or scale bar; and the room they need.
#pragma once

#include <string>

#include "io/picture.h"
#include "io/picture_drawing.h"
#include "io/picture_page.h"
#include "io/picture_scene.h"

namespace hexweave {

/// How much larger than on a page of 1200 x 900 letters and lines are.
double page_scale(const PictureOptions& options);

/// The room that is left for the grid. Throws UsageError when there is none.
Frame grid_frame(const Scene& scene, const PictureOptions& options);

/// Appends title, legend, and axes (flat) or the directions of x, y and z with a scale bar.
void append_furniture(const Scene& scene, const PictureOptions& options, const View& view,
                      const std::string& units, Drawing& drawing);

}  // namespace hexweave
