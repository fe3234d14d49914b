// tools/bench/allocations.h: number of memory allocations of this process, in all its threads.
//
// A program that links this file replaces malloc, calloc, realloc and the aligned functions, and so
// operator new. The replacements count the call, then call the C library's own function. The cost is one
// relaxed atomic addition per call. Under a sanitizer, or with another C library, nothing is replaced and
// nothing is counted.
#pragma once
#include <cstdint>

namespace thaum::bench {

/// False if nothing is counted and the counter always reads zero.
bool allocations_are_counted();

/// Number of allocations since the start of the program. Use the difference of two readings.
std::uint64_t allocation_count();

}  // namespace thaum::bench
