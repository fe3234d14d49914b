// game/match/tables.h: a match as three tables for people who compute with it.
//
//     events   one row for each thing that happened: what the match records, pauses, samples left out, marks, the log's end
//     state    one row for every N ticks: both players' place, speed, health, energy and gaze
//     forces   one row for every tick: where each hand's device was and what it was told
//
// CSV as of RFC 4180 but for the line ends, which are LF; the first row names the columns with their units. Numbers are
// the shortest that read back to the same bits, so a table says exactly what the simulation had, and the same log gives
// the same bytes on every run. No locale.
#pragma once
#include <string>
#include <string_view>

#include "game/match/playback.h"

namespace thaum::game {

/// Adds the field, in quotes where it needs them.
void append_csv(std::string& row, std::string_view field);

/// The events of a replay. Columns:
///
///     tick     of the log's clock, pauses included: after that many ticks it had happened
///     time_s   the same in s; played_s: of the match's clock
///     kind     a name of game/components/match.h, or pause, resume, skip, mark, lost, end
///     who      player who did it: 1, 2 or nobody; whom: player to whom it was done (round_end: who has won)
///     with     the wand, the cause of a death, what a burst hurts by, the pad of a resurrection, how the round or the log ended, the mark's number
///     amount   in `unit`: hp, m (burst: how far it reaches), ticks (skip), events (lost: more came in one tick than a match keeps)
///     x_m ...  where; empty for what has no place
///     note     of an end: the result of the replay, in a line
class EventTable {
public:
    static std::string header();
    /// Adds rows for what the last step of the playback brought.
    void follow(const Playback& playback, std::string& out);
    /// Adds the last row: how the log ends.
    void finish(const Playback& playback, std::string& out);

private:
    void marks_up_to(Tick tick, const Playback& playback, std::string& out);

    std::uint64_t seen_ = 0;  ///< of Chronicle::count
    std::size_t marks_ = 0;
    bool paused_ = false;
};

/// The columns of `append_state`: tick, time_s, played_s, paused, and for each player 1 and 2 pN_x_m (of the body's
/// centre) ..., pN_vx_m_s, pN_yaw_rad, pN_pitch_rad, pN_dead, pN_health_hp, pN_wand and an energy of each wand.
std::string state_header(const Simulation& match);
/// One row of the state now.
void append_state(const Simulation& match, std::string& out);

/// The columns of `append_forces`: tick, time_s, and for each player pN_x_m, pN_y_m, pN_z_m (of the device's tip after the tick, in
/// its own frame: x right, y up, z to the user), pN_fx_n ... (what it was told in the tick) and pN_cause (why it was told less than
/// was asked for: none, capped, warm, waiting, stale, over_speed, off, shut_off, panic). The sum of F dx over the rows is the
/// work done on the hand. Then, for books of energy by source (haptics/energy.h): pN_created_j and pN_given_j, what the observer
/// has; pN_px_n ..., the passive sources' part of the force; pN_k_n_per_m and pN_ax_m ..., the stiffness of what the hand hangs on after
/// the tick (0: nothing) and where that is; pN_touches (1 or 0) and pN_sx_m ..., where on a surface the tip was held for this tick's
/// force; pN_arm, 1 for a real one: its place is then that at which this tick's force was computed, not where it led.
std::string forces_header();
/// One row of the tick that was just played.
void append_forces(const Simulation& match, std::string& out);

}  // namespace thaum::game
