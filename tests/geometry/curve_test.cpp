// SPDX-License-Identifier: Apache-2.0
#include "geometry/curve.h"

#include <catch2/catch.hpp>
