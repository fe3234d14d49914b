#include "game/stations/crystal/chisel.h"

#include <algorithm>
#include <cmath>

#include "core/hash.h"
#include "game/components/casting.h"
#include "game/context/effects.h"
#include "game/context/stations.h"
#include "game/stations/crystal/grain.h"
#include "haptics/volume/smooth_grid.h"
#include "haptics/volume/volume_feel.h"

namespace thaum::game::inline stations {
namespace {

using input::Button;

/// Number by which the servo, the loop that computes the hand's force, knows the haptic primitives of the
/// first crystal before any edit (HapticModel::set_number). When the number changes, the servo fades to the
/// new force.
constexpr std::uint32_t crystal_set = 0x4000'0000;
/// Difference between the numbers of a crystal's haptic primitives (HapticModel::set_number) before and after
/// an edit. It is larger than the number of any crystal, so that no two sets have the same number.
constexpr std::uint32_t crystals_apart = 64;

bool is_down(std::uint32_t buttons, Button button) { return (buttons & bit(button)) != 0; }

// ---- begin and end ----------------------------------------------------------------------------------------

/// The crystal at which a wizard can work; an invalid entity if there is none.
ecs::Entity crystal_near(const MatchContext& context, vec3 body) {
    ecs::Entity near;
    context.world.view<const Crystal>().each([&](ecs::Entity e, const Crystal& crystal) {
        if (within_reach_of_crystal(context.data, crystal, body)) near = e;
    });
    return near;
}

/// Whether a wizard is carving the crystal.
bool is_carved(const ecs::World& world, std::uint32_t number) {
    bool carved = false;
    world.view<const AtStation, const Chisel>().each(
        [&](const AtStation& station, const Chisel&) { carved = carved || station.number == number; });
    return carved;
}

/// If a crystal shows its narrow side to a wizard who begins to carve, turns it so that the flat side with
/// the key is in front. Otherwise the hand would begin inside the crystal and could not get out.
void show_flat_side(const ecs::World& world, const AtStation& station, Crystal& crystal) {
    // The crystal stays as its last carver turned it if its flat side faces the wizard to within this angle
    // (rad).
    constexpr double as_left = pi / 6;
    const double off = std::remainder(station.yaw - crystal.yaw, pi);
    if (std::abs(off) <= as_left || is_carved(world, crystal.number)) return;
    crystal.yaw = std::remainder(crystal.yaw + off, 2 * pi);
}

void begin(MatchContext& context, CrystalBodies& bodies, ecs::Entity wizard, vec3 body) {
    const auto near = crystal_near(context, body);
    if (!near) return;
    auto& world = context.world;
    auto& crystal = world.get<Crystal>(near);
    touch_crystal(context, bodies, crystal);
    const auto station = station_at(body, crystal.middle, StationKind::crystal, crystal.number);
    show_flat_side(std::as_const(world), station, crystal);
    world.commands().add(wizard, station);
    world.commands().add(wizard, Chisel{});
}

/// Adds a Chisel to each wizard who begins to work at a crystal, and removes it when the work ends.
void note_carvers(MatchContext& context, CrystalBodies& bodies) {
    auto& world = context.world;
    world
        .view<const Controls, const Motion, ecs::Maybe<const AtStation>, ecs::Maybe<const Chisel>,
              ecs::Maybe<const Dead>>()
        .each([&](ecs::Entity e, const Controls& controls, const Motion& motion, const AtStation* station,
                  const Chisel* chisel, const Dead* dead) {
            const bool wants = dead == nullptr && is_down(controls.held, Button::stir);
            if (wants && station == nullptr) begin(context, bodies, e, motion.position);
            if (chisel == nullptr || station == nullptr) return;
            const auto at = crystal_entity(std::as_const(world), station->number);
            if (wants &&
                within_reach_of_crystal(context.data, std::as_const(world).get<Crystal>(at), motion.position))
                return;
            world.commands().remove<Chisel>(e);
            world.commands().remove<AtStation>(e);
        });
}

// ---- tools ------------------------------------------------------------------------------------------------

/// A wizard who carves, with the data that one gameplay tick needs.
struct Carver {
    ecs::Entity wizard{};
    std::uint32_t player{};
    const Controls& controls;
    const HandState& hand_state;
    const AtStation& station;
    Tick tick{};
};

void tell(MatchContext& context, const Carver& carver, EventKind kind, std::uint32_t detail, vec3 place) {
    record(context, {.tick = carver.tick,
                     .kind = kind,
                     .subject = carver.player,
                     .by = carver.player,
                     .detail = detail,
                     .place = place});
}

/// Selects the tool by the keys that choose wands elsewhere.
void choose_tool(MatchContext& context, const Carver& carver, Lens& lens) {
    const auto count = static_cast<std::uint32_t>(context.data.crystal->tools.size());
    const auto& controls = carver.controls;
    const auto before = lens.tool;
    lens.tool = std::min(lens.tool, count - 1);  // edited data may have fewer tools
    // While a wizard draws a stroke, the keys of wands cast spells (key chords).
    const bool draws = is_down(controls.held, Button::trace);
    if (!draws && controls.wand_pressed != 0 && controls.wand_pressed <= count)
        lens.tool = controls.wand_pressed - 1;
    if (is_down(controls.pressed, Button::next_wand)) lens.tool = (lens.tool + 1) % count;
    if (is_down(controls.pressed, Button::previous_wand)) lens.tool = (lens.tool + count - 1) % count;
    if (lens.tool != before) tell(context, carver, EventKind::tool_taken, lens.tool, carver.station.middle);
}

/// Position of the hand's proxy (m, device frame). The proxy follows the hand, but the crystal's surface
/// stops it.
vec3 felt_place(const HandState& hand_state) {
    const auto& servo = hand_state.servo;
    return servo.primitives == 0 ? hand_state.device.position : servo.proxy;
}

void reward(MatchContext& context, CrystalBodies& bodies, const Carver& carver, Crystal& crystal) {
    begin_effects(context, carver.wizard, context.data.crystal->effects,
                  {.tick = carver.tick, .place = crystal.middle});
    renew_crystal(context, bodies, crystal);
}

/// Takes the focus (the supply that spells and tools cost) for one gameplay tick of the tool. Returns false
/// if there is too little.
bool pay(MatchContext& context, const Carver& carver, Chisel& chisel) {
    const double cost = context.data.crystal->focus_per_second * gameplay_dt;
    auto* focus = context.world.find<Focus>(carver.wizard);
    if (focus == nullptr) return true;
    if (focus->points < cost) {
        if (chisel.blunt == 0) tell(context, carver, EventKind::blunt, 0, carver.station.middle);
        chisel.blunt = 1;
        return false;
    }
    focus->points -= cost;
    return true;
}

void cut(MatchContext& context, CrystalBodies& bodies, const Carver& carver, Chisel& chisel) {
    auto& world = context.world;
    const bool wants = is_down(carver.controls.held | carver.controls.pressed, Button::fire);
    if (!wants) chisel.blunt = 0;
    const bool cutting = wants && pay(context, carver, chisel);
    auto& crystal = world.get<Crystal>(crystal_entity(std::as_const(world), carver.station.number));
    const auto placement = placement_of(crystal);
    const HandFrame frame = chisel_frame(*context.data.crystal, carver.station);
    const vec3 place = field::to_own(placement, frame.to_world(felt_place(carver.hand_state)));
    if (chisel.cutting == 0) chisel.last = place;
    chisel.cutting = cutting ? 1 : 0;
    if (!cutting) return;
    const field::Dab dab{.place = place,
                         .motion = place - chisel.last,
                         .turn = glm::transpose(placement.turn) * glm::mat3_cast(frame.turn),
                         .seconds = gameplay_dt,
                         .seed = hash_combine(carver.tick, carver.player)};
    chisel.last = place;
    crystal.carver = carver.player;
    const auto& tools = context.data.crystal->tools;
    carve_crystal(context, bodies, crystal, tools[std::as_const(world).get<Lens>(carver.wizard).tool], dab);
    if (crystal.overlap >= context.data.crystal->overlap) reward(context, bodies, carver, crystal);
}

void carve(MatchContext& context, CrystalBodies& bodies, Tick tick) {
    auto& world = context.world;
    world.view<const Wizard, const Controls, const HandState, const AtStation, Chisel, Lens>().each(
        [&](ecs::Entity e, const Wizard& wizard, const Controls& controls, const HandState& hand_state,
            const AtStation& station, Chisel& chisel, Lens& lens) {
            const Carver carver{e, wizard.player, controls, hand_state, station, tick};
            choose_tool(context, carver, lens);
            cut(context, bodies, carver, chisel);
        });
}

// ---- turn -------------------------------------------------------------------------------------------------

/// Stick deflection (of 127) up to which the crystal does not turn, because the player only means to move the
/// hand in or out.
constexpr std::int32_t straight = 40;

/// Turns the crystals by the keys or sticks that walk sideways, for one tick. With the control for the right,
/// the side that the carver sees moves to the right.
void turn_crystals(MatchContext& context) {
    auto& world = context.world;
    const double most = context.data.crystal->turning * tick_seconds;
    world.view<Crystal>().each([](Crystal& crystal) { crystal.turned = 0; });
    world.view<const Controls, const AtStation, const Chisel>().each(
        [&](const Controls& controls, const AtStation& station, const Chisel&) {
            if (std::abs(controls.strafe) < straight) return;
            auto& crystal = world.get<Crystal>(crystal_entity(std::as_const(world), station.number));
            const double turn = most * controls.strafe / 127;
            crystal.yaw = std::remainder(crystal.yaw + turn, 2 * pi);
            crystal.turned += turn;
        });
}

// ---- feel -------------------------------------------------------------------------------------------------

/// Placement of the crystal in the frame of a hand's device.
field::Placement in_hand(const HandFrame& frame, const Crystal& crystal) {
    const auto world = placement_of(crystal);
    return {.origin = frame.to_device(world.origin),
            .turn = glm::mat3_cast(glm::conjugate(frame.turn)) * world.turn,
            .scale = 1 / frame.metres_per_metre};
}

}  // namespace

bool within_reach_of_crystal(const MatchData& data, const Crystal& crystal, vec3 body) {
    return is_near_station(data.wizard, body, crystal.middle, data.crystal->reach);
}

HandFrame chisel_frame(const CrystalRules& rules, const AtStation& station) {
    const quat turn = look_rotation(station.yaw, 0);
    return {.origin = station.middle + turn * vec3(0, 0, rules.hand.in_front),
            .turn = turn,
            .metres_per_metre = rules.hand.metres_per_metre};
}

void feel_crystal(const MatchContext& context, ecs::Entity wizard, const HandState& hand_state,
                  haptics::HapticModel& model) {
    const auto& world = context.world;
    const auto& rules = *context.data.crystal;
    const auto& station = world.get<AtStation>(wizard);
    const auto& crystal = world.get<Crystal>(crystal_entity(world, station.number));
    const HandFrame frame = chisel_frame(rules, station);
    const haptics::SmoothGrid smooth{density_grid(world, crystal, field::Kernel::linear)};
    const field::Placed<field::Scalar> density{field::field_of<field::Scalar>(smooth),
                                               in_hand(frame, crystal)};
    haptics::VolumeFeel feel{.density = field::field_of<field::Scalar>(density), .wall_count = 1};
    feel.walls[0] = {.density = static_cast<double>(crystal_surface),
                     .strength = rules.surface.strength,
                     .friction = rules.surface.friction,
                     .reach = rules.surface.depth * spacing_of(crystal) / frame.metres_per_metre};
    // Each edit, by either player, gives the primitives a new number, so the servo fades to the new force.
    model.set_number = crystal_set + crystal.number + crystals_apart * crystal.edits;
    model.coupling = {.stiffness = std::min(rules.hand.stiffness, context.data.device.max_stiffness),
                      .damping = std::min(rules.hand.damping, context.data.device.max_damping)};
    const vec3 tip = haptics::measured_position(context.input.haptic_setup.device, hand_state.device);
    const auto& servo = hand_state.servo;
    model.field_motion = std::abs(crystal.turned) * glm::distance(tip, frame.to_device(crystal.middle));
    haptics::PrimitiveSet set;
    haptics::add_volume_feel(feel,
                             {.proxy = servo.primitives == 0 ? tip : servo.proxy,
                              .tip = tip,
                              .stiffness = model.coupling.stiffness,
                              .motion = haptics::tip_motion(servo, context.data.device.position_quantum)},
                             set);
    model.primitives = set;
}

void add_carving_systems(MatchContext& context, CrystalResource& crystals, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "crystal turns",
                  .reads = world.mask<Controls, AtStation, Chisel>(),
                  .writes = world.mask<Crystal>(),
                  .needs = world.mask<Chisel>(),
                  .run = [&context](ecs::World&, Tick) { turn_crystals(context); }});
    const auto voxels = world.mask<Crystal, CrystalDensity, CrystalColour, resource::Crystals>();
    schedule.add(
        {.name = "carvers",
         .period = gameplay_period,
         .reads = world.mask<Controls, Motion, Dead, AtStation, Chisel>(),
         .writes = voxels,
         .needs = world.mask<Crystal>(),
         .run = [&context, &crystals](ecs::World&, Tick) { note_carvers(context, crystals.write()); }});
    auto writes = effect_writes(world, context.data.crystal->effects);
    writes |= world.mask<Chisel, Lens, Focus>();
    writes |= voxels;
    auto reads = effect_reads(world);
    reads |= world.mask<Controls, HandState, AtStation>();
    schedule.add(
        {.name = "carving",
         .period = gameplay_period,
         .reads = reads,
         .writes = writes,
         .needs = world.mask<Chisel>(),
         .run = [&context, &crystals](ecs::World&, Tick tick) { carve(context, crystals.write(), tick); }});
}

void add_chisel_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "chisels",
                  .reads = world.mask<HandState, AtStation>(),
                  .writes = world.mask<Chisel>(),
                  .needs = world.mask<Chisel>(),
                  .run = [&context](ecs::World& w, Tick) {
                      w.view<const HandState, const AtStation, Chisel>().each(
                          [&](const HandState& hand_state, const AtStation& station, Chisel& chisel) {
                              const HandFrame frame = chisel_frame(*context.data.crystal, station);
                              chisel.place = frame.to_world(felt_place(hand_state));
                              chisel.force = frame.turn * hand_state.servo.safety.output;
                          });
                  }});
}

}  // namespace thaum::game::inline stations
