// game/settings/recorded_names.h: names of a recorded match's players, as its players saw them on the screen.
#pragma once
#include "game/data/teams.h"
#include "input/log.h"

namespace thaum::app {

/// Adds the names on the screen to a log's header, which lists none if all are empty.
void record_names(const game::PlayerNames& names, input::LogHeader& header);

/// Names for the replay of a log. A name that no player could have is left out. Logs of earlier versions have no names:
/// then a bot against a person is "Bot 3".
game::PlayerNames recorded_names(const input::LogHeader& header);

}  // namespace thaum::app
