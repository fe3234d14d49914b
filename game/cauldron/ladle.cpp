#include "game/cauldron/ladle.h"

#include <algorithm>
#include <cmath>

#include "game/cauldron/brew_pages.h"
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

/// Where in the brew the ladle's holder has it: the probe, held in by the wall.
vec3 tip_of(const Grip& grip) { return grip.servo.fluid.place; }

vec3 velocity_of(const HandFrame& frame, const Grip& grip) {
    return frame.turn * (frame.metres_per_metre * haptics::tip_velocity(grip.servo));
}

haptics::FlowSource source_of(const Stage& stage, std::size_t which) {
    const auto& rules = *stage.data.cauldron;
    const auto& brew = stage.brew->brew;
    const auto fields = fields_of(stage.world, which, brew.fluid, field::Kernel::linear);
    const auto in_brew = [&](field::Grid grid) {
        grid.origin += brew.corner;
        return grid;
    };
    haptics::FlowSource source{.viscosity = rules.density * rules.viscosity, .density = rules.density};
    for (std::size_t axis = 0; axis < 3; ++axis)
        source.velocity.component[axis] = in_brew(fields.velocity.component[axis]);
    for (std::size_t s = 0; s < brew.what.size(); ++s) {
        if (brew.what[s] == no_ingredient) continue;
        const auto& substance = rules.ingredients[brew.what[s]].substance;
        source.substances[s] = {.amount = in_brew(fields.substances[s]),
                                .viscosity = rules.density * substance.viscosity,
                                .density = rules.density * substance.weight};
    }
    return source;
}

/// The flow round the ladle at the newest two steps. It is read anew when a step has ended and where the ladle has come off the
/// middle of what was read; ahead of it, since it is used for a step to come.
void read_flow(const Stage& stage, const Cauldron& cauldron, vec3 place, vec3 velocity, Ladle& ladle,
               haptics::FluidTouch& touch) {
    const double spacing = stage.brew->brew.fluid.lattice.h;
    const bool stale = ladle.patched != cauldron.stepped || glm::distance(place, ladle.patch) > spacing;
    if (stale) {
        ladle.patch = place + limited(velocity * (fluid_dt / 2), spacing);
        ladle.patched = cauldron.stepped;
    }
    if (!stale && touch.newer.spacing > 0) return;
    touch.older = haptics::patch_of(source_of(stage, cauldron.newest ^ 1U), ladle.patch);
    touch.newer = haptics::patch_of(source_of(stage, cauldron.newest), ladle.patch);
}

haptics::BowlWall wall_of(const LadleRules& rules, const Basin& basin) {
    haptics::BowlWall wall{.stiffness = rules.stiffness, .damping = rules.damping};
    wall.points = std::min(basin.profile.size(), wall.profile.size());
    std::copy_n(basin.profile.begin(), wall.points, wall.profile.begin());
    return wall;
}

/// What of the model no tick changes while one stirs.
void begin_touch(const Stage& stage, const Cauldron& cauldron, const Ladle& ladle, std::uint32_t player,
                 haptics::FluidTouch& touch) {
    const auto& data = *stage.data.cauldron;
    const auto& rules = data.ladle;
    const HandFrame frame = ladle_frame(data, cauldron, ladle);
    touch = {.number = 1,
             .modes = stage.touch.brew[player],
             .frame = {.origin = frame.origin - cauldron.middle,
                       .turn = glm::mat3_cast(frame.turn),
                       .metres_per_metre = rules.metres_per_metre,
                       .newtons_per_newton = rules.newtons_per_newton},
             .drag = {.viscous = rules.viscous,
                      .form = rules.form,
                      .stirred_mass = data.density * fluid::pushed_volume(rules.radius),
                      .height = rules.height},
             .wall = wall_of(rules, stage.brew->basin),
             .ladle = {.mass = rules.mass, .stiffness = rules.stiffness, .damping = rules.damping}};
}

