// game/data/match_data.h: all data that a match reads from files, loaded and checked once.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/arena/arena.h"
#include "game/arena/look.h"
#include "game/data/casting_rules.h"
#include "game/data/cauldron_rules.h"
#include "game/data/crystal_rules.h"
#include "game/data/gesture_set.h"
#include "game/data/orb_rules.h"
#include "game/data/presentation.h"
#include "game/data/recipe.h"
#include "game/data/rules.h"
#include "game/data/spell.h"
#include "game/data/wand.h"
#include "haptics/device.h"
#include "input/log.h"

namespace thaum::game::inline data {

/// Names that select the data of a match.
struct DataChoice {
    std::string arena = "boiling_court";
    std::string rules = "thaum";  ///< rule set: a file of assets/rules (rule_sets)
    std::string match = "quick";  ///< length of the match: another file of assets/rules (match_lengths)
    /// Mutators, files of assets/mutators, in the order in which they are applied; before `overrides`.
    std::vector<std::string> mutators{};
    /// Values that replace those of data files, such as "bolt.shot.damage=12": file, key path, value.
    std::vector<std::string> overrides{};
    /// Names of the files that may be read, as LogHeader::files has them, so that a file added since a
    /// recording does not change its match; std::nullopt: all. It concerns the folders of which a match reads
    /// every file: gestures, potions, spells and wands.
    std::optional<std::vector<std::string>> files{};
};

struct MatchData {
    DataChoice choice;
    Arena arena;
    ArenaLook look;    ///< light, sky and decoration with which pictures show the arena
    RoundRules round;  ///< rules of rounds, with the changes that the rule set makes
    RuleSet rules;
    WizardRules wizard;
    HapticRules haptic_rules;
    haptics::DeviceSpec device;  ///< device that simulated hands hold
    /// Rules of the cauldron; std::nullopt if the rule set has no cauldron, or the arena no bowl.
    std::optional<CauldronRules> cauldron;
    /// Rules of crystals; std::nullopt if the rule set has no cauldron, or the arena no crystal.
    std::optional<CrystalRules> crystal;
    std::vector<Recipe>
        recipes;  ///< recipes of potions, sorted by name; empty without a cauldron or gestures
    /// Rules of the orb; std::nullopt if the rule set has no cauldron or no spells, or if the arena has no
    /// orb.
    std::optional<OrbRules> orb;
    /// Wands, with the changes that the rule set makes: first those whose files have the names of their
    /// kinds, then the others, both sorted by name.
    std::vector<LoadedWand> wands;
    /// Gestures of assets/gestures. Empty if the rule set has no spells.
    std::shared_ptr<const GestureSet> gestures;
    std::optional<CastingRules> casting;
    /// Spells, sorted as the wands are. A spell's number is its index here.
    std::vector<LoadedSpell> spells;
    /// The effects of all lists: of potions, spells, power-ups, the orb and crystals, by their numbers.
    std::vector<ListedEffect> effects;
    std::shared_ptr<const Presentation> presentation;  ///< how the match is shown; never null after loading
    /// Values that replaced those of data files, by mutators and by the choice's overrides, in order.
    std::vector<std::string> overrides{};
    /// All files that affect a match, each with the hash of its values before overrides.
    std::vector<input::DataFile> files;
};

/// The spell that a gesture casts; null if the gesture casts none.
const LoadedSpell* spell_of(const MatchData& data, std::string_view gesture);

/// Name of a data file in messages, with the name of its folder: "assets/wands/bolt.toml".
std::string shown_path(const std::filesystem::path& assets, std::string_view name);

/// Loads and checks all data of a match. The error names file, line and key of the first fault, and has one
/// more line for every other fault.
Expected<MatchData> load_match_data(const std::filesystem::path& assets, const DataChoice& choice);

/// Data that was read in spite of faults, so that names in it can be checked. It must not be used for a match
/// if there is an error.
struct MatchReading {
    MatchData data;
    std::optional<Error> error{};
};
MatchReading read_match_data(const std::filesystem::path& assets, const DataChoice& choice);

/// Folder of the assets: $THAUM_ASSETS if that is set, else the folder that belongs to the program.
std::filesystem::path find_assets();
/// Folder of the assets that belong to the program: found relative to the program (in a build tree or an
/// installation), else "assets" in the current folder.
std::filesystem::path shipped_assets();

}  // namespace thaum::game::inline data
