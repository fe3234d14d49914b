// game/range/force_sample.h: lets a player of the range feel one fader of the forces: some kicks of a bolt, a blow on a
// carried thing, or the weight of a thing, as strong as the fader lets them be.
#pragma once

#include "game/match/simulation.h"

namespace thaum::app {

class ForceSample {
public:
    /// Whether there is something to feel for a fader.
    static bool exists_for(input::HandFader fader);

    /// Begins anew. Nothing happens for a fader without a sample.
    void begin(input::HandFader fader);
    bool runs() const { return left_ > 0; }
    /// Acts before a tick of play of the player's match.
    void step(game::Simulation& match, std::uint32_t player);
    /// Words for the player.
    std::string_view words() const;

private:
    input::HandFader fader_{};
    Tick left_{};  ///< ticks to the end; 0: nothing plays
};

}  // namespace thaum::app
