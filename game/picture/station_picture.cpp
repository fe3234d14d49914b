#include "game/picture/station_picture.h"

#include <algorithm>
#include <cstring>

#include "game/components/casting.h"
#include "game/components/crystal.h"
#include "game/components/station.h"
#include "game/match/great_work.h"
#include "game/match/simulation.h"
#include "game/stations/cauldron/potions.h"
#include "game/stations/crystal/chisel.h"
#include "game/stations/orb/scrying.h"
#include "game/stations/orb/worn_modes.h"

namespace thaum::game::inline picture {
namespace {

/// Largest half edge of the box that a tool changes (m), for a given voxel edge (m).
double reach_of(const field::Tool& tool, double voxel) {
    double reach = 0;
    for (const auto& operation : tool.operations) {
        const vec3 half = operation.extent.half * (operation.extent.in_metres ? 1 : voxel);
        reach = std::max({reach, half.x, half.y, half.z});
    }
    return reach;
}

/// Duration of the trial use of a tool (s), that of a short click.
constexpr double trial = 0.15;

/// Effect that a carver's tool, used at its present position, would have on the overlap of crystal and key's
/// shape.
DabWorth worth_of(const Simulation& match, const AtStation& station, const Chisel& chisel,
                  const field::Tool& tool) {
    const auto& world = match.world();
    const auto& crystal = world.get<Crystal>(crystal_entity(world, station.number));
    if (crystal.touched == 0) return DabWorth::nothing;
    const auto placement = placement_of(crystal);
    const HandFrame frame = chisel_frame(*match.data().crystal, station);
    const field::Dab dab{.place = field::to_own(placement, chisel.place),
                         .turn = glm::transpose(placement.turn) * glm::mat3_cast(frame.turn),
                         .seconds = trial};
    return worth_of_dab(match.context(), match.crystals(), crystal, tool, dab);
}

/// A wizard who may begin work at a station (orb or crystal).
struct Comer {
    bool presses{};  ///< true: the player presses the button Stir
    vec3 eye{};      ///< position of the eye (m, world)
    vec3 ahead{};    ///< direction of view (unit, world)
};

Comer comer_of(const Simulation& match, ecs::Entity wizard) {
    const auto& world = match.world();
    const auto& gaze = world.get<Gaze>(wizard);
    return {presses_stir(world, wizard), eye_of(match.data().wizard, world.get<Motion>(wizard).position),
            look_rotation(gaze.yaw, gaze.pitch) * vec3(0, 0, -1)};
}

/// Whether a press of the button Stir is meant for a station (orb or crystal) that is out of `reach` (m,
/// along the ground).
bool misses(const Comer& comer, vec3 middle, double reach) {
    return comer.presses && off_axis(comer.eye - middle) < reach + missed_station_m;
}

/// Whether a wizard looks towards a station (orb or crystal) to within 60 degrees, seen from above.
bool faces(const Comer& comer, vec3 middle) {
    vec3 way = middle - comer.eye, ahead = comer.ahead;
    way.y = ahead.y = 0;
    return glm::dot(way, ahead) > 0.5 * glm::length(way) * glm::length(ahead);
}

/// Position at which a probe (the tip that a hand moves in the orb) is shown: inside the glass, although the
/// hand can move beyond it.
vec3 within_glass(const Orb& orb, vec3 place) {
    // Share of the radius within which the tip's bead does not pierce the glass.
    constexpr double share = 0.97;
    const vec3 off = place - orb.middle;
    const double most = share * orb.radius, length = glm::length(off);
    return length > most ? orb.middle + most / length * off : place;
}

/// Display names of the orb's haptic modes (ways to feel the flow), instead of the names in files.
std::string_view shown_mode(std::string_view name) { return name == "vortex_tube" ? "vortex tube" : name; }

double force_share(const Simulation& match, std::uint32_t player, vec3 force) {
    const auto& setup = match.haptic_setup();
    const double cap = setup.on[player] ? force_cap(setup, player) : 0;
    return cap > 0 ? glm::length(force) / cap : 0;
}

/// Copies the strength curve of a haptic mode as the player sees it on the plane where it is drawn: 0 is the
/// mode's lowest strength, and 1 the highest one.
void take_curve(const OrbRules& rules, const OrbMode& mode, const field::TransferFunction& strength,
                std::array<float, curve_points>& out) {
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double at = mode.max_property * static_cast<double>(i) / static_cast<double>(out.size() - 1);
        out.at(i) = static_cast<float>((strength(at) - mode.least) / (rules.most - mode.least));
    }
}

/// Copies the order of ingredients for this player, for the first recipe whose order is random.
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

/// Voxels of one crystal, as views of the World's arrays (blobs).
struct VoxelBlobs {
    std::span<const float> density;
    std::span<const std::uint8_t> colour;
};

VoxelBlobs voxels_in(const ecs::World& world, const Crystal& crystal) {
    constexpr std::size_t bytes = crystal_voxels * sizeof(field::Rgb8);
    return {world.blob<CrystalDensity>().subspan(crystal.number * crystal_voxels, crystal_voxels),
            world.blob<CrystalColour>().subspan(crystal.number * bytes, bytes)};
}

/// Whether the voxels are equal to those of an earlier picture.
bool equal(const CrystalVoxels& old, const VoxelBlobs& current) {
    return std::memcmp(old.density.data(), current.density.data(), current.density.size_bytes()) == 0 &&
           std::memcmp(old.colour.data(), current.colour.data(), current.colour.size_bytes()) == 0;
}

void take_voxels(const ecs::World& world, const Crystal& crystal, CrystalPicture& out) {
    if (crystal.touched == 0) {
        out.voxels = nullptr;
        return;
    }
    const auto current = voxels_in(world, crystal);
    if (out.voxels != nullptr && equal(*out.voxels, current)) return;
    auto copy = std::make_shared<CrystalVoxels>();
    copy->density.assign(current.density.begin(), current.density.end());
    copy->colour.resize(crystal_voxels);
    std::memcpy(copy->colour.data(), current.colour.data(), current.colour.size_bytes());
    out.voxels = std::move(copy);
}

}  // namespace

bool presses_stir(const ecs::World& world, ecs::Entity wizard) {
    const auto* controls = world.find<Controls>(wizard);
    return controls != nullptr && ((controls->held | controls->pressed) & bit(input::Button::stir)) != 0;
}

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
                    TipPicture{.place = within_glass(orb, scrying->place),
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
    const auto& orb = world.single<Orb>();
    const auto comer = comer_of(match, wizard);
    out.misses = !out.near && misses(comer, orb.middle, orb.radius + match.data().orb->reach);
    out.faces = out.scries || faces(comer, orb.middle);
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
    const auto comer = comer_of(match, wizard);
    world.view<const Crystal>().each([&](const Crystal& crystal) {
        const bool near = within_reach_of_crystal(match.data(), crystal, body);
        out.misses = out.misses || (!near && misses(comer, crystal.middle, rules->reach));
        if (!near) return;
        out.near = true;
        out.faces = chisel != nullptr || faces(comer, crystal.middle);
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
        out.tip.worth = worth_of(match, world.get<AtStation>(wizard), *chisel, rules->tools[lens->tool]);
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

}  // namespace thaum::game::inline picture
