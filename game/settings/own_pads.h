// game/settings/own_pads.h: mappings of pads that players have made, in the file `pads.txt` beside the settings file. A
// line is in the form of SDL's gamecontrollerdb.txt, so lines of that file may be added by hand.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"

namespace thaum::app {

/// The file of mappings; empty if there is no settings file.
std::filesystem::path own_pads_file(const std::filesystem::path& settings_file);

/// All mappings of a file, without empty lines and comments (#). A missing file has none. The error: it cannot be read.
Expected<std::vector<std::string>> load_own_pads(const std::filesystem::path& file);
/// Keeps a mapping, instead of an older one of the same model.
Expected<void> save_own_pad(const std::filesystem::path& file, const std::string& mapping);

}  // namespace thaum::app
