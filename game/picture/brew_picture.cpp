#include "game/picture/brew_picture.h"

#include <algorithm>

#include "fluid/sample.h"
#include "game/brew/brew_state.h"
#include "game/components/hand_state.h"
#include "game/components/station.h"
#include "game/match/simulation.h"
#include "game/stations/cauldron/brewing.h"
#include "game/stations/cauldron/cauldron.h"
#include "game/stations/cauldron/potions.h"

namespace thaum::game::inline picture {
namespace {

/// Time to boiling over (ticks) from which on a brew counts as one that never boils over, as on the practice
/// range.
constexpr Tick never_spoils = ticks(3600.0);

/// Numbers of brew states (BrewPicture::state). The number of a moving brew is the match's clock plus an
/// offset; that of a resting brew is `at_rest` plus the time at which it came to rest.
constexpr std::uint64_t untouched = 1, at_rest = std::uint64_t{1} << 48U;

void assign(std::span<const float> from, fluid::Samples& to) { to.assign(from.begin(), from.end()); }

/// Copies the fluid state from the World and not from the solver, which may be one step ahead of the match.
void take_state(const Simulation& match, const BrewWork& work, const Cauldron& cauldron, BrewPicture& out) {
    const auto& fluid = work.brew.fluid;
    const auto samples = [&](std::size_t array) {
        return brew_samples(match.world(), cauldron.newest, fluid, array);
    };
    out.lattice = fluid.lattice;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        assign(samples(axis), out.velocity[axis]);
        out.velocity_places[axis] = fluid.place(axis);
    }
    const auto& rules = *match.data().cauldron;
    const bool changed = cauldron.fluid_potion < match.data().recipes.size();
    out.colours.base = fvec3(changed ? changes_of(match.data(), cauldron).colour : rules.colour);
    for (std::size_t s = 0; s < out.densities.size(); ++s) {
        out.densities[s].clear();
        if (cauldron.contents[s] >= rules.ingredients.size()) continue;
        assign(samples(3 + s), out.densities[s]);
        out.colours.substances[s] = fvec3(rules.ingredients[cauldron.contents[s]].colour);
    }
    out.surface = work.brew.surface;
}

/// Fills in a brew that no player has touched yet. It is at rest and pure, and no fluid has been made for it.
void take_still(const MatchData& data, BrewPicture& out) {
    const auto& rules = *data.cauldron;
    const auto basin = basin_of(data.arena.bowl->size, rules.filled);
    const auto settings = brew_settings(rules, basin);
    out.lattice = fluid::make_lattice(settings.cells, settings.h, settings.edges);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out.velocity[axis] = fluid::make_samples(out.lattice);
        out.velocity_places[axis] = fluid::face_place(axis);
    }
    for (auto& density : out.densities) density.clear();
    out.colours.base = fvec3(rules.colour);
    out.surface = fluid::make_spring_surface(brew_surface(rules, basin));
}

void take_brew_of(const Simulation& match, const Cauldron& cauldron, BrewPicture& out) {
    const auto* work = match.brew();
    const bool moves = cauldron.step_running != 0 || cauldron.surface_asleep == 0;
    const std::uint64_t state = work == nullptr ? untouched
                                : moves         ? untouched + 1 + match.now()
                                                : at_rest + cauldron.stepped;
    if (state == out.state) return;
    out.state = state;
    work == nullptr ? take_still(match.data(), out) : take_state(match, *work, cauldron, out);
}

void take_ladles(const Simulation& match, CauldronPicture& out) {
    constexpr vec3 hand{0.25, -0.35, -0.4};  // position of the hand on the ladle (m, eye frame)
    out.ladles.fill(std::nullopt);
    match.world().view<const Wizard, const Ladle, const AtStation, const Motion, const HandState>().each(
        [&](const Wizard& wizard, const Ladle& ladle, const AtStation& station, const Motion& motion,
            const HandState& hand_state) {
            const vec3 eye = eye_of(match.data().wizard, motion.position);
            out.ladles[wizard.player] = {
                .bowl = ladle.place,
                .top = eye + look_rotation(station.yaw, 0) * hand,
                .force_share = glm::length(hand_state.servo.safety.output) / match.data().device.peak_force};
        });
}

