// game/settings/own_pads.h: mappings of pads that players have made, in the file `pads.txt` beside the settings file. A
// line is in the form of SDL's gamecontrollerdb.txt, so lines of that file may be added by hand (input/pad_mapping.h).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"

namespace thaum::app {

/// The file of mappings; empty if there is no settings file.
std::filesystem::path own_pads_file(const std::filesystem::path& settings_file);

struct OwnPads {
    std::vector<std::string> mappings{};  ///< one for each model: the last one of the file
    std::vector<std::string> faults{};    ///< why lines are left out, or the whole file; each with its place
};

/// All mappings for this system. A missing file has none. Byte order mark, blanks round a line, CRLF, empty lines,
/// comments (#) and lines for other systems make no difference.
OwnPads load_own_pads(const std::filesystem::path& file);
/// Keeps a mapping, instead of older ones of the same model. Other lines stay as they are.
Expected<void> save_own_pad(const std::filesystem::path& file, const std::string& mapping);
/// Takes the mappings of a model out of the file. Other lines stay as they are.
Expected<void> forget_own_pad(const std::filesystem::path& file, const std::string& model);

}  // namespace thaum::app
