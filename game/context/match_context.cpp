#include "game/context/match_context.h"

#include <algorithm>
#include <cmath>

#include "game/components/arm.h"
#include "game/components/casting.h"
#include "game/components/cauldron.h"
#include "game/components/crystal.h"
#include "game/components/fog.h"
#include "game/components/free_hand.h"
#include "game/components/moved_faders.h"
#include "game/components/orb.h"
#include "game/components/potions.h"
#include "game/components/station.h"
#include "game/data/event_kinds.h"

namespace thaum::game::inline context {
namespace {

void add_up(const Event& event, std::array<std::array<MatchStats, max_causes>, players>& match_stats) {
    const bool about_cause = event.kind == EventKind::shot || event.kind == EventKind::death;
    const auto cause = cause_of(about_cause ? static_cast<EventKind>(event.detail) : event.kind);
    if (cause == max_causes || event.subject >= players) return;
    if (event.kind == EventKind::shot) {
        ++match_stats[event.subject][cause].shots;
        return;
    }
    const bool foes_deed = event.by < players && event.by != event.subject;
    if (event.kind == EventKind::death) {
        foes_deed ? ++match_stats[event.by][cause].kills : ++match_stats[event.subject][cause].own_deaths;
    } else if (foes_deed) {
        ++match_stats[event.by][cause].hits;
        match_stats[event.by][cause].damage += event.amount;
    }
}

/// Declares the components of the cauldron, of strokes and of spells.
void declare_magic(ecs::World& world) {
    declare_all<Cauldron, BrewSamples, SurfaceSamples, Ladle, Niche, Pouch, Focus, DrawnStroke, LastReading,
                LastProp, Fog>(world);
    for (const auto& kind : spell_kinds()) kind.declare(world);
    declare_all<Effects, WorkHalf, DrawnOrders>(world);
    for (const auto& kind : effect_kinds())
        if (kind.declare != nullptr) kind.declare(world);
}

/// Declares the components of work at stations (orb and crystals), except those of the cauldron.
void declare_stations(ecs::World& world) {
    declare_all<AtStation, Orb, WornModes, Scrying, Crystal, CrystalDensity, CrystalColour, Chisel,
                CrystalStrike, Lens, GreatWork>(world);
}

}  // namespace

MatchContext::MatchContext(const MatchData& match_data, const MatchInput& match_input)
    : data(match_data),
      input(match_input),
      physics(world, physics::Settings{.gravity = {0, -data.wizard.gravity, 0}}, data.arena.meshes),
      output(world) {}

double force_cap(const HapticSetup& setup, std::uint32_t player) {
    return haptics::limits_of(setup.servos[player], setup.force_percent[player]).cap;
}

void declare_components(ecs::World& world) {
    declare_all<Body, Motion, Look, Prop, Anchor, Pad, PowerUp, Wizard, Controls, Gaze, Stance, Health, Dead,
                Blows, WandBelt, HandState, Score, Match, Dice, EventLog>(world);
    for (const auto& kind : wand_kinds()) kind.declare(world);
    declare_magic(world);
    // Components that many matches lack (real arms, moved faders, hands that cast without a button) are
    // declared last, so that the hashes of matches without them stay the same.
    declare_all<Arm, PastModel, MovedFaders, FreeHand, NearMiss>(world);
    declare_stations(world);
}

ecs::Entity wizard_of(const ecs::World& world, std::uint32_t player) {
    ecs::Entity found;
    world.view<const Wizard>().each([&](ecs::Entity e, const Wizard& w) {
        if (w.player == player) found = e;
    });
    return found;
}

const GestureSet* gestures_of(const MatchContext& context, std::uint32_t player) {
    const auto& own = context.input.gestures[player];
    return own ? own.get() : context.data.gestures.get();
}

vec3 eye_of(const WizardRules& rules, vec3 body_centre) {
    return body_centre + vec3(0, rules.eye - rules.height / 2, 0);
}

std::optional<double> distance_on_floor(const WizardRules& rules, vec3 body_centre, vec3 place, double most) {
    // Height difference up to which feet and a position are on the same floor (m).
    constexpr double same_floor = 1;
    const vec3 off = body_centre - vec3(0, rules.height / 2, 0) - place;
    const double distance = std::sqrt(off.x * off.x + off.z * off.z);
    if (distance > most || std::abs(off.y) > same_floor) return std::nullopt;
    return distance;
}

void record(MatchContext& context, const Event& event) {
    context.output.journal.write().add(event);
    auto& event_log = context.world.single<EventLog>();
    event_log.events[event_log.count % event_log.events.size()] = event;
    ++event_log.count;
    add_up(event, event_log.match_stats);
}

void hurt(MatchContext& context, ecs::Entity wizard, Tick tick, const Hurt& harm) {
    auto& world = context.world;
    auto& health = world.get<Health>(wizard);
    const auto player = std::as_const(world).get<Wizard>(wizard).player;
    if (harm.points <= 0 || tick < health.shielded_until || world.has<Dead>(wizard)) return;
    const bool by_foe = harm.by < players && harm.by != player;
    const auto* effects = std::as_const(world).find<Effects>(wizard);
    const double left =
        harm.points * (by_foe ? health.surge : 1) * factors_of(context.data.effects, effects, tick).harm;
    const double held = tick < health.ward_until && !harm.pierces ? std::min(health.ward, left) : 0;
    health.ward -= held;
    if (held > 0) {
        record(context, {.tick = tick,
                         .kind = EventKind::held_off,
                         .subject = player,
                         .by = harm.by,
                         .detail = static_cast<std::uint32_t>(harm.how),
                         .amount = held,
                         .place = harm.place});
    }
    const double points = left - held;
    if (points <= 0) return;
    health.points -= points;
    health.hurt_at = tick;
    health.hurt_by = harm.by;
    health.hurt_how = static_cast<std::uint32_t>(harm.how);
    if (by_foe) health.foe_did_at = tick;
    record(context, {.tick = tick,
                     .kind = harm.how,
                     .subject = player,
                     .by = harm.by,
                     .detail = harm.detail,
                     .amount = points,
                     .place = harm.place});
}

}  // namespace thaum::game::inline context
