// game/match/record.h: connects a match and its log: makes the log's header, records ticks, and makes a match
// from a log.
#pragma once
#include <filesystem>

#include "game/match/simulation.h"
#include "input/log.h"

namespace thaum::game::inline match {

/// Number of ticks recorded after the end of a match, so that a replay shows how it ends.
inline constexpr Tick log_after_end = 500;

/// Log header of a match that is about to begin. `players` describes the players: "human", "bot 1".
input::LogHeader log_header(const MatchData& data, const MatchSetup& setup, std::vector<std::string> players);

/// Writes the input frame of the tick that the match has just played to the log. When they are due, also
/// writes the hashes, and the mark of a keyframe (a tick whose state can be saved).
void record_tick(const Simulation& match, const input::InputFrame& frame, input::LogWriter& log);

/// Plays one tick and writes it to the log. A null log records nothing.
void tick_and_record(Simulation& match, const input::InputFrame& frame, input::LogWriter* log);

/// Closes the log with the match's result and the hashes of its last state.
Expected<void> close_log(input::LogWriter& log, const Simulation& match);

/// The result in one line: who has won, how, and the score. Names in `winner_names` that are not empty
/// replace "player 1" and "player 2". The end block of a log uses no such names.
std::string result_line(const Simulation& match, const std::array<std::string, players>& winner_names = {});

/// Creates the match that a log's header describes. The error is one line: another rules version, the name of
/// a missing or changed data file, impossible values, or a kind (such as a wand) with another number here.
Expected<std::unique_ptr<Simulation>> match_of_log(const input::LogHeader& header,
                                                   const std::filesystem::path& assets);

/// A one-line warning if the log was recorded with mathematical functions (sin, exp) whose results differ in
/// some bits, or with another version of Bullet; else empty.
std::string build_warning(const input::LogHeader& header);

}  // namespace thaum::game::inline match
