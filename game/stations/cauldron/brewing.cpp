#include "game/stations/cauldron/brewing.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "game/context/effects.h"
#include "game/context/hand_forces.h"
#include "game/stations/cauldron/ladle.h"
#include "game/stations/cauldron/potions.h"

namespace thaum::game::inline stations {
namespace {

bool near(const MatchData& data, const Cauldron& cauldron, vec3 place) {
    const double radius = data.cauldron->aura.radius * changes_of(data, cauldron).aura;
    return off_axis(place - cauldron.middle) < radius;
}

// ---- ingredients ------------------------------------------------------------------------------------------

/// true for each player who has picked up an ingredient in this tick. It is needed because the player's
/// Pouch, the component that holds the ingredient, enters the World only after the tick.
using Takers = std::array<bool, players>;

/// Gives the ingredient that lies in the niche (a place of ingredients) at `place` to the nearest wizard in
/// reach whose hands are empty.
void pick_up(MatchContext& context, Niche& niche, vec3 place, Tick tick, Takers& takers) {
    auto& world = context.world;
    const auto& rules = *context.data.cauldron;
    ecs::Entity taker;
    std::uint32_t who = no_player;
    double nearest = rules.niche_radius;
    world.view<const Wizard, const Motion, ecs::Without<Dead>, ecs::Without<Pouch>>().each(
        [&](ecs::Entity e, const Wizard& wizard, const Motion& motion) {
            const auto way = distance_on_floor(context.data.wizard, motion.position, place, nearest);
            if (!way || takers[wizard.player]) return;
            taker = e;
            who = wizard.player;
            nearest = *way;
        });
    if (!taker) return;
    takers[who] = true;
    world.commands().add(taker, Pouch{.ingredient = niche.ingredient});
    niche.back_at = tick + rules.niche_again;
    record(context, {.tick = tick,
                     .kind = EventKind::ingredient,
                     .subject = who,
                     .by = who,
                     .detail = niche.ingredient,
                     .place = place});
}

/// Ingredient of another kind than the carried one, in a niche (a place of ingredients) within a wizard's
/// reach; no_ingredient: none.
std::uint32_t other_in_reach(const MatchContext& context, vec3 body, std::uint32_t carried, Tick tick) {
    std::uint32_t other = no_ingredient;
    double nearest = context.data.cauldron->niche_radius;
    std::as_const(context.world)
        .view<const Niche, const Motion>()
        .each([&](const Niche& niche, const Motion& motion) {
            if (tick < niche.back_at || niche.ingredient == carried) return;
            const auto way = distance_on_floor(context.data.wizard, body, motion.position, nearest);
            if (!way) return;
            other = niche.ingredient;
            nearest = *way;
        });
    return other;
}

/// Tells each wizard who comes to a niche (a place of ingredients) while carrying an ingredient that a wizard
/// can carry only one.
void refuse_second(MatchContext& context, Tick tick) {
    context.world.view<const Wizard, const Motion, Pouch, ecs::Without<Dead>>().each(
        [&](const Wizard& wizard, const Motion& motion, Pouch& pouch) {
            const auto before = pouch.refused;
            pouch.refused = other_in_reach(context, motion.position, pouch.ingredient, tick);
            if (pouch.refused == before || pouch.refused == no_ingredient) return;
            record(context, {.tick = tick,
                             .kind = EventKind::hands_full,
                             .subject = wizard.player,
                             .by = wizard.player,
                             .detail = pouch.refused,
                             .place = motion.position});
        });
}

/// Returns the carried ingredient to the nearest of its niches (places of ingredients), where it becomes
/// available only later. So a wizard at that niche does not pick it up again at once. A wizard at another
/// niche can pick up that niche's ingredient.
void put_away(MatchContext& context, ecs::Entity e, std::uint32_t player, vec3 body, const Pouch& pouch,
              Tick tick) {
    Niche* home = nullptr;
    double nearest = std::numeric_limits<double>::max();
    context.world.view<Niche, const Motion>().each([&](Niche& niche, const Motion& motion) {
        const double way = glm::distance(body, motion.position);
        if (niche.ingredient != pouch.ingredient || way >= nearest) return;
        home = &niche;
        nearest = way;
    });
    if (home != nullptr) home->back_at = tick + context.data.cauldron->put_back;
    context.world.commands().remove<Pouch>(e);
    record(context, {.tick = tick,
                     .kind = EventKind::put_away,
                     .subject = player,
                     .by = player,
                     .detail = pouch.ingredient,
                     .place = body});
}

/// Whether a wand of the wizard holds a thing. If so, the Throw button throws that thing.
bool holds_thing(const MatchContext& context, ecs::Entity wizard) {
    const auto& wands = context.data.wands;
    return std::any_of(wands.begin(), wands.end(), [&](const LoadedWand& wand) {
        return static_cast<bool>(wand.rules->held_thing(context.world, wizard));
    });
}

/// Drops the carried ingredient into the brew. The fluid has a fixed number of substances, one for each
/// ingredient; if all of them stand for other ingredients, nothing is dropped.
void drop_in(MatchContext& context, Cauldron& cauldron, ecs::Entity e, std::uint32_t player,
             const Ladle& ladle, const Pouch& pouch, Tick tick) {
    const auto& rules = *context.data.cauldron;
    if (!substance_for(contents_to_come(cauldron), pouch.ingredient))
        return refuse_fourth(context, cauldron, player, tick);
    const auto& fluid = context.output.models.read()[player].fluid;
    const vec3 place = haptics::nearest_in_bowl(
        fluid.wall,
        {ladle.place.x - cauldron.middle.x, -rules.ladle.radius, ladle.place.z - cauldron.middle.z});
    const bool full = cauldron.next.count == cauldron.next.list.size();
    if (full) return;
    drop_for_recipe(context, cauldron, player, pouch.ingredient, tick);
    add_stroke(cauldron, {.place = place,
                          .radius = rules.drop_radius,
                          .amount = rules.drop_amount,
                          .ingredient = pouch.ingredient});
    context.world.commands().remove<Pouch>(e);
    if (cauldron.begun == 0) {
        cauldron.begun = std::max<Tick>(tick, 1);
        cauldron.owner = player;
    }
    const auto length = static_cast<std::uint32_t>(rules.recoil_length);
    kick(context, e, haptics::recoil_peak(fluid, {0, rules.recoil, 0}, length), length);
    record(context, {.tick = tick,
                     .kind = EventKind::dropped,
                     .subject = player,
                     .by = player,
                     .detail = pouch.ingredient,
                     .amount = rules.drop_amount,
                     .place = cauldron.middle + place});
}

/// Drops the ingredients of wizards who press fire over the brew.
void drop_all(MatchContext& context, Cauldron& cauldron, Tick tick) {
    context.world.view<const Wizard, const Controls, const Ladle, const Pouch>().each(
        [&](ecs::Entity e, const Wizard& wizard, const Controls& controls, const Ladle& ladle,
            const Pouch& pouch) {
            if ((controls.pressed & bit(input::Button::fire)) != 0)
                drop_in(context, cauldron, e, wizard.player, ladle, pouch, tick);
        });
}

// ---- ownership -------------------------------------------------------------------------------------------

/// If both ladles are in the brew, the player whose ladle did more work becomes the brew's owner. That work
/// must be at least CauldronRules::min_wrest. A brew without ingredients has no owner.
void wrest(MatchContext& context, Cauldron& cauldron, Tick tick) {
    if (cauldron.begun == 0) return;
    std::array<double, players> work{-1, -1};
    context.world.view<const Wizard, const Ladle>().each(
        [&](const Wizard& wizard, const Ladle& ladle) { work[wizard.player] = recent_work(ladle); });
    if (work[0] < 0 || work[1] < 0 || work[0] == work[1]) return;
    const std::uint32_t stronger = work[0] > work[1] ? 0 : 1;
    if (stronger == cauldron.owner || work[stronger] < context.data.cauldron->min_wrest) return;
    cauldron.owner = stronger;
    cauldron.mixed_since = 0;
    record(context, {.tick = tick,
                     .kind = EventKind::wrested,
                     .subject = stronger,
                     .by = stronger,
                     .amount = work[stronger],
                     .place = cauldron.middle});
}

/// Refills every wand of a wizard who stirs in the direction of the flow.
void refill(MatchContext& context, const BrewWork* work, Tick tick) {
    auto& world = context.world;
    const auto& aura = context.data.cauldron->aura;
    world.view<const Ladle, WandBelt>().each([&](const Ladle& ladle, WandBelt& belt) {
        if (!is_refilling(aura, std::as_const(world), work, ladle, tick)) return;
        for (const auto& wand : context.data.wands) {
            auto& energy = belt.energy[wand.stats.energy_slot];
            if (wand.stats.energy_slot != wand.stats.slot) continue;
            energy = std::min(wand.stats.energy_cap, energy + aura.refill * gameplay_dt);
        }
    });
}

// ---- boon -------------------------------------------------------------------------------------------------

/// Gives the boon (healing) to the owner of a brew that has been well mixed for long enough.
void grant_boon(MatchContext& context, Cauldron& cauldron, Tick tick) {
    const auto& boon = context.data.cauldron->boon;
    const bool mixed = cauldron.begun != 0 && cauldron.mixing >= boon.mixed;
    if (!mixed) cauldron.mixed_since = 0;
    if (!mixed || cauldron.boon_given != 0) return;
    if (cauldron.mixed_since == 0) cauldron.mixed_since = tick;
    if (tick < cauldron.mixed_since + boon.after) return;
    cauldron.boon_given = 1;
    cauldron.boon_until = tick + boon.lasts;
    cauldron.boon_for = cauldron.owner;
    record(context, {.tick = tick,
                     .kind = EventKind::boon,
                     .subject = cauldron.owner,
                     .by = cauldron.owner,
                     .amount = boon.healing * seconds(boon.lasts),
                     .place = cauldron.middle});
}

/// Heals the player whom a well-mixed brew rewards (the boon), while that player's wizard is near the bowl.
/// Health grows at most up to that of a new wizard.
void heal_by_boon(MatchContext& context, const Cauldron& cauldron, Tick tick) {
    if (tick >= cauldron.boon_until) return;
    const double gain = context.data.cauldron->boon.healing * gameplay_dt;
    context.world.view<const Wizard, const Motion, Health, ecs::Without<Dead>>().each(
        [&](const Wizard& wizard, const Motion& motion, Health& health) {
            if (wizard.player != cauldron.boon_for || !near(context.data, cauldron, motion.position)) return;
            const double full = full_health(context.data.wizard, health);
            if (health.points < full) health.points = std::min(full, health.points + gain);
        });
}

// ---- spoiling ---------------------------------------------------------------------------------------------

/// Boils the brew over when its time is up: wizards at the rim are hurt and thrown back, and a pure brew is
/// left.
void spoil(MatchContext& context, Cauldron& cauldron, Tick tick) {
    const auto& rules = *context.data.cauldron;
    if (cauldron.begun == 0 || tick < spoils_at(context.data, cauldron)) return;
    const auto owner = cauldron.owner;
    auto& world = context.world;
    world.view<const Wizard, const Motion, const Body, ecs::Without<Dead>>().each([&](ecs::Entity e,
                                                                                      const Wizard&,
                                                                                      const Motion& motion,
                                                                                      const Body& body) {
        if (!within_reach(context.data, cauldron, motion.position)) return;
        const vec3 out = motion.position - cauldron.middle;
        const vec3 away = vec3(out.x, off_axis(out) / 2, out.z) / std::max(1e-9, off_axis(out));
        context.physics.write().apply_central_impulse(e.index,
                                                      body.mass * rules.spoil_push * glm::normalize(away));
        hurt(context, e, tick,
             {.points = rules.spoil_harm, .by = owner, .how = EventKind::spoilt, .place = motion.position});
    });
    record(context, {.tick = tick,
                     .kind = EventKind::boiled_over,
                     .subject = owner,
                     .by = owner,
                     .place = cauldron.middle});
    forget_filling(cauldron);
    cauldron.spoilt = 1;
}

// ---- aura -------------------------------------------------------------------------------------------------

/// Reduces the weight of wizards near a light brew (one of low density), and of those whom an effect makes
/// light.
void lift_all(MatchContext& context, const Cauldron& cauldron, Tick tick) {
    const auto& aura = context.data.cauldron->aura;
    const bool light = is_light(aura, cauldron);
    std::as_const(context.world)
        .view<const Wizard, const Motion, const Body, const Effects, ecs::Without<Dead>>()
        .each([&](ecs::Entity e, const Wizard&, const Motion& motion, const Body& body,
                  const Effects& effects) {
            const bool lifted = light && near(context.data, cauldron, motion.position);
            const double left =
                factors_of(context.data.effects, &effects, tick).gravity * (lifted ? aura.light_gravity : 1);
            leave_weight(context, e, body, left);
        });
}

}  // namespace

bool is_light(const AuraRules& aura, const Cauldron& cauldron) { return cauldron.density < aura.light_below; }
bool is_thick(const AuraRules& aura, const Cauldron& cauldron) {
    return cauldron.viscosity > aura.thick_above;
}

bool is_refilling(const AuraRules& aura, const ecs::World& world, const BrewWork* work, const Ladle& ladle,
                  Tick tick) {
    const vec3 flow = current_at(world, work, ladle.place, tick);
    return glm::length(flow) >= aura.refill_speed && glm::dot(flow, ladle.velocity) > 0;
}

double recent_work(const Ladle& ladle) { return std::accumulate(ladle.work.begin(), ladle.work.end(), 0.0); }

void spawn_niches(MatchContext& context) {
    if (!context.data.cauldron) return;
    const auto& ingredients = context.data.cauldron->ingredients;
    for (const auto& place : context.data.arena.niches) {
        const auto found = std::find_if(ingredients.begin(), ingredients.end(),
                                        [&](const Ingredient& i) { return i.name == place.ingredient; });
        Motion motion;
        motion.position = place.position;
        context.world.create(motion,
                             Niche{.ingredient = static_cast<std::uint32_t>(found - ingredients.begin())});
    }
}

double pace_at(const MatchData& data, const ecs::World& world, vec3 place) {
    if (!data.cauldron || world.count<Cauldron>() == 0) return 1;
    const auto& cauldron = world.single<Cauldron>();
    const auto& aura = data.cauldron->aura;
    return is_thick(aura, cauldron) && near(data, cauldron, place) ? aura.thick_pace : 1;
}

void add_put_away_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    auto reads = world.mask<Wizard, Controls, Motion, Dead, Ladle>();
    for (const auto& wand : context.data.wands) reads |= wand.rules->writes(world);
    const auto writes = world.mask<Niche, Pouch, EventLog, resource::Journal>();
    schedule.add(
        {.name = "put away",
         .period = gameplay_period,
         .reads = reads,
         .writes = writes,
         .needs = world.mask<Pouch>(),
         .run = [&context](ecs::World& w, Tick tick) {
             using input::Button;
             w.view<const Wizard, const Controls, const Motion, const Pouch, ecs::Without<Dead>>().each(
                 [&](ecs::Entity e, const Wizard& wizard, const Controls& controls, const Motion& motion,
                     const Pouch& pouch) {
                     const bool asks = (controls.pressed & bit(Button::throw_)) != 0;
                     // Over the brew, the fire button drops the ingredient instead.
                     const bool drops = (controls.pressed & bit(Button::fire)) != 0 &&
                                        std::as_const(context.world).has<Ladle>(e);
                     if (asks && !drops && !holds_thing(context, e))
                         put_away(context, e, wizard.player, motion.position, pouch, tick);
                 });
         }});
}

