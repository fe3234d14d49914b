// tests/unit/allocations.h: counts what a test program allocates. Link allocations.cpp.
#pragma once
#include <cstddef>

namespace thaum::test {

/// Number of `new` so far in the whole test program, in any thread. The thread sanitizer brings a `new` of its own,
/// which clang does not let us replace: there it is always 0, and the tests that count run in the other builds too.
std::size_t allocations();

}  // namespace thaum::test
