// All distances are to the surface `surface_gap` outside the true one: rounding (1e-16 of a coordinate) then never decides on which
// side the proxy is. A triangle is hit where the path crosses the triangle itself, not its offset plane: between the offset
// planes of two triangles that meet in a ridge there would be a slit. So a mesh whose triangles share corners has no holes.
#include "haptics/surface.h"

#include <algorithm>

namespace thaum::haptics {
namespace {

constexpr double touch_gap = surface_gap;
constexpr double tight = 1e-13;            // m; closer than this is the same place
constexpr double resting_slack = 5e-4;     // m that a touched triangle may have moved unannounced
constexpr double nearly_parallel = 1e-15;  // sine squared, below which two planes make no crease
constexpr double loose = 0.4 * touch_gap;  // m, by which such planes may stand above each other
constexpr int most_moves = 32;             // of the proxy in a tick
constexpr int most_pushes = 4;
constexpr int most_advances = 60;  // grazing a round side halves the gap each time
constexpr std::size_t most_planes = 4;
constexpr std::uint32_t nothing = ~0U;

/// x is free where normal.x >= offset.
struct Wall {
    vec3 normal{};
    double offset{};
    double depth{};  // m, how far it pushes the proxy from the tip
    std::uint32_t surface{};
};

struct Walls {
    std::array<Wall, most_planes> items{};
    std::size_t count{};
};

/// Where a body was is where `now` maps from.
struct Carrier {
    mat3 turn{1.0};
    vec3 pivot_before{};
    vec3 pivot{};
    bool moving{};
    bool turning{};

    vec3 now(vec3 before) const {
        if (!moving) return before;
        const vec3 arm = before - pivot_before;
        return pivot + (turning ? turn * arm : arm);
    }
};

/// A plane, or that of a triangle, close together in memory: each sweep looks at all of them.
struct Facet {
    vec3 normal;
    double offset;  // m, of the true surface
    double gap;     // m, before it: with the texture's top
    std::uint32_t surface;
    SurfaceKind kind;
};

/// What a tick computes once from a patch. Only what the counts say is set.
struct Scene {
    const SurfacePatch* patch;
    std::uint32_t flat_count;
    std::uint32_t solid_count;
    std::uint32_t body_count;
    std::array<Facet, surface_capacity> flats;
    std::array<std::uint32_t, surface_capacity> solids;
    std::array<vec3, surface_capacity> normal;  // of the flat surfaces
    std::array<double, surface_capacity> gap;
    std::array<Carrier, surface_body_capacity> carriers;

