// SPDX-License-Identifier: Apache-2.0
// For the few loops that nearly all of the time is spent in.
#pragma once

/// A function marked with this is compiled twice, for any machine and for those with AVX2, and the
/// right one is taken when the program starts. The results are the same to the bit: contraction is
/// off, and lanes are lanes. Sanitizers do not bear with such functions.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__AVX2__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HEXWEAVE_VECTORIZED [[gnu::target_clones("avx2", "default")]]
#else
#define HEXWEAVE_VECTORIZED
#endif

/// Before a loop none of whose iterations reads what another writes, though the compiler cannot
/// see it.
#if defined(__clang__)
#define HEXWEAVE_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety)")
#else
#define HEXWEAVE_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#endif
