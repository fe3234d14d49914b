// game/range/force_sample.h: lets a player on the practice range feel what one strength setting of the hand's
// forces (a fader) does: some kicks of a bolt, a blow on a carried thing, or the weight of a thing, scaled by
// the fader.
#pragma once

#include "game/match/simulation.h"

namespace thaum::game::inline range {

class ForceSample {
public:
    /// Whether there are forces to try for this fader, the strength of one kind of force.
    static bool exists_for(input::HandFader fader);

    /// Starts the forces to be tried from the beginning. Does nothing for a fader without such forces.
    void begin(input::HandFader fader);
    bool runs() const { return left_ > 0; }
    /// Applies the forces to be tried. Call this before each tick of play of the player's match.
    void step(Simulation& match, std::uint32_t player);
    /// Text for the player about the forces that are being tried.
    std::string_view words() const;

private:
    input::HandFader fader_{};
    Tick left_{};  ///< ticks until the forces to be tried end; 0: none are being tried
};

}  // namespace thaum::game::inline range
