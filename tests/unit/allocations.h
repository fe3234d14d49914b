// tests/unit/allocations.h: counts memory allocations of a test program, which must link allocations.cpp.
#pragma once
#include <cstddef>

namespace thaum::test {

/// Number of calls of `new` so far in the whole test program, in any thread. The thread sanitizer has its own
/// `new`, which clang does not let us replace: there the result is always 0. The tests that count run in the
/// other builds too.
std::size_t allocations();

}  // namespace thaum::test
