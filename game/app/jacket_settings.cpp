#include "game/app/jacket_settings.h"

#include "core/text.h"
#include "game/app/jacket.h"

namespace thaum::app {

void read_jacket(const ConfigTable& table, PlayerSettings& player) {
    auto words = table.string("jacket", player.jacket);
    if (const auto jacket = parse_jacket(words); !jacket)
        table.report("jacket", text("'jacket': ", jacket.error().message));
    else
        player.jacket = std::move(words);
}

void divide_jackets(const ConfigTable& root, Settings& s) {
    const auto first = parse_jacket(s.players[0].jacket), second = parse_jacket(s.players[1].jacket);
    if (!first || !second || first->link == Jacket::Link::none) return;
    if (!is_same_device(*first, *second)) return;
    root.table(player_tables[1]).report("jacket", "'jacket': it is player 1's; give each player another");
    s.players[1].jacket.clear();
}

}  // namespace thaum::app
