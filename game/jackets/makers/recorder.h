// game/jackets/makers/recorder.h: an output that writes the vibrations that one player feels to a CSV file
// (game/jackets/felt_rows.h): a row for every frame (the strengths at one moment) in which any is felt. Each
// match begins at tick 0 again.
//
// The recorder replaces no file: if there is a FILE.csv, it writes FILE_2.csv, and so on. The file appears
// under its name when the session ends, or when the player's jacket is changed. When the disk is full, the
// recording is given up, with one line of explanation.
#pragma once
#include <filesystem>
#include <memory>

#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

/// Output that records to `file`. `player`: 0 or 1, the player's number in the table.
std::unique_ptr<input::TactileOutput> felt_recorder(std::filesystem::path file, std::uint32_t player);

}  // namespace thaum::game::inline jackets
