// game/settings/recorded_names.h: the names of a recorded match's players, as they were shown during the
// match.
#pragma once
#include "game/data/teams.h"
#include "input/log.h"

namespace thaum::game::inline settings {

/// Adds the shown names to a log's header. If all are empty, nothing is added.
void record_names(const PlayerNames& names, input::LogHeader& header);

/// Names for the replay of a log. Invalid names are left out. Logs of earlier versions have no names: there,
/// in a match of a bot against a person, the bot is "Bot 3" (its level).
PlayerNames recorded_names(const input::LogHeader& header);

}  // namespace thaum::game::inline settings
