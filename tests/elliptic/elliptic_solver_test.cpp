// SPDX-License-Identifier: Apache-2.0
#include "elliptic/elliptic_solver.h"

#include <catch2/catch.hpp>
