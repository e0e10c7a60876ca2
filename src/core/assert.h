// SPDX-License-Identifier: Apache-2.0
// HEXWEAVE_ASSERT: a fault of our own, never of the user's input. Checked in Debug builds and in
// the `audit` preset; prints the expression and where it stands, then aborts.
#pragma once

#include <cstdio>
#include <cstdlib>

#ifdef HEXWEAVE_ASSERTIONS
#define HEXWEAVE_ASSERT(expression)                                                         \
    do {                                                                                    \
        if (!(expression)) {                                                                \
            std::fprintf(stderr, "%s:%d: assertion failed in %s: %s\n", __FILE__, __LINE__, \
                         static_cast<const char*>(__func__), #expression);                  \
            std::abort();                                                                   \
        }                                                                                   \
    } while (false)
#else
#define HEXWEAVE_ASSERT(expression) static_cast<void>(sizeof((expression) ? 1 : 0))
#endif
