// game/live/menu_choices.h: choices that the menu offers because the data folder has files for them: bots,
// lengths of a match, arenas and mutators.
#pragma once
#include "game/live/live.h"
#include "game/menu/menu.h"

namespace thaum::game::inline live {

/// Choices of the menu. The rules and the arena of the command line are among them.
MenuContext find_menu_context(const LivePlan& plan);

/// All arenas of a data folder, sorted by name. One whose file cannot be read, or that has the name of
/// another one, is among them with its fault.
std::vector<MenuContext::Named> arena_choices(const std::filesystem::path& assets);

/// Label of a name in a list of the menu; the name itself if it is missing.
std::string label_of(const std::vector<MenuContext::Named>& list, const std::string& name);

/// Index of a name in a list of the menu; 0 if it is missing.
std::size_t index_of(const std::vector<MenuContext::Named>& list, const std::string& name);

}  // namespace thaum::game::inline live
