#include "game/hud/felt_source.h"

#include <array>
#include <cmath>

namespace thaum::game {
namespace {

double recoil_of(const haptics::ServoState& servo) {
    vec3 force{};
    for (const auto& pulse : servo.pulses) {
        if (pulse.at < pulse.length) force += pulse.peak * haptics::half_sine(pulse.at, pulse.length);
    }
    return glm::length(force);
}

double spring_of(const HandState& hand_state) {
    const auto& tether = hand_state.tether;
    if (!(tether.stiffness > 0)) return 0;
    return tether.stiffness * glm::distance(tether.anchor, hand_state.device.position);
}

double wall_of(const haptics::SurfaceState& surface) {
    vec3 force{};
    for (std::uint32_t i = 0; i < surface.contacts; ++i) force += surface.touched.at(i).force;
    return glm::length(force);
}

}  // namespace

FeltSource strongest_source(const HandState& hand_state, std::string_view steady_name) {
    const auto& servo = hand_state.servo;
    const auto& fluid = servo.fluid;
    const std::array<FeltSource, 7> sources{{
        {"Recoil", recoil_of(servo)},
        {"Spring", spring_of(hand_state)},
        {steady_name, glm::length(hand_state.steady_force.force)},
        {"Wall", wall_of(servo.surface)},
        {"Current", glm::length(fluid.force)},
        {"Wall", glm::length(fluid.wall)},
        {"Surface", std::abs(fluid.surface_force)},
    }};
    FeltSource strongest;
    for (const auto& source : sources) {
        if (source.newtons > strongest.newtons) strongest = source;
    }
    return strongest;
}

}  // namespace thaum::game
