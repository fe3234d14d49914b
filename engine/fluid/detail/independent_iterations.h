// fluid/detail/independent_iterations.h: a hint for the compiler on loops along rows.
#pragma once

/// Stands before a loop of which no iteration writes what another one reads or writes. Then the compiler need not compare the
/// places of the arrays, which it may give up for so many of them. No such loop adds up numbers: clang would take the order of
/// the sum as free.
#if defined(__clang__)
#define THAUM_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety)")
#else
#define THAUM_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#endif
