// game/live/body_trial.h: plays one effect on a player's motors, jacket and figure, outside of a match,
// so that the player can feel how strong a fader makes it. The main thread owns it; frames are laid
// over those of a match that is paused.
#pragma once
#include <memory>

#include "game/live/body.h"

namespace thaum::game::inline live {

class BodyTrial {
public:
    using Figure = std::array<float, game::figure_cells>;

    /// `body` and `outputs` outlive this object.
    BodyTrial(const LiveBody& body, LiveTactile& outputs) : body_(body), outputs_(outputs) {}

    /// Plays the first effect of a purpose, and ends an earlier trial. Returns false if there is no such
    /// effect.
    bool start(std::uint32_t player, tactile::Purpose purpose, const tactile::Faders& faders,
               std::int64_t now_ns);
    /// Makes the frames that are due. Call it at least every tactile::frame_ticks while `runs`.
    void step(std::int64_t now_ns);
    bool runs() const { return playing_.has_value(); }
    /// Cells of the figure, 0 to 1; all zero if nothing plays.
    const Figure& figure() const { return figure_; }

private:
    struct Playing {
        std::uint32_t player{};
        std::int64_t began_ns{};
        std::optional<Tick> mixed{};  ///< tick of the last frame
        std::unique_ptr<tactile::TactileMixer> figure{}, motors{},
            jacket{};  ///< null: the player has no such output
    };

    std::unique_ptr<tactile::TactileMixer> mixer_for(const tactile::Layout& layout, std::uint32_t effect,
                                                     const tactile::Faders& faders) const;

    const LiveBody& body_;
    LiveTactile& outputs_;
    std::optional<Playing> playing_{};
    Figure figure_{};
};

}  // namespace thaum::game::inline live
