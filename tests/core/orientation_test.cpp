// SPDX-License-Identifier: Apache-2.0
#include "core/orientation.h"

#include <catch2/catch.hpp>
