#include "game/stations/orb/scrying.h"

#include <algorithm>

#include "game/components/casting.h"
#include "game/context/effects.h"
#include "game/context/stations.h"
#include "game/stations/cauldron/potions.h"
#include "game/stations/orb/orb.h"
#include "game/stations/orb/worn_modes.h"

namespace thaum::game::inline stations {
namespace {

using input::Button;

/// The wizard who scries (searches the orb), and the present tick of play.
struct Scryer {
    ecs::Entity wizard;
    std::uint32_t player{};
    Tick tick{};
};

void tell(MatchContext& context, const Scryer& scryer, EventKind kind, vec3 place, std::uint32_t detail = 0,
          double amount = 0) {
    record(context, {.tick = scryer.tick,
                     .kind = kind,
                     .subject = scryer.player,
                     .by = scryer.player,
                     .detail = detail,
                     .amount = amount,
                     .place = place});
}

// ---- modes ------------------------------------------------------------------------------------------------

/// Switches a haptic mode on or off. Records this, and also that an older mode went off to make room.
void change_mode(MatchContext& context, const Scryer& scryer, vec3 place, std::uint32_t mode,
                 WornModes& modes) {
    const auto before = modes.worn;
    const bool on = put_on_or_off(modes, mode);
    for (const auto old : before)
        if (on && old != no_mode && !wears(modes, old))
            tell(context, scryer, EventKind::mode_worn, place, old, 0);
    tell(context, scryer, EventKind::mode_worn, place, mode, on ? 1 : 0);
}

/// Replaces the newest active haptic mode by the next or previous inactive one.
void step_mode(MatchContext& context, const Scryer& scryer, vec3 place, int step, WornModes& modes) {
    const auto next = neighbour_of_last(modes, context.data.orb->modes.size(), step);
    if (next == no_mode) return;
    if (const auto last = last_worn(modes); last != no_mode) change_mode(context, scryer, place, last, modes);
    change_mode(context, scryer, place, next, modes);
}

/// Changes haptic modes by the keys that choose wands elsewhere. While the button Trace is held, these keys
/// cast spells instead.
void choose_modes(MatchContext& context, const Scryer& scryer, vec3 place, const Controls& controls,
                  WornModes& modes) {
    if ((controls.held & bit(Button::trace)) != 0) return;
    const auto key = controls.wand_pressed;
    if (key != 0 && key <= context.data.orb->modes.size())
        change_mode(context, scryer, place, key - 1, modes);
    const auto pressed = [&](Button button) { return (controls.pressed & bit(button)) != 0; };
    if (pressed(Button::next_wand) || controls.wheel > 0) step_mode(context, scryer, place, 1, modes);
    if (pressed(Button::previous_wand) || controls.wheel < 0) step_mode(context, scryer, place, -1, modes);
}

// ---- curves -----------------------------------------------------------------------------------------------

/// Draws the strength curve of the newest active mode along the hand's motion since the last call. The first
/// millimetres draw nothing, so that a key chord (a wand's key while Trace is held) changes no curve.
void draw(const MatchContext& context, const Scryer& scryer, const DrawnStroke* stroke, WornModes& modes,
          Scrying& scrying) {
    const bool held = stroke != nullptr && stroke->over == 0;
    const auto last = last_worn(modes);
    if (!held || last >= context.data.orb->modes.size()) {
        scrying.drawing = scrying.pen_down = 0;
        return;
    }
    const auto& rules = *context.data.orb;
    const vec3 hand = context.world.get<HandState>(scryer.wizard).device.position;
    if (scrying.pen_down == 0) scrying.pen = hand;
    scrying.pen_down = 1;
    if (scrying.drawing == 0 && glm::distance(hand, scrying.pen) < rules.begins) return;
    scrying.drawing = 1;
    const vec3 reach = context.input.haptic_setup.reach[scryer.player];
    const auto& mode = rules.modes[last];
    draw_curve(rules, mode, on_sheet(rules, mode, scrying.pen, reach), on_sheet(rules, mode, hand, reach),
               modes.strength[last]);
    ++modes.version;
    scrying.pen = hand;
}

// ---- start and end ----------------------------------------------------------------------------------------

bool can_scry(const MatchContext& context, const Scryer& scryer, const Controls& controls,
              const WornModes& modes) {
    const auto& world = context.world;
    const auto* station = world.find<AtStation>(scryer.wizard);
    const bool elsewhere = station != nullptr && station->kind != StationKind::orb;
    return (controls.held & bit(Button::stir)) != 0 && modes.spent == 0 && !elsewhere &&
           !world.has<Dead>(scryer.wizard) && world.get<Focus>(scryer.wizard).points > 0 &&
           within_reach_of_orb(context.data, world.single<Orb>(), world.get<Motion>(scryer.wizard).position);
}

void begin(MatchContext& context, const Scryer& scryer) {
    auto& world = context.world;
    const auto& orb = std::as_const(world).single<Orb>();
    const vec3 body = std::as_const(world).get<Motion>(scryer.wizard).position;
    world.commands().add(scryer.wizard, station_at(body, orb.middle, StationKind::orb));
    world.commands().add(scryer.wizard, Scrying{.place = orb.middle, .distance = 2 * orb.radius});
}

void end(MatchContext& context, const Scryer& scryer) {
    context.world.commands().remove<Scrying>(scryer.wizard);
    context.world.commands().remove<AtStation>(scryer.wizard);
}

/// Takes the focus (the supply that spells cost, too) for a gameplay tick of scrying. Returns false if none
/// is left.
bool pay(MatchContext& context, const Scryer& scryer, WornModes& modes) {
    auto& points = context.world.get<Focus>(scryer.wizard).points;
    points = std::max(0.0, points - context.data.orb->focus * gameplay_dt);
    if (points > 0) return true;
    modes.spent = 1;
    tell(context, scryer, EventKind::unscried, std::as_const(context.world).single<Orb>().middle);
    return false;
}

void follow(MatchContext& context, const Scryer& scryer, const Controls& controls, WornModes& modes) {
    auto& world = context.world;
    if (std::as_const(world).has<Dead>(scryer.wizard)) modes.told = 0;
    if ((controls.held & bit(Button::stir)) == 0) modes.spent = 0;
    const bool scries = can_scry(context, scryer, controls, modes);
    auto* scrying = world.find<Scrying>(scryer.wizard);
    if (scrying == nullptr) {
        if (scries) begin(context, scryer);
        return;
    }
    if (!scries || !pay(context, scryer, modes)) return end(context, scryer);
    choose_modes(context, scryer, scrying->place, controls, modes);
    draw(context, scryer, std::as_const(world).find<DrawnStroke>(scryer.wizard), modes, *scrying);
}

// ---- the probe --------------------------------------------------------------------------------------------

/// Gives the orb's reward: the wizard gets the orb's effects, and is shown the orders of ingredients that
/// were drawn at random for recipes.
void scry(MatchContext& context, const Scryer& scryer, vec3 place, WornModes& modes) {
    const auto& effects = context.data.orb->effects;
    const EffectStart start{.tick = scryer.tick, .place = place};
    const double gained = gain_of(context, scryer.wizard, effects, start);
    begin_effects(context, scryer.wizard, effects, start);
    modes.told = modes.order_told = 1;
    tell(context, scryer, EventKind::scried, place, 0, gained);
    tell_order(context, scryer.player, scryer.tick);
}

void move_probe(MatchContext& context, const Scryer& scryer, const AtStation& station,
                const HandState& hand_state, Scrying& scrying, WornModes& modes) {
    const auto& world = std::as_const(context.world);
    const auto& rules = *context.data.orb;
    const auto& orb = world.single<Orb>();
    const HandFrame frame = probe_frame(rules, orb, station.yaw);
    const auto& servo = hand_state.servo;
    const auto& model = context.output.models.read()[scryer.player];
    scrying.force =
        servo.primitives == 0
            ? vec3(0)
            : frame.turn * (model.coupling.stiffness * (servo.proxy - hand_state.device.position));
    if (scrying.drawing == 0) scrying.place = frame.to_world(hand_state.device.position);
    scrying.distance = distance_from(core_of(orb), scrying.place);
    const bool near = scrying.drawing == 0 && scrying.distance <= rules.core_share * 2 * orb.radius;
    if (near && scrying.near_since == 0) {
        scrying.near_since = std::max<Tick>(scryer.tick, 1);
        tell(context, scryer, EventKind::core_near, scrying.place);
    } else if (!near && scrying.near_since != 0) {
        scrying.near_since = 0;
        tell(context, scryer, EventKind::core_lost, scrying.place);
    }
    if (near && modes.told == 0 && scryer.tick - scrying.near_since >= rules.hold)
        scry(context, scryer, scrying.place, modes);
}

}  // namespace

bool within_reach_of_orb(const MatchData& data, const Orb& orb, vec3 body) {
    return is_near_station(data.wizard, body, orb.middle, orb.radius + data.orb->reach);
}

void add_scrying_system(MatchContext& context, ecs::Schedule& schedule) {
    if (!context.data.orb) return;
    auto& world = context.world;
    schedule.add(
        {.name = "scrying",
         .period = gameplay_period,
         .reads = world.mask<Wizard, Controls, Motion, Dead, Orb, HandState, DrawnStroke>(),
         .writes = world.mask<WornModes, AtStation, Scrying, Focus, EventLog, resource::Journal>(),
         .needs = world.mask<WornModes>(),
         .run = [&context](ecs::World& w, Tick tick) {
             w.view<const Wizard, const Controls, WornModes>().each(
                 [&](ecs::Entity e, const Wizard& wizard, const Controls& controls, WornModes& modes) {
                     follow(context, {e, wizard.player, tick}, controls, modes);
                 });
         }});
}

void add_orb_probe_system(MatchContext& context, ecs::Schedule& schedule) {
    if (!context.data.orb) return;
    auto& world = context.world;
    auto reads = effect_reads(world);
    reads |= world.mask<AtStation, HandState, Orb, DrawnOrders, resource::Models>();
    auto writes = effect_writes(world, context.data.orb->effects);
    writes |= world.mask<Scrying, WornModes>();
    schedule.add(
        {.name = "orb probes",
         .reads = reads,
         .writes = writes,
         .needs = world.mask<Scrying>(),
         .run = [&context](ecs::World& w, Tick tick) {
             w.view<const Wizard, const AtStation, const HandState, Scrying, WornModes, ecs::Without<Dead>>()
                 .each([&](ecs::Entity e, const Wizard& wizard, const AtStation& station,
                           const HandState& hand_state, Scrying& scrying, WornModes& modes) {
                     move_probe(context, {e, wizard.player, tick}, station, hand_state, scrying, modes);
                 });
         }});
}

}  // namespace thaum::game::inline stations
