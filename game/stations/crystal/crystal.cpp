#include "game/stations/crystal/crystal.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/hash.h"
#include "game/stations/crystal/crystal_shape.h"

namespace thaum::game::inline stations {
namespace {

/// Colour of a crystal that no one has painted.
constexpr field::Rgb8 clear_colour{150, 200, 230};
/// Number of the match's random stream from which the seeds of crystals are drawn.
constexpr std::uint64_t seed_stream = 4;

/// Number of hits in one tick for which memory is reserved in advance, so that a first hit need not allocate.
constexpr std::uint32_t usual_strikes = 8;

std::uint64_t next_seed(std::uint64_t seed) { return hash_combine(seed, 0x6b6579); }

std::uint32_t crystals_in(const ecs::World& world) { return world.count<Crystal>(); }

CrystalBody& body_of(CrystalBodies& bodies, const Crystal& crystal) { return bodies.list.at(crystal.number); }

void mark_all_changed(field::Bricks& bricks) {
    ++bricks.newest;
    std::fill(bricks.version.begin(), bricks.version.end(), bricks.newest);
}

/// Prepares the cached data of a crystal whose voxels were just created or restored.
void note_voxels(ecs::World& world, CrystalBodies& bodies, const Crystal& crystal) {
    auto& body = body_of(bodies, crystal);
    mark_all_changed(body.bricks);
    field::measure_overlap(voxels_of(world, bodies, crystal), body.key, crystal_surface, body.overlap);
}

/// Fills the crystal's voxels with its uncarved shape (the rough body of its seed).
void make_rough(MatchContext& context, CrystalBodies& bodies, Crystal& crystal) {
    auto& body = body_of(bodies, crystal);
    body.key.resize(crystal_voxels);
    write_key_density(crystal.seed, crystal_side, body.key);
    const auto view = voxels_of(context.world, bodies, crystal);
    write_rough_density(crystal.seed, body.key, crystal_side, view.density);
    std::fill(view.colour.begin(), view.colour.end(), clear_colour);
    note_voxels(context.world, bodies, crystal);
    crystal.overlap = body.overlap.ratio();
}

/// Yaw that points a crystal's z axis at the middle of the arena, so that both players' crystals look alike
/// (rad).
double yaw_of(vec3 middle) { return middle.x == 0 && middle.z == 0 ? 0 : det::atan2(-middle.x, -middle.z); }

/// Fits the cached data to a World whose crystals are untouched. Reserves their memory, so that the first hit
/// on a crystal need not allocate. Reserved memory that is never used takes up no memory of the machine.
void fit_bodies(const ecs::World& world, CrystalBodies& bodies) {
    bodies.list.resize(crystals_in(world));
    for (auto& body : bodies.list) {
        auto inside = std::move(body.overlap.inside);
        inside.clear();
        inside.reserve(crystal_voxels);
        body.overlap = {.inside = std::move(inside)};
        body.key.clear();
        body.key.reserve(crystal_voxels);
        body.old.reserve(crystal_voxels);
        mark_all_changed(body.bricks);
    }
}

void reserve_voxels(ecs::World& world) {
    const auto crystals = std::size_t{crystals_in(world)};
    if (crystals == 0) return;
    world.reserve<CrystalStrike>(usual_strikes);
    world.reserve_blob<CrystalDensity>(crystals * crystal_voxels);
    world.reserve_blob<CrystalColour>(crystals * crystal_voxels * sizeof(field::Rgb8));
}

/// Point on the line from `from` (outside) to `to` (inside) at which the density is that of the surface.
vec3 bisected(const field::Grid& grid, vec3 from, vec3 to) {
    for (int i = 0; i < 24; ++i) {
        const vec3 middle = 0.5 * (from + to);
        (grid.value(middle) >= static_cast<double>(crystal_surface) ? to : from) = middle;
    }
    return to;
}

/// Range of the parameter of a ray inside a box around the origin; empty if high < low.
struct Stretch {
    double low{}, high{};
};

Stretch within_box(vec3 from, vec3 way, double half) {
    Stretch part{0, HUGE_VAL};
    for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0) {
            if (std::abs(from[axis]) > half) return {1, 0};
            continue;
        }
        const double a = (-half - from[axis]) / way[axis], b = (half - from[axis]) / way[axis];
        part = {std::max(part.low, std::min(a, b)), std::min(part.high, std::max(a, b))};
    }
    return part;
}

}  // namespace

CrystalSeeds next_seeds(const ecs::World& world) {
    CrystalSeeds seeds(crystals_in(world));
    world.view<const Crystal>().each(
        [&](const Crystal& crystal) { seeds.at(crystal.number) = next_seed(crystal.seed); });
    return seeds;
}

void spawn_crystals(MatchContext& context, CrystalBodies& bodies, const CrystalSeeds& seeds) {
    auto& world = context.world;
    std::vector<std::pair<ecs::Entity, Crystal>> found;
    if (context.data.crystal) {
        std::as_const(world).view<const Look, const Motion, const Body>().each(
            [&](ecs::Entity e, const Look& look, const Motion& motion, const Body& body) {
                if (!is_crystal(look.surface, body.shape)) return;
                const auto number = static_cast<std::uint32_t>(found.size());
                const double size = 2 * std::min({body.size.x, body.size.y, body.size.z});
                found.emplace_back(e, Crystal{.middle = motion.position,
                                              .yaw = yaw_of(motion.position),
                                              .size = size,
                                              .seed = number < seeds.size() ? seeds[number] : 0,
                                              .number = number});
            });
    }
    for (const auto& [e, crystal] : found) world.add(e, crystal);
    reserve_voxels(world);
    fit_bodies(world, bodies);
}

