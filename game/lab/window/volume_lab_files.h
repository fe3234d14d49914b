// game/lab/window/volume_lab_files.h: checks the files of `thaum lab VOLUME`: no output may be a file that
// the command reads, or the same file as another output.
#pragma once
#include <string_view>

#include "core/error.h"
#include "game/lab/window/volume_lab.h"

namespace thaum::game::inline lab {

/// True for the name of a volume that the lab generates; any other name is a file.
bool is_made(std::string_view name);

/// Protects the files of colours and materials that lie beside the first volume's file from being
/// overwritten, whether or not the command has read them (core/write_rule.h).
void protect_companions(const VolumeLabPlan& plan);

/// Checks that no two outputs are the same file, and that the command reads none of them. A saved body counts
/// as its three files.
Expected<void> check_outputs(const VolumeLabPlan& plan);

}  // namespace thaum::game::inline lab
