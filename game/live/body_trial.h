// game/live/body_trial.h: plays one effect on a player's motors and jacket and on the picture of the body,
// outside of a match, so that the player can feel how strong a setting (fader) makes it. The main thread owns
// it; its frames (strengths of all motors) are laid over those of a match that is paused.
#pragma once
#include <memory>

#include "game/live/body.h"

namespace thaum::game::inline live {

class BodyTrial {
public:
    using Figure = std::array<float, figure_cells>;

    /// `body` and `outputs` outlive this object.
    BodyTrial(const LiveBody& body, LiveTactile& outputs) : body_(body), outputs_(outputs) {}

    /// Plays the first effect of a kind (purpose), and ends the effect that was playing. Returns false if
    /// there is no effect of that kind.
    bool start(std::uint32_t player, tactile::Purpose purpose, const tactile::Faders& faders,
               std::int64_t now_ns);
    /// Makes the frames (strengths of all motors) that are due. Call it at least every tactile::frame_ticks
    /// milliseconds while `runs` is true.
    void step(std::int64_t now_ns);
    bool runs() const { return playing_.has_value(); }
    /// Strength of each cell of the body's picture (0 to 1); all zero if nothing plays.
    const Figure& figure() const { return figure_; }

private:
    struct Playing {
        std::uint32_t player{};
        std::int64_t began_ns{};
        /// tick of the newest frame, counted from `began_ns`; std::nullopt: there is none yet
        std::optional<Tick> mixed{};
        std::unique_ptr<tactile::TactileMixer> figure{}, motors{},
            jacket{};  ///< mixers of the effect for each output; null: the player has no such output
    };

    std::unique_ptr<tactile::TactileMixer> mixer_for(const tactile::Layout& layout, std::uint32_t effect,
                                                     const tactile::Faders& faders) const;

    const LiveBody& body_;
    LiveTactile& outputs_;
    std::optional<Playing> playing_{};
    Figure figure_{};
};

}  // namespace thaum::game::inline live