void draw_crystals(MatchContext& context, std::uint64_t seed) {
    auto random = random_stream(seed, seed_stream);
    context.world.view<Crystal>().each([&](Crystal& crystal) { crystal.seed = random.next(); });
}

void rebuild_crystals(MatchContext& context, CrystalBodies& bodies) {
    auto& world = context.world;
    fit_bodies(world, bodies);
    std::as_const(world).view<const Crystal>().each([&](const Crystal& crystal) {
        if (crystal.touched == 0) return;
        body_of(bodies, crystal).key = key_density(crystal.seed, crystal_side);
        note_voxels(world, bodies, crystal);
    });
}

void touch_crystal(MatchContext& context, CrystalBodies& bodies, Crystal& crystal) {
    if (crystal.touched != 0) return;
    auto& world = context.world;
    if (world.count<CrystalDensity>() == 0) {
        world.resize<CrystalDensity>(crystals_in(world) * crystal_voxels);
        world.resize<CrystalColour>(crystals_in(world) * crystal_voxels * sizeof(field::Rgb8));
    }
    crystal.touched = 1;
    make_rough(context, bodies, crystal);
}

void renew_crystal(MatchContext& context, CrystalBodies& bodies, Crystal& crystal) {
    crystal.seed = next_seed(crystal.seed);
    ++crystal.edits;
    make_rough(context, bodies, crystal);
}

field::Edit cut_crystal(MatchContext& context, CrystalBodies& bodies, Crystal& crystal,
                        const field::Tool& tool, const field::Dab& dab) {
    THAUM_ASSERT(crystal.touched != 0, "an untouched crystal has no voxels to cut");
    const auto view = voxels_of(context.world, bodies, crystal);
    const auto edit = field::edit(view, tool, dab);
    count_again(bodies, crystal, view, edit.changed);
    return edit;
}

void count_again(CrystalBodies& bodies, Crystal& crystal, const field::VoxelView& view,
                 const field::VoxelBox& changed) {
    auto& overlap = body_of(bodies, crystal).overlap;
    field::recount(overlap, view, changed);
    if (!changed.empty()) ++crystal.edits;
    crystal.overlap = overlap.ratio();
}

field::Placement placement_of(const Crystal& crystal) {
    return {.origin = crystal.middle, .turn = glm::mat3_cast(rotation({0, 1, 0}, crystal.yaw))};
}

field::VoxelView voxels_of(ecs::World& world, CrystalBodies& bodies, const Crystal& crystal) {
    static_assert(sizeof(field::Rgb8) == 3 && alignof(field::Rgb8) == 1);
    const auto first = crystal.number * crystal_voxels;
    auto* colours = reinterpret_cast<field::Rgb8*>(world.blob<CrystalColour>().data());
    return {.count = {crystal_side, crystal_side, crystal_side},
            .spacing = vec3(spacing_of(crystal)),
            .surface = crystal_surface,
            .density = world.blob<CrystalDensity>().subspan(first, crystal_voxels),
            .colour = {colours + first, crystal_voxels},
            .material = {},
            .bricks = &body_of(bodies, crystal).bricks};
}

field::Grid density_grid(const ecs::World& world, const Crystal& crystal, field::Kernel kernel) {
    const auto samples = world.blob<CrystalDensity>();
    constexpr std::ptrdiff_t row = crystal_side, plane = row * crystal_side;
    const vec3 spacing(spacing_of(crystal));
    return {.first = samples.data() + crystal.number * crystal_voxels,
            .count = {crystal_side, crystal_side, crystal_side},
            .stride = {1, row, plane},
            .origin = -0.5 * (crystal_side - 1) * spacing,
            .spacing = spacing,
            .kernel = kernel};
}

std::optional<vec3> surface_along(const ecs::World& world, const Crystal& crystal, vec3 from, vec3 way) {
    const double length = glm::length(way);
    if (!(length > 0) || !is_finite(from) || !is_finite(way)) return std::nullopt;
    const vec3 ahead = way / length;
    const auto part = within_box(from, ahead, crystal.size / 2);
    const auto grid = density_grid(world, crystal, field::Kernel::linear);
    const double step = spacing_of(crystal) / 4;
    vec3 outside = from + part.low * ahead;
    for (double at = part.low; at <= part.high; at += step) {
        const vec3 place = from + at * ahead;
        if (grid.value(place) >= static_cast<double>(crystal_surface)) return bisected(grid, outside, place);
        outside = place;
    }
    return std::nullopt;
}

ecs::Entity crystal_entity(const ecs::World& world, std::uint32_t number) {
    ecs::Entity found;
    world.view<const Crystal>().each([&](ecs::Entity e, const Crystal& crystal) {
        if (crystal.number == number) found = e;
    });
    return found;
}

}  // namespace thaum::game::inline stations
