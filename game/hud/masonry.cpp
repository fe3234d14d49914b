#include "game/hud/masonry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/random.h"
#include "render/colour.h"

namespace thaum::game {
namespace {

using render::colour;
using render::MeshData;

constexpr double corner_reach = 2;       // stone farther away takes no light from a point (m)
constexpr double corner_strength = 0.9;  // a dark corner still gets light reflected by other stone
constexpr double pit_depth = 5;          // depth of the pit (m)
constexpr float lamp_height = 3.4F;      // height of the lamps (m)
constexpr double outside = 0.02;         // margin beyond the arena, where no player can be (m)
const fvec3 lamp_glow = fvec3(5.2F, 2.5F, 0.85F);

// Baked light -----------------------------------------------------------------------------------------------

/// The part of a block within reach of a point.
render::Block near_part(const render::Block& block, vec3 point) {
    return {glm::max(block.low, point - corner_reach), glm::min(block.high, point + corner_reach)};
}

/// Share of the sky that nearby blocks leave open. The shares of two blocks are multiplied, which is exact
/// for blocks at right angles.
double open_sky(const Shade& shade, vec3 point, vec3 normal) {
    // The point is moved off the surface, so that a block that touches it counts.
    const vec3 start = point + 0.03 * normal;
    double open = 1;
    for (const auto& block : shade.blocks) {
        const auto near = near_part(block, start);
        if (glm::any(glm::greaterThanEqual(near.low, near.high))) continue;
        open *= 1 - corner_strength * render::form_factor(near, start, normal);
    }
    return open;
}

/// Light of the wall lamps. It falls with the square of the distance.
fvec3 lamp_light(const Shade& shade, vec3 point, fvec3 normal) {
    fvec3 light(0);
    for (const fvec3 lamp : shade.lamps) {
        const fvec3 to = lamp - fvec3(point);
        const float square = glm::dot(to, to);
        if (square > 80) continue;
        const float facing = std::max(0.0F, glm::dot(normal, to) / std::sqrt(square + 0.01F) + 0.15F);
        light += lamp_glow * (facing / (0.7F + square));
    }
    return light;
}

}  // namespace

Shade make_shade(const Arena& arena, fvec3 towards_sun) {
    Shade shade{.blocks = {}, .lamps = {}, .sun = towards_sun, .half = 0, .wall_top = 0};
    for (const auto& thing : arena.things) {
        if (thing.prop || thing.body.shape != physics::Shape::box) continue;
        shade.blocks.push_back({thing.position - thing.body.size, thing.position + thing.body.size});
        if (thing.surface != Surface::floor) continue;
        shade.half = std::max({shade.half, std::abs(shade.blocks.back().low.x), shade.blocks.back().high.x});
    }
    for (const auto& block : shade.blocks) shade.wall_top = std::max(shade.wall_top, block.high.y);
    const auto half = static_cast<float>(shade.half);
    for (const float share : {-0.75F, -0.25F, 0.25F, 0.75F}) {
        for (const float side : {-1.0F, 1.0F}) {
            const float in = side * (half - 0.35F);
            shade.lamps.push_back({share * half, lamp_height, in});
            shade.lamps.push_back({in, lamp_height, share * half});
        }
    }
    return shade;
}

bool sees_sun(const Shade& shade, vec3 point) {
    return std::none_of(shade.blocks.begin(), shade.blocks.end(), [&](const render::Block& block) {
        return render::meets(block, point, vec3(shade.sun));
    });
}

BakedLight baked_light(const Shade& shade, vec3 point, fvec3 normal) {
    double open = open_sky(shade, point, vec3(normal));
    if (point.y < 0) open *= 1 - 0.65 * std::min(1.0, -point.y / pit_depth);
    const bool faces_sun = glm::dot(normal, shade.sun) > 0.02F;
    return {static_cast<float>(open) * lamp_light(shade, point, normal), static_cast<float>(open),
            faces_sun && sees_sun(shade, point + 0.06 * vec3(normal))};
}

void bake(const Shade& shade, vec3 position, MeshData& mesh) {
    for (auto& v : mesh.vertices) {
        const auto light = baked_light(shade, position + vec3(v.position), v.normal);
        v.lamps = light.lamps;
        v.open = light.open;
        v.sun = light.sunny ? 1.0F : 0.0F;
    }
}

namespace {

// Blocks ----------------------------------------------------------------------------------------------------

/// A face to cover with blocks: its corner, its two edges (u along the courses) and its normal.
struct Face {
    fvec3 corner;   // position of the corner (m)
    fvec3 u, v, n;  // unit vectors
    float length_u{}, length_v{};
};

struct Stonework {
    float block_u{}, block_v{};  // approximate size of a block (m); whole blocks fill the face
    float bevel{};               // width of the bevel (m)
    std::vector<fvec3> colours;
    float joint{};  // brightness of a joint, as a share of the stone's
    std::uint64_t seed{};
};

struct Cell {
    float u0{}, u1{}, v0{}, v1{};
};

/// Height above which blocks have painted joints (m). No wizard stands higher.
constexpr float out_of_reach = 3.1F;
/// Height from which joints look faded at any distance, by Vertex::far_away (m).
constexpr float out_of_sight = 6;
/// Depth of the core in bevel widths, just below the joints.
constexpr float core_depth = 1.25F;
/// Brightness of a joint seen from far away, as a share of the stone's.
constexpr float core_shade = 0.9F;
constexpr float core_piece = 3, core_overlap = 0.3F;  // length and overlap of pieces (m)

std::uint32_t add_vertex(MeshData& mesh, const Face& face, glm::vec3 at, fvec3 normal, fvec3 shade) {
    mesh.vertices.push_back({face.corner + at.x * face.u + at.y * face.v + at.z * face.n, normal, shade});
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// Adds a vertex of a joint. Nearby it has `joint` of the shade. Far away it has the full shade, since a
/// joint finer than a pixel would flicker.
std::uint32_t add_joint(MeshData& mesh, const Face& face, glm::vec3 at, fvec3 normal, fvec3 shade,
                        float joint) {
    const auto index = add_vertex(mesh, face, at, normal, joint * shade);
    mesh.vertices.back().far_away = 1 / joint;
    return index;
}

void add_quad(MeshData& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
}

/// Adds a block without a joint. Only its shade differs from its neighbours'.
void add_bare_block(MeshData& mesh, const Face& face, const Cell& cell, fvec3 shade) {
    const auto a = add_vertex(mesh, face, {cell.u0, cell.v0, 0}, face.n, shade);
    add_vertex(mesh, face, {cell.u1, cell.v0, 0}, face.n, shade);
    add_vertex(mesh, face, {cell.u1, cell.v1, 0}, face.n, shade);
    add_vertex(mesh, face, {cell.u0, cell.v1, 0}, face.n, shade);
    add_quad(mesh, a, a + 1, a + 2, a + 3);
}

/// Adds a block with a painted joint, for edges that are not seen from the side, such as a floor slab's. Two
/// sides are painted; the neighbours paint the other two.
void add_flat_block(MeshData& mesh, const Face& face, const Stonework& work, const Cell& cell, fvec3 shade,
                    float b) {
    const auto put = [&](float u, float v, float joint) {
        return add_joint(mesh, face, {u, v, 0}, face.n, shade, joint);
    };
    const auto corner = put(cell.u0, cell.v0, work.joint), right = put(cell.u1, cell.v0, work.joint);
    const auto far_left = put(cell.u0, cell.v1, work.joint);
    const auto inner = put(cell.u0 + b, cell.v0 + b, 1), inner_right = put(cell.u1, cell.v0 + b, 1);
    const auto inner_far = put(cell.u0 + b, cell.v1, 1), opposite = put(cell.u1, cell.v1, 1);
    add_quad(mesh, inner, inner_right, opposite, inner_far);
    add_quad(mesh, corner, right, inner_right, inner);
    add_quad(mesh, corner, inner, inner_far, far_left);
}

/// Adds one block: a top, and four slanting edges down into the joint. An edge at the border of the face, or
/// below a block without a bevel, ends in the face's plane. This leaves no gap.
void add_block(MeshData& mesh, const Face& face, const Stonework& work, const Cell& cell, fvec3 shade,
               float sunk, bool topmost) {
    const float b = work.bevel;
    const std::array<fvec2, 4> corners{
        fvec2(cell.u0, cell.v0), {cell.u1, cell.v0}, {cell.u1, cell.v1}, {cell.u0, cell.v1}};
    const std::array<fvec2, 4> inwards{fvec2(1, 1), {-1, 1}, {-1, -1}, {1, -1}};
    const auto at_border = [&](fvec2 corner) {
        return corner.x <= 0 || corner.x >= face.length_u || corner.y <= 0 || corner.y >= face.length_v ||
               (topmost && corner.y >= cell.v1);
    };
    std::array<std::uint32_t, 4> top{}, foot{};
    for (std::size_t i = 0; i < 4; ++i) {
        const fvec2 in = corners[i] + b * inwards[i];
        const bool border = at_border(corners[i]);
        const fvec3 slant = glm::normalize(face.n - 0.6F * (inwards[i].x * face.u + inwards[i].y * face.v));
        top[i] = add_vertex(mesh, face, {in, -sunk}, face.n, shade);
        foot[i] = add_joint(mesh, face, {corners[i], border ? 0.0F : -1.2F * b}, slant, shade,
                            border ? 1.0F : work.joint);
    }
    add_quad(mesh, top[0], top[1], top[2], top[3]);
    for (std::size_t i = 0; i < 4; ++i) add_quad(mesh, foot[i], foot[(i + 1) % 4], top[(i + 1) % 4], top[i]);
}

fvec3 any_shade(const Stonework& work, Random& random) {
    const fvec3 base = work.colours[random.below(work.colours.size())];
    return base * static_cast<float>(random.uniform(0.82, 1.14));
}

/// Edges of the blocks in one course, from 0 to `length`. Every other course begins with half a block.
std::vector<float> course(float length, float block, bool shifted, Random& random) {
    const int whole = std::max(1, static_cast<int>(std::lround(length / block)));
    const float size = length / static_cast<float>(whole);
    std::vector<float> edges{0};
    for (int i = 0; i < whole; ++i) {
        const float at = (static_cast<float>(i) + (shifted ? 0.5F : 0.0F)) * size;
        const float moved = at + size * static_cast<float>(random.uniform(-0.12, 0.12));
        if (at > 0.1F * size && moved < length - 0.1F * size) edges.push_back(moved);
    }
    edges.push_back(length);
    return edges;
}

/// True for a point of a face inside another solid or outside the arena, where no player can see it.
bool hidden(const Shade& shade, vec3 point, vec3 normal) {
    const vec3 at = point + 0.05 * normal;
    if (std::abs(at.x) > shade.half + outside || std::abs(at.z) > shade.half + outside) return true;
    if (at.y > shade.wall_top || at.y < -pit_depth - outside) return true;
    return std::any_of(shade.blocks.begin(), shade.blocks.end(), [&](const render::Block& b) {
        return glm::all(glm::greaterThan(at, b.low)) && glm::all(glm::lessThan(at, b.high));
    });
}

/// A block with edges that are seen from the side. From far away only its top is drawn, and the core between
/// the blocks looks like a joint.
render::Patch bevelled_block(const Face& face, const Stonework& work, const Cell& cell, fvec3 tone,
                             float sunk, bool topmost) {
    render::Patch patch{.full = {}, .detail = work.bevel};
    add_block(patch.full, face, work, cell, tone, sunk, topmost);
    const float b = work.bevel / 2;
    add_bare_block(patch.plain, face, {cell.u0 + b, cell.u1 - b, cell.v0 + b, cell.v1 - b}, tone);
    return patch;
}

/// True for a face that wizards walk on.
bool is_slab(const Face& face, const Stonework& work) { return face.n.y > 0.5F && work.block_u > 1; }

bool is_bevelled(double height, const Face& face, const Stonework& work) {
    return !is_slab(face, work) && height <= out_of_reach;
}

/// One block of a course at that height.
render::Patch block(double height, const Face& face, const Stonework& work, const Cell& cell,
                    Random& random) {
    const fvec3 tone = any_shade(work, random);
    const auto sunk = static_cast<float>(random.uniform(0, 0.3)) * work.bevel;
    render::Patch patch;
    if (is_bevelled(height, face, work)) {
        const double next = height + face.v.y * (cell.v1 - cell.v0);
        return bevelled_block(face, work, cell, tone, sunk, !is_bevelled(next, face, work));
    }
    const bool slab = is_slab(face, work);
    if (!slab && height > out_of_sight) {
        add_bare_block(patch.full, face, cell, tone);
        return patch;
    }
    add_flat_block(patch.full, face, work, cell, tone, slab ? 1.7F * work.bevel : work.bevel);
    add_bare_block(patch.plain, face, cell, tone);
    return patch;
}

vec3 at(const Face& face, fvec2 place) { return vec3(face.corner + place.x * face.u + place.y * face.v); }

/// True if not even a corner of the cell can be seen.
bool hidden(const Shade& shade, vec3 position, const Face& face, const Cell& cell) {
    for (const float u : {0.02F, 0.5F, 0.98F}) {
        for (const float v : {0.02F, 0.5F, 0.98F}) {
            const fvec2 place(glm::mix(cell.u0, cell.u1, u), glm::mix(cell.v0, cell.v1, v));
            if (!hidden(shade, position + at(face, place), vec3(face.n))) return false;
        }
    }
    return true;
}

/// Gives each vertex the baked light of the nearest vertex with a similar normal. The shade then stays the
/// same when one mesh replaces the other.
void take_light(const MeshData& from, MeshData& to) {
    for (auto& v : to.vertices) {
        float least = std::numeric_limits<float>::max();
        for (const auto& f : from.vertices) {
            const float apart =
                glm::distance(f.position, v.position) + 10 * glm::distance(f.normal, v.normal);
            if (apart >= least) continue;
            least = apart;
            v.lamps = f.lamps;
            v.open = f.open;
            v.sun = f.sun;
        }
    }
}

/// Bakes the light of a patch at its place and adds the patch.
void set_up(const Shade& shade, vec3 position, render::Patch patch, render::Patchwork& out) {
    bake(shade, position, patch.full);
    take_light(patch.full, patch.plain);
    for (auto* mesh : {&patch.full, &patch.plain}) {
        for (auto& v : mesh->vertices) v.position += fvec3(position);
    }
    out.push_back(std::move(patch));
}

/// Adds the core behind the bevelled blocks of a face. It shows as joints between blocks that are drawn
/// without bevels. It is made in pieces, dark nearby and lighter far away. It also reaches a little behind
/// the blocks without a bevel above.
void add_core(const Shade& shade, vec3 position, Face face, const Stonework& work, Cell behind,
              render::Patchwork& out) {
    if (behind.u0 >= behind.u1) return;
    face.corner -= core_depth * work.bevel * face.n;
    behind.v1 = std::min(behind.v1 + core_overlap, face.length_v - work.bevel / 2);
    const float low = behind.u0 + work.bevel / 2, high = behind.u1 - work.bevel / 2;
    const int pieces = std::max(1, static_cast<int>(std::ceil((high - low) / core_piece)));
    const auto edge = [&](int i) {
        return glm::mix(low, high, static_cast<float>(i) / static_cast<float>(pieces));
    };
    for (int i = 0; i < pieces; ++i) {
        MeshData piece;
        add_bare_block(piece, face, {edge(i), edge(i + 1), behind.v0, behind.v1},
                       work.joint * core_shade * work.colours[0]);
        for (auto& v : piece.vertices) v.far_away = 1 / work.joint;
        bake(shade, position, piece);
        set_up(shade, position, {.full = {}, .plain = std::move(piece), .detail = work.bevel}, out);
    }
}

Cell around(const Cell& a, const Cell& b) {
    return {std::min(a.u0, b.u0), std::max(a.u1, b.u1), std::min(a.v0, b.v0), std::max(a.v1, b.v1)};
}

/// True if the sun reaches no vertex of the cell, no point between them, and no point slightly beyond the
/// edges.
bool is_sunless(const Shade& shade, vec3 position, const Face& face, const Cell& cell,
                const render::Patch& patch) {
    const auto sunny = [](const render::Vertex& v) { return v.sun > 0; };
    if (std::any_of(patch.full.vertices.begin(), patch.full.vertices.end(), sunny)) return false;
    if (glm::dot(face.n, shade.sun) <= 0) return true;
    for (const float u : {-0.1F, 0.1F, 0.3F, 0.5F, 0.7F, 0.9F, 1.1F}) {
        for (const float v : {-0.1F, 0.1F, 0.3F, 0.5F, 0.7F, 0.9F, 1.1F}) {
            const fvec2 place(glm::mix(cell.u0, cell.u1, u), glm::mix(cell.v0, cell.v1, v));
            if (sees_sun(shade, position + at(face, place) + 0.06 * vec3(face.n))) return false;
        }
    }
    return true;
}

void lay(render::Patchwork& out, const Shade& shade, vec3 position, const Face& face, const Stonework& work) {
    Random random = random_stream(work.seed, 7);
    const int courses = std::max(1, static_cast<int>(std::lround(face.length_v / work.block_v)));
    const float height = face.length_v / static_cast<float>(courses);
    Cell bevelled{face.length_u, 0, face.length_v, 0};
    for (int row = 0; row < courses; ++row) {
        const auto edges = course(face.length_u, work.block_u, row % 2 == 1, random);
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
            const Cell cell{edges[i], edges[i + 1], static_cast<float>(row) * height,
                            static_cast<float>(row + 1) * height};
            if (hidden(shade, position, face, cell)) continue;
            const double up = position.y + at(face, {cell.u0, cell.v0}).y;
            set_up(shade, position, block(up, face, work, cell, random), out);
            out.back().sunless = is_sunless(shade, position, face, cell, out.back());
            if (is_bevelled(up, face, work)) bevelled = around(bevelled, cell);
        }
    }
    add_core(shade, position, face, work, bevelled, out);
}

/// The face of a box across `axis`, seen from outside. Courses of upright faces are level.
Face face_of(fvec3 half, int axis, float side) {
    Face face;
    face.n = fvec3(0);
    face.n[axis] = side;
    face.v = axis == 1 ? fvec3(0, 0, -1) : fvec3(0, 1, 0);
    face.u = glm::cross(face.v, face.n);
    face.length_u = 2 * std::abs(glm::dot(face.u, half));
    face.length_v = 2 * std::abs(glm::dot(face.v, half));
    face.corner = face.n * half[axis] - face.u * face.length_u / 2.0F - face.v * face.length_v / 2.0F;
    return face;
}

std::uint64_t seed_of(vec3 position, int face) {
    const auto part = [](double v) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(v * 64) + 65536);
    };
    return part(position.x) * 7919 + part(position.y) * 104729 + part(position.z) * 1299709 +
           static_cast<std::uint64_t>(face);
}

