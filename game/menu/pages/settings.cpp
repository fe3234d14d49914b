// Menu page: settings of the picture, of words and of recordings, and links to the pages below it.
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

void add_setting_rows(const MenuState& s, const MenuContext&, Rows& rows) {
    add_settings(s, SettingPage::main, rows);
    rows.push_back(
        link_to("sound", "Sound", "Changes how loud effects, music and menus are, and for whose ears."));
    rows.push_back(link_for_player("player", "Each player's own settings",
                                   "Changes a player's name, captions and look."));
    rows.push_back(
        link_for_player(page_name::mixer, "Forces and body",
                        "Mixes what each player's hand and body feel, and keeps mixes as profiles."));
}

const PageRegistration settings_page{{
    .name = "settings",
    .title = [](const MenuState&, const MenuContext&) { return std::string("Settings"); },
    .add_rows = add_setting_rows,
    .reset = [](MenuState& s) { return reset_settings(s, SettingPage::main); },
}};

}  // namespace
}  // namespace thaum::game::inline menu
