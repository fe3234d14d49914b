#include "game/hud/station_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "game/cauldron/potions.h"
#include "game/components/casting.h"
#include "game/components/crystal.h"
#include "game/components/station.h"
#include "game/crystal/chisel.h"
#include "game/match/great_work.h"
#include "game/match/simulation.h"
#include "game/orb/scrying.h"
#include "game/orb/worn_modes.h"

namespace thaum::game {
namespace {

/// Greatest half edge of what a tool reaches (m), in voxels of this edge (m).
double reach_of(const field::Tool& tool, double voxel) {
    double reach = 0;
    for (const auto& operation : tool.operations) {
        const vec3 half = operation.extent.half * (operation.extent.in_metres ? 1 : voxel);
        reach = std::max({reach, half.x, half.y, half.z});
    }
    return reach;
}

/// Words for the names of modes, which are those of files.
std::string_view shown_mode(std::string_view name) { return name == "vortex_tube" ? "vortex tube" : name; }

double force_share(const Simulation& match, std::uint32_t player, vec3 force) {
    const auto& setup = match.haptic_setup();
    const double cap = setup.on[player] ? force_cap(setup, player) : 0;
    return cap > 0 ? glm::length(force) / cap : 0;
}

/// Takes a curve as its player sees it on the sheet: from the mode's least strength to the most.
void take_curve(const OrbRules& rules, const OrbMode& mode, const field::TransferFunction& strength,
                std::array<float, curve_points>& out) {
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double at = mode.most_property * static_cast<double>(i) / static_cast<double>(out.size() - 1);
        out.at(i) = static_cast<float>((strength(at) - mode.least) / (rules.most - mode.least));
    }
}

/// Takes the player's own order of the first recipe whose order is drawn.
void take_order(const Simulation& match, std::uint32_t player, ScryingPicture& out) {
    for (const auto& recipe : match.data().recipes) {
        if (!recipe.drawn) continue;
        const auto order = order_of(recipe, match.world(), player);
        out.potion = recipe.name;
        for (std::size_t i = 0; i < std::min(order.count, out.order.size()); ++i)
            out.order.at(i) = match.data().cauldron->ingredients[order.steps[i].ingredient].name;
        return;
    }
}

void take_modes(const Simulation& match, const WornModes& modes, ScryingPicture& out) {
    const auto& rules = *match.data().orb;
    for (std::uint32_t i = 0; i < rules.modes.size() && i < out.modes.size(); ++i) {
        out.modes.at(i) = shown_mode(rules.modes[i].name);
        out.worn.at(i) = wears(modes, i);
    }
    out.newest = last_worn(modes);
    if (out.newest < rules.modes.size())
        take_curve(rules, rules.modes[out.newest], modes.strength.at(out.newest), out.curve);
}

/// Voxels of one crystal in the World's blobs.
struct VoxelBlobs {
    std::span<const float> density;
    std::span<const std::uint8_t> colour;
};

VoxelBlobs voxels_in(const ecs::World& world, const Crystal& crystal) {
    constexpr std::size_t bytes = crystal_voxels * sizeof(field::Rgb8);
    return {world.blob<CrystalDensity>().subspan(crystal.number * crystal_voxels, crystal_voxels),
            world.blob<CrystalColour>().subspan(crystal.number * bytes, bytes)};
}

/// Whether the voxels are those of an earlier picture.
bool equal(const CrystalVoxels& old, const VoxelBlobs& now) {
    return std::memcmp(old.density.data(), now.density.data(), now.density.size_bytes()) == 0 &&
           std::memcmp(old.colour.data(), now.colour.data(), now.colour.size_bytes()) == 0;
}

void take_voxels(const ecs::World& world, const Crystal& crystal, CrystalPicture& out) {
    if (crystal.touched == 0) {
        out.voxels = nullptr;
        return;
    }
    const auto now = voxels_in(world, crystal);
    if (out.voxels != nullptr && equal(*out.voxels, now)) return;
    auto copy = std::make_shared<CrystalVoxels>();
    copy->density.assign(now.density.begin(), now.density.end());
    copy->colour.resize(crystal_voxels);
    std::memcpy(copy->colour.data(), now.colour.data(), now.colour.size_bytes());
    out.voxels = std::move(copy);
}

}  // namespace

