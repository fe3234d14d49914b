// Fake pads and joysticks of any model, simulated by umockdev. A program sees them if it, or the process that
// starts it, runs under umockdev-wrapper. /dev/uinput is not needed.
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
    std::int32_t rest = 0;  ///< value while no one touches the axis
};

struct Model {
    std::uint16_t bus = BUS_USB, vendor{}, product{}, version{};
    std::string name{};
    std::vector<std::uint16_t> buttons{};
    std::vector<Axis> axes{};  ///< axes, including those of hats (direction pads)
    bool motors = false;
};

Model xbox_360();
Model xbox_one();
/// A joystick without motors, with this number of buttons, axes and hats (direction pads), which SDL numbers
/// in this order.
Model stick(std::size_t buttons, std::size_t axes, std::size_t hats);
/// Linux code of the button or axis with this number in SDL.
std::uint16_t button_code(std::size_t number);
std::uint16_t axis_code(std::size_t number);

constexpr int max_effects = 16;

struct Pad {
    _UMockdevTestbed* testbed{};
    Model model{};
    int fd = -1;
    std::filesystem::path link{}, target{};
    std::string device{};  ///< path of the device in /sys
    std::string prefix{};  ///< prefix of the lines about the pad's motors
    int felt = -1;         ///< file for the lines about the motors; below 0: none
    std::atomic<bool> plugged{true};
    /// for each effect number, whether the program has uploaded an effect
    std::array<std::atomic<bool>, max_effects> effects{};
    /// Present values of the axes, which programs read again after each report.
    std::array<std::atomic<int>, ABS_CNT> axis_values{};
};

/// Makes the pad /dev/input/event<number>, plugged in. `pad` must exist until the program ends.
void make_pad(Pad& pad, _UMockdevTestbed* testbed, const Model& model, std::size_t number);
/// Reports a change of a button (EV_KEY) or an axis (EV_ABS).
void report(Pad& pad, std::uint16_t type, std::uint16_t code, int value);
/// Unplugs the pad, or plugs it in.
void plug(Pad& pad, bool in);
/// Writes a line for each start and end of an effect. Never returns.
[[noreturn]] void follow_motors(Pad& pad);

}  // namespace fake
