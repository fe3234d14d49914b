// Menu page: the name, captions and look of one player.
#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

void type_name_of_player(const RowPress& press) {
    auto& s = press.state;
    type(s, Typing::name, s.settings.players[s.player].name);
}

void add_player_rows(const MenuState& s, const MenuContext&, Rows& rows) {
    const auto& player = s.settings.players[s.player];
    const auto& name = player.name.empty() ? std::string("none") : player.name;
    rows.push_back(whose_row(s, "Whose settings"));
    rows.push_back({.look = {.label = "Name",
                             .help = "Stands on the screen instead of the team's name.",
                             .value = s.typing && s.typed == Typing::name ? text(*s.typing, "_") : name},
                    .confirm = type_name_of_player});
    add_player_settings(s, SettingPage::main, rows);
}

/// Resets a player's page. The menu cannot name a jacket or its layout (where its motors sit), so the player
/// keeps both. What the player feels has a page of its own.
std::string reset_player(MenuState& s) {
    const auto felt = feel_of(s.settings, s.player);
    auto& own = s.settings.players[s.player];
    own = PlayerSettings{.jacket = std::move(own.jacket), .jacket_layout = std::move(own.jacket_layout)};
    use(felt, s.settings, s.player);
    return text(player_words(s.settings, s.player), ": settings");
}

const PageRegistration player_page{{
    .name = "player",
    .title = [](const MenuState&, const MenuContext&) { return std::string("Each player's own settings"); },
    .add_rows = add_player_rows,
    .reset = reset_player,
}};

}  // namespace
}  // namespace thaum::game::inline menu
