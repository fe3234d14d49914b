// game/settings/jacket_settings.h: reads the players' jackets from the settings file.
#pragma once
#include "core/config.h"
#include "game/settings/settings.h"

namespace thaum::game::inline settings {

/// Reads a player's jacket and its layout. After a fault, which is reported, the player keeps the earlier
/// jacket.
void read_jacket(const ConfigTable& table, PlayerSettings& player);
/// If both players have the same jacket, removes it from the second player and reports this.
void divide_jackets(const ConfigTable& root, Settings& s);

}  // namespace thaum::game::inline settings