    const Surface& surface(std::uint32_t i) const { return patch->surfaces[i]; }
    const SurfaceBody& body_of(std::uint32_t i) const { return patch->bodies[surface(i).body]; }
};

bool is_flat(SurfaceKind kind) { return kind <= SurfaceKind::sheet; }
bool is_triangle(SurfaceKind kind) { return kind == SurfaceKind::triangle || kind == SurfaceKind::sheet; }

Carrier carrier_of(const SurfaceBody& body, double dt) {
    Carrier carrier;
    carrier.moving = body.velocity != vec3(0) || body.spin != vec3(0);
    if (!carrier.moving) return carrier;
    carrier.pivot = body.position;
    carrier.pivot_before = body.position - dt * body.velocity;
    const double speed = glm::length(body.spin);
    carrier.turning = speed > 0;
    if (carrier.turning) carrier.turn = glm::mat3_cast(rotation(body.spin / speed, speed * dt));
    return carrier;
}

/// m
double top_of(const Texture& texture) {
    return texture.kind != TextureKind::none && texture.amplitude > 0 && texture.wavelength > 0
               ? 2 * texture.amplitude
               : 0;
}

/// Leaves out a triangle without area.
void add_flat(Scene& scene, std::uint32_t i) {
    const Surface& s = scene.surface(i);
    const vec3 normal = s.kind == SurfaceKind::plane ? s.b : glm::cross(s.b - s.a, s.c - s.a);
    const double length2 = glm::dot(normal, normal);
    if (!(length2 > 0) || !std::isfinite(length2)) return;
    const vec3 unit = normal * (1 / std::sqrt(length2));
    scene.normal[i] = unit;
    scene.flats[scene.flat_count++] = {unit, glm::dot(unit, s.a), scene.gap[i], i, s.kind};
}

void set_scene(Scene& scene, const SurfacePatch& patch, double dt) {
    scene.patch = &patch;
    scene.flat_count = scene.solid_count = 0;
    scene.body_count =
        static_cast<std::uint32_t>(std::min<std::size_t>(patch.body_count, surface_body_capacity));
    std::array<double, surface_body_capacity> gaps{};
    for (std::uint32_t i = 0; i < scene.body_count; ++i) {
        scene.carriers[i] = carrier_of(patch.bodies[i], dt);
        gaps[i] = touch_gap + top_of(patch.bodies[i].material.texture);
    }
    const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(patch.count, surface_capacity));
    for (std::uint32_t i = 0; i < count; ++i) {
        if (patch.surfaces[i].body >= scene.body_count) continue;
        scene.gap[i] = gaps[patch.surfaces[i].body];
        if (is_flat(patch.surfaces[i].kind)) {
            add_flat(scene, i);
        } else {
            scene.solids[scene.solid_count++] = i;
        }
    }
}

// ---- distances ----------------------------------------------------------------------------------------------------

struct Distance {
    double value;  // m, negative inside
    vec3 normal;   // unit, outward
};

Distance from_core(vec3 out, double radius) {
    const double length = glm::length(out);
    return {length - radius, length > 0 ? out / length : vec3(0, 1, 0)};
}

Distance to_box(vec3 p, vec3 half) {
    const vec3 beyond = glm::abs(p) - half;
    const vec3 sign(p.x < 0 ? -1 : 1, p.y < 0 ? -1 : 1, p.z < 0 ? -1 : 1);
    if (beyond.x <= 0 && beyond.y <= 0 && beyond.z <= 0) {
        const int axis = beyond.x >= beyond.y && beyond.x >= beyond.z ? 0 : beyond.y >= beyond.z ? 1 : 2;
        vec3 normal(0);
        normal[axis] = sign[axis];
        return {beyond[axis], normal};
    }
    return from_core(sign * glm::max(beyond, vec3(0)), 0);
}

Distance to_cylinder(vec3 p, double radius, double half) {
    const double across = std::sqrt(p.x * p.x + p.z * p.z);
    const vec3 out = across > 0 ? vec3(p.x / across, 0, p.z / across) : vec3(1, 0, 0);
    const vec3 up(0, p.y < 0 ? -1 : 1, 0);
    const double beside = across - radius, above = std::abs(p.y) - half;
    if (beside <= 0 && above <= 0) return beside >= above ? Distance{beside, out} : Distance{above, up};
    return from_core(std::max(beside, 0.0) * out + std::max(above, 0.0) * up, 0);
}

/// To a solid that is no half-space.
Distance to_solid(const Surface& s, quat orientation, vec3 p) {
    const vec3 arm = p - s.a;
    if (s.kind == SurfaceKind::sphere) return from_core(arm, s.b.x);
    const vec3 local = glm::conjugate(orientation) * arm;
    Distance d{};
    if (s.kind == SurfaceKind::box)
        d = to_box(local, s.b);
    else if (s.kind == SurfaceKind::cylinder)
        d = to_cylinder(local, s.b.x, s.b.y);
    else
        d = from_core({local.x, local.y - std::clamp(local.y, -s.b.y, std::max(s.b.y, -s.b.y)), local.z},
                      s.b.x);
    d.normal = orientation * d.normal;
    return d;
}

/// Whether the plane's point p lies in the triangle.
bool over_triangle(const Surface& s, vec3 normal, vec3 p, double slack) {
    const std::array corners{s.a, s.b, s.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const vec3 from = corners[i], edge = corners[(i + 1) % 3] - from;
        const double inward = glm::dot(glm::cross(normal, edge), p - from);  // times the edge's length
        if (inward < 0 && inward * inward > slack * slack * glm::dot(edge, edge)) return false;
    }
    return true;
}

// ---- the swept point ----------------------------------------------------------------------------------------------

/// A way, with what each surface asks of it.
struct Way {
    vec3 from{}, step{};
    double length{};

