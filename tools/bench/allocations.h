// tools/bench/allocations.h: how often this process asked for memory, in all its threads.
//
// A program that links this replaces malloc, calloc, realloc and their aligned kin (so operator new as well) by
// functions that count and then call the C library's own. The price is one relaxed atomic addition a call.
// Under a sanitizer, or with another C library, nothing is replaced and nothing counted.
#pragma once
#include <cstdint>

namespace thaum::bench {

/// False where the counter always reads zero.
bool allocations_are_counted();

/// Allocations since the program's start; take the difference of two readings.
std::uint64_t allocation_count();

}  // namespace thaum::bench
