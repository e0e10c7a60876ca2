// SPDX-License-Identifier: Apache-2.0
#include "quality/measure.h"

#include <catch2/catch.hpp>
