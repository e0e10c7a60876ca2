// SPDX-License-Identifier: Apache-2.0
#include "elliptic/solve_result.h"
