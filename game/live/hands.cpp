#include "game/live/hands.h"

#include <algorithm>
#include <utility>

#include "game/settings/bindings.h"

namespace thaum::game::inline live {

using input::Action;
using input::DeviceKind;

HandNews PlayerHands::begin_match(const Settings& settings, const Pads& pads) {
    HandNews news;
    seated_ = settings;
    for (std::uint32_t p = 0; p < players; ++p) {
        const auto place = static_cast<std::size_t>(seats_[p].seat.pad);
        const bool seen = place < pads.size() && pads[place].present;
        const bool half = holds_[p].half;
        const bool lost = has_pad(seats_[p]) && !seen && !half;
        holds_[p] = {.seen = seen, .lost = lost, .let_go_first = true, .half = half};
        if (lost) news.lost = p;
    }
    rebind(settings);
    return news;
}

void PlayerHands::leave_seats() {
    for (auto& seat : seats_) seat = {};
    holds_ = {};
}

void PlayerHands::release() const {
    each([](auto& hands) { hands.focus_lost(); });
}

void PlayerHands::rebind(const Settings& settings) const {
    for (std::uint32_t p = 0; p < players; ++p) {
        const auto& hands = seats_[p].hands;
        if (!hands) continue;
        hands->rebind(settings.bindings_of(device_of(p)));
        const auto &current = settings.players[p], &then = seated_.players[p];
        hands->set_turn_ramp(current.turn_ramp_s);
        hands->set_sticks({current.stick_dead_zone, current.stick_curve});
        hands->set_look(current.sensitivity / then.sensitivity, current.invert_y != then.invert_y);
    }
}

// Pads ------------------------------------------------------------------------------------------------------

HandNews PlayerHands::look(const Pads& pads, const Settings& settings, bool menu_open) {
    HandNews news;
    for (std::uint32_t p = 0; p < players; ++p) {
        if (const auto other = other_pad_for(p, pads)) seats_[p].seat.pad = static_cast<int>(*other);
        const auto place = static_cast<std::size_t>(seats_[p].seat.pad);
        if (!has_pad(seats_[p]) || place >= pads.size()) continue;
        news.used[place] = came_back(p, pads[place], settings, news);
        feed(p, pads[place], menu_open);
    }
    return news;
}

/// Notes that the player's pad was unplugged or plugged in again. Returns whether a press on it has just
/// brought the player back.
bool PlayerHands::came_back(std::uint32_t player, const input::PadState& pad, const Settings& settings,
                            HandNews& news) {
    auto& hold = holds_[player];
    const bool seen_before = std::exchange(hold.seen, pad.present);
    if (!pad.present && seen_before && !hold.half) {
        seats_[player].hands->focus_lost();
        hold.lost = true;
        news.lost = player;
    }
    if (!pad.present || (!hold.lost && !hold.half) || pad.buttons == 0) return false;
    hold.half = false;
    hold.let_go_first = true;
    rejoin(player, settings, news);
    return true;
}

/// Index of a free pad on which a button is pressed: a player whose own pad is lost goes on with that pad.
/// std::nullopt: there is no such pad, or the player has lost no pad.
std::optional<std::size_t> PlayerHands::other_pad_for(std::uint32_t player, const Pads& pads) const {
    if (!has_pad(seats_[player]) || !holds_[player].lost) return {};
    for (std::size_t place = 0; place < pads.size(); ++place) {
        const bool taken = std::any_of(seats_.begin(), seats_.end(), [&](const TakenSeat& seat) {
            return has_pad(seat) && seat.seat.pad == static_cast<int>(place);
        });
        if (!taken && pads[place].present && pads[place].buttons != 0) return place;
    }
    return {};
}

/// Passes the pad's state to the collector of its player's input. Buttons that were held when the player
/// joined or the menu opened must all have been released first.
void PlayerHands::feed(std::uint32_t player, const input::PadState& pad, bool menu_open) {
    auto& hold = holds_[player];
    if (!pad.present || hold.lost || hold.half) return;
    if (menu_open) hold.let_go_first = true;
    if (hold.let_go_first && (pad.buttons != 0 || menu_open)) return;
    hold.let_go_first = false;
    seats_[player].hands->pad(pad);
}

HandNews PlayerHands::take_plugged_pads(const Settings& settings) {
    HandNews news;
    for (std::uint32_t p = 0; p < players; ++p) {
        if (!is_plugged_again(p)) continue;
        holds_[p].let_go_first = true;
        rejoin(p, settings, news);
    }
    return news;
}

/// Gives the collector of the player's input the bindings of the new device, and reports in `news` if every
/// player has a device again.
void PlayerHands::rejoin(std::uint32_t player, const Settings& settings, HandNews& news) {
    holds_[player].lost = false;
    rebind(settings);
    if (std::none_of(holds_.begin(), holds_.end(), [](const auto& hold) { return hold.lost; }))
        news.all_back = player;
}

// Half of the keyboard --------------------------------------------------------------------------------------

DeviceKind PlayerHands::device_of(std::uint32_t player) const {
    return holds_[player].half ? DeviceKind::keyboard_half : seats_[player].spec.kind;
}

bool PlayerHands::half_is_free() const {
    for (std::uint32_t p = 0; p < players; ++p) {
        if (seats_[p].hands && device_of(p) == DeviceKind::keyboard_half) return false;
    }
    return true;
}

std::optional<std::uint32_t> PlayerHands::heir_of_half() const {
    if (!half_is_free()) return {};
    for (std::uint32_t p = 0; p < players; ++p)
        if (has_pad(seats_[p]) && !holds_[p].seen && !holds_[p].half) return p;
    return {};
}

std::optional<HandNews> PlayerHands::take_half(int key, const Settings& settings) {
    const bool asks = is_bound(settings.bindings_of(DeviceKind::keyboard_half).of(Action::fire), key);
    return asks ? take_half(settings) : std::nullopt;
}

std::optional<HandNews> PlayerHands::take_half(const Settings& settings) {
    const auto player = heir_of_half();
    if (!player) return {};
    holds_[*player].half = true;
    HandNews news;
    rejoin(*player, settings, news);
    return news;
}

// Queries about the devices ---------------------------------------------------------------------------------

bool PlayerHands::pauses(int key, const Settings& settings) const {
    for (std::uint32_t p = 0; p < players; ++p) {
        if (seats_[p].hands && is_bound(settings.bindings_of(device_of(p)).of(Action::pause), key))
            return true;
    }
    return false;
}

std::optional<std::uint32_t> PlayerHands::first_lost() const {
    for (std::uint32_t p = 0; p < players; ++p)
        if (is_lost(p)) return p;
    return {};
}

bool PlayerHands::any_pad() const { return std::any_of(seats_.begin(), seats_.end(), has_pad); }

bool PlayerHands::any_mouse() const {
    return std::any_of(seats_.begin(), seats_.end(), [](const TakenSeat& seat) {
        return seat.hands && seat.seat.kind == SeatKind::keyboard_mouse;
    });
}

}  // namespace thaum::game::inline live