void add_brewing_systems(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "niches",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Motion, Dead>(),
                  .writes = world.mask<Niche, Pouch, EventLog, resource::Journal>(),
                  .needs = world.mask<Niche>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      refuse_second(context, tick);
                      Takers takers{};
                      w.view<Niche, const Motion>().each([&](Niche& niche, const Motion& motion) {
                          if (tick >= niche.back_at) pick_up(context, niche, motion.position, tick, takers);
                      });
                  }});
    schedule.add({.name = "brewing",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Effects, Controls, Motion, Body, Dead, BrewSamples, Ladle,
                                      DrawnOrders, resource::Brew, resource::Models>(),
                  .writes = world.mask<Cauldron, Pouch, WandBelt, Health, EventLog, HandState,
                                       resource::Journal, resource::Physics>(),
                  .needs = world.mask<BrewSamples>(),
                  .run = [&context, &brew](ecs::World& w, Tick tick) {
                      auto& cauldron = w.single<Cauldron>();
                      drop_all(context, cauldron, tick);
                      wrest(context, cauldron, tick);
                      refill(context, brew.read().work.get(), tick);
                      grant_boon(context, cauldron, tick);
                      heal_by_boon(context, cauldron, tick);
                      spoil(context, cauldron, tick);
                      change_brew(context.data, cauldron, tick);
                  }});
    schedule.add({.name = "light brew",
                  .reads = world.mask<Cauldron, Wizard, Motion, Body, Effects, Dead>(),
                  .writes = world.mask<resource::Physics>(),
                  .needs = world.mask<BrewSamples>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      lift_all(context, std::as_const(w).single<Cauldron>(), tick);
                  }});
}

}  // namespace thaum::game::inline stations
