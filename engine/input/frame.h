// input/frame.h: input of one tick, as integers. A match is a pure function of its header and of these
// frames. Therefore they contain no results and no floating point numbers.
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
/// Number of sources of force in a stirred fluid: those of haptics::fluid_modes, in their order.
inline constexpr std::size_t fluid_faders = 7;

/// A player's faders for the forces at the hand. `force` is the largest force. Each other fader is the share
/// of one source of force that the player feels. The sources of a stirred fluid follow, beginning with
/// `fluid`. The numbers are part of the log's format.
enum class HandFader : std::uint8_t { none, force, weight, blows, recoil, roughness, fluid };
inline constexpr std::size_t hand_faders = static_cast<std::size_t>(HandFader::fluid) - 1 + fluid_faders;
/// Value of HandFader::force that means: the largest force is the share of the device's force that the data
/// files give.
inline constexpr std::uint8_t force_as_rules = 101;

/// A change, by a player during the match, of a fader for the forces at the hand.
struct FaderChange {
    /// Number of the fader: a HandFader, or from HandFader::fluid on a kind of force of a fluid; 0: none.
    std::uint8_t fader{};
    std::uint8_t percent{};  ///< new value, 0 to 100, or force_as_rules: as in the data files
    bool operator==(const FaderChange&) const = default;
};
/// Whether the numbers are a valid change of a fader, or no change. Other numbers occur only in damaged logs.
constexpr bool is_valid(const FaderChange& change) {
    if (change.fader == 0) return change.percent == 0;
    const bool force = change.fader == static_cast<std::uint8_t>(HandFader::force);
    return change.fader <= hand_faders && change.percent <= (force ? force_as_rules : 100);
}

/// Kind of a device, which decides the meaning of `DeviceSample::counts`. `arm` is the stylus of a force
/// feedback arm, whose counts are its pose (arm::Count). `keyboard_half` is a second player's keys on the
/// same keyboard. All kinds but `arm` are hands, whose counts are motion and levels of mouse, keys or sticks
/// (hand::Count).
enum class DeviceKind : std::uint8_t { keyboard_mouse, keyboard_half, pad, bot, script, arm };
inline constexpr std::size_t device_kinds = 6;

/// Name of a kind: "keyboard_mouse", "pad", ... The settings have a table of the same name.
std::string_view name_of(DeviceKind kind);

namespace hand {
/// Indices into `counts` of a hand. The first three are sums over the tick, the others are levels at its end.
enum Count : std::size_t {
    look_right,  ///< mouse counts to the right; times DeviceSpec::look_rad_per_count
    look_up,     ///< mouse counts upwards (away from the user); DeviceSpec::invert_y reverses the sign
    wheel,       ///< wheel steps; away from the user is positive
    strafe,      ///< speed to the right, -127..127; 127 is full speed
    forward,     ///< speed forwards, -127..127; 127 is full speed
    turn_right,  ///< turn rate to the right, -127..127; 127: DeviceSpec::turn_rad_per_s
    turn_up,     ///< turn rate upwards, with the same scale; DeviceSpec::invert_y reverses it
    trigger,     ///< position of the `fire` trigger, 0..255; 255 for a key or button that is held
};
}  // namespace hand

namespace arm {
/// Indices into `counts` of an arm: position (um), orientation as axis times angle (urad), and number of
/// samples since the pose was measured. Device frame: +x right, +y up, +z towards the user.
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

/// Largest number of a wand, in DeviceSample::wand.
inline constexpr std::uint32_t max_wands = 9;

/// Bits of DeviceSample::buttons. Their order is part of the log's format, so new ones go to the end. Bits 11
/// to 15 and 19 to 22 stay unused: in format 1 of the log they hold DeviceSample::wand.
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

/// Bit of a button in DeviceSample::buttons.
constexpr std::uint32_t bit(Button button) { return static_cast<std::uint32_t>(button); }

/// Input of one device in one tick.
struct DeviceSample {
    std::array<std::int32_t, max_counts> counts{};
    /// Button bits that were down at the end of the tick or were pressed during it.
    std::uint32_t buttons{};
    /// Wand whose key was pressed last and is still down, 1 to max_wands; 0: none.
    std::uint8_t wand{};
    /// True: the device is unplugged or lost. A device joins or leaves the match at the tick in which this
    /// value changes.
    bool away{};
    FaderChange change{};  ///< change of a fader for the forces at the hand that the player made in this tick
    /// Age of the haptic model (all that the servo knows of the world) that the servo used (ticks), at least
    /// 1. It is 0 for devices other than arms. It is also 0 for an arm in a tick without a sample, whose
    /// counts are then meaningless.
    std::uint16_t model_age{};
    /// Number of samples left out before this one because the simulation was too far behind, or because
    /// samples of an arm were lost. If it is not 0, every arm's servo restarts and an arm's sample is not
    /// used.
    std::uint16_t skips{};
    bool operator==(const DeviceSample&) const = default;

