// SPDX-License-Identifier: Apache-2.0
#include "blocks/block_grid.h"