Stonework slabs() {
    return {
        1.7F,   1.5F,
        0.035F, {colour(0x6E7086), colour(0x5F6178), colour(0x7A748A), colour(0x666A7C), colour(0x7B6C72)},
        0.38F,  0};
}

Stonework bricks() {
    return {
        2.0F,   0.8F,
        0.045F, {colour(0x8A5F5C), colour(0x7A5258), colour(0x94695E), colour(0x6E5664), colour(0x82605F)},
        0.40F,  0};
}

Stonework ashlar() {
    return {1.6F, 1.0F, 0.05F, {colour(0x5E566C), colour(0x544E62), colour(0x685E70)}, 0.4F, 0};
}

Stonework small_stones() {
    return {0.7F, 0.5F, 0.03F, {colour(0x84808F), colour(0x77738A), colour(0x8E8488)}, 0.45F, 0};
}

Stonework work_of(Surface surface, const Face& face) {
    if (surface == Surface::wall) return bricks();
    if (surface == Surface::stone || surface == Surface::kerb || surface == Surface::plinth)
        return small_stones();
    if (surface == Surface::floor && face.n.y > 0.5F) return slabs();
    return ashlar();
}

}  // namespace

void add_masonry_box(const Shade& shade, const Thing& thing, render::Patchwork& out) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0F, 1.0F}) {
            if (axis == 1 && side < 0) continue;
            const auto face = face_of(fvec3(thing.body.size), axis, side);
            auto work = work_of(thing.surface, face);
            work.seed = seed_of(thing.position, axis * 2 + (side > 0 ? 1 : 0));
            lay(out, shade, thing.position, face, work);
        }
    }
}

