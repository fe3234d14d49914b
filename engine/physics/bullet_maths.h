// physics/bullet_maths.h: replaces the elementary functions that Bullet uses.
//
// Bullet's libraries call sin, cos, sincos, acos, asin, atan2 and pow. glibc has several variants of
// each and chooses one by the processor. Variants with and without fused multiplication differ in the
// last bit, and then two replays of a match diverge. The program therefore defines these seven
// functions itself, using core/maths.h. The dynamic linker searches the program first, so Bullet and
// all other code in the process call them. sqrt and fmod are not replaced, because their results are
// exactly defined.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace thaum::physics {

/// Functions that Bullet's libraries import from the mathematical library although their results depend
/// on the processor, as "library: function". Empty in a correctly linked program. Another version of
/// Bullet may import more than the seven functions.
std::vector<std::string> foreign_maths();

/// Asserts, once per process, that foreign_maths() is empty.
void require_our_maths();

/// Hash of the seven functions' results for a fixed list of arguments; the header of a log contains it.
/// The hash is the same in every correct build. If a hash differs, the compiler has produced other results
/// for core/maths.cpp, and no match can be replayed.
std::uint64_t maths_probe();

}  // namespace thaum::physics
