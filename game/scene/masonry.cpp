#include "game/scene/masonry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.h"
#include "render/colour.h"

namespace thaum::game::inline scene {
namespace {

using render::colour;
using render::MeshData;

constexpr double outside = 0.02;  // distance outside the arena's bounds from which on no player can be (m)

/// A face to be covered with blocks: its corner, its two edges (u along the courses, which are rows of
/// blocks, v across them) and its normal.
struct Face {
    fvec3 corner;   // position of the corner from which both edges run (m)
    fvec3 u, v, n;  // unit vectors along the two edges, and the normal
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
/// Height from which on joints look faded at any distance, by Vertex::far_away (m).
constexpr float out_of_sight = 6;
/// Depth of the core (the surface behind the blocks), in bevel widths: just below the joints.
constexpr float core_depth = 1.25F;
/// Brightness of a joint seen from far away, as a share of the stone's.
constexpr float core_shade = 0.9F;
constexpr float core_piece = 3, core_overlap = 0.3F;  // length and overlap of the pieces of a core (m)

std::uint32_t add_vertex(MeshData& mesh, const Face& face, glm::vec3 at, fvec3 normal, fvec3 shade) {
    mesh.vertices.push_back({face.corner + at.x * face.u + at.y * face.v + at.z * face.n, normal, shade});
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// Adds a vertex of a joint. Near the viewer its brightness is `joint` times the shade. Far away it is the
/// full shade, since a joint finer than a pixel would flicker.
std::uint32_t add_joint(MeshData& mesh, const Face& face, glm::vec3 at, fvec3 normal, fvec3 shade,
                        float joint) {
    const auto index = add_vertex(mesh, face, at, normal, joint * shade);
    mesh.vertices.back().far_away = 1 / joint;
    return index;
}

void add_quad(MeshData& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
}

/// Adds a block without a joint, which differs from its neighbours only in shade.
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
    if (!is_inside(shade, at, outside)) return true;
    if (at.y > shade.wall_top || at.y < -shade.depth - outside) return true;
    return std::any_of(shade.blocks.begin(), shade.blocks.end(), [&](const render::Block& b) {
        return glm::all(glm::greaterThan(at, b.low)) && glm::all(glm::lessThan(at, b.high));
    });
}

/// A block with edges that are seen from the side. From far away only its top is drawn, and the core (the
/// surface behind the blocks), which shows between them, looks like joints.
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

/// One block of a course of stones. `height`: height of its lower edge (m, world).
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

/// Whether not even a corner of the cell can be seen.
bool hidden(const Shade& shade, vec3 position, const Face& face, const Cell& cell) {
    for (const float u : {0.02F, 0.5F, 0.98F}) {
        for (const float v : {0.02F, 0.5F, 0.98F}) {
            const fvec2 place(glm::mix(cell.u0, cell.u1, u), glm::mix(cell.v0, cell.v1, v));
            if (!hidden(shade, position + at(face, place), vec3(face.n))) return false;
        }
    }
    return true;
}

/// Gives each vertex the baked light of the nearest vertex with a similar normal, so that the shade does not
/// change when one mesh replaces the other.
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

}  // namespace

void add_lit_patch(const Shade& shade, vec3 position, render::Patch patch, render::Patchwork& out) {
    bake(shade, position, patch.full);
    take_light(patch.full, patch.plain);
    for (auto* mesh : {&patch.full, &patch.plain}) {
        for (auto& v : mesh->vertices) v.position += fvec3(position);
    }
    out.push_back(std::move(patch));
}

namespace {

/// Adds the core, the surface behind the bevelled blocks of a face. It shows as joints between blocks that
/// are drawn without bevels. The core is made in pieces, and is dark nearby and lighter far away. It also
/// extends a little behind the blocks above that have no bevel.
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
        add_lit_patch(shade, position, {.full = {}, .plain = std::move(piece), .detail = work.bevel}, out);
    }
}

Cell around(const Cell& a, const Cell& b) {
    return {std::min(a.u0, b.u0), std::max(a.u1, b.u1), std::min(a.v0, b.v0), std::max(a.v1, b.v1)};
}

/// Whether the sun reaches no vertex of the cell, no point between them, and no point slightly beyond the
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
            add_lit_patch(shade, position, block(up, face, work, cell, random), out);
            out.back().sunless = is_sunless(shade, position, face, cell, out.back());
            if (is_bevelled(up, face, work)) bevelled = around(bevelled, cell);
        }
    }
    add_core(shade, position, face, work, bevelled, out);
}

/// The face of a box perpendicular to `axis`, seen from outside. Courses of vertical faces are horizontal.
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
            const auto face = face_of(fvec3(thing.body.size), axis, side);
            auto work = work_of(thing.surface, face);
            work.seed = seed_of(thing.position, axis * 2 + (side > 0 ? 1 : 0));
            lay(out, shade, thing.position, face, work);
        }
    }
}

