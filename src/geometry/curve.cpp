// SPDX-License-Identifier: Apache-2.0
#include "geometry/curve.h"