void add_masonry_ramp(const Shade& shade, const Thing& thing, const physics::TriangleMesh& solid,
                      render::Patchwork& out) {
    fvec3 half(0);
    for (const auto& v : solid.vertices) half = glm::max(half, glm::abs(fvec3(v)));
    // The high edge is the side with vertices at the top.
    float high = 1;
    for (const auto& v : solid.vertices) {
        if (static_cast<float>(v.y) > 0.9F * half.y) high = v.x > 0 ? 1.0F : -1.0F;
    }
    Face slope;
    slope.v = glm::normalize(fvec3(2 * half.x * high, 2 * half.y, 0));
    slope.u = fvec3(0, 0, high);
    slope.n = glm::cross(slope.u, slope.v);
    slope.corner = fvec3(-high * half.x, -half.y, -high * half.z);
    slope.length_u = 2 * half.z;
    slope.length_v = 2 * glm::length(fvec2(half.x, half.y));
    if (slope.n.y < 0) {
        slope.corner += slope.length_u * slope.u;
        slope.u = -slope.u;
        slope.n = -slope.n;
    }
    auto work = ashlar();
    work.block_u = 1.5F;
    work.block_v = 0.8F;
    work.seed = seed_of(thing.position, 6);
    lay(out, shade, thing.position, slope, work);
}

