#include "haptics/detail/felt_primitives.h"

#include <algorithm>
#include <cmath>

namespace thaum::haptics {
namespace {

/// Bound of the error up to which the balance of spring and primitives (forces on the proxy) counts as solved
/// (N). Beyond it, the forces found for the primitives may be wrong. The hand then feels the spring's force
/// instead, which is right for the proxy that was found.
constexpr double solved_residual = 1e-9;

/// Ticks until the proxy has found its place after the set of primitives has jumped. It takes some ticks
/// because the haptic modes, which make the primitives, read their fields where the proxy was in the last
/// tick.
constexpr std::uint32_t unsettled_ticks = first_ticks;

/// Returns true if the set of primitives (forces on the proxy) appeared, ended or jumped.
bool detect_set_switch(ServoState& state, const HapticModel& model) {
    const auto count = static_cast<std::uint32_t>(model.primitives.items().size());
    const bool jumped = count != state.primitives || (count != 0 && model.set_number != state.set_number);
    state.set_number = count == 0 ? 0 : model.set_number;
    if (jumped) state.settling = {};
    auto& unsettled = state.energy.unsettled;
    unsettled = jumped && count != 0 ? unsettled_ticks : unsettled - std::min(unsettled, 1U);
    return jumped;
}

/// Moves the proxy to, or towards, the place where the force of the spring to the tip and those of the
/// primitives (planes, lines, points and pushes) cancel. Returns the force on the hand (N). The force is zero
/// if the tip's position is not finite or out of range; the proxy then restarts at the tip.
vec3 force_on_proxy(ServoState& state, const HapticModel& model, vec3 tip, vec3 velocity) {
    const vec3 before = state.primitives == 0 ? tip : state.proxy;
    const Spring spring = effective_spring(model.coupling, tip, velocity, before, tick_seconds);
    const Balance found = balance(model.primitives, spring);
    const bool usable = std::isfinite(found.residual);
    state.primitives = usable ? static_cast<std::uint32_t>(model.primitives.items().size()) : 0;
    if (!usable) {
        state.settling = {};
        state.proxy = tip;
        return vec3(0);
    }
    state.proxy = found.proxy;
    if (model.primitives.by_proxy())
        state.proxy = settle(
            state.settling, {before, found.proxy, tip, spring, model.coupling.stiffness, model.field_motion});
    const bool balanced = state.proxy == found.proxy && found.residual <= solved_residual;
    return (balanced ? found.force : spring.stiffness * (state.proxy - spring.centre)) + state.settling.lag;
}

}  // namespace

bool feel_primitives(ServoState& state, const HapticModel& model, const Tip& tip, Sources& sources) {
    const bool switched = detect_set_switch(state, model);
    if (model.primitives.items().empty()) {
        state.proxy = tip.position;
        state.primitives = 0;
        return switched;
    }
    const vec3 force = force_on_proxy(state, model, tip.position, tip.velocity);
    if (!conservative(model.primitives)) {
        sources.active += force;
        return switched;
    }
    sources.passive += force;
    sources.springs += force;
    return switched;
}

}  // namespace thaum::haptics
