#include "game/casting/casting.h"

#include <algorithm>
#include <memory>

#include "game/components/cauldron.h"
#include "game/components/crystal.h"
#include "game/components/hand_state.h"
#include "game/components/orb.h"
#include "game/components/station.h"
#include "game/context/effects.h"
#include "game/data/reading.h"
#include "game/stations/cauldron/potions.h"

namespace thaum::game::inline casting {
namespace {

using input::Button;

// ---- the stroke -------------------------------------------------------------------------------------------

/// Position of a hand that draws in the air, turned into a point of the stroke.
vec3 point_in_air(const HandState& hand_state, const DrawnStroke& trace) {
    return hand_state.device.position + trace.beyond;
}

/// Position of a hand that draws on the brew with the ladle, turned into a point of the stroke.
vec3 point_on_brew(const HandState& hand_state, const DrawnStroke& trace) {
    const vec3 at = hand_state.device.position + trace.beyond;
    return {at.x, -at.z, at.y};
}

/// Drops every second point of a stroke that has reached its capacity, to make room for more.
void thin(DrawnStroke& trace) {
    for (std::uint32_t i = 0; i < trace.count / 2; ++i) trace.points[i] = trace.points[2 * i];
    trace.count /= 2;
    trace.every *= 2;
}

/// Adds the current position of the hand to the stroke. The stored force is always the viscous one that a
/// hand feels in the air, even on the brew. With the brew's drag, which grows with the square of the speed,
/// half of the slow strokes would not be recognised, and each brew would have another limit between gentle
/// and harsh.
void append(const CastingRules& rules, const HandState& hand_state, const Ladle* ladle, DrawnStroke& trace) {
    if (trace.waits > 0) {
        --trace.waits;
        return;
    }
    if (trace.count == trace.points.size()) thin(trace);
    const vec3 at = ladle != nullptr ? point_on_brew(hand_state, trace) : point_in_air(hand_state, trace);
    double force = 0;
    if (trace.count > 0) {
        const auto& last = trace.points[trace.count - 1];
        force =
            rules.viscosity * glm::distance(at, vec3(last.x, last.y, last.z)) / (trace.every * gameplay_dt);
    }
    trace.points[trace.count++] = {static_cast<float>(at.x), static_cast<float>(at.y),
                                   static_cast<float>(at.z), static_cast<float>(force)};
    trace.waits = trace.every - 1;
}

// ---- casting ----------------------------------------------------------------------------------------------

Event event_of(const MatchContext& context, const Caster& caster, EventKind kind, std::uint32_t detail,
               double amount) {
    return {.tick = caster.tick,
            .kind = kind,
            .subject = caster.player,
            .by = caster.player,
            .detail = detail,
            .amount = amount,
            .place = context.world.get<Motion>(caster.wizard).position};
}

void cast(MatchContext& context, const Caster& caster, const LoadedSpell& spell, double force) {
    const auto& rules = *context.data.casting;
    const bool harsh = force >= rules.harsh_from;
    const double cost = spell.stats.focus * (harsh ? rules.harsh_cost : 1);
    const auto number = static_cast<std::uint32_t>(&spell - context.data.spells.data());
    auto& focus = context.world.get<Focus>(caster.wizard);
    const auto tell = [&](EventKind kind, double amount) {
        record(context, event_of(context, caster, kind, number, amount));
    };
    if (focus.points < cost) return tell(EventKind::unfocused, cost - focus.points);
    if (const auto refusal = spell.rules->refusal(context, caster.wizard); !refusal.empty()) {
        context.output.strokes.write()[caster.player].refusal = refusal;
        return tell(EventKind::fizzled, 0);
    }
    focus.points -= cost;
    const double strength = harsh ? rules.harsh_strength : 1;
    tell(EventKind::cast, strength);
    spell.rules->cast({context, caster.wizard, caster.tick, strength});
    const vec3 place = std::as_const(context.world).get<Motion>(caster.wizard).position;
    begin_effects(context, caster.wizard, spell.effects,
                  {.tick = caster.tick, .place = place, .strength = strength});
}

}  // namespace

void act_on(MatchContext& context, const Caster& caster, const Reading& reading, const GestureSet& gestures) {
    if (context.input.strokes_unread[caster.player]) return;
    const auto& stroke = reading.stroke;
    context.world.get<LastReading>(caster.wizard) = {.at = std::max<Tick>(caster.tick, 1),
                                                     .probability = stroke.probability,
                                                     .force = stroke.force,
                                                     .turns = stroke.turns,
                                                     .gesture = stroke.gesture,
                                                     .nearest = reading.nearest};
    if (std::as_const(context.world).has<Ladle>(caster.wizard)) {
        const auto* drawn = std::as_const(context.world).find<DrawnStroke>(caster.wizard);
        return brew_by_stroke(context, caster.wizard, {stroke, drawn == nullptr ? 0 : drawn->reached},
                              caster.tick);
    }
    const auto* spell = stroke.gesture == no_gesture
                            ? nullptr
                            : spell_of(context.data, gestures.gestures()[stroke.gesture].name);
    if (spell != nullptr) return cast(context, caster, *spell, stroke.force);
    record(context, event_of(context, caster, EventKind::unread, reading.nearest, stroke.probability));
}

namespace {

/// The reading that replaces the reading of a stroke after a key chord (a wand's key pressed while Trace is
/// held). It is the gesture of the key's spell, with probability 1.
Reading chord_reading(const MatchContext& context, const GestureSet& gestures, const Controls& controls) {
    const auto& rules = *context.data.casting;
    Reading reading;
    for (const auto& spell : context.data.spells) {
        const auto gesture = gestures.number(spell.stats.gesture);
        if (spell.stats.slot + 1 != controls.wand_pressed || !gesture) continue;
        reading.nearest = reading.stroke.gesture = *gesture;
        reading.stroke.probability = 1;
        reading.stroke.force = controls.harsh != 0 ? rules.harsh_from : rules.gentle_below / 2;
        // A key chord (a wand's key while Trace is held) has no sense of rotation, so its circle fits recipes
        // that ask for either sense.
    }
    return reading;
}

/// Casts the spell of a key chord (a wand's key while Trace is held), and records the key for the screen.
void act_by_chord(MatchContext& context, const Caster& caster, const Reading& chord, std::uint32_t slot) {
    auto& ended = context.output.strokes.write()[caster.player];
    ended.chord_at = std::max<Tick>(caster.tick, 1);
    ended.chord_slot = slot;
    act_on(context, caster, chord, *gestures_of(context, caster.player));
}

/// Records the finished stroke, so that the screen can show it.
void keep(MatchContext& context, const Caster& caster, const DrawnStroke& trace) {
    const auto& reading = context.world.get<LastReading>(caster.wizard);
    const bool read = reading.at == std::max<Tick>(caster.tick, 1) && reading.gesture != no_gesture;
    auto& ended = context.output.strokes.write()[caster.player];
    ended.stroke = trace;
    ended.at = std::max<Tick>(caster.tick, 1);
    ended.read = read;
}

bool is_at(const ecs::World& world, ecs::Entity wizard, StationKind kind) {
    const auto* station = world.find<AtStation>(wizard);
    return station != nullptr && station->kind == kind;
}

/// In each gameplay tick, begins, continues or ends the stroke of one wizard.
void follow(MatchContext& context, ReadingSpace& space, const Caster& caster, DrawnStroke& trace) {
    auto& world = context.world;
    const auto& controls = std::as_const(world).get<Controls>(caster.wizard);
    const auto* gestures = gestures_of(context, caster.player);
    const auto* ladle = std::as_const(world).find<Ladle>(caster.wizard);
    auto& hand_state = world.get<HandState>(caster.wizard);
    const bool dead = std::as_const(world).has<Dead>(caster.wizard);
    const bool held = (controls.held & bit(Button::trace)) != 0;
    const bool moved_on = (ladle != nullptr) != (trace.on_brew != 0) ||
                          is_at(world, caster.wizard, StationKind::orb) != (trace.on_orb != 0);
    if (moved_on) trace.over = 1;
    if (ladle != nullptr && trace.count == 0) trace.reached = std::as_const(world).single<Cauldron>().reached;
    if (!dead && trace.over == 0) append(*context.data.casting, hand_state, ladle, trace);
    if (!dead && held && controls.wand_pressed != 0 && trace.over == 0) {
        const auto chord = chord_reading(context, *gestures, controls);
        trace.over = by_chord;
        if (chord.stroke.gesture != no_gesture)
            act_by_chord(context, caster, chord, controls.wand_pressed - 1);
    }
    if (held && !dead) return;
    if (!dead && trace.over == 0 && trace.on_orb == 0 && !is_slip(*context.data.casting, trace))
        act_on(context, caster, read_drawn(*gestures, trace, space), *gestures);
    if (trace.on_brew == 0) hand_state.home = trace.home;
    if (!dead && trace.on_orb == 0) keep(context, caster, trace);
    world.commands().remove<DrawnStroke>(caster.wizard);
}

/// Adds the system that gives focus (what spells cost) back over time. It gives none while a wizard searches
/// the orb or uses a carving tool, because both cost focus and would otherwise be free.
void add_focus_system(MatchContext& context, ecs::Schedule& schedule) {
    schedule.add(
        {.name = "focus",
         .period = gameplay_period,
         .reads = context.world.mask<Dead, Scrying, Chisel>(),
         .writes = context.world.mask<Focus>(),
         .needs = context.world.mask<Focus>(),
         .run = [&context](ecs::World& w, Tick) {
             const auto& rules = *context.data.casting;
             w.view<Focus, ecs::Maybe<const Chisel>, ecs::Without<Dead>, ecs::Without<Scrying>>().each(
                 [&](Focus& focus, const Chisel* chisel) {
                     if (chisel != nullptr && chisel->cutting != 0) return;
                     focus.points =
                         std::min(rules.focus_cap, focus.points + rules.focus_regain * gameplay_dt);
                 });
         }});
}

}  // namespace

CastingAccess access_of_casting(const MatchContext& context) {
    const auto& world = context.world;
    CastingAccess access{.reads = world.mask<Wizard, Controls, Dead, Ladle, AtStation, Motion>(),
                         .writes = world.mask<DrawnStroke, HandState, Focus, LastReading, EventLog,
                                              resource::Journal, resource::Strokes>()};
    // A spell may ask the wand in hand what it holds, so this system declares that it reads everything that
    // any wand writes.
    for (const auto& wand : context.data.wands) access.reads |= wand.rules->writes(world);
    if (context.data.cauldron) {
        access.reads |= brew_by_stroke_reads(world);
        access.writes |= brew_by_stroke_writes(context);
    }
    for (const auto& spell : context.data.spells) {
        access.reads |= spell.rules->reads(world);
        access.writes |= spell.rules->writes(world);
        access.writes |= effect_writes(world, spell.effects);
    }
    return access;
}

void begin_stroke(MatchContext& context, ecs::Entity wizard) {
    auto& world = context.world;
    if (!context.data.gestures || std::as_const(world).has<DrawnStroke>(wizard)) return;
    world.commands().add(wizard, DrawnStroke{.on_brew = is_at(world, wizard, StationKind::cauldron) ? 1U : 0U,
                                             .on_orb = is_at(world, wizard, StationKind::orb) ? 1U : 0U,
                                             .home = std::as_const(world).get<HandState>(wizard).home});
}

void add_casting_systems(MatchContext& context, ecs::Schedule& schedule) {
    if (!context.data.gestures) return;
    add_focus_system(context, schedule);
    const auto access = access_of_casting(context);
    schedule.add({.name = "strokes",
                  .period = gameplay_period,
                  .reads = access.reads,
                  .writes = access.writes,
                  .needs = context.world.mask<DrawnStroke>(),
                  .run = [&context, space = std::make_shared<ReadingSpace>()](ecs::World& w, Tick tick) {
                      w.view<const Wizard, DrawnStroke>().each(
                          [&](ecs::Entity e, const Wizard& wizard, DrawnStroke& trace) {
                              follow(context, *space, {e, wizard.player, tick}, trace);
                          });
                  }});
    for (const auto& spell : context.data.spells) spell.rules->add_systems({context, schedule});
}

}  // namespace thaum::game::inline casting
