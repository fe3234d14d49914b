// game/live/fader_input.h: turns a player's settings into moves of faders, which are input of a match: one
// move for each tick until the match has what the player wants. The main thread states the wish at any time.
// The simulation thread takes the moves.
#pragma once
#include <atomic>

#include "input/frame.h"

namespace thaum::game::inline live {

class FaderInput {
public:
    using Values = std::array<std::uint8_t, input::hand_faders>;

    /// A match begins, whose log's header has the values `at_start`. No other thread may use this meanwhile.
    void begin_match(const Values& at_start) { given_ = at_start; }

    // The main thread.
    void want(const Values& values) {
        for (std::size_t i = 0; i < values.size(); ++i) wanted_[i] = values[i];
    }

    // The simulation thread.
    /// The next move, or none.
    input::FaderChange take() {
        for (std::size_t i = 0; i < given_.size(); ++i) {
            const std::uint8_t wanted = wanted_[i];
            if (wanted == given_[i]) continue;
            given_[i] = wanted;
            return {static_cast<std::uint8_t>(i + 1), wanted};
        }
        return {};
    }

    /// Notes a move that the match has from elsewhere, or none.
    void note(const input::FaderChange& change) {
        if (change.fader != 0) given_.at(change.fader - 1U) = change.percent;
    }

private:
    std::array<std::atomic<std::uint8_t>, input::hand_faders> wanted_{};
    Values given_{};  ///< values that the match has
};

}  // namespace thaum::game::inline live
