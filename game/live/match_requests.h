// game/live/match_requests.h: requests of the main thread to the simulation thread about the present match.
//
// A request that must be carried out once is a MatchRequest in a queue. It acts before the next tick. A value
// of which only the newest counts, or which both threads set, is an atomic beside the queue.
#pragma once
#include <atomic>
#include <optional>

#include "core/spsc_queue.h"
#include "game/live/hand_over.h"
#include "game/range/practice.h"

namespace thaum::game::inline live {

/// Sets a bookmark in the log of the match, by the session's mark key.
struct PressMark {
    void carry_out(RequestTarget& target) const { target.next_press |= input::bit(input::Button::mark); }
};

struct MatchRequests {
    // Called by the main thread.
    /// Adds a request. If the queue is full, which happens only if the simulation thread hangs, the request
    /// is dropped.
    void ask(const MatchRequest& request) { (void)queue_.push(request); }

    // Called by the simulation thread.
    /// Removes the oldest waiting request and returns it; std::nullopt if none waits.
    std::optional<MatchRequest> take() {
        const auto* oldest = queue_.front();
        if (oldest == nullptr) return {};
        const auto request = *oldest;
        queue_.pop();
        return request;
    }
    /// Carries out all requests that wait.
    void carry_out(RequestTarget target) {
        while (const auto next = take()) next->carry_out(target);
    }
    /// Forgets the requests that wait, because they were meant for a match that has ended.
    void forget() {
        while (take()) {}
    }

    std::atomic<bool> end{false};  ///< true: the match must end
    /// true: players want to go on after a result. Either thread sets it. Then the next round begins, or
    /// after the last round this match ends and another one follows.
    std::atomic<bool> rematch{false};
    /// Player for whom the session presses the pause button, to pause or to go on. Set by either thread.
    /// Ignored if the match is paused, or goes on, already. no_player: none.
    std::atomic<std::uint32_t> pause{no_player}, go_on{no_player};
    std::atomic<DummyKind> dummy{DummyKind::still};  ///< wanted kind of the practice range's dummy
    /// wanted changes of the practice range's rules, such as endless energy
    std::atomic<RangeChanges> range{RangeChanges{}};
    static_assert(decltype(range)::is_always_lock_free);
    HandOver<OwnGestures> own_gestures{};  ///< own gestures of the player of the range, after a change

private:
    SpscQueue<MatchRequest, 64> queue_{};
};

}  // namespace thaum::game::inline live
