// physics/bullet_maths.h: the elementary functions that Bullet computes with.
//
// Bullet's libraries call sin, cos, sincos, acos, asin, atan2 and pow of the mathematical library. glibc has several variants of
// each and chooses by the processor; with and without fused multiplication they differ in the last bit, and then two matches
// part. So the program defines these seven itself, under the same names, with the functions of core/maths.h. The dynamic
// linker looks into the program first, and Bullet, like all else in the process, calls ours. sqrt and fmod stay: they have
// one right result.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace thaum::physics {

/// Functions that Bullet's libraries take from the mathematical library although processors differ in them, as
/// "library: function"; empty in a program that is linked as it should be. Another version of Bullet may call more than seven.
std::vector<std::string> foreign_maths();

/// Asserts that there are none, once per process.
void require_our_maths();

/// Hash of the seven functions' results over a fixed list of arguments; a log's header carries it. The same in every build: where
/// it is not, this compiler has made other bits of core/maths.cpp, and no match replays.
std::uint64_t maths_probe();

}  // namespace thaum::physics
