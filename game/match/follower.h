// game/match/follower.h: helps code that looks at a match every few ticks to make sounds or effects from it.
#pragma once
#include <cmath>

#include "game/match/simulation.h"

namespace thaum::game::inline match {

/// Share of full health below which players hear and feel their own heart.
inline constexpr double loud_heart_health = 0.25;

/// Place of a reader, which is code that follows a match, in that match: the tick of its last look, and the
/// events that it has seen.
class MatchFollower {
public:
    /// Whether the match has simply played on since the last look(). False before the first one, after a jump
    /// of the clock, and for a match that was changed otherwise.
    bool goes_on(const Simulation& match) const;
    /// Whether look() has been called before.
    bool has_begun() const { return begun_; }
    /// Notes that the caller has read the match up to its present tick.
    void look(const Simulation& match);
    /// Lets each_event leave out the events up to now.
    void skip_events(const Simulation& match) { events_seen_ = match.events().count(); }
    /// Calls f(event) for each event since the last look.
    template <class F>
    void each_event(const Simulation& match, F f) {
        match.events().each_new(events_seen_, f);
    }

private:
    bool begun_ = false;
    Tick tick_{};
    std::uint64_t events_seen_{};  ///< number of the first event that has not been read yet
};

/// Counts the steps of a walking wizard, by the distance walked.
struct Stride {
    static constexpr double length = 1.5;  ///< distance between two steps (m)

    double walked{};  ///< distance since the last step (m)

    /// Adds the distance walked in `dt` seconds. Returns whether a step is completed.
    bool walks(const Stance& stance, const Motion& motion, double dt) {
        if (stance.grounded == 0) return false;
        walked += std::hypot(motion.velocity.x, motion.velocity.z) * dt;
        if (!(walked > length)) return false;
        walked = 0;
        return true;
    }
};

}  // namespace thaum::game::inline match
