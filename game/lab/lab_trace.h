// game/lab/lab_trace.h: the lab's figures as CSV, one row per step. Without computing times the same run
// gives the same bytes.
#pragma once
#include <string>

#include "game/lab/lab.h"

namespace thaum::game::inline lab {

/// `times` adds columns with computing times (us). Columns use the index of a substance, because a session
/// may replace the substance at that index.
std::string lab_trace_header(bool times);
void append_lab_row(const LabState& lab, const LabFigures& figures, bool times, std::string& rows);

}  // namespace thaum::game::inline lab
