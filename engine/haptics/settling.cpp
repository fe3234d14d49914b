#include "haptics/settling.h"

#include <algorithm>

namespace thaum::haptics {
namespace {

/// Factors of the bound in each tick: from first_pace to most_pace in 9 ticks, and from there to least_pace in 257.
constexpr double beginning = 0.7, calming = 0.97;
/// Rise of the bound for each newton by which motion stretches the spring. At a steady speed, the bound is thus 5 times
/// the stretch of one tick.
constexpr double freeing = 5 * (1 - calming);
/// Way of the proxy that every tick allows, as a multiple of the tip's way.
constexpr double prompt = 2;
/// Cosines of the angle between two ways from which on the proxy goes straight on: if the balance moves as the proxy and
/// the tip explain, and if it moves farther.
constexpr double straight_on = 0.5, straight_astray = 0.97;
/// Factors of the pace. The first one shrinks it at a turn. The second is so small that a proxy that crosses a ridge
/// every second or third tick still comes to rest. No such proxy goes straight on for longer than `few` ticks, so the
/// last one may be large.
constexpr double at_turn = 0.5, after_turn = 1.2, later = 2;
constexpr std::uint64_t few = 2;

/// Whether the balance has moved farther than the proxy and the tip together. Then the proxy's own step was too large: a
/// whole step to the balance would not come nearer to where all forces cancel.
bool is_astray(const Settling& state, const ProxyWay& way, double moved) {
    const double own = glm::length(state.step) + moved + least_pace / way.stiffness;
    return glm::distance(way.balance, state.balance) > own;
}

void adapt_pace(Settling& state, const ProxyWay& way, double moved) {
    const vec3 wanted = way.balance - way.from;
    const double before = glm::length(state.step);
    const bool counts = way.stiffness * before > least_pace;  // not the noise of rounding
    const bool astray = is_astray(state, way, moved);
    const double straight = astray ? straight_astray : straight_on;
    if (counts && glm::dot(wanted, state.step) < straight * glm::length(wanted) * before) {
        state.pace = at_turn * std::min(state.pace, way.stiffness * before);
        state.straight = 0;
    } else {
        state.pace *= astray || state.straight < few ? after_turn : later;
        ++state.straight;
    }
    state.pace = std::clamp(state.pace, least_pace, state.bound);
}

/// Lets the bound fall by the factor of a tick, and rise with the motion of tip and fields.
void adapt_bound(Settling& state, const ProxyWay& way, double field_motion) {
    const double away = glm::distance(way.tip, state.rest);
    const double motion = std::max(0.0, away - still_range) + field_motion;
    if (away > still_range) state.rest = glm::mix(way.tip, state.rest, still_range / away);
    if (state.bound > most_pace) {
        state.bound = std::max(most_pace, beginning * state.bound);
    } else {
        const double raised = calming * state.bound + freeing * way.stiffness * motion;
        state.bound = std::clamp(raised, least_pace, most_pace);
    }
}

}  // namespace

vec3 settle(Settling& state, const ProxyWay& way) noexcept {
    const vec3 wanted = way.balance - way.from;
    double moved = 0;
    if (state.pace == 0) {
        state.pace = state.bound = first_pace;
        state.rest = way.tip;
    } else {
        const double field_motion = std::max(0.0, way.field_motion);  // 0 if it is not a number
        moved = glm::distance(way.tip, state.tip) + field_motion;
        adapt_bound(state, way, field_motion);
        adapt_pace(state, way, moved);
    }
    state.tip = way.tip;
    state.balance = way.balance;
    const double allowed = state.pace / way.stiffness + prompt * moved;
    state.step = limited(wanted, allowed);
    return state.step == wanted ? way.balance : way.from + state.step;
}

}  // namespace thaum::haptics
