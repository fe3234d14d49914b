// game/live/replay.h: the simulation thread of a session that shows a replay.
#pragma once
#include "game/live/shared.h"

namespace thaum::game::inline live {

/// Plays the plan's replay as the viewer asks in shared.replay, until shared.stop. At the log's end it waits.
/// Calls `wake` after it has jumped to a tick, so that the main thread notices.
void run_replay(const LivePlan& plan, LiveShared& shared, const std::function<void()>& wake);

}  // namespace thaum::game::inline live