void take_orb(const Simulation& match, OrbPicture& out) {
    const auto& world = match.world();
    out.there = match.data().orb && world.count<Orb>() > 0;
    if (!out.there) return;
    const auto& orb = world.single<Orb>();
    out.middle = orb.middle;
    out.radius = orb.radius;
    out.seed = orb.seed;
    out.probes.fill(std::nullopt);
    world.view<const Wizard, const WornModes, ecs::Maybe<const Scrying>>().each(
        [&](const Wizard& wizard, const WornModes& modes, const Scrying* scrying) {
            out.found.at(wizard.player) = modes.told != 0;
            if (scrying != nullptr)
                out.probes.at(wizard.player) =
                    TipPicture{.place = scrying->place,
                               .force = scrying->force,
                               .force_share = force_share(match, wizard.player, scrying->force)};
        });
}

void take_scrying(const Simulation& match, ecs::Entity wizard, std::uint32_t player, ScryingPicture& out) {
    const auto& world = match.world();
    const auto* modes = world.find<WornModes>(wizard);
    if (!match.data().orb || modes == nullptr) return;
    const auto* scrying = world.find<Scrying>(wizard);
    out.scries = scrying != nullptr;
    out.near = out.scries ||
               within_reach_of_orb(match.data(), world.single<Orb>(), world.get<Motion>(wizard).position);
    if (!out.near) return;
    const auto& rules = *match.data().orb;
    take_modes(match, *modes, out);
    out.wanted_s = seconds(rules.hold);
    out.told = modes->told != 0;
    if (modes->order_told != 0) take_order(match, player, out);
    if (scrying == nullptr) return;
    out.draws = scrying->drawing != 0;
    out.core_near = scrying->near_since != 0;
    const auto played = match.match().played;
    if (out.core_near && played > scrying->near_since)
        out.held_s = std::min(seconds(played - scrying->near_since), out.wanted_s);
}

void take_crystals(const Simulation& match, std::vector<CrystalPicture>& out) {
    out.resize(match.data().crystal ? match.world().count<Crystal>() : 0);
    match.world().view<const Crystal>().each([&](const Crystal& crystal) {
        if (crystal.number >= out.size()) return;
        auto& picture = out[crystal.number];
        picture.middle = crystal.middle;
        picture.yaw = crystal.yaw;
        picture.edge = crystal.size;
        picture.seed = crystal.seed;
        take_voxels(match.world(), crystal, picture);
    });
}

void take_carving(const Simulation& match, ecs::Entity wizard, std::uint32_t player, CarvingPicture& out) {
    const auto& rules = match.data().crystal;
    const auto& world = match.world();
    const auto* lens = world.find<Lens>(wizard);
    if (!rules || lens == nullptr) return;
    const vec3 body = world.get<Motion>(wizard).position;
    const auto* chisel = world.find<Chisel>(wizard);
    double voxel = 0;  // edge of a voxel of the crystal within reach (m)
    world.view<const Crystal>().each([&](const Crystal& crystal) {
        if (!within_reach_of_crystal(match.data(), crystal, body)) return;
        out.near = true;
        out.overlap = crystal.overlap;
        voxel = spacing_of(crystal);
    });
    out.wanted = rules->overlap;
    if (chisel == nullptr) return;
    out.carves = true;
    out.crystal = world.get<AtStation>(wizard).number;
    std::copy_n(rules->tool_names.begin(), std::min(rules->tool_names.size(), out.tools.size()),
                out.tools.begin());
    if (lens->tool < rules->tools.size()) {
        out.tool = lens->tool;
        out.tip.radius = reach_of(rules->tools[lens->tool], voxel);
    }
    out.tip.place = chisel->place;
    out.tip.force = chisel->force;
    out.tip.force_share = force_share(match, player, chisel->force);
    out.tip.works = chisel->cutting != 0;
}

void take_work(const Simulation& match, ecs::Entity wizard, std::uint32_t player, WorkPicture& out) {
    const auto& world = match.world();
    const auto* lens = world.find<Lens>(wizard);
    out.lens = lens != nullptr && lens->held != 0;
    if (world.count<GreatWork>() == 0) return;
    out.whole_s = seconds(match.data().crystal->work_lasts);
    const double held_s = seconds(held_both_for(world, player, match.match().played));
    out.left_s = world.single<GreatWork>().since.at(player) != 0 ? std::max(out.whole_s - held_s, 0.0) : 0;
}

}  // namespace thaum::game
