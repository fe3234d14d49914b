// game/lab/volume_trace.h: what a hand feels in a volume as CSV, one row per tick. The same run gives the
// same bytes.
#pragma once
#include <string>

#include "game/lab/volume_lab.h"

namespace thaum::game::inline lab {

/// Column titles. The columns from hand_x_m on are the input of the step: target of the hand, tool and undo.
/// hand_path reads them, so a trace can be played again. tool: index of the held tool in the sorted list,
/// from 1; 0: none. history: -1 undo, 1 redo.
std::string volume_trace_header();
/// Appends the row of the step that `input` has produced.
void append_volume_row(const VolumeLab& lab, const VolumeLabInput& input, const VolumeLabFigures& figures,
                       std::string& rows);

}  // namespace thaum::game::inline lab
