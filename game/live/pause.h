// game/live/pause.h: conditions, besides the players' buttons, that pause a match or let players leave it: a
// lost focus, and the end of the round. Also the text of the pause. Times are arguments (ns, monotonic
// clock).
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "game/components/match.h"
#include "game/data/teams.h"

namespace thaum::game::inline live {

enum class PlayState : std::uint8_t { playing, paused, over };

/// Loss of the window's focus. Only a loss that lasts counts, because the focus also comes and goes while a
/// window opens or fills the screen.
class FocusLoss {
public:
    static constexpr std::int64_t flicker_ns = 150'000'000;

    void changed(bool focused, std::int64_t now_ns) { since_ns_ = focused ? 0 : now_ns; }
    /// Whether the focus was lost and the session has not reacted to that yet.
    bool pending() const { return since_ns_ != 0; }
    /// Whether the window has been without the focus for longer than `flicker_ns`, so that the match must
    /// pause.
    bool lasts(std::int64_t now_ns) const { return pending() && now_ns > since_ns_ + flicker_ns; }
    void handled() { since_ns_ = 0; }

private:
    std::int64_t since_ns_ = 0;  ///< time of the loss; 0: the window has the focus, or the loss was handled
};

/// Time since the round's end. For a moment after the end, a key that was meant for play must not leave the
/// match, so that the players see the result.
class RoundEnd {
public:
    static constexpr std::int64_t leave_not_before_ns = 800'000'000;

    void follow(PlayState state, std::int64_t now_ns) {
        if (state != PlayState::over) since_ns_ = 0;
        if (state == PlayState::over && since_ns_ == 0) since_ns_ = now_ns;
    }
    bool may_leave(std::int64_t now_ns) const {
        return since_ns_ != 0 && now_ns > since_ns_ + leave_not_before_ns;
    }

private:
    std::int64_t since_ns_ = 0;  ///< time of the round's end; 0: the round goes on
};

/// Text of the pause menu.
struct PauseWords {
    std::string head{}, line{};  ///< title of the pause menu, and reason of the pause
    std::string missing{};       ///< why the match cannot go on (whose pad is not plugged in); empty: it can
    std::string half_for{};      ///< player who may go on with half of the keyboard; empty: nobody
    bool operator==(const PauseWords&) const = default;
};

/// Reasons of a pause.
struct PauseFacts {
    std::uint32_t paused_by = no_player;  ///< player who pressed the pause button; no_player: nobody
    /// true: the session itself pressed the pause button, because the window lost the focus
    bool focus_lost = false;
    /// number of each player's lost pad; std::nullopt: none is lost
    std::array<std::optional<int>, players> lost_pad{};
    /// true: the lost pad is plugged in again, and its player only has to press a button
    std::array<bool, players> plugged_again{};
    std::uint32_t heir_of_half = no_player;  ///< player who can take half of the keyboard; no_player: nobody
    PlayerNames names{};
    /// key that takes half of the keyboard instead of a pad; empty: it is not free
    std::string key_for_half{};
};

PauseWords pause_words(const PauseFacts& facts);

}  // namespace thaum::game::inline live
