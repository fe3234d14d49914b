// game/lab/lab_trace.h: the lab's figures as CSV, a row a step. Without times of the clock the same run gives the same bytes.
#pragma once
#include <string>

#include "game/lab/lab.h"

namespace thaum::game {

/// `times`: with microseconds. A substance is known by its place: what stands there may change.
std::string lab_trace_header(bool times);
void append_lab_row(const LabState& lab, const LabFigures& figures, bool times, std::string& rows);

}  // namespace thaum::game
