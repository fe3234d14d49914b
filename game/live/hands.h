// game/live/hands.h: the input of all players during a match, and the device that each player uses now. A
// player whose pad was unplugged rejoins by a button of that pad or of a free one, or goes on with half of
// the keyboard (the keypad and the arrow keys).
#pragma once
#include "game/live/seats.h"

namespace thaum::game::inline live {

/// Words for a player whose pad is lost: how to rejoin, while the pad is unplugged and once it is plugged in
/// again.
inline constexpr std::string_view how_to_rejoin = "plug it in and press a button on it or on a free pad",
                                  press_to_rejoin = "press a button on it to go on";

/// Players whose devices have just gone or come back.
struct HandNews {
    std::optional<std::uint32_t> lost{};  ///< player whose pad is not plugged in: the match must pause
    /// player who came back last, now that no player is without a device: the match must go on
    std::optional<std::uint32_t> all_back{};
    /// true for each pad whose press has just brought a player back; the press has no other effect
    std::array<bool, std::tuple_size_v<Pads>> used{};
};

class PlayerHands {
public:
    /// `seats` (places of the players in a match) outlives this object, and changes between matches only.
    explicit PlayerHands(TakenSeats& seats) : seats_(seats) {}

    /// Begins a match with seats that were taken under `settings`. Buttons held now must be released before
    /// they act in the match. A player who had half of the keyboard in the last match keeps it in a rematch.
    /// Any other player whose pad is not plugged in counts as one who has lost it.
    HandNews begin_match(const Settings& settings, const Pads& pads);
    /// Empties the seats (places of the players) and forgets which devices their players used.
    void leave_seats();

    /// Calls f with the collector of each person's input, which gathers the events until the next tick takes
    /// them. A collector ignores controls without a binding.
    template <class F>
    void each(F&& f) const {
        for (const auto& seat : seats_) {
            if (seat.hands) f(*seat.hands);
        }
    }
    /// Releases all held controls. Call it when their own release will not be reported, as after the window
    /// has lost the focus.
    void release() const;
    /// Gives the collectors of all players' input the bindings of `settings`, and releases all held controls.
    void rebind(const Settings& settings) const;

    /// Passes the states of the pads on to their players. Notes pads that were unplugged or plugged in again,
    /// and presses with which players rejoin. While a menu is open, pads do not act in the match.
    HandNews look(const Pads& pads, const Settings& settings, bool menu_open);
    /// Lets the player whose pad is not plugged in go on with half of the keyboard, if `key` is the fire key
    /// of that half. Returns std::nullopt for another key, or if nobody can take that half.
    std::optional<HandNews> take_half(int key, const Settings& settings);
    /// Lets the player whose pad is not plugged in go on with half of the keyboard. Returns std::nullopt if
    /// nobody can.
    std::optional<HandNews> take_half(const Settings& settings);
    /// Brings all players back whose lost pads are plugged in again.
    HandNews take_plugged_pads(const Settings& settings);

    /// The device that the player uses now.
    input::DeviceKind device_of(std::uint32_t player) const;
    /// Whether the player's pad was unplugged and the player has not rejoined with any device yet.
    bool is_lost(std::uint32_t player) const { return holds_[player].lost; }
    /// Whether the player's lost pad is plugged in again, and waits for a press.
    bool is_plugged_again(std::uint32_t player) const { return holds_[player].lost && holds_[player].seen; }
    /// The first player who has lost a pad and has not rejoined yet; std::nullopt: there is none.
    std::optional<std::uint32_t> first_lost() const;
    /// The player whose pad is not plugged in and who would get half of the keyboard. std::nullopt: nobody
    /// needs that half, or it is taken.
    std::optional<std::uint32_t> heir_of_half() const;
    /// Whether the key is bound to the pause on the device of any player.
    bool pauses(int key, const Settings& settings) const;
    bool any_pad() const;
    bool any_mouse() const;
    /// Whether no player uses half of the keyboard.
    bool half_is_free() const;

private:
    /// State of the pad that one player uses.
    struct PadHold {
        bool seen = false;          ///< the pad was plugged in when the pads were last read
        bool lost = false;          ///< the pad was unplugged, and its player has not rejoined yet
        bool let_go_first = false;  ///< true: buttons held now are ignored until all have been released
        bool half = false;          ///< the player continues with half of the keyboard
    };

    void rejoin(std::uint32_t player, const Settings& settings, HandNews& news);
    bool came_back(std::uint32_t player, const input::PadState& pad, const Settings& settings,
                   HandNews& news);
    std::optional<std::size_t> other_pad_for(std::uint32_t player, const Pads& pads) const;
    void feed(std::uint32_t player, const input::PadState& pad, bool menu_open);

    TakenSeats& seats_;
    std::array<PadHold, players> holds_{};
    Settings seated_{};  ///< settings that the seats' DeviceSpecs were made from
};

}  // namespace thaum::game::inline live
