#include "input/detail/rumble_effect.h"

#include <algorithm>
#include <cmath>

namespace thaum::input::detail {
namespace {

constexpr double pad_steps = 255;
/// Magnitude of one step of a motor: 255 steps make Linux's largest magnitude, 65,535.
constexpr long step_magnitude = 257;

std::uint16_t magnitude(const tactile::TactileFrame& frame, std::size_t actuator) {
    if (actuator >= frame.count) return 0;
    const auto amplitude = static_cast<double>(frame.amplitude.at(actuator));
    // With this form of the test NaN counts as 0.
    if (!(amplitude > 0)) return 0;
    return static_cast<std::uint16_t>(std::lround(std::min(amplitude, 1.0) * pad_steps) * step_magnitude);
}

}  // namespace

ff_effect rumble_effect(const tactile::TactileFrame& frame, std::int16_t id) {
    ff_effect effect{};
    effect.type = FF_RUMBLE;
    effect.id = id;
    // A length of 0 would mean that the effect never ends, so it is at least 1 ms.
    effect.replay.length =
        static_cast<std::uint16_t>(std::clamp<Tick>(frame.time_to_live, 1, longest_rumble_ms));
    effect.u.rumble.strong_magnitude = magnitude(frame, 0);
    effect.u.rumble.weak_magnitude = magnitude(frame, 1);
    return effect;
}

}  // namespace thaum::input::detail
