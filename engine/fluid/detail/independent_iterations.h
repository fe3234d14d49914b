// fluid/detail/independent_iterations.h: a hint for the compiler on loops along rows.
#pragma once

/// Placed before a loop whose iterations are independent: none writes what another one reads or writes. The
/// compiler then need not check whether the arrays overlap, a check that makes it give up if there are many
/// arrays. Such a loop must not add up numbers, because clang would then change the order of the sum.
#if defined(__clang__)
#define THAUM_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety)")
#else
#define THAUM_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#endif
