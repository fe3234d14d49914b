// game/settings/own_pads.h: mappings of pads that players have made, in the file `pads.txt` beside the
// settings file. A line has the format of SDL's gamecontrollerdb.txt, so lines from there may be added by
// hand (input/pad_mapping.h).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"

namespace thaum::game::inline settings {

/// The file of mappings; empty if there is no settings file.
std::filesystem::path own_pads_file(const std::filesystem::path& settings_file);

struct OwnPads {
    std::vector<std::string> mappings{};  ///< one mapping for each model, the last one in the file
    /// Why lines, or the whole file, are left out; each with its position.
    std::vector<std::string> faults{};
};

/// All mappings for this system; none if there is no file. A byte order mark, blanks around a line, CRLF,
/// empty lines, comments (#) and lines for other systems are ignored.
OwnPads load_own_pads(const std::filesystem::path& file);
/// Saves a mapping in place of older ones of the same model. Other lines are not changed.
Expected<void> save_own_pad(const std::filesystem::path& file, const std::string& mapping);
/// Removes the mappings of a model from the file. Other lines are not changed.
Expected<void> forget_own_pad(const std::filesystem::path& file, const std::string& model);

}  // namespace thaum::game::inline settings
