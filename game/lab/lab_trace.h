// game/lab/lab_trace.h: the results of the lab's steps as CSV, one row per step. Without computing times, the
// same run gives the same bytes.
#pragma once
#include <string>

#include "game/lab/lab.h"

namespace thaum::game::inline lab {

/// Line with the column titles. `times` adds columns with computing times (us). Titles number the substances,
/// because a session may replace the ingredient of a substance.
std::string lab_trace_header(bool times);
void append_lab_row(const LabState& lab, const LabFigures& figures, bool times, std::string& rows);

}  // namespace thaum::game::inline lab
