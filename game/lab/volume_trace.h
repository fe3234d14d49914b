// game/lab/volume_trace.h: what a hand feels in a volume as CSV, one row a tick. The same run gives the same bytes.
#pragma once
#include <string>

#include "game/lab/volume_lab.h"

namespace thaum::game {

std::string volume_trace_header();
void append_volume_row(const VolumeLab& lab, const VolumeLabFigures& figures, std::string& rows);

}  // namespace thaum::game
