// game/app/live_tactile.h: the tactile outputs of a live session: the motors of each player's pad.
//
// The main thread owns a LiveTactile and tells which pad each player uses. The thread that plays a match passes a frame
// of the layout `pad` for each player every 8 ms. Without pads nothing runs. A pad without motors costs one line.
#pragma once
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "game/app/settings.h"
#include "game/components/wizard.h"
#include "input/rumble.h"
#include "input/tactile_player.h"
#include "render/context.h"

namespace thaum::app {

class LiveTactile {
public:
    using MakeOutput = std::function<std::unique_ptr<input::TactileOutput>(const input::PadId&)>;
    /// Tests pass a maker of fakes.
    explicit LiveTactile(MakeOutput make = input::rumble_output);

    // The main thread. All may be called during a match.
    void apply(const Settings& settings);
    /// Gives a player the motors of a pad; nothing happens if the player has them. Null, a pad that is
    /// not plugged in, or one without a guid: none.
    void use_pad(std::uint32_t player, const render::PadState* pad);
    /// Prints the state of each player's motors if it has changed for the worse or back.
    void tell_status();
    input::TactileReport report(std::uint32_t player) const;

    // The thread of a match.
    /// Whether a player's motors run at present. Frames for others need not be made.
    bool feels(std::uint32_t player) const;
    /// Passes a frame of the layout `pad`. Never waits. Without further frames the motors stop after its time to live.
    void feel(std::uint32_t player, const tactile::TactileFrame& frame);

private:
    struct Seat {
        std::optional<input::PadId> pad{};
        std::unique_ptr<input::TactilePlayer> own{};  ///< made for the first pad, and kept
        std::atomic<input::TactilePlayer*> player{};  ///< `own`, for the thread of a match
        std::atomic<bool> plays{};                    ///< the player has a pad
        std::atomic<float> gain{};
        std::string told{};  ///< the state that was printed last
    };

    MakeOutput make_;
    std::array<Seat, game::players> seats_{};
};

}  // namespace thaum::app
