#include "game/match/hand/bare_probe.h"

#include <algorithm>

#include "game/context/stations.h"
#include "game/context/surfaces.h"

namespace thaum::game::inline match {
namespace {

/// Surfaces are searched in a sphere around the line from the hand's proxy, which stops at surfaces, to the
/// wand's tip. The sphere reaches this much beyond the line (m), more than any motion of the tip in a tick.
constexpr double margin = 0.15;
/// Displacement of the device frame in one tick above which the wizard was moved by a jump, such as a return
/// to life, and did not walk (m).
constexpr double leap = 0.5;

/// Contact properties that the wand's tip feels. `roughness`: share of the friction that the player wants to
/// feel, 0 to 1.
Feel feel_of(const MatchData& data, double roughness) {
    const ProbeRules& probe = data.haptic_rules.probe;
    return {.stiffness = std::min(probe.stiffness, data.device.max_stiffness),
            .damping = std::min(probe.damping, data.device.max_damping),
            .static_friction = roughness * probe.static_friction,
            .dynamic_friction = roughness * probe.dynamic_friction};
}

double wand_per_hand(const MatchContext& context, ecs::Entity wizard) {
    return context.input.haptic_setup.wand_per_hand[context.world.get<Wizard>(wizard).player];
}

HandFrame frame_of(const MatchContext& context, ecs::Entity wizard, vec3 eye) {
    const auto& gaze = context.world.get<Gaze>(wizard);
    HandFrame frame{.turn = look_rotation(gaze.yaw, gaze.pitch),
                    .metres_per_metre = wand_per_hand(context, wizard)};
    frame.origin = eye + frame.turn * wand_tip;
    return frame;
}

/// Whether the wizard feels surfaces. A wizard feels something else while the wand holds something by a
/// tether (a spring to the hand), or while the wizard works at a station, such as the cauldron.
bool can_probe(const MatchContext& context, ecs::Entity wizard, const HandState& hand_state) {
    return wand_per_hand(context, wizard) > 0 && context.data.haptic_rules.probe.stiffness > 0 &&
           !(hand_state.tether.stiffness > 0) && !context.world.has<Dead>(wizard) &&
           !at_station(context.world, wizard);
}

/// Pushes a touched prop (a loose thing). Its later hits are credited to the player who pushed it, unless the
/// other player moved it within the last seconds (WizardRules::blame). The reason is that a wizard hit by a
/// thrown thing has usually touched that thing with the wand, too.
void push(MatchContext& context, const haptics::SurfaceContact& contact, vec3 impulse, vec3 place,
          const Prop& deed) {
    const auto thing = context.world.entity(contact.key);
    if (!thing || !context.world.has<Prop>(thing) || !context.physics.read().has(contact.key)) return;
    context.physics.write().apply_impulse(contact.key, impulse, place);
    auto& prop = context.world.get<Prop>(thing);
    const bool anothers =
        prop.moved_by < players && deed.moved_at <= prop.moved_at + context.data.wizard.blame;
    if (!anothers || prop.moved_by == deed.moved_by) prop = deed;
}

void push_touched(MatchContext& context, std::uint32_t player, const HandState& hand_state, Tick tick) {
    const auto& rules = context.data.haptic_rules;
    const auto& surface = hand_state.servo.surface;
    const HandFrame frame{hand_state.frame_origin, hand_state.frame_turn,
                          context.input.haptic_setup.wand_per_hand[player]};
    const vec3 place = frame.to_world(surface.proxy);
    for (std::uint32_t i = 0; i < surface.contacts; ++i) {
        const vec3 force = frame.turn * surface.touched[i].force / -rules.probe.newtons_per_newton;
        push(context, surface.touched[i], force * physics_dt, place, {.moved_at = tick, .moved_by = player});
    }
}

}  // namespace

void add_probe_system(MatchContext& context, ecs::Schedule& schedule) {
    if (!(context.data.haptic_rules.probe.newtons_per_newton > 0)) return;
    auto& world = context.world;
    schedule.add({.name = "probe",
                  .period = physics_period,
                  .reads = world.mask<Wizard, HandState, Dead>(),
                  .writes = world.mask<Prop, resource::Physics>(),
                  .needs = world.mask<HandState>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      w.view<const Wizard, const HandState, ecs::Without<Dead>>().each(
                          [&](const Wizard& wizard, const HandState& hand_state) {
                              if (hand_state.probing != 0)
                                  push_touched(context, wizard.player, hand_state, tick);
                          });
                  }});
}

void fill_probe_model(const MatchContext& context, ecs::Entity wizard, HandState& hand_state,
                      haptics::HapticModel& model) {
    model.start = vec3(0);
    model.frame_motion = {};
    model.patch_number = hand_state.probe_number;
    const bool probed = hand_state.probing != 0;
    hand_state.probing = can_probe(context, wizard, hand_state) ? 1 : 0;
    if (hand_state.probing == 0) return clear_patch(model.patch);
    const vec3 eye = eye_of(context.data.wizard, context.world.get<Motion>(wizard).position);
    const HandFrame frame = frame_of(context, wizard, eye);
    HandFrame before{hand_state.frame_origin, hand_state.frame_turn, frame.metres_per_metre};
    const bool jumped = !probed || glm::length(frame.origin - before.origin) > leap;
    if (jumped) {
        before = frame;
        ++hand_state.probe_number;
    }
    hand_state.frame_origin = frame.origin;
    hand_state.frame_turn = frame.turn;
    model.patch_number = hand_state.probe_number;
    model.start = frame.to_device(eye);
    const auto& servo = hand_state.servo;
    const vec3 tip = frame.to_world(hand_state.device.position + servo.contact_offset);
    const vec3 proxy = jumped ? eye : servo.surface.begun != 0 ? before.to_world(servo.surface.proxy) : tip;
    const Around around{.point = 0.5 * (tip + proxy),
                        .radius = 0.5 * glm::length(tip - proxy) + margin,
                        .mask = layer::ground | layer::prop,
                        .ignore = wizard.index};
    const double roughness = context.input.haptic_setup.roughness[context.world.get<Wizard>(wizard).player];
    const Feel feel = feel_of(context.data, roughness);
    model.frame_motion = frame_motion_of(frame, before);
    fill_patch(model.patch, context.physics.read(), around, frame, before, feel);
}

}  // namespace thaum::game::inline match