    Way(vec3 start, vec3 whole) : from(start), step(whole), length(glm::length(whole)) {}
};

struct Hit {
    double at{2};   // part of the way
    double drop{};  // m, of the way, against the wall
    Wall wall{};
};

/// Whether a hit comes before another; of two at once the one that is met more squarely.
bool sooner(double at, double drop, const Hit& than, double length) {
    const double lead = (than.at - at) * length;
    return lead > tight || (lead > -tight && drop > than.drop);
}

/// A wall through the surface's gap, at a distance known at p.
Wall wall_at(const Scene& scene, vec3 p, Distance d, std::uint32_t i) {
    return {d.normal, glm::dot(d.normal, p) - d.value + scene.gap[i], 0, i};
}

void sweep_flat(const Scene& scene, const Facet& flat, const Way& way, Hit& first) {
    vec3 normal = flat.normal;
    double offset = flat.offset;
    double start = glm::dot(normal, way.from) - offset;
    double drop = -glm::dot(normal, way.step);
    if (flat.kind == SurfaceKind::sheet && start < 0) {
        normal = -normal;
        offset = -offset;
        start = -start;
        drop = -drop;
    }
    const double end = start - drop;
    if (!(drop > 0) || end >= flat.gap - tight) return;
    if (flat.kind != SurfaceKind::plane && start < -touch_gap / 2) return;
    const double at = std::clamp((start - flat.gap) / drop, 0.0, 1.0);
    if (!sooner(at, drop, first, way.length)) return;
    if (flat.kind != SurfaceKind::plane) {
        const double crossing = end < 0 ? std::clamp(start / drop, 0.0, 1.0) : 1.0;
        if (!over_triangle(scene.surface(flat.surface), flat.normal, way.from + crossing * way.step, tight))
            return;
    }
    first = {at, drop, {normal, offset + flat.gap, 0, flat.surface}};
}

/// At the nearest point of a convex shape stands a plane that has all of it behind, up to which a point may move at once.
void sweep_solid(const Scene& scene, std::uint32_t i, const Way& way, Hit& first) {
    const Surface& s = scene.surface(i);
    const quat orientation = scene.body_of(i).orientation;
    double at = 0;
    const double gap = scene.gap[i];
    double drop = 0;
    Distance here{};
    for (int n = 0; n < most_advances; ++n) {
        here = to_solid(s, orientation, way.from + at * way.step);
        drop = -glm::dot(here.normal, way.step);
        if (!(drop > 0) || here.value - (1 - at) * drop >= gap - tight) return;
        if (here.value <= gap + tight) break;
        at += (here.value - gap) / drop;
        if (at > first.at + 1e-9) return;
    }
    if (sooner(at, drop, first, way.length))
        first = {at, drop, wall_at(scene, way.from + at * way.step, here, i)};
}

Hit first_hit(const Scene& scene, const Way& way, std::uint32_t but = nothing) {
    Hit first;
    for (std::uint32_t i = 0; i < scene.flat_count; ++i) {
        if (scene.flats[i].surface != but) sweep_flat(scene, scene.flats[i], way, first);
    }
    for (std::uint32_t i = 0; i < scene.solid_count; ++i) {
        if (scene.solids[i] != but) sweep_solid(scene, scene.solids[i], way, first);
    }
    return first;
}

// ---- the nearest place before some walls ---------------------------------------------------------------------------

struct Goal {
    vec3 place{};
    bool found{};
};

/// Depths of three walls or fewer that meet where the proxy is: the multipliers of the nearest place to the tip.
struct Trial {
    std::array<std::size_t, 3> walls{};
    std::array<double, 3> depths{};
    std::size_t count{};
};

/// Whether all push and no other wall is entered.
bool holds(const Walls& walls, const Trial& trial, vec3 tip, double slack, vec3& place) {
    place = tip;
    for (std::size_t i = 0; i < trial.count; ++i) {
        if (!(trial.depths[i] > 0)) return false;
        place += trial.depths[i] * walls.items[trial.walls[i]].normal;
    }
    for (std::size_t i = 0; i < walls.count; ++i) {
        const auto used = trial.walls.begin() + static_cast<std::ptrdiff_t>(trial.count);
        if (std::find(trial.walls.begin(), used, i) != used) continue;
        if (glm::dot(walls.items[i].normal, place) < walls.items[i].offset - slack) return false;
    }
    return true;
}

/// How far inside wall i the tip is.
double entered(const Walls& walls, std::size_t i, vec3 tip) {
    return walls.items[i].offset - glm::dot(walls.items[i].normal, tip);
}

Trial against_one(const Walls& walls, std::size_t i, vec3 tip) { return {{i}, {entered(walls, i, tip)}, 1}; }

Trial against_two(const Walls& walls, std::size_t i, std::size_t j, vec3 tip) {
    const vec3 along = glm::cross(walls.items[i].normal, walls.items[j].normal);
    const double sine2 = glm::dot(along, along);
    const double g = glm::dot(walls.items[i].normal, walls.items[j].normal);
    if (sine2 < nearly_parallel) return {{i, j}, {-1, -1}, 2};
    const double a = entered(walls, i, tip), b = entered(walls, j, tip);
    return {{i, j}, {(a - g * b) / sine2, (b - g * a) / sine2}, 2};
}

/// Three planes meet at sum offset_i (n_j x n_k) / det; the depths are coordinates of the way there along the normals.
Trial against_three(const Walls& walls, std::size_t i, std::size_t j, std::size_t k, vec3 tip) {
    const vec3 a = walls.items[i].normal, b = walls.items[j].normal, c = walls.items[k].normal;
    const vec3 bc = glm::cross(b, c), ca = glm::cross(c, a), ab = glm::cross(a, b);
    const double det = glm::dot(a, bc);
    if (det * det < nearly_parallel) return {{i, j, k}, {-1, -1, -1}, 3};
    const vec3 way =
        (entered(walls, i, tip) * bc + entered(walls, j, tip) * ca + entered(walls, k, tip) * ab) / det;
    return {{i, j, k}, {glm::dot(way, bc) / det, glm::dot(way, ca) / det, glm::dot(way, ab) / det}, 3};
}

/// Keeps the walls of the trial, with their depths.
void keep(Walls& walls, const Trial& trial) {
    std::array<Wall, most_planes> kept{};
    for (std::size_t i = 0; i < trial.count; ++i) {
        kept[i] = walls.items[trial.walls[i]];
        kept[i].depth = trial.depths[i];
    }
    walls.items = kept;
    walls.count = trial.count;
}

Goal nearest_place(Walls& walls, vec3 tip, double slack) {
    Goal goal{tip, true};
    const auto try_walls = [&](const Trial& trial) {
        if (!holds(walls, trial, tip, slack, goal.place)) return false;
        keep(walls, trial);
        return true;
    };
    if (try_walls({})) return goal;
    const std::size_t n = walls.count;
    for (std::size_t i = 0; i < n; ++i)
        if (try_walls(against_one(walls, i, tip))) return goal;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
            if (try_walls(against_two(walls, i, j, tip))) return goal;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
            for (std::size_t k = j + 1; k < n; ++k)
                if (try_walls(against_three(walls, i, j, k, tip))) return goal;
    goal.found = false;
    return goal;
}

/// The only place that is nearest to the tip: tries every set of up to three walls. Keeps those that push. Not found where
/// nothing is before all walls.
Goal nearest_place(Walls& walls, vec3 tip) {
    const Goal goal = nearest_place(walls, tip, tight);
    return goal.found ? goal : nearest_place(walls, tip, loose);
}

/// A wall of the same surface is replaced: of a round one it is another.
void add_wall(Walls& walls, const Wall& wall) {
    for (std::size_t i = 0; i < walls.count; ++i) {
        if (walls.items[i].surface != wall.surface) continue;
        walls.items[i] = wall;
        return;
    }
    if (walls.count < most_planes) walls.items[walls.count++] = wall;
}

// ---- what moves over the proxy --------------------------------------------------------------------------------------

bool was_touched(const Scene& scene, const SurfaceState& state, std::uint32_t i) {
    for (std::uint32_t c = 0; c < std::min<std::uint32_t>(state.contacts, 3); ++c) {
        if (state.touched[c].key == scene.body_of(i).key && state.touched[c].part == scene.surface(i).part)
            return true;
    }
    return false;
}

/// Where the body that bears most of the last push takes the proxy.
vec3 carried(const Scene& scene, const SurfaceState& state) {
    if (state.contacts == 0) return state.proxy;
    for (std::uint32_t i = 0; i < scene.body_count; ++i) {
        if (scene.patch->bodies[i].key == state.touched[0].key) return scene.carriers[i].now(state.proxy);
    }
    return state.proxy;
}

/// Whether a flat surface is now before the proxy, which came from in front of it. One that was touched and moved a little more
/// than it said counts too.
bool overran(const Scene& scene, const SurfaceState& state, const Facet& flat, vec3 from, vec3 x,
             Wall& wall) {
    if (from != x) {
        Hit hit;
        sweep_flat(scene, flat, Way(from, x - from), hit);
        wall = hit.wall;
        if (hit.at <= 1) return true;
    }
    const double height = glm::dot(flat.normal, x) - flat.offset;
    if (height >= flat.gap - tight) return false;
    wall = {flat.normal, flat.offset + flat.gap, 0, flat.surface};
    if (flat.kind == SurfaceKind::plane) return true;
    return flat.kind == SurfaceKind::triangle && height < 0 && height > -resting_slack &&
           was_touched(scene, state, flat.surface) &&
           over_triangle(scene.surface(flat.surface), flat.normal, x, tight);
}

/// Likewise a solid: nothing may stay inside.
bool overran(const Scene& scene, std::uint32_t i, vec3 from, vec3 x, Wall& wall) {
    if (from != x) {
        Hit hit;
        sweep_solid(scene, i, Way(from, x - from), hit);
        wall = hit.wall;
        if (hit.at <= 1) return true;
    }
    const Distance d = to_solid(scene.surface(i), scene.body_of(i).orientation, x);
    wall = wall_at(scene, x, d, i);
    return d.value < scene.gap[i] - tight;
}

using Places = std::array<vec3, surface_body_capacity>;

/// Adds the walls that overran the proxy; whether there were some. from: where each body would have taken it.
bool add_overrun(const Scene& scene, const SurfaceState& state, const Places& from, vec3 x, Walls& walls) {
    bool pushed = false;
    Wall wall;
    for (std::uint32_t i = 0; i < scene.flat_count && walls.count < most_planes; ++i) {
        const Facet& flat = scene.flats[i];
        if (!overran(scene, state, flat, from[scene.surface(flat.surface).body], x, wall)) continue;
        add_wall(walls, wall);
        pushed = true;
    }
    for (std::uint32_t i = 0; i < scene.solid_count && walls.count < most_planes; ++i) {
        const std::uint32_t solid = scene.solids[i];
        if (!overran(scene, solid, from[scene.surface(solid).body], x, wall)) continue;
        add_wall(walls, wall);
        pushed = true;
    }
    return pushed;
}

/// The proxy after the bodies' motion. Between two that close on it one must give.
vec3 pushed_out(const Scene& scene, const SurfaceState& state, vec3 start) {
    Places from;
    for (std::uint32_t i = 0; i < scene.body_count; ++i) from[i] = scene.carriers[i].now(state.proxy);
    Walls walls;
    vec3 x = start;
    for (int round = 0; round < most_pushes; ++round) {
        const std::size_t before = walls.count;
        if (!add_overrun(scene, state, from, x, walls)) return x;
        const Goal goal = nearest_place(walls, start);
        if (!goal.found) return x;
        x = goal.place;
        if (walls.count == most_planes && walls.count == before) return x;
    }
    return x;
}

// ---- towards the tip ------------------------------------------------------------------------------------------------

/// What a wall has of the force on the hand.
struct Share {
    vec3 force{};    // N
    double depth{};  // m, as it is felt
};

struct Journey {
    vec3 x{};
    Walls walls{};
    std::array<Share, most_planes> shares{};
    bool slid{};
    bool limited{};
};

const SurfaceMaterial& material_of(const Scene& scene, const Wall& wall) {
    return scene.body_of(wall.surface).material;
}

/// A wall's push with its texture.
struct Felt {
    double depth{};  // m
    vec3 way{};      // of the push, per depth; unit but for bumps
};

Felt felt(const Scene& scene, const Wall& wall, vec3 x) {
    const SurfaceBody& body = scene.body_of(wall.surface);
    const Texture& texture = body.material.texture;
    const double top = top_of(texture);
    if (top == 0) return {wall.depth, wall.normal};
    const vec3 place = glm::conjugate(body.orientation) * (x - body.position);
    const Relief relief = relief_at(texture, scene.patch->bumps, place);
    const double depth = wall.depth - top;  // beneath the surface
    if (texture.kind == TextureKind::impact) return {depth >= 0 ? depth + relief.height : 0.0, wall.normal};
    const vec3 slope = body.orientation * relief.slope;
    const vec3 way = wall.normal - (slope - glm::dot(slope, wall.normal) * wall.normal);
    const double length = texture.kind == TextureKind::vibration ? glm::length(way) : 1;
    return {std::max(0.0, depth + relief.height), way / length};
}

/// m; the push of all walls times their friction.
double friction_reach(const Scene& scene, const Journey& slide, bool sliding) {
    double reach = 0;
    for (std::size_t i = 0; i < slide.walls.count; ++i) {
        const Wall& wall = slide.walls.items[i];
        const SurfaceMaterial& m = material_of(scene, wall);
        const double friction = sliding ? m.dynamic_friction : m.static_friction;
        if (friction > 0) reach += friction * felt(scene, wall, slide.x).depth;
    }
    return reach;
}

/// How much of the way from x the patch's reach allows.
double allowed(const SurfacePatch& patch, vec3 x, vec3 way) {
    if (!(patch.reach < HUGE_VAL)) return 1;
    const vec3 arm = x - patch.centre;
    const double a = glm::dot(way, way), b = glm::dot(arm, way),
                 c = glm::dot(arm, arm) - patch.reach * patch.reach;
    if (a + 2 * b + c <= 0) return 1;  // the end lies within
    if (!(a > 0)) return 0;
    const double root = b * b - a * c;
    return root > 0 ? std::clamp((std::sqrt(root) - b) / a, 0.0, 1.0) : 0.0;
}

/// Whether every wall still stands where the proxy is: it may have gone round an edge.
bool supported(const Scene& scene, const Walls& walls, vec3 x) {
    constexpr double slack = 10 * tight;
    for (std::size_t n = 0; n < walls.count; ++n) {
        const std::uint32_t i = walls.items[n].surface;
        const Surface& s = scene.surface(i);
        if (is_triangle(s.kind)) {
            if (!over_triangle(s, scene.normal[i], x, slack)) return false;
        } else if (!is_flat(s.kind)) {
            const Distance here = to_solid(s, scene.body_of(i).orientation, x);
            const double turned = glm::length(here.normal - walls.items[n].normal) * walls.items[n].depth;
            if (here.value > scene.gap[i] + slack || turned > slack) return false;
        }
    }
    return true;
}

/// Where friction lets the proxy go.
vec3 held_back(const Scene& scene, const Journey& slide, vec3 goal, bool sliding) {
    if (slide.walls.count == 0) return goal;
    const vec3 away = slide.x - goal;
    const double distance = glm::length(away);
    if (distance <= friction_reach(scene, slide, sliding || slide.slid) + tight) return slide.x;
    return goal + away * (friction_reach(scene, slide, true) / distance);
}

/// A part of the way, as far as it is free.
void go(Journey& slide, vec3 way) {
    slide.x += way;
    if (slide.walls.count != 0 && glm::dot(way, way) > tight * tight) slide.slid = true;
}

/// Against one round body the planes before it come nearer by depth / radius a time; this is the end of that at once.
void round_off(const Scene& scene, Journey& slide, vec3 tip) {
    Wall& wall = slide.walls.items[0];
    const Surface& s = scene.surface(wall.surface);
    if (slide.walls.count != 1 || is_flat(s.kind) || slide.x == tip) return;
    const Distance from_tip = to_solid(s, scene.body_of(wall.surface).orientation, tip);
    const double gap = scene.gap[wall.surface];
    const vec3 end = tip + (gap - from_tip.value) * from_tip.normal;
    constexpr double same_side = 0.9;
    if (from_tip.value >= gap || glm::dot(from_tip.normal, wall.normal) < same_side) return;
    if (first_hit(scene, Way(slide.x, end - slide.x), wall.surface).at <= 1) return;
    slide.x = end;
    wall = wall_at(scene, tip, from_tip, wall.surface);
    wall.depth = gap - from_tip.value;
}

/// From contact to contact until nothing is nearer to the tip, or friction holds.
Journey slide_to(const Scene& scene, vec3 start, vec3 tip, bool was_sliding) {
    Journey slide{.x = start};
    vec3 cleared{};
    bool first = true;
    for (int move = 0; move < most_moves; ++move) {
        const Walls before = slide.walls;
        const Goal goal = nearest_place(slide.walls, tip);
        if (!goal.found) {  // no room: stays, held by those that were there before
            slide.walls = before;
            return slide;
        }
        vec3 way = held_back(scene, slide, goal.place, was_sliding) - slide.x;
        const double part = allowed(*scene.patch, slide.x, way);
        way *= part;
        const Hit hit = first_hit(scene, Way(slide.x, way));
        go(slide, std::min(hit.at, 1.0) * way);
        if (hit.at <= 1) {
            add_wall(slide.walls, hit.wall);
            continue;
        }
        slide.limited = part < 1;
        if (!slide.limited && glm::length(slide.x - goal.place) <= tight) round_off(scene, slide, tip);
        if (slide.walls.count == 0 || slide.limited || supported(scene, slide.walls, slide.x)) return slide;
        if (!first && glm::length(slide.x - cleared) < tight) return slide;
        first = false;
        cleared = slide.x;
        slide.walls.count = 0;
    }
    return slide;
}

// ---- the force ------------------------------------------------------------------------------------------------------

/// They are at most four.
void most_loaded_first(Walls& walls) {
    for (std::size_t i = 1; i < walls.count; ++i)
        for (std::size_t j = i; j > 0 && walls.items[j - 1].depth < walls.items[j].depth; --j)
            std::swap(walls.items[j - 1], walls.items[j]);
}

/// N, on the hand. Of it each wall's `share`: its own push, and by its depth of what all have together.
vec3 force_of(const Scene& scene, Journey& slide, const SurfaceTip& tip) {
    double depth = 0, stiffness = 0, damping = 0;
    vec3 push(0), velocity(0), spring = slide.x - tip.position;
    for (std::size_t i = 0; i < slide.walls.count; ++i) {
        const Wall& wall = slide.walls.items[i];
        const SurfaceBody& body = scene.body_of(wall.surface);
        const Felt here = felt(scene, wall, slide.x);
        depth += here.depth;
        stiffness += here.depth * body.material.stiffness;
        damping += here.depth * body.material.damping;
        push += here.depth * here.way;
        spring += here.depth * here.way - wall.depth * wall.normal;
        slide.shares[i] = {here.depth * here.way, here.depth};
        velocity += here.depth * (body.velocity + glm::cross(body.spin, slide.x - body.position));
    }
    const double length = glm::length(push);
    if (!(depth > 0) || !(length > 0)) return vec3(0);
    const vec3 normal = push / length;
    const double inward = std::max(0.0, -glm::dot(tip.velocity - velocity / depth, normal));
    const vec3 force = stiffness / depth * spring + damping / depth * inward * normal;
    for (std::size_t i = 0; i < slide.walls.count; ++i) {
        Share& share = slide.shares[i];
        share.force =
            stiffness / depth * share.force + share.depth / depth * (force - stiffness / depth * push);
    }
    return force;
}

void remember(const Scene& scene, SurfaceState& state, const Journey& slide) {
    const auto& walls = slide.walls;
    state = {.proxy = slide.x, .begun = 1};
    state.contacts = static_cast<std::uint32_t>(std::min<std::size_t>(walls.count, 3));
    for (std::uint32_t i = 0; i < state.contacts; ++i) {
        const std::uint32_t s = walls.items[i].surface;
        state.touched[i] = {scene.body_of(s).key, scene.surface(s).part, slide.shares[i].force};
    }
    state.sliding = state.contacts != 0 && slide.slid ? 1 : 0;
    state.limited = slide.limited ? 1 : 0;
}

// ---- textures -------------------------------------------------------------------------------------------------------

/// Of three nodes about a place, `off` from the middle one in cells: weights of the quadratic B-spline, and their slopes.
struct Weights {
    std::array<double, 3> value{};
    std::array<double, 3> slope{};
};

Weights weights_at(double off) {
    const double before = 0.5 - off, after = 0.5 + off;
    return {{before * before / 2, 0.75 - off * off, after * after / 2}, {-before, -2 * off, after}};
}

/// In cells, wrapped to the map.
double cells_of(double length, double wavelength) {
    const double turns = length / wavelength;
    return (turns - std::floor(turns)) * static_cast<double>(bump_cells);
}

Relief bumps_at(const Texture& t, const BumpMap& map, double u, double v) {
    const double cell_u = cells_of(u, t.wavelength), cell_v = cells_of(v, t.wavelength);
    const double node_u = std::floor(cell_u + 0.5), node_v = std::floor(cell_v + 0.5);
    const Weights wu = weights_at(cell_u - node_u), wv = weights_at(cell_v - node_v);
    double height = 0, along_u = 0, along_v = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto column = (static_cast<std::size_t>(node_u) + i + bump_cells - 1) % bump_cells;
            const auto row = (static_cast<std::size_t>(node_v) + j + bump_cells - 1) % bump_cells;
            const auto node = static_cast<double>(map[row * bump_cells + column]);
            height += node * wu.value[i] * wv.value[j];
            along_u += node * wu.slope[i] * wv.value[j];
            along_v += node * wu.value[i] * wv.slope[j];
        }
    }
    const double steep = static_cast<double>(bump_cells) / t.wavelength;
    return {2 * t.amplitude * height, 2 * t.amplitude * steep * (along_u * t.axes[0] + along_v * t.axes[1])};
}

}  // namespace

