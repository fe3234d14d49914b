// game/data/mutator.h: mutators, the files of assets/mutators. Each changes a match by some values that
// replace those of other data files, as the option --set does.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"

namespace thaum::game::inline data {

struct DataChoice;

/// A value that replaces one of a data file.
struct Override {
    std::string value;    ///< file, key path and value: "bolt.shot.damage=12"
    std::string place{};  ///< where it is written, for messages: "assets/mutators/fog.toml:7"; empty: --set
};

/// Contents of assets/mutators/NAME.toml.
struct Mutator {
    std::string name;   ///< name of the file without .toml
    std::string shown;  ///< name in the menu
    std::string words;  ///< one line on what the mutator does
    std::vector<Override> overrides;
};

struct ListedMutator {
    std::string name;        ///< name of the file without .toml
    Expected<Mutator> file;  ///< the file, or its faults
};

/// All mutators of a data folder, sorted by name.
std::vector<ListedMutator> list_mutators(const std::filesystem::path& assets);

/// All overrides of a choice in the order in which they are applied: those of its mutators, then its own.
/// The error names a mutator that does not exist or is named twice, a fault in a file, or two mutators that
/// set one key to different values.
Expected<std::vector<Override>> overrides_of(const std::filesystem::path& assets, const DataChoice& choice);

}  // namespace thaum::game::inline data
