#include "game/context/hand_forces.h"

namespace thaum::game::inline context {
namespace {

/// Peak force of the device for which the forces in the wands' files are given (N).
constexpr double reference_peak = 3.3;

/// Force at this player's device per force in the wands' files (N/N). It depends on the device and on the
/// player's settings.
double felt_share(const MatchContext& context, ecs::Entity wizard) {
    const auto player = context.world.get<Wizard>(wizard).player;
    return force_cap(context.input.haptic_setup, player) / reference_peak;
}

}  // namespace

HandState empty_hand_state() {
    HandState hand_state;
    hand_state.device = haptics::resting_at({});
    return hand_state;
}

void kick_at_peak(MatchContext& context, ecs::Entity wizard, double share, Tick length) {
    kick(context, wizard, vec3(0, 0, share * reference_peak), length);
}

void recoil(MatchContext& context, ecs::Entity wizard, double newtons, Tick length) {
    const auto player = std::as_const(context.world).get<Wizard>(wizard).player;
    const double share = context.input.haptic_setup.recoil[player];
    if (share > 0) kick(context, wizard, vec3(0, 0, share * newtons), length);
}

void kick(MatchContext& context, ecs::Entity wizard, vec3 newtons, Tick length) {
    auto& hand_state = context.world.get<HandState>(wizard);
    hand_state.kick = {.peak = newtons * felt_share(context, wizard),
                       .length = static_cast<std::uint32_t>(length),
                       .number = hand_state.kick.number + 1};
}

void set_steady_force(MatchContext& context, ecs::Entity wizard, vec3 newtons) {
    context.world.get<HandState>(wizard).steady_force.force = newtons * felt_share(context, wizard);
}

void tether(MatchContext& context, ecs::Entity wizard, const haptics::Tether& to) {
    auto& held = context.world.get<HandState>(wizard).tether;
    const bool jumps = (held.stiffness > 0) != (to.stiffness > 0);
    const auto number = held.number + (jumps ? 1 : 0);
    held = to;
    held.number = number;
}

void let_go(MatchContext& context, ecs::Entity wizard) {
    auto& hand_state = context.world.get<HandState>(wizard);
    if (hand_state.steady_force.force != vec3(0))
        hand_state.steady_force = {.force = {}, .number = hand_state.steady_force.number + 1};
    tether(context, wizard, {});
    hand_state.pull = {};
}

vec3 wand_tip_of(double wand_per_hand, const HandState& hand_state) {
    const auto& servo = hand_state.servo;
    const bool touches = servo.surface.contacts != 0;
    return wand_tip + wand_per_hand *
                          (touches ? servo.surface.proxy : hand_state.device.position + servo.contact_offset);
}

}  // namespace thaum::game::inline context
