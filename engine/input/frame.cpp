#include "input/frame.h"

namespace thaum::input {

std::string_view name_of(DeviceKind kind) {
    constexpr std::array<std::string_view, device_kinds> names{
        "keyboard_mouse", "keyboard_half", "pad", "bot", "script", "arm"};
    return names[static_cast<std::size_t>(kind)];
}

std::array<std::uint8_t, hand_faders> DeviceSpec::faders() const {
    const auto kept_percent = [](std::uint8_t reduction) {
        return static_cast<std::uint8_t>(100 - reduction);
    };
    const std::uint8_t force = no_forces ? 0 : force_percent != 0 ? force_percent : force_as_rules;
    std::array<std::uint8_t, hand_faders> values{force, kept_percent(weight_reduction),
                                                 kept_percent(blow_reduction), kept_percent(recoil_reduction),
                                                 kept_percent(roughness_reduction)};
    const auto fluid = static_cast<std::size_t>(HandFader::fluid) - 1;
    for (std::size_t i = 0; i < fluid_faders; ++i) values[fluid + i] = kept_percent(fluid_reduction[i]);
    return values;
}

}  // namespace thaum::input
