#include "game/cauldron/brewing.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "game/cauldron/ladle.h"
#include "game/match/touch.h"

namespace thaum::game {
namespace {

bool near(const MatchData& data, const Cauldron& cauldron, vec3 place) {
    return off_axis(place - cauldron.middle) < data.cauldron->aura.radius;
}

// ---- ingredients ---------------------------------------------------------------------------------------------------

/// Who has found an ingredient in this tick: what they carry comes into the World after it.
using Takers = std::array<bool, players>;

/// The nearest of those whose hands are empty.
void pick_up(Stage& stage, Niche& niche, vec3 place, Tick tick, Takers& takers) {
    auto& world = stage.world;
    const auto& rules = *stage.data.cauldron;
    ecs::Entity taker;
    std::uint32_t who = no_player;
    double nearest = rules.niche_radius;
    world.view<const Wizard, const Motion, ecs::Without<Dead>, ecs::Without<Pouch>>().each(
        [&](ecs::Entity e, const Wizard& wizard, const Motion& motion) {
            const auto way = way_on_floor(stage.data.wizard, motion.position, place, nearest);
            if (!way || takers[wizard.player]) return;
            taker = e;
            who = wizard.player;
            nearest = *way;
        });
    if (!taker) return;
    takers[who] = true;
    world.commands().add(taker, Pouch{.ingredient = niche.ingredient});
    niche.back_at = tick + rules.niche_again;
    record(world, {.tick = tick,
                   .kind = EventKind::ingredient,
                   .subject = who,
                   .by = who,
                   .detail = niche.ingredient,
                   .place = place});
}

/// With what the next step of the fluid brings.
Contents contents_to_come(const Cauldron& cauldron) {
    Contents what = cauldron.what;
    for (std::uint32_t i = 0; i < cauldron.next.count; ++i) {
        const auto ingredient = cauldron.next.list[i].ingredient;
        if (ingredient == no_ingredient) continue;
        if (const auto substance = substance_for(what, ingredient)) what[*substance] = ingredient;
    }
    return what;
}

/// Nothing where the brew holds as many others as it can.
void drop_in(Stage& stage, Cauldron& cauldron, ecs::Entity e, std::uint32_t player, const Ladle& ladle,
             const Pouch& pouch, Tick tick) {
    const auto& rules = *stage.data.cauldron;
    if (!substance_for(contents_to_come(cauldron), pouch.ingredient)) return;
    const vec3 place = haptics::held_in(
        stage.models[player].fluid.wall,
        {ladle.place.x - cauldron.middle.x, -rules.ladle.radius, ladle.place.z - cauldron.middle.z});
    const bool taken = add_stroke(cauldron, {.place = place,
                                             .radius = rules.drop_radius,
                                             .amount = rules.drop_amount,
                                             .ingredient = pouch.ingredient});
    if (!taken) return;
    stage.world.commands().remove<Pouch>(e);
    if (cauldron.begun == 0) {
        cauldron.begun = std::max<Tick>(tick, 1);
        cauldron.owner = player;
    }
    const auto length = static_cast<std::uint32_t>(rules.recoil_length);
    kick(stage, e, haptics::recoil_peak(stage.models[player].fluid, {0, rules.recoil, 0}, length), length);
    record(stage.world, {.tick = tick,
                         .kind = EventKind::dropped,
                         .subject = player,
                         .by = player,
                         .detail = pouch.ingredient,
                         .amount = rules.drop_amount,
                         .place = cauldron.middle + place});
}

// ---- whose it is -----------------------------------------------------------------------------------------------------

/// Both ladles in: the one that has done more. Nothing of nobody's brew is worth a fight.
void wrest(Stage& stage, Cauldron& cauldron, Tick tick) {
    if (cauldron.begun == 0) return;
    std::array<double, players> work{-1, -1};
    stage.world.view<const Wizard, const Ladle>().each(
        [&](const Wizard& wizard, const Ladle& ladle) { work[wizard.player] = recent_work(ladle); });
    if (work[0] < 0 || work[1] < 0 || work[0] == work[1]) return;
    const std::uint32_t stronger = work[0] > work[1] ? 0 : 1;
    if (stronger == cauldron.owner || work[stronger] < stage.data.cauldron->wrest_least) return;
    cauldron.owner = stronger;
    record(stage.world, {.tick = tick,
                         .kind = EventKind::wrested,
                         .subject = stronger,
                         .by = stronger,
                         .amount = work[stronger],
                         .place = cauldron.middle});
}

/// Stirring with the flow refills every wand.
void refill(Stage& stage, Tick tick) {
    auto& world = stage.world;
    const auto& aura = stage.data.cauldron->aura;
    world.view<const Ladle, WandBelt>().each([&](const Ladle& ladle, WandBelt& belt) {
        const vec3 flow = current_at(std::as_const(world), stage.brew.get(), ladle.place, tick);
        if (glm::length(flow) < aura.refill_speed || glm::dot(flow, ladle.velocity) <= 0) return;
        for (const auto& wand : stage.data.wands) {
            auto& energy = belt.energy[wand.stats.energy_slot];
            if (wand.stats.energy_slot != wand.stats.slot) continue;
            energy = std::min(wand.stats.energy_cap, energy + aura.refill * gameplay_dt);
        }
    });
}

// ---- spoiling --------------------------------------------------------------------------------------------------------

/// Too late for what was begun: it boils over, hurts who stands at the rim and throws him back, and is pure again.
void spoil(Stage& stage, Cauldron& cauldron, Tick tick) {
    const auto& rules = *stage.data.cauldron;
    if (cauldron.begun == 0 || tick < cauldron.begun + rules.spoils_after) return;
    const auto owner = cauldron.owner;
    auto& world = stage.world;
    world.view<const Wizard, const Motion, const Body, ecs::Without<Dead>>().each([&](ecs::Entity e,
                                                                                      const Wizard&,
                                                                                      const Motion& motion,
                                                                                      const Body& body) {
        if (!within_reach(stage.data, cauldron, motion.position)) return;
        const vec3 out = motion.position - cauldron.middle;
        const vec3 away = vec3(out.x, off_axis(out) / 2, out.z) / std::max(1e-9, off_axis(out));
        stage.physics.apply_central_impulse(e.index, body.mass * rules.spoil_push * glm::normalize(away));
        hurt(world, e, tick,
             {.points = rules.spoil_harm, .by = owner, .how = EventKind::spoilt, .place = motion.position});
    });
    record(world, {.tick = tick,
                   .kind = EventKind::boiled_over,
                   .subject = owner,
                   .by = owner,
                   .place = cauldron.middle});
    cauldron.begun = 0;
    cauldron.owner = no_player;
    cauldron.spoilt = 1;
}

// ---- aura ------------------------------------------------------------------------------------------------------------

bool is_light(const MatchData& data, const Cauldron& cauldron) {
    return cauldron.density < data.cauldron->aura.light_below;
}

void lift_all(Stage& stage, const Cauldron& cauldron) {
    if (!is_light(stage.data, cauldron)) return;
    const double share = 1 - stage.data.cauldron->aura.light_gravity;
    std::as_const(stage.world)
        .view<const Wizard, const Motion, const Body, ecs::Without<Dead>>()
        .each([&](ecs::Entity e, const Wizard&, const Motion& motion, const Body& body) {
            if (!near(stage.data, cauldron, motion.position)) return;
            stage.physics.apply_central_impulse(
                e.index, -share * body.mass * physics_dt * stage.physics.settings().gravity);
        });
}

}  // namespace

double recent_work(const Ladle& ladle) { return std::accumulate(ladle.work.begin(), ladle.work.end(), 0.0); }

void spawn_niches(Stage& stage) {
    if (!stage.data.cauldron) return;
    const auto& ingredients = stage.data.cauldron->ingredients;
    for (const auto& place : stage.data.arena.niches) {
        const auto found = std::find_if(ingredients.begin(), ingredients.end(),
                                        [&](const Ingredient& i) { return i.name == place.ingredient; });
        Motion motion;
        motion.position = place.position;
        stage.world.create(motion,
                           Niche{.ingredient = static_cast<std::uint32_t>(found - ingredients.begin())});
    }
}

double pace_at(const MatchData& data, const ecs::World& world, vec3 place) {
    if (!data.cauldron || world.count<Cauldron>() == 0) return 1;
    const auto& cauldron = world.single<Cauldron>();
    const auto& aura = data.cauldron->aura;
    return cauldron.viscosity > aura.thick_above && near(data, cauldron, place) ? aura.thick_pace : 1;
}

void add_brewing_systems(Stage& stage, ecs::Schedule& schedule) {
    auto& world = stage.world;
    schedule.add({.name = "niches",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Motion, Dead>(),
                  .writes = world.mask<Niche, Pouch, Chronicle>(),
                  .needs = world.mask<Niche>(),
                  .run = [&stage](ecs::World& w, Tick tick) {
                      Takers takers{};
                      w.view<Niche, const Motion>().each([&](Niche& niche, const Motion& motion) {
                          if (tick >= niche.back_at) pick_up(stage, niche, motion.position, tick, takers);
                      });
                  }});
    schedule.add({.name = "brewing",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Controls, Motion, Body, Dead, BrewPage, Ladle>(),
                  .writes = world.mask<Cauldron, Pouch, WandBelt, Health, Chronicle, Grip>(),
                  .needs = world.mask<BrewPage>(),
                  .run = [&stage](ecs::World& w, Tick tick) {
                      auto& cauldron = w.single<Cauldron>();
                      w.view<const Wizard, const Controls, const Ladle, const Pouch>().each(
                          [&](ecs::Entity e, const Wizard& wizard, const Controls& controls,
                              const Ladle& ladle, const Pouch& pouch) {
                              if ((controls.pressed & bit(input::Button::fire)) != 0)
                                  drop_in(stage, cauldron, e, wizard.player, ladle, pouch, tick);
                          });
                      wrest(stage, cauldron, tick);
                      refill(stage, tick);
                      spoil(stage, cauldron, tick);
                  }});
    schedule.add(
        {.name = "light brew",
         .reads = world.mask<Cauldron, Wizard, Motion, Body, Dead>(),
         .needs = world.mask<BrewPage>(),
         .run = [&stage](ecs::World& w, Tick) { lift_all(stage, std::as_const(w).single<Cauldron>()); }});
}

}  // namespace thaum::game
