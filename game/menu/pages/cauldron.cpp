// Menu page: strengths (faders) of the forces that the cauldron's brew has on one player's hand.
#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

void switch_fader(const RowPress& press) {
    auto& fader = press.state.settings.cauldron[press.state.player][press.row.index];
    fader.on = !fader.on;
}

void turn_fader(const RowPress& press, int way) {
    change(press.state.settings.cauldron[press.state.player][press.row.index], way);
}

void add_cauldron_rows(const MenuState& s, const MenuContext&, Rows& rows) {
    rows.push_back(whose_row(s, "Whose hand"));
    const auto& faders = s.settings.cauldron[s.player];
    for (std::size_t i = 0; i < faders.size(); ++i)
        rows.push_back({.look = {.label = std::string(label_of_fader(i)),
                                 .help = std::string(effect_of_fader(i)),
                                 .value = shown(faders[i]),
                                 .adjustable = true,
                                 .dim = !faders[i].on},
                        .confirm = switch_fader,
                        .turn = turn_fader,
                        .index = i});
}

std::string reset_cauldron(MenuState& s) {
    s.settings.cauldron[s.player] = {};
    return text(player_words(s.settings, s.player), ": cauldron feedback");
}

const PageRegistration cauldron_page{{
    .name = "cauldron",
    .title = [](const MenuState&, const MenuContext&) { return std::string("Cauldron feedback"); },
    .add_rows = add_cauldron_rows,
    .reset = reset_cauldron,
    .line =
        [](const MenuState& s, const MenuContext&, const Row&) {
            return text("what the hand of ", player_words(s.settings, s.player), " feels while it stirs");
        },
    .hint =
        [](const MenuState&, const MenuContext&, const Row&) {
            return std::string(
                "less, more: arrows    off, on: Enter, A, click on its name    back: Esc, B, right button");
        },
}};

}  // namespace
}  // namespace thaum::game::inline menu
