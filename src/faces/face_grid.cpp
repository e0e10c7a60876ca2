// SPDX-License-Identifier: Apache-2.0
#include "faces/face_grid.h"
