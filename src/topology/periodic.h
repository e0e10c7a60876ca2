// SPDX-License-Identifier: Apache-2.0
// Periodic interfaces: which sides are the images of which, and what is made of what for that.
#pragma once

#include "core/diagnostics.h"
#include "topology/draft.h"

namespace hexweave {

/// Fills the periodic interfaces. Sides are paired, and lie on each other, as their vertices and
/// edges tell: every point of a side of `to` is the image of one of a side of `from` to 1e-9 of the
/// grid's size. Reports sides without an image or with several, and sides that are not free.
void pair_periodic_sides(Network& network, const Case& c, Diagnostics& diagnostics);

/// Tells the edges and faces of paired sides whose images they are. Reports faces that ask for what
/// an image cannot have: a surface or a way of being made.
void make_images(Network& network, Diagnostics& diagnostics);

/// Moves the vertices of images exactly there, and those on an axis of rotation exactly onto it.
/// Reports a vertex that two interfaces would have at different places.
void settle_images(Network& network, Diagnostics& diagnostics);

}  // namespace hexweave
