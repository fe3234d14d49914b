#include "haptics/primitives/settling.h"

#include <algorithm>
#include <cmath>

namespace thaum::haptics {
namespace {

/// Factors by which Settling::bound, the limit of the force's change in a tick, falls in each tick. It falls
/// by `beginning` from first_pace to max_pace in `first_ticks`, and by `calming` from there to min_pace in
/// 227 ticks.
constexpr double beginning = 0.7, calming = 0.97;
/// Rise of Settling::bound (N) for each newton of spring force that motion adds in a tick. At a steady speed,
/// the bound thus settles at 5 times the force that one tick of motion adds.
constexpr double freeing = 5 * (1 - calming);
/// Smallest cosine of the angle between the proxy's last step and its way to the balance, the place where all
/// forces cancel, at which the proxy counts as going straight on, not as turning. `straight_astray` applies
/// if the balance has moved farther than motion explains (is_astray).
constexpr double straight_on = 0.5, straight_astray = 0.97;
/// Factors of the pace, the largest change of the force in a tick. `at_turn` shrinks the pace when the proxy
/// turns. `after_turn` lets it grow in the first `few` ticks that go straight on. It is so small that a proxy
/// that crosses a ridge of the field every second or third tick still comes to rest. After more straight
/// ticks the proxy crosses no ridge, so `later` may be large.
constexpr double at_turn = 0.5, after_turn = 1.2, later = 2;
constexpr std::uint64_t few = 2;

/// Whether the balance of spring and primitives is astray: since the last tick it has moved farther than
/// proxy, tip and fields together, where `moved` is the way of tip and fields (m). This shows that the
/// proxy's last step was too large. A whole step to the balance would come no nearer to the place where all
/// forces cancel.
bool is_astray(const Settling& state, const ProxyWay& way, double moved) {
    const double own = glm::length(state.step) + moved + min_pace / way.spring.stiffness;
    return glm::distance(way.balance, state.balance) > own;
}

void adapt_pace(Settling& state, const ProxyWay& way, double moved) {
    const vec3 wanted = way.balance - way.from;
    const double before = glm::length(state.step);
    // The last step was large enough to have a direction.
    const bool counts = way.spring.stiffness * before > min_pace;
    const bool astray = is_astray(state, way, moved);
    const double straight = astray ? straight_astray : straight_on;
    if (counts && glm::dot(wanted, state.step) < straight * glm::length(wanted) * before) {
        state.pace = at_turn * std::min(state.pace, way.spring.stiffness * before);
        state.straight = 0;
    } else {
        state.pace *= astray || state.straight < few ? after_turn : later;
        ++state.straight;
    }
    state.pace = std::clamp(state.pace, min_pace, state.bound);
}

/// Updates the upper bound of the pace (largest change of the force in a tick). The bound falls by a constant
/// factor in each tick, and rises with the motion of tip and fields.
void adapt_bound(Settling& state, const ProxyWay& way, double field_motion) {
    const double away = glm::distance(way.tip, state.rest);
    const double motion = std::max(0.0, away - still_range) + field_motion;
    if (away > still_range) state.rest = glm::mix(way.tip, state.rest, still_range / away);
    if (state.bound > max_pace) {
        state.bound = std::max(max_pace, beginning * state.bound);
    } else {
        const double raised = calming * state.bound + freeing * way.stiffness * motion;
        state.bound = std::clamp(raised, min_pace, max_pace);
    }
}

/// Force of the spring on the hand if the proxy is at this place (N).
vec3 force_at(const ProxyWay& way, vec3 proxy) { return way.spring.stiffness * (proxy - way.spring.centre); }

/// Part of the spring's and damper's pull on the proxy that is due to the hand's place and velocity (N). The
/// damper's pull towards the proxy's last place is left out. Only changes of the result are used, so it may
/// be off by a constant.
vec3 pull_of_hand(const ProxyWay& way) {
    return way.spring.stiffness * way.spring.centre - (way.spring.stiffness - way.stiffness) * way.from;
}

/// Largest share of the proxy's way, 0 to 1, that changes the force by at most `most` (N). `start` is the
/// change of the force if the proxy stays, and `along` the change that the whole way adds (N). If every share
/// changes it by more, it is the share with the least change.
double share_within(vec3 start, vec3 along, double most) {
    const double square = glm::dot(along, along);
    if (!(square > 0)) return 0;
    const double nearest = -glm::dot(start, along) / square;
    const vec3 across = start + nearest * along;
    const double room = std::max(0.0, most * most - glm::dot(across, across));
    return std::clamp(nearest + std::sqrt(room / square), 0.0, 1.0);
}

/// Share of the way to the balance (the place where all forces cancel), 0 to 1, that the proxy goes: the
/// largest with which the spring's force changes by at most `most` (N).
double share_of_way(const Settling& state, const ProxyWay& way, double most) {
    const vec3 start = force_at(way, way.from) - state.force;
    const vec3 along = way.spring.stiffness * (way.balance - way.from), whole = start + along;
    return glm::dot(whole, whole) <= most * most ? 1 : share_within(start, along, most);
}

}  // namespace

vec3 settle(Settling& state, const ProxyWay& way) noexcept {
    const vec3 pull = pull_of_hand(way);
    const bool begins = state.pace == 0;
    double explained = 0;
    if (begins) {
        state.pace = state.bound = first_pace;
        state.rest = way.tip;
        state.force = force_at(way, way.from);
    } else {
        const double field_motion = std::max(0.0, way.field_motion);  // a motion that is not a number counts
                                                                      // as 0
        adapt_bound(state, way, field_motion);
        adapt_pace(state, way, glm::distance(way.tip, state.tip) + field_motion);
        explained = glm::distance(pull, state.pull) + way.stiffness * field_motion;
    }
    const double share = share_of_way(state, way, state.pace + explained);
    state.step = share * (way.balance - way.from);
    const vec3 proxy = share == 1 ? way.balance : way.from + state.step;
    const vec3 felt_before = state.force + state.lag;
    state.tip = way.tip;
    state.pull = pull;
    state.balance = way.balance;
    state.force = force_at(way, proxy);
    const vec3 change = state.force - felt_before;
    const vec3 felt_change = limited(change, std::max(state.pace, max_pace) + explained);
    state.lag = begins ? vec3(0) : felt_change - change;
    return proxy;
}

}  // namespace thaum::haptics
