#include "game/match/belt.h"
#include "game/data/wand_slots.h"

#include <algorithm>

#include "game/components/arm.h"
#include "game/components/crystal.h"
#include "game/components/fog.h"
#include "game/components/station.h"

namespace thaum::game::inline match {
namespace {

using input::Button;

bool needs_wheel(const ecs::World& world, ecs::Entity wizard, const LoadedWand* wand) {
    return wand != nullptr && wand->rules->moves_by_wheel() && wand->rules->held_at(world, wizard);
}

void choose(const MatchData& data, const Controls& controls, bool wheel_is_taken, WandBelt& belt) {
    constexpr auto forward = std::uint32_t{1};
    constexpr auto backward = static_cast<std::uint32_t>(wand_slots - 1);
    const auto pressed = [&](Button b) { return (controls.pressed & input::bit(b)) != 0; };
    // While a wizard draws a stroke, the keys of wands do not select wands but cast spells (key chords).
    const bool draws = data.gestures && (controls.held & input::bit(Button::trace)) != 0;
    const auto wand = draws ? 0 : controls.wand_pressed;
    if (wand != 0 && wand_in_slot(data, wand - 1) != nullptr) belt.selected = wand - 1;
    if (wheel_is_taken) return;
    if (pressed(Button::next_wand)) belt.selected = next_slot(data, belt.selected, forward);
    if (pressed(Button::previous_wand)) belt.selected = next_slot(data, belt.selected, backward);
}

void regain(const MatchData& data, WandBelt& belt) {
    for (const auto& wand : data.wands) {
        if (wand.stats.energy_slot != wand.stats.slot) continue;  // the wand whose energy it is regains it
        auto& energy = belt.energy[wand.stats.energy_slot];
        energy = std::min(wand.stats.energy_cap, energy + wand.stats.energy_regain * gameplay_dt);
    }
}

void put_away(MatchContext& context, ecs::Entity wizard, const LoadedWand* wand, Tick tick) {
    if (wand != nullptr) wand->rules->put_away({context, wizard, tick, wand->stats});
}

void use_wands(MatchContext& context, ecs::Entity wizard, const Controls& controls, WandBelt& belt,
               Tick tick) {
    const auto* before = wand_in_hand(context.data, belt);
    choose(context.data, controls, needs_wheel(context.world, wizard, before), belt);
    regain(context.data, belt);
    const auto* wand = wand_in_hand(context.data, belt);
    if (wand != before) put_away(context, wizard, before, tick);
    if (wand != nullptr) wand->rules->use({context, wizard, tick, wand->stats});
}

}  // namespace

void put_away_wand(MatchContext& context, ecs::Entity wizard, Tick tick) {
    const auto& belt = std::as_const(context.world).get<WandBelt>(wizard);
    put_away(context, wizard, wand_in_hand(context.data, belt), tick);
}

void add_belt_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    auto writes = world.mask<WandBelt>();
    for (const auto& wand : context.data.wands) writes |= wand.rules->writes(world);
    schedule.add({.name = "wands",
                  .period = gameplay_period,
                  .reads = world.mask<Wizard, Effects, Controls, Gaze, Motion, Body, Dead, AtStation, Arm,
                                      Fog, Lens, resource::Physics>(),
                  .writes = writes,
                  .needs = world.mask<WandBelt>(),
                  .run = [&context](ecs::World& w, Tick tick) {
                      w.view<WandBelt, const Controls, ecs::Without<Dead>, ecs::Without<AtStation>>().each(
                          [&](ecs::Entity e, WandBelt& belt, const Controls& controls) {
                              use_wands(context, e, controls, belt, tick);
                          });
                      const auto put_down = [&](ecs::Entity e, const WandBelt&, const auto&) {
                          put_away_wand(context, e, tick);
                      };
                      w.view<const WandBelt, const Dead>().each(put_down);
                      w.view<const WandBelt, const AtStation>().each(put_down);
                  }});
}

void add_wand_forces(MatchContext& context, ecs::Schedule& schedule) {
    for (const auto& wand : context.data.wands) wand.rules->add_forces({context, schedule});
}

void add_missile_systems(MatchContext& context, ecs::Schedule& schedule) {
    for (const auto& wand : context.data.wands) wand.rules->add_missiles({context, schedule});
}

}  // namespace thaum::game::inline match
