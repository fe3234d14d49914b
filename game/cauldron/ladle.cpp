#include "game/cauldron/ladle.h"

#include <algorithm>
#include <cmath>

#include "game/components/grip.h"
#include "game/match/touch.h"

namespace thaum::game {
namespace {

using input::Button;

constexpr Tick span_length = ticks(0.125);  // of Ladle::work

bool wants_to_stir(const Controls& controls) { return (controls.held & bit(Button::stir)) != 0; }

/// Who stirs from now on, and who does not any more.
void note_stirrers(Stage& stage, Cauldron& cauldron) {
    auto& world = stage.world;
    bool anybody = false;
    world.view<const Controls, const Motion, ecs::Maybe<const Ladle>, ecs::Maybe<const Dead>>().each(
        [&](ecs::Entity e, const Controls& controls, const Motion& motion, const Ladle* ladle,
            const Dead* dead) {
            const bool stirs = dead == nullptr && wants_to_stir(controls) &&
                               within_reach(stage.data, cauldron, motion.position);
            if (stirs && ladle == nullptr) {
                const vec3 in = cauldron.middle - motion.position;
                world.commands().add(e, Ladle{.yaw = det::atan2(-in.x, -in.z)});
                anybody = true;
            } else if (!stirs && ladle != nullptr) {
                world.commands().remove<Ladle>(e);
            }
        });
    if (anybody) touched_brew(stage);
}

/// J into the present span of time.
void note_work(Ladle& ladle, double joules, Tick tick) {
    const auto span = static_cast<std::uint32_t>(tick / span_length % Ladle::spans);
    if (span != ladle.span) ladle.work[span] = 0;
    ladle.span = span;
    ladle.work[span] += joules;
}

void move_ladle(const Stage& stage, Cauldron& cauldron, std::uint32_t player, const Grip& grip, Ladle& ladle,
                Tick tick) {
    const auto& rules = stage.data.cauldron->ladle;
    const HandFrame frame = ladle_frame(*stage.data.cauldron, cauldron, ladle);
    const bool touches = grip.servo.surface.contacts != 0;
    ladle.place = frame.to_world(touches ? grip.servo.surface.proxy : grip.device.position);
    ladle.velocity = frame.turn * (frame.metres_per_metre * haptics::tip_velocity(grip.servo));
    const vec3 in_brew = ladle.place - cauldron.middle;
    const bool wet = ladle.place.y < surface_at(stage.brew.get(), cauldron, ladle.place);
    const vec3 slip = ladle.velocity - current_at(stage.world, stage.brew.get(), ladle.place, tick);
    ladle.force = wet ? rules.drag * slip : vec3(0);
    note_work(ladle, glm::dot(ladle.force, ladle.velocity) * tick_seconds, tick);
    if (ladle.force != vec3(0))
        add_ladle_stroke(cauldron, player, in_brew, ladle.force * tick_seconds, rules.radius);
}

}  // namespace

HandFrame ladle_frame(const CauldronRules& rules, const Cauldron& cauldron, const Ladle& ladle) {
    const quat turn = look_rotation(ladle.yaw, 0);
    return {.origin = cauldron.middle + turn * vec3(0, -rules.ladle.below, rules.ladle.in),
            .turn = turn,
            .metres_per_metre = rules.ladle.metres_per_metre};
}

bool within_reach(const MatchData& data, const Cauldron& cauldron, vec3 body) {
    const double rim = data.arena.bowl->size.radius;
    return off_axis(body - cauldron.middle) < rim + data.cauldron->ladle.reach &&
           std::abs(body.y - cauldron.middle.y) < data.wizard.height;
}

void add_stir_system(Stage& stage, ecs::Schedule& schedule) {
    auto& world = stage.world;
    schedule.add({.name = "stir",
                  .period = gameplay_period,
                  .reads = world.mask<Controls, Motion, Dead>(),
                  .writes = world.mask<Ladle, Cauldron, BrewPage, SurfacePage>(),
                  .needs = world.mask<Cauldron>(),
                  .run = [&stage](ecs::World& w, Tick) { note_stirrers(stage, w.single<Cauldron>()); }});
}

void add_ladle_system(Stage& stage, ecs::Schedule& schedule) {
    auto& world = stage.world;
    schedule.add({.name = "ladles",
                  .reads = world.mask<Wizard, Grip, BrewPage, SurfacePage>(),
                  .writes = world.mask<Ladle, Cauldron>(),
                  .needs = world.mask<Ladle>(),
                  .run = [&stage](ecs::World& w, Tick tick) {
                      auto& cauldron = w.single<Cauldron>();
                      w.view<const Wizard, const Grip, Ladle>().each(
                          [&](const Wizard& wizard, const Grip& grip, Ladle& ladle) {
                              move_ladle(stage, cauldron, wizard.player, grip, ladle, tick);
                          });
                  }});
}

}  // namespace thaum::game