// Decoration ------------------------------------------------------------------------------------------------

namespace {

/// One of the four walls: the middle of its foot, the direction along it, and the direction into the arena.
struct Wall {
    fvec3 middle, along, inwards;
};

std::array<Wall, 4> walls(const Shade& shade) {
    const auto half = static_cast<float>(shade.half);
    return {Wall{{0, 0, half}, {1, 0, 0}, {0, 0, -1}}, Wall{{0, 0, -half}, {1, 0, 0}, {0, 0, 1}},
            Wall{{half, 0, 0}, {0, 0, 1}, {-1, 0, 0}}, Wall{{-half, 0, 0}, {0, 0, 1}, {1, 0, 0}}};
}

fvec3 half_along(const Wall& wall, float along, float up, float deep) {
    return glm::abs(wall.along) * along + fvec3(0, up, 0) + glm::abs(wall.inwards) * deep;
}

/// Turns a mesh that faces +z towards the inside of the arena.
fmat4 facing(const Wall& wall) {
    return render::rotated({0, 1, 0}, std::atan2(wall.inwards.x, wall.inwards.z));
}

/// Merlons are plain boxes, since no player comes near enough to see a bevel.
void add_merlons(const Shade& shade, const Wall& wall, float half, float top, render::Patchwork& out) {
    for (float at = -half + 1; at < half; at += 2.5F) {
        const fvec3 place = wall.middle + at * wall.along + fvec3(0, top + 0.5F, 0) - 0.5F * wall.inwards;
        set_up(shade, vec3(place),
               {.full = render::box(half_along(wall, 0.7F, 0.55F, 0.5F), colour(0x6E5662))}, out);
    }
}

/// Adds a bevelled box.
void add_ashlar(const Shade& shade, fvec3 place, fvec3 half, fvec3 paint, float bevel,
                render::Patchwork& out) {
    set_up(shade, vec3(place),
           {.full = render::box(half, paint, bevel), .plain = render::box(half, paint), .detail = bevel},
           out);
}

void add_pilasters(const Shade& shade, const Wall& wall, float half, float top, render::Patchwork& out) {
    for (const float share : {-0.75F, -0.25F, 0.25F, 0.75F}) {
        const fvec3 foot = wall.middle + share * half * wall.along + 0.06F * wall.inwards;
        add_ashlar(shade, foot + fvec3(0, top / 2, 0), half_along(wall, 0.55F, top / 2, 0.12F),
                   colour(0x5E566C), 0.05F, out);
        add_ashlar(shade, foot + fvec3(0, 0.8F * top, 0), half_along(wall, 0.75F, 0.25F, 0.22F),
                   colour(0x746A7C), 0.06F, out);
    }
}

/// Adds a team's banner with its mark, so that the two ends of the arena look different.
void add_banner(const Shade& shade, const Wall& wall, float at, std::uint32_t team, render::Patchwork& out) {
    const fvec3 cloth = team == 0 ? colour(0xB8481A) : colour(0x1E5FA8);
    const fvec3 light = team == 0 ? colour(0xFFC27A) : colour(0x9ED4FF);
    const fvec3 place = wall.middle + at * wall.along + fvec3(0, 6.2F, 0) + 0.1F * wall.inwards;
    MeshData banner = render::box({1.1F, 2.3F, 0.04F}, cloth);
    render::append(banner, render::box({1.1F, 0.12F, 0.05F}, light), render::translated({0, -2.0F, 0}));
    render::append(banner, render::box({1.25F, 0.08F, 0.08F}, colour(0x4A3A30)),
                   render::translated({0, 2.35F, 0}));
    const auto mark =
        team == 0 ? render::frame(14, 0.75F, 0.51F, 0.1F, light) : render::triangle_mark(0.85F, light);
    render::append(banner, mark, render::translated({0, 0.35F, 0.06F}));
    set_up(shade, vec3(place), {.full = render::transformed(std::move(banner), facing(wall))}, out);
}

/// Adds a tower in pieces, one above the other, because the arena's walls hide most of each tower.
void add_tower(fvec3 foot, float radius, float height, render::Patchwork& out) {
    const fvec3 stone = colour(0x4E4466), roof = colour(0x3A2C58);
    const auto add = [&](std::span<const fvec2> profile, fvec3 paint) {
        MeshData mesh;
        render::append(mesh, render::revolve(profile, 10, paint), render::translated(foot));
        out.push_back({.full = std::move(mesh)});
    };
    constexpr int pieces = 4;
    const auto shaft = [&](int i) {
        const float up = static_cast<float>(i) / pieces;
        return fvec2(glm::mix(1.0F, 0.9F, up) * radius, up * height);
    };
    for (int i = 0; i < pieces; ++i) add(std::array{shaft(i), shaft(i + 1)}, stone);
    add(std::array{fvec2(0.9F * radius, height), fvec2(1.15F * radius, height),
                   fvec2(1.15F * radius, height + 2)},
        stone);
    add(std::array{fvec2(0, height + 2), fvec2(1.35F * radius, height + 2), fvec2(0.5F * radius, height + 6),
                   fvec2(0, height + 13)},
        roof);
}

struct Tower {
    fvec3 foot;
    float radius, height;
};
constexpr std::array<Tower, 6> towers{Tower{{-34, 0, -46}, 5, 30}, {{14, 0, -58}, 6, 40},
                                      {{48, 0, -30}, 4.5F, 27},    {{52, 0, 26}, 6, 36},
                                      {{-12, 0, 52}, 5, 31},       {{-54, 0, 16}, 5.5F, 34}};

}  // namespace

