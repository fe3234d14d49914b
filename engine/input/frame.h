// input/frame.h: what came in during one tick, as integers. A match is a pure function of its header and of these
// frames, so nothing here is a result and nothing is a floating point number.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace thaum::input {

inline constexpr std::size_t max_devices = 4;
inline constexpr std::size_t max_counts = 8;
/// What a hand feels of a fluid that it stirs: so many sources, those of haptics::fluid_modes in their order.
inline constexpr std::size_t fluid_faders = 7;

/// What `DeviceSample::counts` means. All but `arm` are hands: hand::Count. `arm` is a stylus:
/// arm::Count.
enum class DeviceKind : std::uint8_t { keyboard_mouse, keyboard_half, pad, bot, script, arm };
inline constexpr std::size_t device_kinds = 6;

/// "keyboard_mouse", "pad", ...; also the name of the kind's table in settings.
std::string_view name_of(DeviceKind kind);

namespace hand {
/// Places in `counts` of a hands kind. The first three are sums over the tick, the others levels at its end.
enum Count : std::size_t {
    look_right,  ///< mouse counts to the right; times DeviceSpec::look_rad_per_count
    look_up,     ///< mouse counts upwards (away from the user); DeviceSpec::flags may invert it
    wheel,       ///< wheel steps; away from the user is positive
    strafe,      ///< -127..127, to the right
    forward,     ///< -127..127
    turn_right,  ///< -127..127 of DeviceSpec::turn_rad_per_s
    turn_up,     ///< -127..127 of DeviceSpec::turn_rad_per_s; DeviceSpec::flags may invert it
    trigger,     ///< 0..255, how far `fire` is pulled; a key or button that is held is 255
};
}  // namespace hand

namespace arm {
/// Places in `counts` of an arm: position in um, orientation (axis times angle) in urad, in the device frame (+x right, +y up,
/// +z towards the user); and for how many samples the pose was not measured anew.
enum Count : std::size_t {
    position_x,
    position_y,
    position_z,
    rotation_x,
    rotation_y,
    rotation_z,
    pose_age,
};
}  // namespace arm

/// Largest number in DeviceSample::wand.
inline constexpr std::uint32_t most_wands = 9;

/// Bits of DeviceSample::buttons. The order is part of the log's format: new ones go to the end. Bits 11 to 15 and
/// 19 to 22 are never set here: in a log they hold DeviceSample::wand.
enum class Button : std::uint32_t {
    fire = 1U << 0U,
    jump = 1U << 1U,
    next_wand = 1U << 2U,
    previous_wand = 1U << 3U,
    trace = 1U << 4U,
    stir = 1U << 5U,
    throw_ = 1U << 6U,
    clutch = 1U << 7U,
    panic = 1U << 8U,
    pause = 1U << 9U,
    rejoin = 1U << 10U,
    mark = 1U << 16U,
    confirm = 1U << 17U,
    quit = 1U << 18U,
};

constexpr std::uint32_t bit(Button button) { return static_cast<std::uint32_t>(button); }

/// One device in one tick.
struct DeviceSample {
    std::array<std::int32_t, max_counts> counts{};
    std::uint32_t buttons{};  ///< Button bits that were down at the tick's end or were pressed during it
    /// Wand whose key was pressed last and is still down, 1 to most_wands; 0: none.
    std::uint32_t wand{};
    /// Ticks since the haptic model was made that the servo used, at least 1; 0 for hands, and for an arm in a tick that
    /// found no sample of it: then no count means anything.
    std::uint16_t model_age{};
    /// Samples left out before this one because the simulation was too far behind; at an arm also where samples of it got lost.
    /// With either, every arm's servo begins anew, and this sample of an arm is not used.
    std::uint16_t skips{};
    bool operator==(const DeviceSample&) const = default;

    bool down(Button button) const { return (buttons & bit(button)) != 0; }
    void press(Button button) { buttons |= bit(button); }
};

/// All devices in one tick. Device i is described by LogHeader::devices[i]; those beyond stay zero.
struct InputFrame {
    std::array<DeviceSample, max_devices> devices{};
    bool operator==(const InputFrame&) const = default;
};

/// What else decides how a device's counts act; it stands in the log's header, so a setting changed later
/// does not change a replay.
struct DeviceSpec {
    static constexpr std::uint32_t most_box_um = 10'000'000;
    static constexpr std::uint32_t invert_y = 1U << 0U;   ///< flag: look_up and turn_up act downwards
    static constexpr std::uint32_t no_forces = 1U << 1U;  ///< flag: the player wants to feel none
    static constexpr std::uint32_t force_shift =
        8;  ///< flags, 7 bits from there: %, at most 100, of the device's force
    static constexpr std::uint32_t force_bits =
        0x7FU << force_shift;  ///< that reaches the hand; 0: the rules' share
    static constexpr std::uint32_t weight_shift =
        15;  ///< flags, 7 bits from there: %, at most 100, by which the
             ///< weight of what is carried is felt less
    static constexpr std::uint32_t weight_bits = 0x7FU << weight_shift;
    static constexpr std::uint32_t blow_shift = 22;  ///< likewise the blows that it takes
    static constexpr std::uint32_t blow_bits = 0x7FU << blow_shift;

    std::uint32_t player{};  ///< index into LogHeader::players
    DeviceKind kind{};
    std::string name;                    ///< for people: "mouse and keyboard", "pad 1"
    double look_rad_per_count{0.00087};  ///< rad of view a mouse count turns; about 0.05 degrees
    double turn_rad_per_s{3.5};          ///< rad/s of view at full stick
    std::uint32_t flags{};
    /// Of an arm: the edges of the box that it says it reaches, um, at most most_box_um; zero: it did not say.
    std::array<std::uint32_t, 3> box_um{};
    /// %, at most 100, by which each source of a fluid's forces is felt less.
    std::array<std::uint8_t, fluid_faders> fluid_kept_off{};
    bool operator==(const DeviceSpec&) const = default;

    /// 0 to 100 %: how much of the device's force its player wants at most. 0 is none at all.
    void ask_for_force(std::uint32_t percent) {
        flags &= ~(no_forces | force_bits);
        flags |= percent == 0 ? no_forces : std::min(percent, 100U) << force_shift;
    }
    /// %; 0 where the rules say it.
    std::uint32_t force_asked_for() const { return (flags & force_bits) >> force_shift; }

    /// 0 to 100 %, of what the data files say.
    void ask_for_carried(std::uint32_t weight_percent, std::uint32_t blow_percent) {
        flags &= ~(weight_bits | blow_bits);
        flags |= (100 - std::min(weight_percent, 100U)) << weight_shift;
        flags |= (100 - std::min(blow_percent, 100U)) << blow_shift;
    }
    /// %, by which they are felt less.
    std::uint32_t weight_kept_off() const { return (flags & weight_bits) >> weight_shift; }
    std::uint32_t blows_kept_off() const { return (flags & blow_bits) >> blow_shift; }

    /// 0 to 100 %, of what the data files say.
    void ask_for_fluid(std::size_t source, std::uint32_t percent) {
        fluid_kept_off[source] = static_cast<std::uint8_t>(100 - std::min(percent, 100U));
    }
};

}  // namespace thaum::input
