// tools/bench/invariants.h: conditions that each row of a report must meet on any machine, such as equal
// hashes and no allocation where none is allowed. If a row breaks one, its measurement is invalid.
#pragma once
#include "tools/bench/report.h"

namespace thaum::bench {

/// Reason why this row of the report cannot be trusted, as one line with the value and its bound; empty:
/// none. An error or a metric that is not finite breaks an invariant, except the infinite error of a row that
/// may diverge.
std::string broken_invariant(const Row& row);

/// Sets `fault` of every row that breaks an invariant, and adds it to the faults of the report.
void check_invariants(Report& report);

}  // namespace thaum::bench
