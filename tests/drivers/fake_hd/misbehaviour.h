// tests/drivers/fake_hd/misbehaviour.h: faults of the fake library: in calls of its functions, and in the
// values that it returns. script.h lists the options of the script.
#pragma once
#include "drivers/fake_hd/library.h"

namespace thaum::fake_hd {

/// Simulates a scripted fault of a library call, which may never return. Returns the error code with which
/// the call must fail; 0: the call continues. The mutex must be unlocked.
unsigned int misbehave(Library& l, const char* call);

// The functions below need the mutex to be locked.

/// Measured position of the tip (mm).
vec3 measured_mm(const Device& d);
/// Writes the 4 x 4 transform, column by column. The stylus tilts with the position, 10 rad/m, like that of a
/// real arm.
void put_transform(const Device& d, double* to);
/// Writes a limit of the device; returns false if there is none of this name.
bool put_limit(const Library& l, unsigned int name, double* to);
int degrees_of_freedom(const Library& l, int well);
/// Returns the wrong text that the script's option `strings` or `error_strings` asks for, else the correct
/// text `well`.
const char* said(const Library& l, const char* word, const char* well);

}  // namespace thaum::fake_hd
