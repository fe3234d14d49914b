// game/live/tactile.h: the tactile outputs of a live session: the motors of each
// player's pad, and each player's jacket.
//
// The main thread owns a LiveTactile and tells it which pad each player uses; the settings name the jackets.
// The thread that plays a match passes frames for each player every 8 ms: one of the layout `pad`, and one of
// the jacket's layout. Without pads and jackets nothing runs. One line reports an output that cannot be
// opened.
#pragma once
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "game/components/wizard.h"
#include "game/jackets/jacket.h"
#include "game/live/told_state.h"
#include "game/settings/settings.h"
#include "input/rumble.h"
#include "input/tactile_player.h"

namespace thaum::game::inline live {

/// Name of a layout (the places of the motors of a jacket) that a player has written. Its number of motors is
/// 0 here, because it differs by player (own_motors).
inline constexpr JacketLayout own_layout{"own", 0};

class LiveTactile {
public:
    using MakeOutput = std::function<std::unique_ptr<input::TactileOutput>(const input::PadState&)>;
    using MakeJacket =
        std::function<std::unique_ptr<input::TactileOutput>(const Jacket&, std::uint32_t player)>;
    /// `make` opens the motors of a pad, and `make_jacket` a jacket. Tests pass makers of fakes.
    explicit LiveTactile(MakeOutput make = input::rumble_output, MakeJacket make_jacket = jacket_output);

    // Called by the main thread, before the first match.
    /// Notes that the player has written a layout with `motors` actuators for the jacket.
    void use_own_layout(std::uint32_t player, std::size_t motors);

    // Called by the main thread, also during a match.
    /// Applies the strengths of motors, and connects jackets whose settings have changed.
    void apply(const Settings& settings);
    /// Gives a player the motors of a pad; nothing happens if the player has them. Null, or a pad that is not
    /// plugged in or has no device file: none.
    void use_pad(std::uint32_t player, const input::PadState* pad);
    /// Prints the state of each player's motors and jacket when they stop working or work again.
    void tell_status();
    /// State of a player's jacket in one sentence; empty: the player has none.
    std::string jacket_state(std::uint32_t player) const;
    input::TactileReport report(std::uint32_t player) const;
    input::TactileReport jacket_report(std::uint32_t player) const;
    /// Plays a frame (strengths of all motors) together with those of a match, so that a player feels an
    /// effect that is being tried out.
    void try_out(std::uint32_t player, const tactile::TactileFrame& frame);
    void try_out_jacket(std::uint32_t player, const tactile::TactileFrame& frame);

    /// Strengths (faders) of the kinds of effect, as a player has set them for motors and for the jacket.
    tactile::Faders faders(std::uint32_t player) const;

    // Called by the thread of a match, and by the main thread while it tries an effect.
    /// Whether the motors of a player's pad can play at present. If not, no frames need be made for them.
    bool feels(std::uint32_t player) const;
    /// Passes a frame for the motors of the player's pad. Never waits. If no other frame follows, the motors
    /// stop when the frame's time to live is over.
    void feel(std::uint32_t player, const tactile::TactileFrame& frame);
    /// Whether a player's settings name a jacket, open or not.
    bool has_jacket(std::uint32_t player) const { return seats_.at(player).jacket.plays; }
    /// Name of the layout (a file of assets/tactile/layouts) of a player's connected jacket. Empty if the
    /// jacket is not connected: then no frames (strengths of its motors) need be made.
    std::string_view jacket_layout(std::uint32_t player) const;
    /// Whether a player's view shows the figure of a body, which lights up where the player feels something.
    bool shows_figure(std::uint32_t player) const { return seats_.at(player).figure; }
    /// The player's settings for sounds on the jacket.
    FeltSoundWish felt_sound(std::uint32_t player) const;
    /// Passes a frame (strengths of all motors) to the jacket, as `feel` does. A frame of another number of
    /// actuators is dropped: the jacket has just been changed.
    void feel_jacket(std::uint32_t player, const tactile::TactileFrame& frame);

private:
    /// Connection to an output, motors of a pad or a jacket, that may be replaced or be missing.
    struct Socket {
        /// plays frames (strengths of all motors) on the output; made for the first output, and kept for
        /// later ones
        std::unique_ptr<input::TactilePlayer> own{};
        std::atomic<input::TactilePlayer*> player{};  ///< the object in `own`, for the thread of a match
        std::atomic<bool> plays{};                    ///< true: there is an output
        ToldState told{};

        void use(std::unique_ptr<input::TactileOutput> output);
        bool is_open() const { return plays && player.load()->is_open(); }
        void tell_status(std::size_t number);
        input::TactileReport report() const;
    };
    struct Seat {
        std::string pad{};  ///< device file of the pad; empty: none
        Socket motors{};
        std::atomic<float> gain{};
        std::array<std::atomic<double>, tactile::purpose_count> faders{};
        std::string jacket_words{};  ///< the player's setting `jacket`, which names maker and place
        Socket jacket{};
        std::atomic<const JacketLayout*> layout = &no_layout;
        std::size_t own_motors{};  ///< actuators of the player's own layout; 0: there is none
        std::atomic<bool> figure{};
        std::atomic<double> sound{};
        std::atomic<FeltGroups> sound_of{};
    };
    void use_jacket(std::uint32_t player, const std::string& words);
    static std::size_t motors_of_seat(const Seat& seat);

    MakeOutput make_;
    MakeJacket make_jacket_;
    std::array<Seat, players> seats_{};
};

}  // namespace thaum::game::inline live
