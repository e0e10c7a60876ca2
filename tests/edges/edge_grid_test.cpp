// SPDX-License-Identifier: Apache-2.0
#include "edges/edge_grid.h"

#include <catch2/catch.hpp>