void take_mixed(const Simulation& match, const Cauldron& cauldron, CauldronPicture& out) {
    const auto newest = std::find_if(out.brew.densities.rbegin(), out.brew.densities.rend(),
                                     [](const fluid::Samples& one) { return !one.empty(); });
    const bool some = match.brew() != nullptr && newest != out.brew.densities.rend();
    // The fluid has had no step since the share `mixed` was computed from it, so the share is still right.
    if (some && out.mixed > 0 && out.mixed_at == cauldron.stepped) return;
    out.mixed = some ? fluid::filled_share(match.brew()->brew.fluid, *newest) : 0;
    out.mixed_at = cauldron.stepped;
}

void take_boon(const BoonRules& rules, const Cauldron& cauldron, Tick played, CauldronPicture& out) {
    const bool waits = cauldron.mixed_since != 0 && cauldron.boon_given == 0;
    const auto due = cauldron.mixed_since + rules.after;
    out.well_mixed = 1 / (1 + (1 - rules.mixed) * (1 - rules.mixed));
    out.boon_in_s = waits && due > played ? seconds(due - played) : 0;
    out.boon_open = cauldron.begun != 0 && cauldron.boon_given == 0;
    out.boon_for = played < cauldron.boon_until ? cauldron.boon_for : no_player;
}

}  // namespace

void take_brew(const Brew& brew, const CauldronRules& rules, std::uint64_t state, BrewPicture& out) {
    const auto& fluid = brew.fluid;
    out.state = state;
    out.lattice = fluid.lattice;
    out.velocity = fluid.state.velocity;
    for (std::size_t axis = 0; axis < 3; ++axis) out.velocity_places[axis] = fluid.place(axis);
    out.colours.base = fvec3(rules.colour);
    for (std::size_t s = 0; s < out.densities.size(); ++s) {
        out.densities[s].clear();
        if (brew.contents[s] >= rules.ingredients.size()) continue;
        out.densities[s] = fluid.state.substances[s];
        out.colours.substances[s] = fvec3(rules.ingredients[brew.contents[s]].colour);
    }
    out.surface = brew.surface;
}

void take_cauldron(const Simulation& match, CauldronPicture& out) {
    out.there = match.data().cauldron && match.world().count<Cauldron>() > 0;
    if (!out.there) return;
    const auto& cauldron = match.world().single<Cauldron>();
    const auto& rules = *match.data().cauldron;
    take_brew_of(match, cauldron, out.brew);
    take_ladles(match, out);
    for (std::size_t s = 0; s < out.contents.size(); ++s) {
        const bool some = cauldron.contents[s] < rules.ingredients.size();
        out.contents[s] =
            some ? std::string_view(rules.ingredients[cauldron.contents[s]].name) : std::string_view();
    }
    out.owner = cauldron.owner;
    take_mixed(match, cauldron, out);
    out.heat = std::clamp((1 - cauldron.density) / std::max(1 - rules.aura.light_below, 1e-3), 0.0, 1.0);
    const auto played = match.match().played, end = spoils_at(match.data(), cauldron);
    const bool spoils = rules.spoils_after < never_spoils;
    out.whole_time_s = spoils ? seconds(rules.spoils_after) : 0;
    out.spoils_in_s = spoils && cauldron.begun != 0 && end > played ? seconds(end - played) : 0;
    out.fresh = out.spoils_in_s / std::max(seconds(rules.spoils_after + cauldron.more_time), 1e-3);
    out.potion = cauldron.fluid_potion < match.data().recipes.size()
                     ? std::string_view(match.data().recipes[cauldron.fluid_potion].name)
                     : std::string_view();
    take_boon(rules.boon, cauldron, played, out);
    out.slows = is_thick(rules.aura, cauldron);
    out.lifts = is_light(rules.aura, cauldron);
}

}  // namespace thaum::game::inline picture
