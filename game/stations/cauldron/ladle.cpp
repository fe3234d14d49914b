#include "game/stations/cauldron/ladle.h"

#include <algorithm>

#include "game/brew/brew_state.h"
#include "game/components/hand_state.h"

namespace thaum::game::inline stations {
namespace {

using input::Button;

// period of one entry of Ladle::work, which has the work on the brew in the last 1.5 s (ticks)
constexpr Tick span_length = ticks(0.125);

bool wants_to_stir(const Controls& controls) { return (controls.held & bit(Button::stir)) != 0; }

/// Adds a Ladle to each wizard who begins to stir and removes it when stirring ends.
void note_stirrers(MatchContext& context, BrewResource& brew, Cauldron& cauldron) {
    auto& world = context.world;
    bool anybody = false;
    world.view<const Controls, const Motion, ecs::Maybe<const Ladle>, ecs::Maybe<const Dead>>().each(
        [&](ecs::Entity e, const Controls& controls, const Motion& motion, const Ladle* ladle,
            const Dead* dead) {
            const bool stirs = dead == nullptr && wants_to_stir(controls) &&
                               within_reach(context.data, cauldron, motion.position);
            if (stirs && ladle == nullptr) {
                world.commands().add(e, station_at(motion.position, cauldron.middle, StationKind::cauldron));
                world.commands().add(e, Ladle{});
                anybody = true;
            } else if (!stirs && ladle != nullptr) {
                world.commands().remove<Ladle>(e);
                world.commands().remove<AtStation>(e);
            }
        });
    if (anybody) touch_brew(context, brew.write());
}

/// Adds work of the ladle on the brew (J) to the entry of Ladle::work for the present period.
void note_work(Ladle& ladle, double joules, Tick tick) {
    const auto span = static_cast<std::uint32_t>(tick / span_length % Ladle::spans);
    if (span != ladle.span) ladle.work[span] = 0;
    ladle.span = span;
    ladle.work[span] += joules;
}

/// Position of the ladle's tip (m, brew's frame). It is the haptic probe, the point that the hand moves,
/// which is kept inside the bowl's wall.
vec3 tip_of(const HandState& hand_state) { return hand_state.servo.fluid.place; }

vec3 velocity_of(const HandFrame& frame, const HandState& hand_state) {
    return frame.turn * (frame.metres_per_metre * haptics::tip_velocity(hand_state.servo));
}

haptics::FlowSource source_of(const MatchContext& context, const Brew& brew, std::size_t which) {
    const auto& rules = *context.data.cauldron;
    const auto& changes = changes_of(context.data, context.world.single<Cauldron>());
    const double density = rules.density * changes.density;
    const auto fields = fields_of(context.world, which, brew.fluid, field::Kernel::linear);
    const auto in_brew = [&](field::Grid grid) {
        grid.origin += brew.corner;
        return grid;
    };
    haptics::FlowSource source{.viscosity = density * rules.viscosity * changes.viscosity,
                               .density = density};
    for (std::size_t axis = 0; axis < 3; ++axis)
        source.velocity.component[axis] = in_brew(fields.velocity.component[axis]);
    for (std::size_t s = 0; s < brew.contents.size(); ++s) {
        if (brew.contents[s] == no_ingredient) continue;
        const auto& substance = rules.ingredients[brew.contents[s]].substance;
        source.substances[s] = {.amount = in_brew(fields.substances[s]),
                                .viscosity = density * substance.viscosity,
                                .density = density * substance.weight};
    }
    return source;
}

/// Samples the flow around the ladle from the two newest fluid states. This is done again after each fluid
/// step, and when the ladle has left the middle of the sampled patch. The patch is centred ahead of the
/// ladle, since the ladle moves on in the ticks that use it.
void read_flow(const MatchContext& context, const Brew& brew, const Cauldron& cauldron, vec3 place,
               vec3 velocity, Ladle& ladle, haptics::FluidTouch& fluid) {
    const double spacing = brew.fluid.lattice.h;
    const bool stale = ladle.patched != cauldron.stepped || glm::distance(place, ladle.patch) > spacing;
    if (stale) {
        ladle.patch = place + limited(velocity * (fluid_dt / 2), spacing);
        ladle.patched = cauldron.stepped;
    }
    if (!stale && fluid.newer.spacing > 0) return;
    fluid.older = haptics::patch_of(source_of(context, brew, cauldron.newest ^ 1U), ladle.patch);
    fluid.newer = haptics::patch_of(source_of(context, brew, cauldron.newest), ladle.patch);
}

haptics::BowlWall wall_of(const LadleRules& rules, const Basin& basin) {
    haptics::BowlWall wall{.stiffness = rules.stiffness, .damping = rules.damping};
    wall.points = std::min(basin.profile.size(), wall.profile.size());
    std::copy_n(basin.profile.begin(), wall.points, wall.profile.begin());
    return wall;
}

double stirred_mass(const MatchData& data, const Cauldron& cauldron) {
    return data.cauldron->density * changes_of(data, cauldron).density *
           fluid::pushed_volume(data.cauldron->ladle.radius);
}

/// Sets the parts of the hand's haptic model of the fluid that stay constant while a player stirs.
void begin_touch(const MatchContext& context, const Basin& basin, const Cauldron& cauldron, double yaw,
                 std::uint32_t player, haptics::FluidTouch& fluid) {
    const auto& data = *context.data.cauldron;
    const auto& rules = data.ladle;
    const HandFrame frame = ladle_frame(data, cauldron, yaw);
    fluid = {.number = 1,
             .modes = context.input.haptic_setup.brew[player],
             .frame = {.origin = frame.origin - cauldron.middle,
                       .turn = glm::mat3_cast(frame.turn),
                       .metres_per_metre = rules.metres_per_metre,
                       .newtons_per_newton = rules.newtons_per_newton},
             .drag = {.viscous = rules.viscous,
                      .form = rules.form,
                      .stirred_mass = stirred_mass(context.data, cauldron),
                      .height = rules.height},
             .wall = wall_of(rules, basin),
             .ladle = {.mass = rules.mass, .stiffness = rules.stiffness, .damping = rules.damping}};
}

void move_ladle(const MatchContext& context, Cauldron& cauldron, std::uint32_t player,
                const HandState& hand_state, double yaw, Ladle& ladle, Tick tick) {
    const auto& rules = *context.data.cauldron;
    const vec3 tip = tip_of(hand_state);
    ladle.place = cauldron.middle + tip;
    ladle.velocity = velocity_of(ladle_frame(rules, cauldron, yaw), hand_state);
    ladle.force = -haptics::full_drag(context.output.models.read()[player].fluid, tip, ladle.velocity,
                                      hand_state.servo.fluid.immersed);
    note_work(ladle, glm::dot(ladle.force, ladle.velocity) * tick_seconds, tick);
    if (ladle.force != vec3(0))
        add_ladle_stroke(cauldron, player, tip, ladle.force * tick_seconds, rules.ladle.radius);
}

}  // namespace

HandFrame ladle_frame(const CauldronRules& rules, const Cauldron& cauldron, double yaw) {
    const quat turn = look_rotation(yaw, 0);
    return {.origin = cauldron.middle + turn * vec3(0, -rules.ladle.below, rules.ladle.in),
            .turn = turn,
            .metres_per_metre = rules.ladle.metres_per_metre};
}

void feel_brew(const MatchContext& context, const BrewWork& work, ecs::Entity wizard, Ladle& ladle, Tick tick,
               haptics::FluidTouch& fluid) {
    const auto& hand_state = context.world.get<HandState>(wizard);
    const auto player = context.world.get<Wizard>(wizard).player;
    const double yaw = context.world.get<AtStation>(wizard).yaw;
    const auto& cauldron = context.world.single<Cauldron>();
    const auto& surface = work.brew.surface;
    const bool begins = fluid.number == 0;
    if (begins) begin_touch(context, work.basin, cauldron, yaw, player, fluid);
    fluid.drag.stirred_mass = stirred_mass(context.data, cauldron);
    const HandFrame frame = ladle_frame(*context.data.cauldron, cauldron, yaw);
    const vec3 place =
        haptics::nearest_in_bowl(fluid.wall, haptics::to_bowl(fluid.frame, hand_state.device.position));
    read_flow(context, work.brew, cauldron, place, velocity_of(frame, hand_state), ladle, fluid);
    fluid.step_age = static_cast<std::uint64_t>(tick - cauldron.stepped - 1);
    fluid.surface = {.height = cauldron.height[player],
                     .velocity = cauldron.surface_speed[player],
                     .stiffness = surface.settings.contact,
                     .pop_through = surface.settings.pop_through,
                     .cling = surface.settings.cling,
                     .inside = cauldron.inside[player],
                     .present = 1};
    // The surface knows of a new ladle only one tick later. A ladle that starts below the surface counts as
    // already inside.
    const double depth = fluid.surface.height - place.y;
    if (begins && depth * fluid.surface.stiffness >= fluid.surface.pop_through) fluid.surface.inside = 1;
}

bool within_reach(const MatchData& data, const Cauldron& cauldron, vec3 body) {
    const double rim = data.arena.bowl->size.radius;
    return is_near_station(data.wizard, body, cauldron.middle, rim + data.cauldron->ladle.reach);
}

void add_stir_system(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add(
        {.name = "stir",
         .period = gameplay_period,
         .reads = world.mask<Controls, Motion, Dead>(),
         .writes = world.mask<Ladle, AtStation, Cauldron, BrewSamples, SurfaceSamples, resource::Brew>(),
         .needs = world.mask<Cauldron>(),
         .run = [&context, &brew](ecs::World& w, Tick) {
             note_stirrers(context, brew, w.single<Cauldron>());
         }});
}

void add_ladle_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "ladles",
                  .reads = world.mask<Wizard, HandState, AtStation, resource::Models>(),
                  .writes = world.mask<Ladle, Cauldron>(),
                  .needs = world.mask<Ladle>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      auto& cauldron = w.single<Cauldron>();
                      w.view<const Wizard, const HandState, const AtStation, Ladle>().each(
                          [&](const Wizard& wizard, const HandState& hand_state, const AtStation& station,
                              Ladle& ladle) {
                              move_ladle(context, cauldron, wizard.player, hand_state, station.yaw, ladle,
                                         tick);
                          });
                  }});
}

}  // namespace thaum::game::inline stations
