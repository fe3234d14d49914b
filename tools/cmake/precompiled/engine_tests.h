// The headers that most sources of the engine's tests include, compiled once.
#pragma once
#include <gtest/gtest.h>

#include "engine.h"
