#include "haptics/settling.h"

#include <algorithm>

namespace thaum::haptics {
namespace {

/// Factor of the bound in each tick of rest: from most_pace to least_pace in 270 ticks.
constexpr double calming = 0.96;
/// Way of the proxy that every tick allows, as a multiple of the tip's way.
constexpr double prompt = 2;
/// Cosine of the angle between two ways from which on the proxy goes straight on. A proxy that circles its balance turns
/// by less than a right angle in each tick.
constexpr double straight_on = 0.5;
/// Factors of the pace. The first one shrinks it at a turn. The second is so small that a proxy that crosses a ridge
/// every second or third tick still comes to rest. No such proxy goes straight on for longer than `few` ticks, so the
/// last one may be large.
constexpr double at_turn = 0.5, after_turn = 1.2, later = 2;
constexpr std::uint64_t few = 2;

void adapt_pace(Settling& state, vec3 wanted, double stiffness) {
    const double before = glm::length(state.step);
    const bool counts = stiffness * before > least_pace;  // not the noise of rounding
    if (counts && glm::dot(wanted, state.step) < straight_on * glm::length(wanted) * before) {
        state.pace = at_turn * std::min(state.pace, stiffness * before);
        state.straight = 0;
    } else {
        state.pace *= state.straight < few ? after_turn : later;
        ++state.straight;
    }
    state.pace = std::clamp(state.pace, least_pace, most_pace);
}

}  // namespace

vec3 settle(Settling& state, const ProxyWay& way) noexcept {
    const vec3 wanted = way.balance - way.from;
    const bool begins = state.pace == 0;
    const double moved = begins ? 0 : glm::distance(way.tip, state.tip) + way.field_motion;
    if (begins)
        state.pace = most_pace;
    else
        adapt_pace(state, wanted, way.stiffness);
    const bool rests = !begins && way.field_motion == 0 && glm::distance(way.tip, state.rest) <= still_range;
    state.bound = rests ? std::max(least_pace, calming * state.bound) : most_pace;
    if (!rests) state.rest = way.tip;
    state.tip = way.tip;
    const double allowed = std::min(state.pace, state.bound) / way.stiffness + prompt * moved;
    state.step = limited(wanted, allowed);
    return state.step == wanted ? way.balance : way.from + state.step;
}

}  // namespace thaum::haptics
