// unit/live_rig.h: keys, pads and seats (players' devices) for tests of a live session's parts.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "core/file.h"
#include "core/text.h"
#include "game/live/seats.h"

namespace thaum::game::rig {

constexpr std::int64_t ms = 1'000'000;  ///< one millisecond (ns)
constexpr render::Size window{1280, 720};

/// A path for a file or folder, at which nothing lies before and after the test.
struct TestPath {
    explicit TestPath(std::string_view name) : path(folder.path() / name) {}

    const TemporaryFolder folder{};
    const std::filesystem::path path;
};

inline int key(std::string_view name) { return *key_code_of(name); }

/// Key, button or axis number of the first control that the settings bind to an action.
inline int code_of(const Settings& settings, input::DeviceKind kind, input::Action action) {
    return settings.bindings_of(kind).of(action).at(0).code;
}
inline int code_of(const Settings& settings, SessionKey key) { return settings.of(key).at(0).code; }

/// A pad that is plugged in, with some buttons down.
inline input::PadState pad_with(std::initializer_list<input::PadButton> held = {}) {
    input::PadState pad{.present = true, .name = "Make-believe pad"};
    for (const auto button : held) pad.buttons |= 1U << static_cast<unsigned>(button);
    return pad;
}
/// A pad with an axis at `value`.
inline input::PadState pad_at(input::PadAxis axis, double value) {
    auto pad = pad_with();
    pad.axes[static_cast<std::size_t>(axis)] = value;
    return pad;
}

inline TakenSeats seats_for(live::Seat first, live::Seat second, const Settings& settings = {}) {
    return take_seats(settings, {std::move(first), std::move(second)});
}
inline const live::Seat mouse_seat{.kind = SeatKind::keyboard_mouse},
    half_seat{.kind = SeatKind::keyboard_half}, first_pad_seat{.kind = SeatKind::pad, .pad = 0},
    second_pad_seat{.kind = SeatKind::pad, .pad = 1}, bot_seat{.kind = SeatKind::bot, .bot = "level_1"};

inline input::DeviceSample taken(const TakenSeats& seats, std::uint32_t player) {
    return seats[player].hands->take();
}
inline bool is_down(const input::DeviceSample& sample, input::Button button) {
    return (sample.buttons & input::bit(button)) != 0;
}

}  // namespace thaum::game::rig
