// game/match/data.h: all that a match reads from files, loaded and checked once.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "game/arena/arena.h"
#include "game/cauldron/brew.h"
#include "game/match/rules.h"
#include "game/wands/wand.h"
#include "haptics/device.h"

namespace thaum::game {

struct DataChoice {
    std::string arena = "boiling_court";
    std::string rules = "thaum";           ///< the rule set: thaum or classic
    std::string match = "quick";           ///< how long it is: quick or standard
    std::vector<std::string> overrides{};  ///< "bolt.shot.damage=12": file, key path, value
};

/// A file that can change the match, for the log.
struct DataFile {
    std::string name;  ///< from the assets folder: "wands/bolt.toml"
    std::uint64_t hash{};
};

struct MatchData {
    DataChoice choice;
    Arena arena;
    RoundRules round;  ///< with what the rule set switches
    RuleSet rules;
    WizardRules wizard;
    TouchRules touch;
    haptics::DeviceSpec device;             ///< that hands hold
    std::optional<CauldronRules> cauldron;  ///< none where the rule set has none, or the arena no bowl
    std::vector<LoadedWand> wands;          ///< by name of kind; with what the rule set switches
    std::vector<DataFile> files;
};

/// The error names file, line and key.
Expected<MatchData> load_match_data(const std::filesystem::path& assets, const DataChoice& choice);

/// Where the assets are: $THAUM_ASSETS, else beside the program, else where it was built or installed.
std::filesystem::path find_assets();

}  // namespace thaum::game
