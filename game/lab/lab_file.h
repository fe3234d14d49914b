// game/lab/lab_file.h: saving a lab session to a file (fluid/saved.h), and loading it. With the same data
// files, a loaded session continues exactly as the saved one would.
#pragma once
#include <filesystem>

#include "core/bytes.h"
#include "game/lab/lab.h"

namespace thaum::game::inline lab {

Bytes save_lab(const LabState& lab);

/// Reads a saved session from its bytes. `rules` gives what the bytes do not hold: the ladle and the brew's
/// density. The error says what is wrong with the bytes.
Expected<LabState> restore_lab(std::span<const std::byte> bytes, const CauldronRules& rules);

/// Saves a session to a file (save_lab), or restores it from one (load_lab). The error also names the file. A
/// failed save leaves no partial file.
Expected<void> save_lab(const LabState& lab, const std::filesystem::path& file);
Expected<LabState> load_lab(const std::filesystem::path& file, const CauldronRules& rules);

}  // namespace thaum::game::inline lab
