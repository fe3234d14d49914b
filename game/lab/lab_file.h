// game/lab/lab_file.h: the lab as a file (fluid/saved.h), and back. With the same data files it goes on to the same bits.
#pragma once
#include <filesystem>

#include "core/bytes.h"
#include "game/lab/lab.h"

namespace thaum::game {

Bytes save_lab(const LabState& lab);

/// `rules`: what the file does not hold, the ladle and the brew's density. The error says what is wrong with the file.
Expected<LabState> restore_lab(std::span<const std::byte> bytes, const CauldronRules& rules);

/// The error names the file as well. Nothing is left half-written.
Expected<void> save_lab(const LabState& lab, const std::filesystem::path& file);
Expected<LabState> load_lab(const std::filesystem::path& file, const CauldronRules& rules);

}  // namespace thaum::game
