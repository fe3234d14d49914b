// game/match/header_text.h: the header of a log in words, for people and scripts.
#pragma once
#include <string>

#include "input/log.h"

namespace thaum::game {

/// A line for each value of the header, after a line about the file itself. A line begins with the name of the value.
std::string header_text(const input::LogReader& log);

}  // namespace thaum::game
