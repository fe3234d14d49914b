// tests/drivers/fake_hd/misbehaviour.h: faults of the fake library: in calls of its functions, and in the
// values that it returns. script.h lists the words of the script.
#pragma once
#include "drivers/fake_hd/library.h"

namespace thaum::fake_hd {

/// Disturbs a call of the library as the script says; it may never return. Returns the error code with which
/// the call must fail; 0: the call goes on. Call this without the mutex.
unsigned int misbehave(Library& l, const char* call);

// Call these with the mutex locked.

/// Measured position of the tip (mm).
vec3 measured_mm(const Device& d);
/// 16 numbers, column by column. The stylus leans with the place, 10 rad/m, as an arm's does.
void put_transform(const Device& d, double* to);
/// A limit, told in any place; false where the name is none's.
bool put_limit(const Library& l, unsigned int name, double* to);
int degrees_of_freedom(const Library& l, int well);
/// Text for the script's word `strings` or `error_strings`; `well` if the script has no such fault.
const char* said(const Library& l, const char* word, const char* well);

}  // namespace thaum::fake_hd
