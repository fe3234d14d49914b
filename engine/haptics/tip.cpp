#include "haptics/tip.h"

#include <algorithm>
#include <cmath>

#include "haptics/servo.h"

namespace thaum::haptics {
namespace {

/// Stores a position and returns the mean velocity over the stored ones, which span at most `velocity_window`
/// ticks (m/s). A velocity over one tick would have noise of centimetres per second by the encoder's quantum.
/// A position that is not finite makes the velocity NaN twice: when it arrives and when it is the oldest. The
/// safety stage cuts the force in both cases.
vec3 store_position(ServoState& state, vec3 position) {
    auto& ring = state.positions;
    const bool full = state.samples == velocity_window;
    const vec3 oldest = full ? ring[state.next_position] : ring[0];
    const std::uint32_t span = state.samples;
    ring[state.next_position] = position;
    state.next_position = static_cast<std::uint32_t>((state.next_position + 1) % velocity_window);
    if (!full) ++state.samples;
    if (span == 0) return is_finite(position) ? vec3(0) : position;
    return (position - oldest) / (span * tick_seconds);
}

}  // namespace

Tip move_tip(ServoState& state, vec3 position, double quantum) {
    const vec3 velocity = store_position(state, position);
    return {.position = position, .velocity = velocity, .path_speed = path_speed(state, quantum)};
}

vec3 tip_velocity(const ServoState& state) {
    if (state.samples < 2) return vec3(0);
    const auto& ring = state.positions;
    const auto at = [&](std::size_t back) {
        return ring[(state.next_position + velocity_window - 1 - back) % velocity_window];
    };
    const std::uint32_t span = state.samples - 1;
    return (at(0) - at(span)) / (span * tick_seconds);
}

vec3 prompt_velocity(const ServoState& state, double quantum) {
    if (state.samples < 2) return vec3(0);
    const double slack = std::max(quantum, finest_motion);
    const auto& ring = state.positions;
    const auto at = [&](std::uint32_t back) {
        return ring[(state.next_position + velocity_window - 1 - back) % velocity_window];
    };
    const auto straight = [&](vec3 step, std::uint32_t span) {
        for (std::uint32_t i = 1; i < span; ++i) {
            const vec3 off = glm::abs(at(0) - static_cast<double>(i) * step - at(i));
            if (!(std::max({off.x, off.y, off.z}) <= slack)) return false;
        }
        return true;
    };
    vec3 step = at(0) - at(1);
    for (std::uint32_t span = 2; span < state.samples; ++span) {
        const vec3 mean = (at(0) - at(span)) / static_cast<double>(span);
        if (!straight(mean, span)) break;
        step = mean;
    }
    return step / tick_seconds;
}

vec3 tip_motion(const ServoState& state, double quantum) {
    return prompt_velocity(state, quantum) * tick_seconds;
}

double path_speed(const ServoState& state, double quantum) {
    if (state.samples < 2) return 0;
    const auto& ring = state.positions;
    const std::uint32_t oldest = state.samples == velocity_window ? state.next_position : 0;
    double path = 0;
    for (std::uint32_t i = 1; i < state.samples; ++i)
        path += glm::distance(ring[(oldest + i - 1) % velocity_window], ring[(oldest + i) % velocity_window]);
    const std::uint32_t steps = state.samples - 1;
    // Each end of a step may be off by half a quantum along each axis.
    const double rounded = std::sqrt(3.0) * quantum * steps;
    const double least = path - rounded;
    return least < 0 ? 0 : least / (steps * tick_seconds);
}

}  // namespace thaum::haptics