void move_ladle(const Stage& stage, Cauldron& cauldron, std::uint32_t player, const Grip& grip, Ladle& ladle,
                Tick tick) {
    const auto& rules = *stage.data.cauldron;
    const vec3 tip = tip_of(grip);
    ladle.place = cauldron.middle + tip;
    ladle.velocity = velocity_of(ladle_frame(rules, cauldron, ladle), grip);
    ladle.force =
        -haptics::whole_drag(stage.models[player].fluid, tip, ladle.velocity, grip.servo.fluid.immersed);
    note_work(ladle, glm::dot(ladle.force, ladle.velocity) * tick_seconds, tick);
    if (ladle.force != vec3(0))
        add_ladle_stroke(cauldron, player, tip, ladle.force * tick_seconds, rules.ladle.radius);
}

/// s, in which who begins to stir has turned his eyes to the brew, but for e^-1 of the way.
constexpr double turning_time = 0.15;

void look_into(const WizardRules& rules, const Cauldron& cauldron, vec3 body, const Ladle& ladle,
               Gaze& gaze) {
    const vec3 way = cauldron.middle - eye_of(rules, body);
    const double share = tick_seconds / turning_time;
    const double left = std::remainder(ladle.yaw - gaze.yaw, 2 * pi);
    gaze.yaw = std::remainder(gaze.yaw + share * left, 2 * pi);
    gaze.pitch += share * (det::atan2(way.y, off_axis(way)) - gaze.pitch);
}

}  // namespace

HandFrame ladle_frame(const CauldronRules& rules, const Cauldron& cauldron, const Ladle& ladle) {
    const quat turn = look_rotation(ladle.yaw, 0);
    return {.origin = cauldron.middle + turn * vec3(0, -rules.ladle.below, rules.ladle.in),
            .turn = turn,
            .metres_per_metre = rules.ladle.metres_per_metre};
}

void feel_brew(Stage& stage, const Grip& grip, std::uint32_t player, Ladle& ladle, Tick tick,
               haptics::FluidTouch& touch) {
    const auto& cauldron = std::as_const(stage.world).single<Cauldron>();
    const auto& sheet = stage.brew->brew.sheet;
    const bool begins = touch.number == 0;
    if (begins) begin_touch(stage, cauldron, ladle, player, touch);
    const HandFrame frame = ladle_frame(*stage.data.cauldron, cauldron, ladle);
    const vec3 place = haptics::held_in(touch.wall, haptics::to_bowl(touch.frame, grip.device.position));
    read_flow(stage, cauldron, place, velocity_of(frame, grip), ladle, touch);
    touch.step_age = static_cast<std::uint64_t>(tick - cauldron.stepped - 1);
    touch.surface = {.height = cauldron.height[player],
                     .velocity = cauldron.rise[player],
                     .stiffness = sheet.settings.contact,
                     .pop_through = sheet.settings.pop_through,
                     .cling = sheet.settings.cling,
                     .inside = cauldron.inside[player],
                     .there = 1};
    // The surface learns of a ladle a tick after it is taken. One that is taken below the surface has not pushed through it.
    const double depth = touch.surface.height - place.y;
    if (begins && depth * touch.surface.stiffness >= touch.surface.pop_through) touch.surface.inside = 1;
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
    schedule.add(
        {.name = "ladles",
         .reads = world.mask<Wizard, Grip, Motion, BrewPage, SurfacePage>(),
         .writes = world.mask<Ladle, Cauldron, Gaze>(),
         .needs = world.mask<Ladle>(),
         .run = [&stage](ecs::World& w, Tick tick) {
             auto& cauldron = w.single<Cauldron>();
             w.view<const Wizard, const Grip, const Motion, Ladle, Gaze>().each(
                 [&](const Wizard& wizard, const Grip& grip, const Motion& motion, Ladle& ladle, Gaze& gaze) {
                     move_ladle(stage, cauldron, wizard.player, grip, ladle, tick);
                     look_into(stage.data.wizard, cauldron, motion.position, ladle, gaze);
                 });
         }});
}

}  // namespace thaum::game
