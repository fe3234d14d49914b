// game/match/tables.h: writes a match as tables for analysis:
//
//     events   one row per event: recorded events, pauses, left out samples, devices that leave or join, marks,
//              the log's end
//     state    one row every N ticks: position, velocity, health, energy and gaze of both players
//     forces   one row per tick: position of each hand's device and the commanded force
//
// The format is CSV as in RFC 4180, except that lines end in LF. The first row names the columns with their
// units. Numbers are the shortest that read back to the same bits, so a table holds exactly the simulation's
// values. The same log gives the same bytes on every run, whatever the locale.
#pragma once
#include <string>

#include "game/match/playback.h"

namespace thaum::game::inline match {

/// The events of a replay. Columns:
///
///     tick     number of ticks played, pauses included (the log's clock)
///     time_s   the same in s; played_s: ticks of play in s
///     kind     an event name of game/data/event_kinds.h, or pause, resume, skip, left, joined,
///              fader, mark, lost, end
///     who      player who caused the event, whose device left or joined, or who moved a fader: 1, 2 or
///              empty
///     whom     player to whom it happened (round_end: the winner)
///     with     wand, cause of a death or of a burst's harm, pad, power-up, ingredient, round,
///              ending of the round or of the log, name of the device or fader, or number of the mark
///     amount   in `unit`: hp, points, m (reach of a burst), m3, J, ticks (skip), percent (fader; 101: the
///              largest force of the data files), events (lost: gone before they could be written)
///     x_m ...  position (world); empty if the event has none
///     note     kind end: the result of the replay in one line
class EventTable {
public:
    static std::string header();
    /// Appends rows for the events of the playback's last step.
    void follow(const Playback& playback, std::string& out);
    /// Appends the last row, with the ending of the log.
    void finish(const Playback& playback, std::string& out);

private:
    void marks_up_to(Tick tick, const Playback& playback, std::string& out);
    void follow_devices(const Playback& playback, std::string& out);
    void follow_faders(const Playback& playback, std::string& out);

    std::uint64_t seen_ = 0;  ///< value of EventJournal::count up to which events have been written
    std::size_t marks_ = 0;
    bool paused_ = false;
    /// For each device, true if it was disconnected at the last step.
    std::array<bool, input::max_devices> away_{};
};

/// Value of the column `with` for an event; empty if it has none.
std::string with_of(const Event& event, const Simulation& match);

/// Header of `append_state`: tick, time_s, played_s, paused, then for player N = 1, 2: pN_x_m ... (body
/// centre), pN_vx_m_s ..., pN_yaw_rad, pN_pitch_rad, pN_dead, pN_health_hp, pN_wand and the energy of each
/// wand.
std::string state_header(const Simulation& match);
/// Appends one row about the present state.
void append_state(const Simulation& match, std::string& out);

/// Header of `append_forces`: tick, time_s, then for player N = 1, 2:
///
///     pN_x_m ...         position of the device's tip after the tick (device frame: x right, y up, z to the
///                        user); for a real arm the position at which the force of this tick was computed
///     pN_fx_n ...        commanded force; the sum of F dx over the rows is the work on the hand
///     pN_cause           why less force was commanded than requested: none, capped, warm, waiting, stale,
///                        over_speed, off, shut_off, panic
///     pN_created_j, pN_given_j   energy that passive sources of force, such as springs and drag, created,
///                        and work of active ones, such as recoil (haptics/energy.h)
///     pN_px_n ...        part of the force by passive sources
///     pN_k_n_per_m, pN_ax_m ...   stiffness of the tether (a spring to the hand) after the tick, 0 without
///                        one, and position of its anchor, the place to which it pulls the hand
///     pN_touches, pN_sx_m ...     1 or 0: contact with a surface, and the contact point of this tick's force
///     pN_arm             1 for a real arm
std::string forces_header();
/// Appends one row about the tick that was just played.
void append_forces(const Simulation& match, std::string& out);

}  // namespace thaum::game::inline match
