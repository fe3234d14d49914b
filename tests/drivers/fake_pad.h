// Fake pads and joysticks of any model, made by umockdev. Programs see them if they, or the process that starts them, run
// under umockdev-wrapper. /dev/uinput is not needed.
#pragma once
#include <linux/input.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

struct _UMockdevTestbed;

namespace fake {

struct Axis {
    std::uint16_t code{};
    std::int32_t lowest = -32768, highest = 32767;
    std::int32_t rest = 0;  ///< value while nobody touches it
};

struct Model {
    std::uint16_t bus = BUS_USB, vendor{}, product{}, version{};
    std::string name{};
    std::vector<std::uint16_t> buttons{};
    std::vector<Axis> axes{};  ///< those of hats, too
    bool motors = false;
};

Model xbox_360();
Model xbox_one();
/// A joystick with so many buttons, axes and hats, which SDL numbers in this order. Without motors.
Model stick(std::size_t buttons, std::size_t axes, std::size_t hats);
/// Code of the button or axis to which SDL gives a number.
std::uint16_t button_code(std::size_t number);
std::uint16_t axis_code(std::size_t number);

constexpr int most_effects = 16;

struct Pad {
    _UMockdevTestbed* testbed{};
    Model model{};
    int fd = -1;
    std::filesystem::path link{}, target{};
    std::string device{};  ///< path of the device in /sys
    std::string prefix{};  ///< of the lines about its motors
    int felt = -1;         ///< file for these lines; below 0: none
    std::atomic<bool> plugged{true};
    /// Effects that the program has uploaded.
    std::array<std::atomic<bool>, most_effects> effects{};
    /// Present values of the axes. Programs read them again after each report.
    std::array<std::atomic<int>, ABS_CNT> axis_values{};
};

/// Makes the pad /dev/input/event<number>, plugged in. `pad` must live until the program ends.
void make_pad(Pad& pad, _UMockdevTestbed* testbed, const Model& model, std::size_t number);
/// Reports a change of a button (EV_KEY) or an axis (EV_ABS).
void report(Pad& pad, std::uint16_t type, std::uint16_t code, int value);
/// Pulls the pad out, or plugs it in.
void plug(Pad& pad, bool in);
/// Writes a line for each beginning and end of an effect. Never returns.
[[noreturn]] void follow_motors(Pad& pad);

}  // namespace fake
