// Menu page: settings of the sounds.
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

const PageRegistration sound_page{{
    .name = "sound",
    .title = [](const MenuState&, const MenuContext&) { return std::string("Sound"); },
    .add_rows = [](const MenuState& s, const MenuContext&,
                   Rows& rows) { add_settings(s, SettingPage::sound, rows); },
    .reset = [](MenuState& s) { return reset_settings(s, SettingPage::sound); },
    .line = [](const MenuState&, const MenuContext& context, const Row&) { return context.sound; },
}};

}  // namespace
}  // namespace thaum::game::inline menu
