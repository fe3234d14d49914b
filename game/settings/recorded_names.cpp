#include "game/settings/recorded_names.h"

#include <algorithm>

#include "core/text.h"
#include "game/settings/player_name.h"

namespace thaum::game::inline settings {
namespace {

constexpr std::string_view bot = "bot ";

/// Level of a bot from the description of a player in a log; empty for a person, and for any other text.
std::string_view level_of(std::string_view player) {
    if (!player.starts_with(bot)) return {};
    player.remove_prefix(bot.size());
    const bool digit = player.size() == 1 && player[0] >= '0' && player[0] <= '9';
    return digit ? player : std::string_view();
}

}  // namespace

void record_names(const PlayerNames& names, input::LogHeader& header) {
    header.names.clear();
    const bool any =
        std::any_of(names.begin(), names.end(), [](const std::string& name) { return !name.empty(); });
    if (any) header.names.assign(names.begin(), names.end());
}

PlayerNames recorded_names(const input::LogHeader& header) {
    PlayerNames names;
    for (std::size_t p = 0; p < std::min(names.size(), header.names.size()); ++p)
        names[p] = player_name(header.names[p]).value_or(std::string());
    if (!header.names.empty() || header.players.size() != names.size()) return names;
    for (std::size_t p = 0; p < names.size(); ++p) {
        const auto level = level_of(header.players[p]);
        if (!level.empty() && header.players[1 - p] == "human") names[p] = text("Bot ", level);
    }
    return names;
}

}  // namespace thaum::game::inline settings