Relief relief_at(const Texture& t, const BumpMap& bumps, vec3 place) noexcept {
    if (top_of(t) == 0) return {};
    const vec3 arm = place - t.origin;
    const double u = glm::dot(arm, t.axes[0]), v = glm::dot(arm, t.axes[1]);
    constexpr double most_turns = 1e9;
    const double least = t.wavelength * most_turns;
    if (!(std::abs(u) < least && std::abs(v) < least)) return {};  // so far away that u has no phase
    if (t.kind == TextureKind::bumps) return bumps_at(t, bumps, u, v);
    const double turns = u / t.wavelength;
    const double phase = 2 * pi * (turns - std::floor(turns));
    return {t.amplitude * (1 + det::sin(phase)),
            t.amplitude * 2 * pi / t.wavelength * det::cos(phase) * t.axes[0]};
}

SurfacePatch moved_on(SurfacePatch patch, double seconds) {
    std::array<Carrier, surface_body_capacity> carriers;
    const auto bodies = std::min<std::size_t>(patch.body_count, surface_body_capacity);
    for (std::size_t i = 0; i < bodies; ++i) {
        SurfaceBody& body = patch.bodies[i];
        const vec3 before = body.position;
        body.position += seconds * body.velocity;
        carriers[i] = carrier_of(body, seconds);
        carriers[i].pivot_before = before;
        body.orientation = carriers[i].turning
                               ? glm::normalize(glm::quat_cast(carriers[i].turn) * body.orientation)
                               : body.orientation;
    }
    const auto count = std::min<std::size_t>(patch.count, surface_capacity);
    for (std::size_t i = 0; i < count; ++i) {
        Surface& surface = patch.surfaces[i];
        if (surface.body >= bodies || !carriers[surface.body].moving) continue;
        const Carrier& carrier = carriers[surface.body];
        surface.a = carrier.now(surface.a);
        if (surface.kind == SurfaceKind::plane)
            surface.b = carrier.turning ? carrier.turn * surface.b : surface.b;
        if (!is_triangle(surface.kind)) continue;
        surface.b = carrier.now(surface.b);
        surface.c = carrier.now(surface.c);
    }
    return patch;
}

Touched touch(const SurfacePatch& patch, SurfaceState& state, const SurfaceTip& tip, double dt) noexcept {
    if (!is_finite(tip.position)) {
        state = {};
        return {.proxy = tip.position};
    }
    if (patch.count == 0) {
        state = {.proxy = tip.position, .begun = 1};
        return {.proxy = tip.position};
    }
    Scene scene;
    set_scene(scene, patch, dt);
    if (state.begun == 0) state.proxy = tip.position;
    const vec3 start = pushed_out(scene, state, carried(scene, state));
    Journey slide = slide_to(scene, start, tip.position, state.sliding != 0);
    most_loaded_first(slide.walls);
    const vec3 force = force_of(scene, slide, tip);
    if (!is_finite(slide.x) || !is_finite(force)) {
        state = {};
        return {.proxy = tip.position};
    }
    vec3 push(0);
    for (std::size_t i = 0; i < slide.walls.count; ++i)
        push += slide.walls.items[i].depth * slide.walls.items[i].normal;
    remember(scene, state, slide);
    return {force, slide.walls.count == 0 ? tip.position : slide.x, push, state.contacts};
}

}  // namespace thaum::haptics
