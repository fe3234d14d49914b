// The headers that most sources of the game's tests include, compiled once.
#pragma once
#include <gtest/gtest.h>

#include "game.h"