    /// Whether the button is down.
    bool down(Button button) const { return (buttons & bit(button)) != 0; }
    /// Marks the button as down.
    void press(Button button) { buttons |= bit(button); }
};

/// Input of all devices in one tick. LogHeader::devices[i] describes device i. Unused devices stay zero.
struct InputFrame {
    std::array<DeviceSample, max_devices> devices{};
    bool operator==(const InputFrame&) const = default;
};

/// Settings that decide how a device's counts act. They are in the log's header, so a later change of
/// settings does not change a replay.
struct DeviceSpec {
    static constexpr std::uint32_t max_box_um = 10'000'000;

    std::uint32_t player{};  ///< index into LogHeader::players
    DeviceKind kind{};
    std::string name;                    ///< name for display: "mouse and keyboard", "pad 1"
    double look_rad_per_count{0.00087};  ///< turn of the view per mouse count (rad), about 0.05 degrees
    double turn_rad_per_s{3.5};          ///< turn rate of the view at full stick (rad/s)
    bool invert_y{};                     ///< true: look_up and turn_up act downwards
    bool no_forces{};                    ///< true: the player wants no forces
    /// Largest force (% of the device's force, at most 100); 0: as in the data files.
    std::uint8_t force_percent{};
    std::uint8_t weight_reduction{};  ///< reduction of the felt weight of a carried object (%, at most 100)
    std::uint8_t blow_reduction{};    ///< reduction of the felt blows on a carried object (%, at most 100)
    std::uint8_t recoil_reduction{};  ///< reduction of the felt recoil of wands (%, at most 100)
    /// Reduction of the felt friction of touched objects (%, at most 100).
    std::uint8_t roughness_reduction{};
    /// For an arm: edges of the box that the arm reports as its workspace (um), at most max_box_um; zero:
    /// unknown.
    std::array<std::uint32_t, 3> box_um{};
    /// Reduction of the felt force of each source in a fluid (%, at most 100).
    std::array<std::uint8_t, fluid_faders> fluid_reduction{};
    /// Strength of the help with aiming (%, at most 100; game/context/aim_assist.h).
    std::uint8_t aim_assist{};
    /// True: samples may contain changes of the faders for the forces at the hand. Programs that do not know
    /// such changes refuse the log.
    bool moves_faders{};
    /// True: gestures of the hand cast spells without a button (game/casting/free_casting.h).
    bool casts_freely{};
    bool operator==(const DeviceSpec&) const = default;

    /// Sets the largest force that the player wants, 0 to 100 % of the device's force. 0 means no forces.
    void set_force_percent(std::uint32_t percent) {
        no_forces = percent == 0;
        force_percent = static_cast<std::uint8_t>(std::min(percent, 100U));
    }

    /// Sets how much of the weight of a carried object, and of the blows on it, the player feels, 0 to 100 %
    /// of the data files' values.
    void set_carried_percent(std::uint32_t weight_percent, std::uint32_t blow_percent) {
        weight_reduction = static_cast<std::uint8_t>(100 - std::min(weight_percent, 100U));
        blow_reduction = static_cast<std::uint8_t>(100 - std::min(blow_percent, 100U));
    }

    /// Sets how much of the recoil and of the friction of touched objects the player feels, 0 to 100 %.
    void set_touch_percent(std::uint32_t recoil_percent, std::uint32_t roughness_percent) {
        recoil_reduction = static_cast<std::uint8_t>(100 - std::min(recoil_percent, 100U));
        roughness_reduction = static_cast<std::uint8_t>(100 - std::min(roughness_percent, 100U));
    }

    /// Sets how much of a fluid source the player feels, 0 to 100 % of the data files' value.
    void set_fluid_percent(std::size_t source, std::uint32_t percent) {
        fluid_reduction[source] = static_cast<std::uint8_t>(100 - std::min(percent, 100U));
    }

    /// Values of all faders at the beginning of the match; the fader with the number n in HandFader has index
    /// n - 1.
    std::array<std::uint8_t, hand_faders> faders() const;
};

}  // namespace thaum::input
