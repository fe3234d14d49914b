// game/match/record.h: a match and its log: what the header says, one recorded tick, and a match played from a log.
#pragma once
#include <filesystem>

#include "game/match/simulation.h"
#include "input/log.h"

namespace thaum::game {

/// The header of a match about to begin. `players` says who plays: "human", "bot 1".
input::LogHeader log_header(const MatchData& data, const MatchSetup& setup, std::vector<std::string> players);

/// What a log keeps of the tick that the match has just had: its frame, and the hashes and marks that are due.
void record_tick(const Simulation& match, const input::InputFrame& frame, input::LogWriter& log);

/// One tick of the match, its frame and what belongs to it into the log (null: not recorded).
void tick_and_record(Simulation& match, const input::InputFrame& frame, input::LogWriter* log);

/// Closes the log with the match's result and the hashes of its last state.
Expected<void> close_log(input::LogWriter& log, const Simulation& match);

/// One line: who has won, how, and the score.
std::string result_line(const Simulation& match);

/// The match that a log's header describes. The error is one line: other rules version, a data file that is
/// missing or has changed (named), impossible values.
Expected<std::unique_ptr<Simulation>> match_of_log(const input::LogHeader& header,
                                                   const std::filesystem::path& assets);

/// A line of warning where the log was recorded with elementary functions that compute other bits than ours; else empty.
std::string probe_warning(const input::LogHeader& header);

}  // namespace thaum::game
