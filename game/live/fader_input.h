// game/live/fader_input.h: turns a player's settings into changes of faders (the strengths of the forces at
// the hand), which are input of a match: one change in each tick until the match has all values that the
// player wants. The main thread sets the wanted values at any time. The simulation thread takes the changes.
#pragma once
#include <atomic>

#include "input/frame.h"

namespace thaum::game::inline live {

class FaderInput {
public:
    using Values = std::array<std::uint8_t, input::hand_faders>;

    /// Begins a match whose faders (strengths of forces) have the values `at_start`, which the header of its
    /// log records. No other thread may use this object meanwhile.
    void begin_match(const Values& at_start) { given_ = at_start; }

    /// Called by the main thread: sets the values that the player wants.
    void want(const Values& values) {
        for (std::size_t i = 0; i < values.size(); ++i) wanted_[i] = values[i];
    }

    /// Called by the simulation thread: returns the next change of a fader that the match must get; none if
    /// the match has all wanted values.
    input::FaderChange take() {
        for (std::size_t i = 0; i < given_.size(); ++i) {
            const std::uint8_t wanted = wanted_[i];
            if (wanted == given_[i]) continue;
            given_[i] = wanted;
            return {static_cast<std::uint8_t>(i + 1), wanted};
        }
        return {};
    }

    /// Notes a change of a fader that the match got in another way, so that `take` need not repeat it.
    /// Nothing happens if `change` is none.
    void note(const input::FaderChange& change) {
        if (change.fader != 0) given_.at(change.fader - 1U) = change.percent;
    }

private:
    std::array<std::atomic<std::uint8_t>, input::hand_faders> wanted_{};
    Values given_{};  ///< values of the faders in the match, as far as changes were taken or noted
};

}  // namespace thaum::game::inline live
