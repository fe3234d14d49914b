// The engine's precompiled headers, and those headers of the game's lowest libraries that most sources of the
// game include.
#pragma once
#include "engine.h"

#include "ecs/schedule.h"
#include "ecs/world.h"
#include "game/context/match_context.h"
#include "game/match/simulation.h"
