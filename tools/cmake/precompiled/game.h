// The engine's precompiled headers, and the headers of the game's lowest floors, which most sources of the game include.
#pragma once
#include "engine.h"

#include "ecs/schedule.h"
#include "ecs/world.h"
#include "game/context/match_context.h"
#include "game/match/simulation.h"
