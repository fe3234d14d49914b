#include "haptics/pulse.h"

#include "haptics/servo.h"

namespace thaum::haptics {
namespace {

bool newer(std::uint32_t number, std::uint32_t than) {
    const std::uint32_t ahead = number - than;  // the difference is right even after the numbers have wrapped
                                                // round
    return ahead != 0 && ahead < 1U << 31U;
}

bool playing(const PlayingPulse& pulse) { return pulse.at < pulse.length; }

/// Starts the pulse if its number is newer than that of the last pulse. Returns true if it ends another pulse
/// that is still playing.
bool start_pulse(ServoState& state, const Pulse& pulse) {
    if (!newer(pulse.number, state.last_pulse)) return false;
    state.last_pulse = pulse.number;
    PlayingPulse& slot = state.pulses[state.next_pulse];
    const bool cuts_off = playing(slot);
    slot = {pulse.peak, pulse.length, 0};
    state.next_pulse = static_cast<std::uint32_t>((state.next_pulse + 1) % pulses_at_once);
    return cuts_off;
}

vec3 play_pulses(ServoState& state) {
    vec3 force{};
    for (PlayingPulse& pulse : state.pulses) {
        if (!playing(pulse)) continue;
        force += pulse.peak * half_sine(pulse.at, pulse.length);
        ++pulse.at;
    }
    return force;
}

}  // namespace

/// Mean over tick k = `at` of a half sine with a peak of 1 over n = `length` ticks: (n/pi) (cos(pi k/n) -
/// cos(pi (k+1)/n)), written as a product so that no nearly equal numbers are subtracted.
double half_sine(std::uint32_t at, std::uint32_t length) {
    if (at >= length) return 0;
    const double half_tick = pi / (2.0 * length);
    return det::sin(half_tick) / half_tick * det::sin((2.0 * at + 1) * half_tick);
}

PushForce feel_pushes(ServoState& state, const Pulse& newest, const SteadyForce& steady) {
    PushForce push;
    push.cut_off = start_pulse(state, newest);
    push.switched = steady.number != state.steady_force_number;
    state.steady_force_number = steady.number;
    push.force = play_pulses(state) + steady.force;
    return push;
}

}  // namespace thaum::haptics
