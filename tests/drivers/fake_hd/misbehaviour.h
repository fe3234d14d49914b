// tests/drivers/fake_hd/misbehaviour.h: faults of the fake library: in calls of its functions, and in the
// values that it returns. script.h lists the words of the script.
#pragma once
#include "drivers/fake_hd/library.h"

namespace thaum::fake_hd {

/// Applies the script's fault, if any, to a call of this function. Returns an error code if the call must
/// fail, else 0. May not return at all. Call it with the mutex unlocked.
unsigned int misbehave(Library& l, const char* call);

// Call these with the mutex locked.

/// Measured position of the tip (mm).
vec3 measured_mm(Library& l);
/// Writes the tip's transform, 16 numbers by columns. The stylus rotates about y by 10 rad per metre of x,
/// so that its rotation changes with position.
void put_transform(Library& l, double* to);
/// Writes a limit of the device. Returns false if no limit has this name.
bool put_limit(const Library& l, unsigned int name, double* to);
int degrees_of_freedom(const Library& l, int well);
/// Text for the script's word `strings` or `error_strings`; `well` if the script has no such fault.
const char* said(const Library& l, const char* word, const char* well);

}  // namespace thaum::fake_hd
