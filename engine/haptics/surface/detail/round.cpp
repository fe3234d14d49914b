#include "haptics/surface/detail/round.h"

#include <algorithm>
#include <bit>

#include "haptics/surface/detail/sweep.h"
#include "haptics/surface/detail/texture.h"

namespace thaum::haptics {
namespace {

// ---- pieces of surfaces -----------------------------------------------------------------------------------

/// Smooth part of a surface: a plane, or all places at one distance from a point or a line (its core).
struct Piece {
    enum class Kind : std::uint8_t { plane, about_point, about_line } kind{};
    /// Number of the part of a solid: -1, 0 and 1 are the lower end, the side and the upper end of a capsule.
    /// A sphere and the side of a cylinder are 0, anything else not_round.
    int zone{};
    vec3 centre{};  ///< a point of the core, which is the centre or the axis of a round piece (m)
    vec3 axis{};    ///< direction of the line, or normal of the plane (unit)
    /// Distance of a proxy on the piece from the core, with the gap that it keeps; for a plane its offset
    /// (m).
    double radius{};
};

constexpr int not_round = 2;  // zone of the flat parts and edges of a solid

/// Zone (see Piece) of the part of a solid that is nearest to x, which lies outside.
int zone_of(const Surface& s, quat orientation, vec3 x) {
    if (s.kind == SurfaceKind::sphere) return 0;
    if (s.kind != SurfaceKind::capsule && s.kind != SurfaceKind::cylinder) return not_round;
    const double half = s.b.y, y = (glm::conjugate(orientation) * (x - s.a)).y;
    if (!(half >= 0)) return not_round;
    if (std::abs(y) <= half) {
        if (s.kind == SurfaceKind::capsule) return 0;
        const vec3 local = glm::conjugate(orientation) * (x - s.a);
        const double beside = std::sqrt(local.x * local.x + local.z * local.z) - s.b.x;
        return beside > 0 || beside > std::abs(y) - half ? 0 : not_round;
    }
    if (s.kind == SurfaceKind::cylinder) return not_round;
    return y > 0 ? 1 : -1;
}

int zone_of(const Scene& scene, std::uint32_t surface, vec3 x) {
    return zone_of(scene.surface(surface), scene.body_of(surface).orientation, x);
}

Piece piece_at(const Scene& scene, const Wall& wall, vec3 x) {
    const Surface& s = scene.surface(wall.surface);
    const quat orientation = scene.body_of(wall.surface).orientation;
    const int zone = is_flat(s.kind) ? not_round : zone_of(s, orientation, x);
    if (zone == not_round) return {Piece::Kind::plane, zone, {}, wall.normal, wall.offset};
    const double radius = s.b.x + scene.gap[wall.surface];
    if (s.kind == SurfaceKind::sphere) return {Piece::Kind::about_point, zone, s.a, {}, radius};
    const vec3 axis = orientation * vec3(0, 1, 0);
    if (zone == 0) return {Piece::Kind::about_line, zone, s.a, axis, radius};
    return {Piece::Kind::about_point, zone, s.a + zone * s.b.y * axis, {}, radius};
}

/// Displacement from the core (centre or axis of a round surface) to y (m).
vec3 from_core(const Piece& piece, vec3 y) {
    const vec3 arm = y - piece.centre;
    return piece.kind == Piece::Kind::about_line ? arm - glm::dot(arm, piece.axis) * piece.axis : arm;
}

Distance distance_to(const Piece& piece, vec3 y) {
    if (piece.kind == Piece::Kind::plane) return {glm::dot(piece.axis, y) - piece.radius, piece.axis};
    const vec3 out = from_core(piece, y);
    const double length = glm::length(out);
    return {length - piece.radius, length > 0 ? out / length : vec3(0, 1, 0)};
}

/// Second derivative of the distance from a piece of surface, in the direction of one of its tangents (1/m).
double bend_along(const Piece& piece, vec3 y, vec3 tangent) {
    if (piece.kind == Piece::Kind::plane) return 0;
    const double along = piece.kind == Piece::Kind::about_line ? glm::dot(piece.axis, tangent) : 0;
    return (1 - along * along) / glm::length(from_core(piece, y));
}

// ---- paths ------------------------------------------------------------------------------------------------

/// Path of the proxy along one piece of surface, or along the curve in which two meet. Its parameter goes
/// from 0 at the proxy to 1 at the goal.
struct Path {
    std::array<Piece, 2> pieces{};
    std::size_t count{};
    /// For two pieces: start and displacement of a straight line (m). A place of the path is found by moving
    /// a place of this line to the curve in which the two pieces of surface meet (onto_both).
    vec3 from{}, way{};
    bool has_end{};  ///< for two pieces: true if `end` is the place at parameter 1
    vec3 end{};      ///< for two pieces: last place of the path (m)
    /// Point of the core (centre or axis of the piece) nearest to the tip (m). This field and those below are
    /// for one piece.
    vec3 core{};
    vec3 out{};         ///< direction from `core` to the tip (unit)
    vec3 side{};        ///< direction at right angles to `out`, on the proxy's side (unit)
    double half_tan{};  ///< tangent of half the angle from `out` to the proxy
    double axial{};     ///< distance of the proxy from `core` along the axis (m)
    double ratio{};     ///< distance of the tip from the core divided by that of the proxy
};

/// Moves y to the curve in which two pieces of surface meet, by repeated shortest displacements to the
/// intersection of their tangent planes. Returns false if it finds no such place.
bool onto_both(const std::array<Piece, 2>& pieces, vec3& y) {
    constexpr int max_steps = 12;
    constexpr double parallel = 1e-12;
    // Length of the last step (m). The error after it is its square over the radius, which is below rounding.
    constexpr double last = 1e-9;
    for (int n = 0; n < max_steps; ++n) {
        const Distance a = distance_to(pieces[0], y), b = distance_to(pieces[1], y);
        const double g = glm::dot(a.normal, b.normal), sine2 = 1 - g * g;
        if (sine2 < parallel) return false;
        const Depths by = depths_of_two(-a.value, -b.value, g, sine2);
        y += by.a * a.normal + by.b * b.normal;
        if (std::abs(by.a) + std::abs(by.b) <= last) return true;
    }
    return false;
}

/// Sets y to the place of a path at the parameter s, 0 to 1. Returns false if the path lies on two pieces and
/// they do not meet there.
bool place_on(const Path& path, double s, vec3& y) {
    if (path.count == 2) {
        y = path.from + s * path.way;
        return onto_both(path.pieces, y);
    }
    constexpr double negligible = 1e-12;  // distance that counts as zero (m)
    const Piece& piece = path.pieces[0];
    const double left = 1 - s;
    const bool both = std::abs(path.axial) > negligible && path.half_tan * piece.radius > negligible;
    const double t = path.half_tan * (!both ? left : left > 0 ? det::pow(left, path.ratio) : 0.0);
    const double inverse = 1 / (1 + t * t);
    y = path.core + path.axial * left * piece.axis +
        piece.radius * inverse * ((1 - t * t) * path.out + 2 * t * path.side);
    return true;
}

/// Path on one piece of surface to its place nearest to the tip, by steepest descent of the distance to the
/// tip.
Path path_on_one(const Piece& piece, vec3 x, vec3 tip) {
    // Sine of the angle about the core between proxy and tip below which they count as in line, so that the
    // proxy is pulled neither way round the core.
    constexpr double opposite = 1e-15;
    Path path{.pieces = {piece}, .count = 1};
    const double height =
        piece.kind == Piece::Kind::about_line ? glm::dot(tip - piece.centre, piece.axis) : 0;
    const vec3 in = from_core(piece, tip), normal = distance_to(piece, x).normal;
    const double rho = glm::length(in);
    path.core = piece.centre + height * piece.axis;
    if (piece.kind == Piece::Kind::about_line) path.axial = glm::dot(x - path.core, piece.axis);
    path.ratio = rho / piece.radius;
    path.out = rho > 0 ? in / rho : normal;
    const double cosine = glm::dot(normal, path.out);
    const vec3 beside = normal - cosine * path.out;
    const double sine = glm::length(beside);
    if (sine < opposite) {
        path.out = normal;
        return path;
    }
    path.side = beside / sine;
    path.half_tan = cosine < 0 ? (1 - cosine) / sine : sine / (1 + cosine);
    return path;
}

/// Path along the curve in which two pieces of surface meet: a Newton step towards the place where the pull
/// to the tip has no component along the curve.
Path path_on_two(const Piece& a, const Piece& b, vec3 x, vec3 tip, vec3 direction) {
    // Smallest second derivative of the energy along the curve with which the step is computed, where a
    // straight curve has 1. A smaller one would make the step too long.
    constexpr double flattest = 1e-3;
    Path path{.pieces = {a, b}, .count = 2, .from = x};
    const vec3 na = distance_to(a, x).normal, nb = distance_to(b, x).normal;
    const vec3 cross = glm::cross(na, nb);
    const double sine2 = glm::dot(cross, cross), g = glm::dot(na, nb);
    if (!(sine2 > 0)) return path;
    vec3 tangent = cross / std::sqrt(sine2);
    if (glm::dot(direction, tangent) < 0) tangent = -tangent;
    const Depths bend = depths_of_two(-bend_along(a, x, tangent), -bend_along(b, x, tangent), g, sine2);
    const vec3 curvature = bend.a * na + bend.b * nb;
    const double pull = glm::dot(tip - x, tangent);
    const double step = pull / std::max(flattest, 1 - glm::dot(tip - x, curvature));
    path.way = step / std::max(1.0, step * glm::length(curvature)) * tangent;
    for (int n = 0; n < 8 && !path.has_end; ++n) {
        path.has_end = place_on(path, 1, path.end);
        if (!path.has_end) path.way *= 0.5;
    }
    return path;
}

// ---- where a path ends ------------------------------------------------------------------------------------

/// How the walls (planes at the touched surfaces) hold the proxy at a place of a path. Forces are given as
/// lengths: with one stiffness, they are in proportion.
struct Loads {
    double least{};   ///< smallest depth of the tip behind a wall; at zero the wall releases the proxy (m)
    double pull{};    ///< pull of the tip on the proxy along the walls (m)
    double excess{};  ///< part of the pull that friction does not hold (m)
};

/// A path, with the data needed to evaluate its places.
struct Track {
    const Scene* scene{};
    const Walls* walls{};
    SurfaceSet own{};  ///< surfaces on which the path lies, which it cannot meet
    Path path{};
    vec3 tip{};
    std::array<double, 2> friction{};  ///< coefficient of friction of each wall while the proxy slides
    bool textured{};                   ///< a wall has a texture, which changes the depth that is felt

