// game/bots/bot_file.h: the bots that can be chosen: the files of assets/bots.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"
#include "core/error.h"
#include "game/bots/bot.h"

namespace thaum::game::inline bots {

/// Ways of playing that a bot's file may name. They are shown; what a bot does is said by its numbers.
inline constexpr std::array<std::string_view, 3> bot_styles{"brawler", "alchemist", "sculptor"};
/// Largest length of a bot's shown name (characters): that of players' names.
inline constexpr std::size_t longest_bot_name = 16;
/// Largest number of bases of a bot: files of which each is based on the next.
inline constexpr std::size_t most_bases = 4;

/// Contents of assets/bots/NAME.toml. A file that says `base = "OTHER"` has only what differs from
/// bots/OTHER.toml, also in its tables.
struct BotFile {
    std::string name;   ///< name of the file without .toml
    std::string shown;  ///< name in the menu and on the screen
    std::string_view style;
    std::string words;  ///< one line on how the bot plays
    BotSkill skill;
};

struct ListedBot {
    std::string name;        ///< name of the file without .toml
    Expected<BotFile> file;  ///< the file, or its faults
};

/// All bots of a data folder, in the order in which they are offered: by level, the weakest first, then by
/// name. Those whose files have faults come last.
std::vector<ListedBot> list_bots(const std::filesystem::path& assets);

/// Name of the bot that a word means: the name itself, or a level, which means the first bot of that level.
/// The error names all bots.
Expected<std::string> bot_named(const std::filesystem::path& assets, std::string_view word);
/// Name of the last bot of list_bots whose file has no fault.
Expected<std::string> strongest_bot(const std::filesystem::path& assets);

/// Loads the bot that a word means (bot_named). The error names file, line and key.
Expected<BotFile> load_bot(const std::filesystem::path& assets, std::string_view word);
/// Loads the skill alone of the bot that a word means.
Expected<BotSkill> load_bot_skill(const std::filesystem::path& assets, std::string_view word);

/// Reads the part of a skill that concerns aiming and shooting, from the file of a bot or of the practice
/// range: reaction_s, aim_error_deg, turn_deg_per_s, view_deg, burst_s, rest_s, range_m.
BotSkill read_marksmanship(const ConfigTable& table);

}  // namespace thaum::game::inline bots
