// The precompiled headers of the engine's tests.
#pragma once
#include <gtest/gtest.h>

#include "engine.h"
