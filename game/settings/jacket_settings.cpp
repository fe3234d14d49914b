#include "game/settings/jacket_settings.h"

#include "core/one_line.h"
#include "core/text.h"
#include "game/jackets/jacket.h"

namespace thaum::game::inline settings {

void read_jacket(const ConfigTable& table, PlayerSettings& player) {
    auto words = table.string("jacket", player.jacket);
    if (const auto jacket = parse_jacket(words); !jacket)
        table.report("jacket", text("'jacket': ", jacket.error().message));
    else
        player.jacket = std::move(words);
    auto layout = table.string("jacket_layout", player.jacket_layout);
    constexpr std::size_t longest = 1000;  // largest length of the layout's name or path (bytes)
    if (layout.size() > longest || printable(layout, layout.size()) != layout)
        table.report("jacket_layout", "'jacket_layout': write a layout's name, or the path of its file");
    else
        player.jacket_layout = std::move(layout);
}

void divide_jackets(const ConfigTable& root, Settings& s) {
    const auto first = parse_jacket(s.players[0].jacket), second = parse_jacket(s.players[1].jacket);
    if (!first || !second || !*first || !is_same_device(*first, *second)) return;
    root.table(player_tables[1]).report("jacket", "'jacket': it is player 1's; give each player another");
    s.players[1].jacket.clear();
}

}  // namespace thaum::game::inline settings
