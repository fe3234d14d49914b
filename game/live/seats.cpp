#include "game/live/seats.h"

#include <algorithm>
#include <cmath>

#include "core/parse.h"
#include "core/text.h"
#include "game/bots/bot.h"
#include "game/range/range.h"

namespace thaum::game::inline live {

using input::DeviceKind;

// ---- Words of --hands -------------------------------------------------------------------------------------

Expected<Seat> hand_named(std::string_view word) {
    constexpr std::string_view numbered_arm = "arm:";
    constexpr std::uint64_t max_number = 1000;
    if (word == "mouse") return Seat{.kind = SeatKind::keyboard_mouse};
    if (word == "half") return Seat{.kind = SeatKind::keyboard_half};
    if (word == "pad") return Seat{.kind = SeatKind::pad};
    if (word == "arm") return Seat{.kind = SeatKind::keyboard_mouse, .arm = ArmWish{}};
    if (word.starts_with(numbered_arm)) {
        const auto number = parse_whole(word.substr(numbered_arm.size()), "--hands arm:", 0, max_number);
        if (!number) return number.error();
        return Seat{.kind = SeatKind::keyboard_mouse, .arm = ArmWish{*number}};
    }
    return fail(text("--hands '", word, "': must be mouse, half, pad or arm, or arm:0, arm:1, ..."));
}

Expected<std::vector<Seat>> hands_named(std::string_view words) {
    std::vector<Seat> hands;
    for (;;) {
        const auto comma = std::min(words.find(','), words.size());
        const auto hand = hand_named(words.substr(0, comma));
        if (!hand) return hand.error();
        hands.push_back(*hand);
        if (comma == words.size()) break;
        words.remove_prefix(comma + 1);
    }
    if (hands.size() > players) return fail("--hands takes one or two devices, one a player");
    if (hands.size() < 2 || hands[0].kind != hands[1].kind || hands[0].kind == SeatKind::pad) return hands;
    // Only one player has the mouse. If both seats ask for it, a seat with an arm gives way: the second one
    // if it has an arm, else the first one.
    auto* gives_way = hands[1].arm ? &hands[1] : hands[0].arm ? hands.data() : nullptr;
    const bool same_arm = hands[0].arm && hands[1].arm && hands[0].arm->number && hands[1].arm->number &&
                          *hands[0].arm->number == *hands[1].arm->number;
    if (gives_way == nullptr || same_arm)
        return fail(
            "--hands takes one or two devices, and both of one kind only if they are pads or two arms");
    gives_way->kind = SeatKind::pad_or_half;
    return hands;
}

// Taking seats ----------------------------------------------------------------------------------------------

namespace {

DeviceKind device_kind(SeatKind kind) {
    switch (kind) {
        case SeatKind::keyboard_mouse: return DeviceKind::keyboard_mouse;
        case SeatKind::keyboard_half: return DeviceKind::keyboard_half;
        case SeatKind::bot:
        case SeatKind::dummy: return DeviceKind::bot;
        default: return DeviceKind::pad;
    }
}

std::string device_name(const Seat& seat) {
    switch (seat.kind) {
        case SeatKind::keyboard_mouse: return "mouse and keyboard";
        case SeatKind::keyboard_half: return "half of the keyboard";
        default: return text("pad ", seat.pad + 1);
    }
}

double aim_assist_of(const PlayerSettings& settings, DeviceKind kind) {
    switch (kind) {
        case DeviceKind::keyboard_mouse: return settings.aim_assist_mouse;
        case DeviceKind::keyboard_half: return settings.aim_assist_keys;
        case DeviceKind::pad: return settings.aim_assist_pad;
        default: return 0;
    }
}

std::uint32_t percent_of(double share) { return static_cast<std::uint32_t>(std::lround(100 * share)); }

/// Sets the device's faders (strengths in %) for the forces at the player's hand.
void ask_for_forces(const Settings& settings, std::uint32_t player, input::DeviceSpec& spec) {
    const auto& own = settings.players[player];
    if (const auto percent = force_percent_of(own)) spec.set_force_percent(*percent);
    spec.set_carried_percent(percent_of(own.carried_weight), percent_of(own.carried_blows));
    spec.set_touch_percent(percent_of(own.recoil), percent_of(own.roughness));
    ask_for(settings.cauldron[player], spec);
    spec.moves_faders = true;
}

TakenSeat take_seat(const Settings& settings, const Seat& seat, std::uint32_t player) {
    if (seat.kind == SeatKind::bot) return {seat, bot_device(player, seat.bot), nullptr, nullptr};
    if (seat.kind == SeatKind::dummy) return {seat, dummy_device(), nullptr, nullptr};
    input::DeviceSpec spec;
    spec.player = player;
    spec.kind = device_kind(seat.kind);
    spec.name = device_name(seat);
    const auto& own = settings.players[player];
    spec.look_rad_per_count *= own.sensitivity;
    spec.turn_rad_per_s = own.turn_deg_per_s * radians_per_degree;
    spec.invert_y = own.invert_y;
    spec.aim_assist = static_cast<std::uint8_t>(percent_of(aim_assist_of(own, spec.kind)));
    spec.casts_freely = own.free_casting;
    ask_for_forces(settings, player, spec);
    return {seat, spec, std::make_unique<input::HandsCollector>(settings.bindings_of(spec.kind)),
            std::make_unique<FaderInput>()};
}

Seat seat_of(const Device& device) {
    switch (device.kind) {
        case DeviceKind::keyboard_mouse: return {.kind = SeatKind::keyboard_mouse};
        case DeviceKind::keyboard_half: return {.kind = SeatKind::keyboard_half};
        default: return {.kind = SeatKind::pad, .pad = device.pad};
    }
}

}  // namespace

Seats joined_seats(const MenuState& menu, const MenuContext& context, bool practice) {
    Seats seats;
    for (std::size_t p = 0; p < seats.size(); ++p) {
        const auto& device = menu.seats[p];
        seats[p] =
            device ? seat_of(*device) : Seat{.kind = SeatKind::bot, .bot = context.bots[menu.bot].name};
    }
    if (practice) seats[dummys] = {.kind = SeatKind::dummy};
    return seats;
}

Seats planned_seats(Seats seats, const Pads& pads) {
    std::size_t free_pad = 0;
    for (auto& seat : seats) {
        if (seat.kind == SeatKind::pad_or_half)
            seat.kind = pads[free_pad].present ? SeatKind::pad : SeatKind::keyboard_half;
        if (seat.kind == SeatKind::pad) seat.pad = static_cast<int>(free_pad++);
    }
    return seats;
}

TakenSeats take_seats(const Settings& settings, const Seats& seats) {
    TakenSeats taken;
    for (std::uint32_t p = 0; p < players; ++p) taken[p] = take_seat(settings, seats[p], p);
    return taken;
}

void want_faders(const Settings& settings, const TakenSeats& seats) {
    for (std::uint32_t p = 0; p < players; ++p) {
        if (!seats[p].faders) continue;
        input::DeviceSpec wanted;
        ask_for_forces(settings, p, wanted);
        seats[p].faders->want(wanted.faders());
    }
}

bool has_pad(const TakenSeat& seat) { return seat.hands && seat.seat.kind == SeatKind::pad; }

std::optional<std::uint32_t> first_person(const TakenSeats& seats) {
    for (std::uint32_t p = 0; p < players; ++p) {
        if (seats[p].hands) return p;
    }
    return {};
}

}  // namespace thaum::game::inline live
