// game/settings/jacket_settings.h: reads the players' jackets from the settings file.
#pragma once
#include "core/config.h"
#include "game/settings/settings.h"

namespace thaum::app {

/// Reads a player's jacket and its layout. A fault is reported, and the player keeps the former one.
void read_jacket(const ConfigTable& table, PlayerSettings& player);
/// Takes a jacket that both players have from the second one, and reports it.
void divide_jackets(const ConfigTable& root, Settings& s);

}  // namespace thaum::app
