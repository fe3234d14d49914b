// tools/bench/invariants.h: what must hold in a row whatever the machine, such as no hash that differs and no
// allocation where none may be. A row that breaks one of them has measured something else than it says.
#pragma once
#include "tools/bench/report.h"

namespace thaum::bench {

/// Why the row cannot be trusted, as a line that names the figure and its bound; empty: it can. An error or a metric
/// that is no finite number is never right.
std::string broken_invariant(const Row& row);

/// Sets `fault` of every row that breaks an invariant, and adds it to the report's faults.
void check_invariants(Report& report);

}  // namespace thaum::bench
