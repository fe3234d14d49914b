#include "game/match/carry_over.h"

#include <algorithm>

#include "core/assert.h"
#include "ecs/snapshot.h"
#include "game/cauldron/cauldron.h"
#include "game/components/grip.h"
#include "game/match/arm.h"
#include "game/match/bodies.h"
#include "game/match/touch.h"
#include "game/player/walk.h"
#include "game/wands/belt.h"

namespace thaum::game {
namespace {

/// Each wand keeps its energy, and the one in hand stays there; a wand that is new is full.
WandBelt carried_belt(const MatchData& from, const MatchData& to, const WandBelt& old) {
    auto belt = full_belt(to);
    belt.fired = old.fired;
    for (const auto& wand : to.wands) {
        const auto before = std::find_if(from.wands.begin(), from.wands.end(),
                                         [&](const auto& w) { return w.kind == wand.kind; });
        if (before == from.wands.end()) continue;
        belt.energy[wand.stats.energy_slot] =
            std::min(old.energy[before->stats.energy_slot], wand.stats.energy_cap);
        if (before->stats.slot == old.selected) belt.selected = wand.stats.slot;
    }
    return belt;
}

/// The body by the new rules, on the same feet; none for who is dead.
void refit(Stage& stage, ecs::Entity wizard, const WizardRules& before) {
    auto& world = stage.world;
    const auto& rules = stage.data.wizard;
    const auto body = wizard_body(rules);
    const auto* old = std::as_const(world).find<Body>(wizard);
    if (old != nullptr && *old == body) return;
    const bool had_body = old != nullptr;
    if (had_body) world.remove<Body>(wizard);
    world.get<Motion>(wizard).position.y += (rules.height - before.height) / 2;
    if (had_body) world.add(wizard, body);
}

void refit_wizards(const Stage& from, Stage& to) {
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto wizard = wizard_of(to.world, player);
        auto& belt = to.world.get<WandBelt>(wizard);
        belt = carried_belt(from.data, to.data, belt);
        refit(to, wizard, from.data.wizard);
    }
}

template <class... Cs>
void copy(const ecs::World& from, ecs::Entity source, ecs::World& to, ecs::Entity target) {
    ((to.get<Cs>(target) = from.get<Cs>(source)), ...);
}

/// A wizard of the old scene into the new one. What the wands remember of things there is not carried along.
void move_wizard(const Stage& from, Stage& to, std::uint32_t player) {
    auto& world = to.world;
    const auto old = wizard_of(from.world, player), now = wizard_of(world, player);
    copy<Gaze, Stance, Health, WandBelt, Grip, Score>(from.world, old, world, now);
    let_go(to, now);
    world.remove<Body>(now);
    copy<Motion>(from.world, old, world, now);
    world.get<Motion>(now).asleep = 0;  // what it stood on may be gone
    if (const auto* dead = from.world.find<Dead>(old))
        world.add(now, *dead);
    else
        world.add(now, from.world.get<Body>(old));
}

void move_match(const Stage& from, Stage& to) {
    to.world.single<Match>() = from.world.single<Match>();
    to.world.single<Dice>() = from.world.single<Dice>();
    to.world.single<Chronicle>() = from.world.single<Chronicle>();
}

void copy_world(const Stage& from, Stage& to) {
    Bytes snapshot;
    ecs::save(from.world, snapshot);
    const auto restored = ecs::restore(to.world, snapshot);
    THAUM_ASSERT(restored, "a match of the same program has the same components");
    rebuild_physics(to);
    rebuild_brew(to);
}

}  // namespace

void carry_over(const Stage& from, Stage& to) {
    if (to.data.arena == from.data.arena) {
        copy_world(from, to);
    } else {
        move_match(from, to);
        for (std::uint32_t player = 0; player < players; ++player) move_wizard(from, to, player);
        carry_arms(arms_in(from.world), to.world);
    }
    refit_wizards(from, to);
    to.physics.rebuild();
}

}  // namespace thaum::game