void add_decoration(const Shade& shade, render::Patchwork& out) {
    const auto half = static_cast<float>(shade.half), top = static_cast<float>(shade.wall_top);
    const auto all = walls(shade);
    for (const auto& wall : all) {
        add_merlons(shade, wall, half, top, out);
        add_pilasters(shade, wall, half, top, out);
    }
    for (const float at : {-10.0F, 0.0F, 10.0F}) {
        add_banner(shade, all[0], at, 0, out);
        add_banner(shade, all[1], at, 1, out);
    }
}

render::Patchwork skyline() {
    render::Patchwork out;
    for (const auto& tower : towers) add_tower(tower.foot, tower.radius, tower.height, out);
    return out;
}

render::Patchwork lamps(const Shade& shade) {
    render::Patchwork out;
    const fvec3 flame = colour(0xFFB45A), window = colour(0xFFC878);
    for (const fvec3 place : shade.lamps) {
        MeshData lamp;
        render::append(lamp, render::cone(0.05F, 0.16F, 0.3F, 6, colour(0x803A14)),
                       render::translated(place));
        render::append(lamp, render::cone(0.13F, 0, 0.5F, 6, flame),
                       render::translated(place + fvec3(0, 0.38F, 0)));
        out.push_back({.full = std::move(lamp)});
    }
    for (const auto& tower : towers) {
        const fvec3 in = glm::normalize(fvec3(-tower.foot.x, 0, -tower.foot.z));
        const fmat4 turned = render::rotated({0, 1, 0}, std::atan2(in.x, in.z));
        for (const float up : {-2.5F, -7.0F}) {
            const fvec3 place = tower.foot + (tower.radius - 0.1F) * in + fvec3(0, tower.height + up, 0);
            out.push_back({.full = render::transformed(render::box({0.35F, 0.7F, 0.3F}, window),
                                                       render::translated(place) * turned)});
        }
    }
    return out;
}

}  // namespace thaum::game