    mutable double known_s{-1};  ///< path parameter of the place that was computed last; -1: none yet
    /// The place at `known_s` (m), kept because several functions ask for the same place.
    mutable vec3 known{};

    vec3 at(double s) const {
        if (s == known_s) return known;
        if (s == 1 && path.has_end) return path.end;
        vec3 y = path.from;
        place_on(path, s, y);
        known_s = s;
        known = y;
        return y;
    }
};

/// Push of a wall (plane at a touched surface) on the proxy at a place of a path.
struct WallLoad {
    vec3 normal{};
    double depth{};  ///< depth of the tip behind the wall (m)
};
using WallLoads = std::array<WallLoad, 2>;

/// Push of each wall at the place y of a path. Two walls share the displacement by which both together hold
/// the proxy away from the tip.
WallLoads wall_loads(const Path& path, vec3 y, vec3 pull) {
    WallLoads walls;
    for (std::size_t i = 0; i < path.count; ++i) {
        walls[i].normal = distance_to(path.pieces[i], y).normal;
        walls[i].depth = -glm::dot(pull, walls[i].normal);
    }
    if (path.count < 2) return walls;
    const vec3 a = walls[0].normal, b = walls[1].normal, cross = glm::cross(a, b);
    const Depths depths =
        depths_of_two(walls[0].depth, walls[1].depth, glm::dot(a, b), glm::dot(cross, cross));
    walls[0].depth = depths.a;
    walls[1].depth = depths.b;
    return walls;
}

/// Largest pull along the walls, given as a length, at which friction holds the proxy at the place y (m).
double reach_of_friction(const Track& track, const WallLoads& loads, vec3 y) {
    if (!track.textured) {
        double reach = 0;
        for (std::size_t i = 0; i < track.path.count; ++i)
            if (track.friction[i] > 0) reach += track.friction[i] * loads[i].depth;
        return reach;
    }
    Walls walls = *track.walls;
    for (std::size_t i = 0; i < walls.count; ++i) {
        walls.items[i].normal = loads[i].normal;
        walls.items[i].depth = loads[i].depth;
    }
    return friction_reach(*track.scene, walls, y, true);
}

Loads loads_at(const Track& track, double s) {
    const vec3 y = track.at(s), pull = track.tip - y;
    const WallLoads walls = wall_loads(track.path, y, pull);
    vec3 along = pull;
    double least = walls[0].depth;
    for (std::size_t i = 0; i < track.path.count; ++i) {
        along += walls[i].depth * walls[i].normal;
        least = std::min(least, walls[i].depth);
    }
    const double length = glm::length(along);
    return {least, length, length - reach_of_friction(track, walls, y)};
}

/// A place on the path, by its parameter, and the value of a function there.
struct Sample {
    double s{}, value{};
};

/// Place at which a function falls to zero between two samples, one above and one below zero. Uses the secant
/// of the last two samples, or bisection if the secant leaves the bracket. The value there is at most zero,
/// or within the tolerance.
template <class Function>
double fall_to_zero(const Function& function, Sample above, Sample below, double guess, double tolerance) {
    constexpr int max_samples = 64;
    Sample newer = above;
    double s = guess;
    for (int n = 0; n < max_samples && below.value < -tolerance; ++n) {
        if (!(s > above.s && s < below.s) || n % 8 == 7) s = 0.5 * (above.s + below.s);
        if (!(s > above.s && s < below.s)) break;
        const Sample older = newer;
        newer = {s, function(s)};
        if (std::abs(newer.value) <= tolerance) return s;
        (newer.value > 0 ? above : below) = newer;
        s = newer.s - newer.value * (newer.s - older.s) / (newer.value - older.value);
    }
    return below.s;
}

/// Place on a path, from 0 to `end`, from which on a condition no longer holds, found by bisection. The
/// caller knows that the condition does not hold at `end`.
template <class Condition>
double fails_at(const Condition& condition, double end) {
    constexpr int halvings = 60;
    double last = 0, first = end;
    for (int n = 0; n < halvings; ++n) {
        const double middle = 0.5 * (last + first);
        (condition(middle) ? last : first) = middle;
    }
    return first;
}

/// First place on the path between the parameters `from` and `to` where a wall (plane at a touched surface)
/// releases the proxy or friction holds it; `to` if there is none. At `from`, with the loads `start`, neither
/// happens.
double hold_between(const Track& track, double from, const Loads& start, double to) {
    constexpr double exact = 1e-16;
    double end = to;
    Loads loads = loads_at(track, end);
    if (loads.least <= 0) {
        const double even = from + (end - from) * (start.least / (start.least - loads.least));
        end = fall_to_zero([&](double s) { return loads_at(track, s).least; }, {from, start.least},
                           {end, loads.least}, even, exact);
        loads = loads_at(track, end);
    }
    if (loads.excess >= -0.5 * place_tolerance) return end;
    const double if_straight = from + (to - from) * (start.excess / start.pull);
    return fall_to_zero([&](double s) { return loads_at(track, s).excess; }, {from, start.excess},
                        {end, loads.excess}, if_straight, 0.5 * place_tolerance);
}

/// Whether a path turns by a large angle up to the parameter `end`. On the way, walls or friction may then
/// release the proxy and hold it again, which a look at both ends alone would miss.
bool is_long(const Path& path, double end) {
    constexpr double far = 0.1;  // angle that counts as large (rad)
    if (path.count == 1) return path.half_tan > 1 && path.axial != 0;
    const double length2 = end * end * glm::dot(path.way, path.way);
    return std::any_of(path.pieces.begin(), path.pieces.end(), [&](const Piece& piece) {
        return piece.kind != Piece::Kind::plane && length2 > far * far * piece.radius * piece.radius;
    });
}

/// First place of the path, by its parameter, where a wall releases the proxy or friction holds it; 1, its
/// end, if there is none. A path that turns far is examined again, in parts.
double hold_at(const Track& track, const Loads& start) {
    constexpr int parts = 8;
    const double last = hold_between(track, 0, start, 1);
    if (!is_long(track.path, last)) return last;
    Loads loads = start;
    double from = 0;
    for (int part = 1; part < parts; ++part) {
        const double to = last * part / parts, end = hold_between(track, from, loads, to);
        if (end < to) return end;
        from = to;
        loads = loads_at(track, to);
        if (loads.least <= 0 || loads.excess <= 0) return to;
    }
    return last;
}

/// Whether each wall, at a place of the path, is on the same smooth piece of its surface as at the start.
bool on_its_pieces(const Track& track, double s) {
    const vec3 y = track.at(s);
    for (std::size_t i = 0; i < track.walls->count; ++i) {
        const Wall& wall = track.walls->items[i];
        const int zone = track.path.pieces[i].zone;
        if (zone == not_round ? !stands(*track.scene, wall, y)
                              : zone_of(*track.scene, wall.surface, y) != zone)
            return false;
    }
    return true;
}

/// Place where a path leaves the smooth pieces of surface on which it began. The proxy keeps a tiny gap from
/// a body, so round an edge it moves on an arc whose radius is that gap. A path that starts on this arc
/// continues beyond it, along tangent planes that have the whole of each body behind them. Otherwise the
/// proxy would hang on the edge.
double end_of_pieces(const Track& track, double end) {
    constexpr double over_an_edge = 5 * surface_gap;  // length by which a path continues over an edge (m)
    const double last = fails_at([&](double s) { return on_its_pieces(track, s); }, end);
    const vec3 start = track.at(0);
    if (glm::length(track.at(last) - start) > place_tolerance) return last;
    const double length = glm::length(track.at(end) - start);
    return length > over_an_edge ? end * (over_an_edge / length) : end;
}

bool within_reach(const Track& track, double s) {
    const SurfacePatch& patch = *track.scene->patch;
    const vec3 arm = track.at(s) - patch.centre;
    return glm::dot(arm, arm) <= patch.reach * patch.reach;
}

// ---- the sweep --------------------------------------------------------------------------------------------

/// Vector out of the surfaces at y, whose component along the normal of each surface is 1, or less in a very
/// sharp crease.
vec3 outward(const Path& path, vec3 y) {
    constexpr double steepest = 0.1;
    const vec3 a = distance_to(path.pieces[0], y).normal;
    if (path.count == 1) return a;
    const vec3 b = distance_to(path.pieces[1], y).normal;
    return (a + b) / std::max(steepest, 1 + glm::dot(a, b));
}

/// A surface that a path meets besides those on which it lies, or none.
struct Obstacle {
    bool met{};
    vec3 place{};  ///< place on the path's tangents where it is met (m)
    Wall wall{};
};

Obstacle obstacle_on(const Scene& scene, const Sweep& way, SurfaceSet passed_over) {
    const Hit hit = first_hit(scene, way, passed_over);
    return {hit.at <= 1, way.from + std::min(hit.at, 1.0) * way.step, hit.wall};
}

/// Two straight lines that stand for a curved part of a path in the search for obstacles. They lead from its
/// first place over an apex to its last, and stay outside the surfaces on which the path lies.
struct Tangents {
    vec3 from{}, apex{}, to{};
    double reach{};  ///< largest distance of the two lines from their start (m)
};

/// The two tangents that stand for a path between the parameters `from` and `to`. `a` is the place at `from`.
Tangents tangents_between(const Track& track, double from, vec3 a, double to) {
    constexpr double above_tangents = 1.2;
    const vec3 b = track.at(to), middle = track.at(0.5 * (from + to));
    const double sagitta = glm::length(middle - 0.5 * (a + b));
    const vec3 apex = middle + above_tangents * sagitta * outward(track.path, middle);
    return {a, apex, b, std::max(glm::length(apex - a), glm::length(b - a))};
}

/// First other surface on the two tangents that stand for a curved part of a path.
Obstacle obstacle_on(const Scene& scene, const Tangents& tangents, SurfaceSet passed_over) {
    const vec3 apex = tangents.apex;
    const Obstacle first = obstacle_on(scene, Sweep(tangents.from, apex - tangents.from), passed_over);
    return first.met ? first : obstacle_on(scene, Sweep(apex, tangents.to - apex), passed_over);
}

/// Whether the patch (all surfaces near the tip) has no surfaces except those that the walls belong to.
bool alone(const Scene& scene, const Walls& walls) {
    return scene.flat_count + scene.solid_count == walls.count;
}

/// Moves along a path up to the parameter `end` or to the first other surface. Parts of the curved path are
/// tested by two tangents each. If these meet a surface, the path itself may still pass beneath it. So the
/// part is halved until its tangents are free, or until it is so short that the surface counts as met. After
/// each free part, the next one is twice as long. From the second part on, only surfaces that are near enough
/// are tested. The move also ends when the tick has no sweeps (tests of single surfaces) left.
Obstacle travel(const Track& track, double end, int& sweeps_left) {
    // Shortest part of the path that is halved further (m). On a radius of 1 mm, such tangents are within
    // 1e-15 m of the path.
    constexpr double shortest = 1e-9;
    constexpr int max_parts = 200;
    // Cost of computing the places of a part, in tests of a path against one surface.
    constexpr int per_part = 2;
    const Scene& scene = *track.scene;
    const int surfaces = static_cast<int>(scene.flat_count + scene.solid_count);
    if (alone(scene, *track.walls)) return {.place = track.at(end)};
    Clearances near;
    vec3 here = track.at(0);
    double done = 0, part = end;
    for (int n = 0; n < max_parts && sweeps_left > 0 && done < end; ++n) {
        const double to = std::min(done + part, end);
        const Tangents tangents = tangents_between(track, done, here, to);
        const SurfaceSet far = part < end ? near.beyond(scene, here, tangents.reach) : 0;
        const SurfaceSet passed_over = track.own | far;
        const Obstacle obstacle = obstacle_on(scene, tangents, passed_over);
        sweeps_left -= per_part + surfaces - std::popcount(passed_over);
        if (!obstacle.met) {
            done = to;
            here = tangents.to;
            part *= 2;
            continue;
        }
        if (glm::length(tangents.to - here) < shortest) return obstacle;
        part *= 0.5;
    }
    return {.place = here};
}

SurfaceSet surfaces_of(const Walls& walls) {
    SurfaceSet own = 0;
    for (std::size_t i = 0; i < walls.count; ++i) own |= only(walls.items[i].surface);
    return own;
}

Track track_of(const Scene& scene, const Walls& walls, vec3 x, const RoundGoal& goal) {
    Track track{.scene = &scene, .walls = &walls, .own = surfaces_of(walls), .tip = goal.tip};
    for (std::size_t i = 0; i < walls.count; ++i) {
        const SurfaceMaterial& material = scene.body_of(walls.items[i].surface).material;
        track.friction[i] = material.dynamic_friction;
        track.textured |= top_of(material.texture) != 0;
    }
    const Piece a = piece_at(scene, walls.items[0], x);
    track.path = walls.count == 1
                     ? path_on_one(a, x, goal.tip)
                     : path_on_two(a, piece_at(scene, walls.items[1], x), x, goal.tip, goal.tangent - x);
    return track;
}

/// Removes the wall (plane at a touched surface) with the smallest depth, which holds the proxy least.
void min_drop(Walls& walls) {
    if (walls.count == 2 && walls.items[0].depth < walls.items[1].depth) walls.items[0] = walls.items[1];
    --walls.count;
}

/// Moves the proxy to the corner of three walls, where it cannot move otherwise. The displacement is only
/// rounding, or a Newton step towards the corner if a surface is round.
RoundEnd step_to_corner(const Scene& scene, SlideState& slide, vec3 corner) {
    const Sweep way(slide.x, corner - slide.x);
    const Hit hit = first_hit(scene, way);
    slide.x += std::min(hit.at, 1.0) * way.step;
    if (hit.at <= 1) add_wall(slide.walls, hit.wall);
    return way.length * std::min(hit.at, 1.0) > place_tolerance ? RoundEnd::moved : RoundEnd::rests;
}

/// Adds a wall if the proxy stands at one more surface that blocks its way to `tangent`, the place that it
/// heads for. The path has to follow this surface too, so the wall must be known before the path is computed.
/// Returns false if there is no such surface.
bool add_blocking(const Scene& scene, SlideState& slide, vec3 tangent) {
    if (alone(scene, slide.walls)) return false;
    const Sweep ahead(slide.x, tangent - slide.x);
    const Hit hit = first_hit(scene, ahead, surfaces_of(slide.walls));
    if (hit.at * ahead.length > place_tolerance) return false;
    add_wall(slide.walls, hit.wall);
    return true;
}

}  // namespace

bool is_round(const Scene& scene, const Walls& walls, vec3 x) {
    for (std::size_t i = 0; i < walls.count; ++i) {
        const std::uint32_t surface = walls.items[i].surface;
        if (!is_flat(scene.surface(surface).kind) && zone_of(scene, surface, x) != not_round) return true;
    }
    return false;
}

void refresh_round(const Scene& scene, Walls& walls, vec3 x, bool moved) {
    constexpr double slack = 10 * place_tolerance;
    for (std::size_t i = 0; i < walls.count; ++i) {
        Wall& wall = walls.items[i];
        wall.met_here = wall.depth == 0 || (wall.met_here && !moved);
    }
    if (!is_round(scene, walls, x)) return;
    std::size_t kept = 0;
    const auto keep = [&](const Wall& wall) {
        if (&walls.items[kept] != &wall) walls.items[kept] = wall;
        ++kept;
    };
    for (std::size_t i = 0; i < walls.count; ++i) {
        const Wall& wall = walls.items[i];
        const Surface& s = scene.surface(wall.surface);
        if (is_flat(s.kind) || zone_of(scene, wall.surface, x) == not_round) {
            if (wall.met_here || stands(scene, wall, x)) keep(wall);
            continue;
        }
        const Distance here = to_solid(s, scene.body_of(wall.surface).orientation, x);
        if (here.value <= scene.gap[wall.surface] + slack) keep(wall_at(scene, x, here, wall.surface));
    }
    walls.count = kept;
}

RoundEnd slide_round(const Scene& scene, SlideState& slide, const RoundGoal& goal) {
    const double pull = glm::length(slide.x - goal.tangent);
    if (pull <= friction_reach(scene, slide.walls, slide.x, goal.was_sliding || slide.slid) + place_tolerance)
        return RoundEnd::rests;
    if (slide.walls.count > 2) return step_to_corner(scene, slide, goal.tangent);
    if (add_blocking(scene, slide, goal.tangent)) return RoundEnd::moved;
    const Track track = track_of(scene, slide.walls, slide.x, goal);
    const Loads start = loads_at(track, 0);
    if (start.least <= 0) {
        min_drop(slide.walls);
        return RoundEnd::moved;
    }
    if (start.excess <= 0) return RoundEnd::rests;
    double end = hold_at(track, start);
    if (!on_its_pieces(track, end)) end = end_of_pieces(track, end);
    const bool limited = scene.patch->reach < HUGE_VAL && !within_reach(track, end);
    if (limited) end = fails_at([&](double s) { return within_reach(track, s); }, end);
    const Obstacle obstacle = travel(track, end, slide.sweeps_left);
    const bool moved = glm::length(obstacle.place - slide.x) > place_tolerance;
    slide.slid = slide.slid || moved;
    slide.x = obstacle.place;
    if (obstacle.met) {
        add_wall(slide.walls, obstacle.wall);
        return RoundEnd::moved;
    }
    slide.limited = limited;
    if (limited) return RoundEnd::limited;
    return moved ? RoundEnd::moved : RoundEnd::rests;
}

}  // namespace thaum::haptics
