#include "game/match/bare_probe.h"

#include <algorithm>

#include "game/components/cauldron.h"
#include "game/match/surfaces.h"
#include "game/match/touch.h"

namespace thaum::game {
namespace {

/// m, beyond the way from proxy to tip: more than view and hand move the tip in a tick.
constexpr double margin = 0.15;
/// m; what moves farther in a tick does not walk.
constexpr double leap = 0.5;

Feel feel_of(const MatchData& data) {
    const ProbeRules& probe = data.touch.probe;
    return {.stiffness = std::min(probe.stiffness, data.device.max_stiffness),
            .damping = std::min(probe.damping, data.device.max_damping),
            .static_friction = probe.static_friction,
            .dynamic_friction = probe.dynamic_friction};
}

double wand_per_hand(const Stage& stage, ecs::Entity wizard) {
    return stage.touch.wand_per_hand[stage.world.get<Wizard>(wizard).player];
}

HandFrame frame_of(const Stage& stage, ecs::Entity wizard, vec3 eye) {
    const auto& gaze = stage.world.get<Gaze>(wizard);
    HandFrame frame{.turn = look_rotation(gaze.yaw, gaze.pitch),
                    .metres_per_metre = wand_per_hand(stage, wizard)};
    frame.origin = eye + frame.turn * wand_tip;
    return frame;
}

/// Who holds something by a tether feels that, who stirs the brew.
bool can_probe(const Stage& stage, ecs::Entity wizard, const Grip& grip) {
    return wand_per_hand(stage, wizard) > 0 && stage.data.touch.probe.stiffness > 0 &&
           !(grip.tether.stiffness > 0) && !stage.world.has<Dead>(wizard) && !stage.world.has<Ladle>(wizard);
}

/// What it does is then the deed of who pushed it; but not where another has set it going just before: who is struck by a thing has
/// mostly touched it with the wand.
void push(Stage& stage, const haptics::SurfaceContact& contact, vec3 impulse, vec3 place, const Prop& deed) {
    const auto thing = stage.world.entity(contact.key);
    if (!thing || !stage.world.has<Prop>(thing) || !stage.physics.has(contact.key)) return;
    stage.physics.apply_impulse(contact.key, impulse, place);
    auto& prop = stage.world.get<Prop>(thing);
    const bool anothers = prop.moved_by < players && deed.moved_at <= prop.moved_at + stage.data.wizard.blame;
    if (!anothers || prop.moved_by == deed.moved_by) prop = deed;
}

void push_touched(Stage& stage, std::uint32_t player, const Grip& grip, Tick tick) {
    const auto& rules = stage.data.touch;
    const auto& surface = grip.servo.surface;
    const HandFrame frame{grip.frame_origin, grip.frame_turn, stage.touch.wand_per_hand[player]};
    const vec3 place = frame.to_world(surface.proxy);
    for (std::uint32_t i = 0; i < surface.contacts; ++i) {
        const vec3 force = frame.turn * surface.touched[i].force / -rules.probe.newtons_per_newton;
        push(stage, surface.touched[i], force * physics_dt, place, {.moved_at = tick, .moved_by = player});
    }
}

}  // namespace

void add_probe_system(Stage& stage, ecs::Schedule& schedule) {
    if (!(stage.data.touch.probe.newtons_per_newton > 0)) return;
    auto& world = stage.world;
    schedule.add({.name = "probe",
                  .period = physics_period,
                  .reads = world.mask<Wizard, Grip, Dead>(),
                  .writes = world.mask<Prop>(),
                  .needs = world.mask<Grip>(),
                  .run = [&stage](ecs::World& w, Tick tick) {
                      w.view<const Wizard, const Grip, ecs::Without<Dead>>().each(
                          [&](const Wizard& wizard, const Grip& grip) {
                              if (grip.probing != 0) push_touched(stage, wizard.player, grip, tick);
                          });
                  }});
}

void feel_about(const Stage& stage, ecs::Entity wizard, Grip& grip, haptics::HapticModel& model) {
    model.patch.count = 0;
    model.drift = {};
    model.patch_number = grip.probe_number;
    const bool probed = grip.probing != 0;
    grip.probing = can_probe(stage, wizard, grip) ? 1 : 0;
    if (grip.probing == 0) return;
    const vec3 eye = eye_of(stage.data.wizard, stage.world.get<Motion>(wizard).position);
    const HandFrame frame = frame_of(stage, wizard, eye);
    HandFrame before{grip.frame_origin, grip.frame_turn, frame.metres_per_metre};
    const bool jumped = !probed || glm::length(frame.origin - before.origin) > leap;
    if (jumped) {
        before = frame;
        ++grip.probe_number;
    }
    grip.frame_origin = frame.origin;
    grip.frame_turn = frame.turn;
    model.patch_number = grip.probe_number;
    model.start = frame.to_device(eye);
    model.drift = drift_of(frame, before);
    const auto& servo = grip.servo;
    const vec3 tip = frame.to_world(grip.device.position + servo.shift);
    const vec3 proxy = jumped ? eye : servo.surface.begun != 0 ? before.to_world(servo.surface.proxy) : tip;
    const Around around{.point = 0.5 * (tip + proxy),
                        .radius = 0.5 * glm::length(tip - proxy) + margin,
                        .mask = layer::ground | layer::prop,
                        .ignore = wizard.index};
    fill_patch(model.patch, stage.physics, around, frame, before, feel_of(stage.data));
}

}  // namespace thaum::game
