#include "game/stations/orb/orb.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace thaum::game::inline stations {
namespace {

/// Least and greatest distance from the orb's middle to the hidden core, the axis of the flow's first vortex,
/// as a share of the edge of the flow's box. The least is not 0, because a probe at rest in the middle must
/// not find the core.
constexpr double min_off_middle = 0.1, max_off_middle = 0.22;
/// Half the length of the part of the hidden core that a hand can reach on a device with a shallow workspace,
/// as a share of the edge of the flow's box. The hidden core is the axis of the flow's first vortex. Along
/// this part the conditions must hold under which players can find the core.
constexpr double searched_half = 0.2;
/// Maximum distance between the hidden core (the axis of the flow's first vortex) and the point around which
/// the whole flow turns, as a share of the edge of the flow's box.
constexpr double max_shift = 0.03;
/// Minimum ratio of the curl of the hidden core's vortex to that of another vortex.
constexpr double min_lead = 1.2;
/// Maximum number of flows that are tried. About one in 20 has a hidden core (the axis of its first vortex)
/// that can be found by hand.
constexpr int max_flows = 1000;

double curl_of(const field::RankineVortex& vortex) { return 2 * std::abs(vortex.speed) / vortex.radius; }

vec3 across(vec3 way, vec3 axis) { return way - glm::dot(way, axis) * axis; }

/// Distance between the hidden core (the axis of the flow's first vortex) and the point beside it around
/// which the whole flow turns (m). It is estimated at one point of the axis.
double shift_at(const field::VortexFlow& flow, vec3 place) {
    const auto& core = flow.vortices[0];
    return glm::length(across(flow(place).value, core.axis)) * core.radius / std::abs(core.speed);
}

/// Seed of a flow whose hidden core (the axis of its first vortex) can be found by hand. If all tries fail,
/// the last seed tried.
std::uint64_t seed_of_flow(double extent, std::uint64_t seed) {
    constexpr std::uint64_t stream = 3;
    Random random = random_stream(seed, stream);
    std::uint64_t drawn = random.next();
    for (int i = 1; i < max_flows && !can_be_found(field::make_vortex_flow(extent, drawn), extent); ++i)
        drawn = random.next();
    return drawn;
}

WornModes modes_at_first(const OrbRules& rules) {
    WornModes modes;
    for (std::size_t i = 0; i < rules.modes.size(); ++i) modes.strength[i] = rules.modes[i].strength;
    return modes;
}

}  // namespace

field::VortexFlow flow_of(const Orb& orb) { return field::make_vortex_flow(2 * orb.radius, orb.seed); }

HiddenCore core_of(const Orb& orb) { return core_within(flow_of(orb), orb.middle, orb.radius); }

HiddenCore core_within(const field::VortexFlow& flow, vec3 middle, double radius) {
    const auto& vortex = flow.vortices[0];
    const vec3 nearest = across(vortex.middle, vortex.axis);
    const double square = radius * radius - glm::dot(nearest, nearest);
    return {.middle = middle + nearest, .axis = vortex.axis, .half = std::sqrt(std::max(0.0, square))};
}

double distance_from(const HiddenCore& core, vec3 place) {
    const double along = std::clamp(glm::dot(place - core.middle, core.axis), -core.half, core.half);
    return glm::distance(place, core.middle + along * core.axis);
}

bool can_be_found(const field::VortexFlow& flow, double extent) {
    const auto& core = flow.vortices[0];
    const vec3 nearest = across(core.middle, core.axis);
    const double off = glm::length(nearest) / extent;
    if (off < min_off_middle || off > max_off_middle) return false;
    for (std::size_t i = 1; i < flow.vortices.size(); ++i)
        if (curl_of(core) < min_lead * curl_of(flow.vortices[i])) return false;
    constexpr int steps = 4;
    for (int i = -steps; i <= steps; ++i) {
        const vec3 place = nearest + i * (searched_half * extent / steps) * core.axis;
        if (shift_at(flow, place) > max_shift * extent) return false;
    }
    return true;
}

void spawn_orb(MatchContext& context, std::uint64_t seed) {
    if (!context.data.orb) return;
    const auto* place = orb_of(context.data.arena);
    const double radius = place->body.size.x;
    auto& world = context.world;
    world.create(Orb{.middle = place->position, .radius = radius, .seed = seed_of_flow(2 * radius, seed)});
    for (std::uint32_t player = 0; player < players; ++player)
        world.add(wizard_of(world, player), modes_at_first(*context.data.orb));
}

std::optional<OrbMemory> orb_memory(const ecs::World& world) {
    if (world.count<Orb>() == 0) return std::nullopt;
    OrbMemory memory{.seed = world.single<Orb>().seed};
    for (std::uint32_t player = 0; player < players; ++player)
        memory.modes[player] = world.get<WornModes>(wizard_of(world, player));
    return memory;
}

void spawn_next_orb(MatchContext& context, const OrbMemory& memory) {
    spawn_orb(context, memory.seed);
    for (std::uint32_t player = 0; player < players; ++player) {
        auto& modes = context.world.get<WornModes>(wizard_of(context.world, player));
        modes = memory.modes[player];
        modes.told = modes.spent = 0;
    }
}

HandFrame probe_frame(const OrbRules& rules, const Orb& orb, double yaw) {
    return {.origin = orb.middle, .turn = look_rotation(yaw, 0), .metres_per_metre = rules.metres_per_metre};
}

}  // namespace thaum::game::inline stations
