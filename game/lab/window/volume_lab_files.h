// game/lab/window/volume_lab_files.h: files of `thaum lab VOLUME`: no output may be a file that the command reads, or another
// output.
#pragma once
#include <string_view>

#include "core/error.h"
#include "game/lab/window/volume_lab.h"

namespace thaum::app {

/// True for a name of a volume that the lab makes; any other name is a file.
bool is_made(std::string_view name);

/// Protects the files of colours and materials beside the first volume, read or not (core/write_rule.h).
void protect_companions(const VolumeLabPlan& plan);

/// Checks that each output has a file of its own, which this command does not read. A saved body has three.
Expected<void> check_outputs(const VolumeLabPlan& plan);

}  // namespace thaum::app
