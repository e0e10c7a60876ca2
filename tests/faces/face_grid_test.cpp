// SPDX-License-Identifier: Apache-2.0
#include "faces/face_grid.h"

#include <catch2/catch.hpp>
