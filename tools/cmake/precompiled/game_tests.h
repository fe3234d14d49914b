// The precompiled headers of the game's tests.
#pragma once
#include <gtest/gtest.h>

#include "game.h"
