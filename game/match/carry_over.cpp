#include "game/match/carry_over.h"

#include <algorithm>

#include "core/assert.h"
#include "ecs/snapshot.h"
#include "game/components/casting.h"
#include "game/components/crystal.h"
#include "game/components/hand_state.h"
#include "game/components/potions.h"
#include "game/context/hand_forces.h"
#include "game/data/wand_slots.h"
#include "game/match/bodies.h"
#include "game/match/hand/arm_system.h"
#include "game/match/haptic_setup.h"
#include "game/match/player/walk.h"
#include "game/stations/orb/worn_modes.h"

namespace thaum::game::inline match {
namespace {

/// WandBelt, the wizard's wands with their energy, for the new data. Each wand keeps its energy, the selected
/// wand stays selected, and added wands have full energy.
WandBelt carried_belt(const MatchData& from, const MatchData& to, const WandBelt& old) {
    auto belt = full_belt(to);
    belt.fired = old.fired;
    belt.venom = old.venom;
    belt.venom_until = old.venom_until;
    belt.venom_lasts = old.venom_lasts;
    for (const auto& wand : to.wands) {
        const auto before = std::find_if(from.wands.begin(), from.wands.end(),
                                         [&](const auto& w) { return w.name == wand.name; });
        if (before == from.wands.end()) continue;
        belt.energy[wand.stats.energy_slot] =
            std::min(old.energy[before->stats.energy_slot], wand.stats.energy_cap);
        if (before->stats.slot == old.selected) belt.selected = wand.stats.slot;
    }
    return belt;
}

/// Replaces the wizard's body by one of the new rules, with the feet at the same position. A dead wizard gets
/// no body.
void refit(MatchContext& context, ecs::Entity wizard, const WizardRules& before) {
    auto& world = context.world;
    const auto& rules = context.data.wizard;
    const auto body = wizard_body(rules);
    const auto* old = std::as_const(world).find<Body>(wizard);
    if (old != nullptr && *old == body) return;
    const bool had_body = old != nullptr;
    if (had_body) world.remove<Body>(wizard);
    world.get<Motion>(wizard).position.y += (rules.height - before.height) / 2;
    if (had_body) world.add(wizard, body);
}

/// Number of earlier effects of the same giver and kind in the list.
std::ptrdiff_t place_among_like(const std::vector<ListedEffect>& all, const ListedEffect& one) {
    return std::count_if(all.begin(), all.begin() + one.number, [&](const ListedEffect& other) {
        return other.giver == one.giver && other.kind == one.kind;
    });
}

/// The effects that act on a wizard, by the numbers that they have in the new data. Those that are no longer
/// listed end.
Effects refit_effects(const MatchData& before, const MatchData& after, const Effects& effects) {
    Effects refitted;
    for (const auto& one : after.effects)
        for (const auto& old : before.effects)
            if (old.giver == one.giver && old.kind == one.kind &&
                place_among_like(before.effects, old) == place_among_like(after.effects, one)) {
                refitted.until[one.number] = effects.until[old.number];
                refitted.strength[one.number] = effects.strength[old.number];
            }
    return refitted;
}

void refit_wizards(const MatchContext& from, MatchContext& to) {
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto wizard = wizard_of(to.world, player);
        auto& belt = to.world.get<WandBelt>(wizard);
        belt = carried_belt(from.data, to.data, belt);
        auto& effects = to.world.get<Effects>(wizard);
        effects = refit_effects(from.data, to.data, effects);
        if (auto* focus = to.world.find<Focus>(wizard); focus != nullptr && to.data.casting)
            focus->points = std::min(focus->points, to.data.casting->focus_cap);
        if (from.data.orb && to.data.orb)
            refit_modes(*from.data.orb, *to.data.orb, to.world.get<WornModes>(wizard));
        refit(to, wizard, from.data.wizard);
    }
}

template <class... Cs>
void copy(const ecs::World& from, ecs::Entity source, ecs::World& to, ecs::Entity target) {
    ((to.get<Cs>(target) = from.get<Cs>(source)), ...);
}

/// Copies a wizard of the old scene into the new one. What a wand holds in the old scene is let go.
void move_wizard(const MatchContext& from, MatchContext& to, std::uint32_t player) {
    auto& world = to.world;
    const auto old = wizard_of(from.world, player), wizard = wizard_of(world, player);
    copy<Gaze, Stance, Health, WandBelt, HandState, Score>(from.world, old, world, wizard);
    let_go(to, wizard);
    world.remove<Body>(wizard);
    copy<Motion>(from.world, old, world, wizard);
    world.get<Motion>(wizard).asleep = 0;  // wakes the wizard, because the ground below may have changed
    if (const auto* focus = from.world.find<Focus>(old); focus != nullptr && world.has<Focus>(wizard))
        world.get<Focus>(wizard) = *focus;
    if (const auto* lens = from.world.find<Lens>(old); lens != nullptr && world.has<Lens>(wizard))
        world.get<Lens>(wizard) = *lens;
    if (const auto* dead = from.world.find<Dead>(old))
        world.add(wizard, *dead);
    else
        world.add(wizard, from.world.get<Body>(old));
}

void move_match(const MatchContext& from, MatchContext& to) {
    to.world.single<Match>() = from.world.single<Match>();
    to.world.single<Dice>() = from.world.single<Dice>();
    to.world.single<EventLog>() = from.world.single<EventLog>();
    if (const auto moved = moved_faders_in(from.world)) to.world.create(*moved);
    if (from.world.count<DrawnOrders>() > 0 && to.world.count<DrawnOrders>() > 0)
        to.world.single<DrawnOrders>() = from.world.single<DrawnOrders>();
    if (from.world.count<GreatWork>() > 0 && to.world.count<GreatWork>() > 0)
        to.world.single<GreatWork>() = from.world.single<GreatWork>();
}

void copy_world(const MatchContext& from, MatchContext& to) {
    Bytes snapshot;
    ecs::save(from.world, snapshot);
    const auto restored = ecs::restore(to.world, snapshot);
    THAUM_ASSERT(restored, "a match of the same program has the same components");
    rebuild_physics(to);
}

/// Whether the components of one match can be copied to another: both have the same arena and the same parts
/// of the game.
bool fits(const MatchData& from, const MatchData& to) {
    return to.arena == from.arena && (to.gestures == nullptr) == (from.gestures == nullptr) &&
           to.cauldron.has_value() == from.cauldron.has_value() &&
           to.orb.has_value() == from.orb.has_value() && to.crystal.has_value() == from.crystal.has_value();
}

}  // namespace

void carry_over(const MatchContext& from, MatchContext& to) {
    to.output.journal.write() = from.output.journal.read();
    to.output.forces.write() = from.output.forces.read();
    if (fits(from.data, to.data)) {
        copy_world(from, to);
    } else {
        move_match(from, to);
        for (std::uint32_t player = 0; player < players; ++player) move_wizard(from, to, player);
        carry_arms(arms_in(from.world), to.world);
    }
    refit_wizards(from, to);
    to.physics.write().rebuild();
}

}  // namespace thaum::game::inline match