namespace {

/// A ramp: half the size of its box (m), the horizontal unit vector along which it rises, and the one across
/// it.
struct RampFrame {
    fvec3 half{0}, rise{0}, across{0};
    float half_length{}, half_width{};
};

RampFrame ramp_frame(const physics::TriangleMesh& solid) {
    RampFrame frame;
    for (const auto& v : solid.vertices) frame.half = glm::max(frame.half, glm::abs(fvec3(v)));
    fvec3 top(0);  // sum of the high edge's vertices
    for (const auto& v : solid.vertices) {
        if (static_cast<float>(v.y) > 0.9F * frame.half.y) top += fvec3(v);
    }
    const int axis = std::abs(top.x) > std::abs(top.z) ? 0 : 2;
    frame.rise[axis] = top[axis] > 0 ? 1.0F : -1.0F;
    frame.across = glm::cross(frame.rise, fvec3(0, 1, 0));
    frame.half_length = frame.half[axis];
    frame.half_width = frame.half[2 - axis];
    return frame;
}

Face slope_of(const RampFrame& ramp) {
    Face slope;
    slope.v = glm::normalize(2 * ramp.half_length * ramp.rise + fvec3(0, 2 * ramp.half.y, 0));
    slope.u = ramp.across;
    slope.n = glm::cross(slope.u, slope.v);
    slope.corner = -ramp.half_length * ramp.rise - fvec3(0, ramp.half.y, 0) - ramp.half_width * ramp.across;
    slope.length_u = 2 * ramp.half_width;
    slope.length_v = 2 * glm::length(fvec2(ramp.half_length, ramp.half.y));
    return slope;
}

/// The vertical face of a ramp's box with the outward normal `n`. `half_u` is half its width (m), `off` its
/// distance from the middle (m).
Face upright_face(fvec3 n, float half_u, float half_v, float off) {
    Face face;
    face.n = n;
    face.v = fvec3(0, 1, 0);
    face.u = glm::cross(face.v, n);
    face.length_u = 2 * half_u;
    face.length_v = 2 * half_v;
    face.corner = off * n - half_u * face.u - half_v * face.v;
    return face;
}

/// Line on a face from (0, `left`) to (length_u, `right`). Below it is stone.
struct EdgeLine {
    float left{}, right{}, length{};
    float height_at(float u) const { return glm::mix(left, right, u / length); }
};

/// The part of a cell below a line, as a polygon.
std::vector<fvec2> clipped(const Cell& cell, const EdgeLine& line) {
    const std::array<fvec2, 4> corners{
        fvec2(cell.u0, cell.v0), {cell.u1, cell.v0}, {cell.u1, cell.v1}, {cell.u0, cell.v1}};
    std::vector<fvec2> polygon;
    for (std::size_t i = 0; i < 4; ++i) {
        const fvec2 a = corners[i], b = corners[(i + 1) % 4];
        const float below_a = line.height_at(a.x) - a.y, below_b = line.height_at(b.x) - b.y;
        if (below_a >= 0) polygon.push_back(a);
        if ((below_a > 0 && below_b < 0) || (below_a < 0 && below_b > 0))
            polygon.push_back(glm::mix(a, b, below_a / (below_a - below_b)));
    }
    return polygon;
}

/// Adds a flat polygon, `behind` metres behind the face.
void add_polygon(const Shade& shade, vec3 position, const Face& face, const std::vector<fvec2>& polygon,
                 float behind, fvec3 tone, render::Patchwork& out) {
    if (polygon.size() < 3) return;
    MeshData mesh;
    for (const fvec2 p : polygon) add_vertex(mesh, face, {p, -behind}, face.n, tone);
    for (std::uint32_t i = 1; i + 1 < polygon.size(); ++i)
        mesh.indices.insert(mesh.indices.end(), {0, i, i + 1});
    add_lit_patch(shade, position, {.full = std::move(mesh)}, out);
}

/// Covers the part of a vertical face below the line with blocks. A darker face behind them is visible
/// through the joints.
void lay_below(render::Patchwork& out, const Shade& shade, vec3 position, const Face& face,
               const Stonework& work, const EdgeLine& line) {
    constexpr float joint_depth = 0.01F;
    Random random = random_stream(work.seed, 7);
    const Cell whole{0, face.length_u, 0, face.length_v};
    if (hidden(shade, position, face, whole)) return;
    add_polygon(shade, position, face, clipped(whole, line), joint_depth, work.joint * work.colours[0], out);
    const int courses = std::max(1, static_cast<int>(std::lround(face.length_v / work.block_v)));
    const float height = face.length_v / static_cast<float>(courses), inset = work.bevel / 4;
    for (int row = 0; row < courses; ++row) {
        const auto edges = course(face.length_u, work.block_u, row % 2 == 1, random);
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
            const Cell cell{edges[i] + inset, edges[i + 1] - inset, static_cast<float>(row) * height + inset,
                            static_cast<float>(row + 1) * height - inset};
            const fvec3 tone = any_shade(work, random);
            if (!hidden(shade, position, face, cell))
                add_polygon(shade, position, face, clipped(cell, line), 0, tone, out);
        }
    }
}

}  // namespace

void add_masonry_ramp(const Shade& shade, const Thing& thing, const physics::TriangleMesh& solid,
                      render::Patchwork& out) {
    const auto ramp = ramp_frame(solid);
    auto work = ashlar();
    work.block_u = 1.5F;
    work.block_v = 0.8F;
    work.seed = seed_of(thing.position, 6);
    lay(out, shade, thing.position, slope_of(ramp), work);
    work = ashlar();
    work.colours = slabs().colours;  // lighter than the slope, since the sides of a ramp are in dark corners
    work.seed = seed_of(thing.position, 7);
    lay(out, shade, thing.position, upright_face(ramp.rise, ramp.half_width, ramp.half.y, ramp.half_length),
        work);
    const float length = 2 * ramp.half_length, top = 2 * ramp.half.y;
    work.seed = seed_of(thing.position, 8);
    lay_below(out, shade, thing.position,
              upright_face(ramp.across, ramp.half_length, ramp.half.y, ramp.half_width), work,
              {0, top, length});
    work.seed = seed_of(thing.position, 9);
    lay_below(out, shade, thing.position,
              upright_face(-ramp.across, ramp.half_length, ramp.half.y, ramp.half_width), work,
              {top, 0, length});
}

}  // namespace thaum::game::inline scene
