// game/lab/volume_trace.h: what a hand feels in a volume as CSV, one row per tick. The same run gives the
// same bytes.
#pragma once
#include <string>

#include "game/lab/volume_lab.h"

namespace thaum::game::inline lab {

/// Line with the column titles. The columns from hand_x_m on are the input of the step: target position of
/// the hand, tool and undo. hand_path reads them, so a trace can be played again. Column `tool`: index of the
/// held tool in the sorted list, from 1; 0: none. Column `history`: -1 undo, 1 redo, 0 neither.
std::string volume_trace_header();
/// Appends the row of the step that was made with `input`.
void append_volume_row(const VolumeLab& lab, const VolumeLabInput& input, const VolumeLabFigures& figures,
                       std::string& rows);

}  // namespace thaum::game::inline lab
