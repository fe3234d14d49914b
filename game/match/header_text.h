// game/match/header_text.h: the header of a log in words, for people and scripts.
#pragma once
#include <string>

#include "input/log.h"

namespace thaum::game::inline match {

/// Text with one line for the log file itself, then one line for each value of the header. Each line begins
/// with the name of its value.
std::string header_text(const input::LogReader& log);

}  // namespace thaum::game::inline match
