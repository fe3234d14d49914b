// render/mesh.h: triangle meshes as plain data, and the documented generators that every shape in the game is made
// of. No OpenGL here: a mesh can be made, joined and tested without a context.
//
//   MeshData robe = cone(0.35F, 0.12F, 1.2F, 16, violet);
//   append(robe, sphere(0.14F, 12, skin), translated({0, 0.75F, 0}));   // robe = robe + head
//
// Lengths in m. Every generator's mesh is closed (but for `grid` and `flat_frame`), wound counter-clockwise seen from outside, and
// centred on the origin of its bounding box with +y as its axis, as physics shapes are, unless it says otherwise.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/maths.h"

namespace thaum::render {

struct Vertex {
    fvec3 position;
    fvec3 normal;  ///< unit
    fvec3 colour;  ///< linear (render/colour.h)

    // What is baked where the mesh stands (render/occlusion.h helps); the rest keeps what a thing in the open has.
    fvec3 lamps{0};  ///< light that never changes, added
    float open = 1;  ///< 0 to 1: how much of the ambient light arrives
    float sun = 1;   ///< 0 or 1: whether the sun arrives, where no shadow map tells
    float far_away =
        1;  ///< the colour is multiplied by this far off, so that fine lines do not flicker there
};

/// Three indices a triangle.
struct MeshData {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// A piece of something big that never changes: left out of the picture or drawn plainly by itself.
struct Patch {
    MeshData full;
    /// The same with fewer triangles, for where what it lacks is less than a pixel and has faded (Vertex::far_away); empty:
    /// there is none.
    MeshData plain{};
    float detail{};  ///< m: the size of what `plain` lacks
    // Without `full`: `plain` stands behind others of that detail and shows only where one of them may be plain.
    bool sunless{};  ///< no sun ever gets there: nobody need look into the shadow map
};

/// Drawn in one call, what is near first.
using Patchwork = std::vector<Patch>;

/// A sphere that holds the mesh, for culling.
struct Bounds {
    fvec3 centre{0};
    float radius{};
};
Bounds bounds(const MeshData& mesh);

// Putting meshes together.

fmat4 translated(fvec3 by);
fmat4 rotated(fvec3 axis, float angle);  ///< unit axis, rad
fmat4 scaled(fvec3 by);
/// Normals by the inverse transpose; a mirroring matrix keeps the outside outside. The matrix must be invertible.
MeshData transformed(MeshData mesh, const fmat4& by);
void append(MeshData& to, const MeshData& part, const fmat4& placed = fmat4(1));
MeshData painted(MeshData mesh, fvec3 colour);
/// Each triangle gets vertices and a normal of its own.
MeshData flat_shaded(const MeshData& mesh);

// Generators. `segments` is the number of sides around the axis, >= 3.

/// bevel in m, from 0 (12 triangles) to the least half size (44 triangles, softly shaded edges).
MeshData box(fvec3 half, fvec3 colour, float bevel = 0);
MeshData cylinder(float radius, float height, int segments, fvec3 colour);
/// A frustum when the top radius is not 0.
MeshData cone(float bottom_radius, float top_radius, float height, int segments, fvec3 colour);
MeshData sphere(float radius, int segments, fvec3 colour);
/// `height` is that of the cylinder between the two half spheres, as Bullet counts it.
MeshData capsule(float radius, float height, int segments, fvec3 colour);
/// A ramp that fills the lower half of its box and rises towards -z.
MeshData wedge(fvec3 half, fvec3 colour);

/// Surface of revolution about +y: points (radius, y), the outside on the right of the way along them, so a solid
/// runs from its lowest point on the axis outwards and up. Closed when it starts and ends on the axis, or where it
/// started. Edges that turn by less than `crease` rad are shaded round. Keeps the profile's y.
MeshData revolve(std::span<const fvec2> profile, int segments, fvec3 colour, float crease = 0.7F);

/// A frame of `sides` sides, one corner up, that faces +z: the ring mark has many sides, the triangle mark three.
MeshData frame(int sides, float outer_radius, float inner_radius, float thickness, fvec3 colour);
/// Only the side that faces +z, at z = 0, for what lies flush on something; not closed.
MeshData flat_frame(int sides, float outer_radius, float inner_radius, fvec3 colour);
MeshData ring_mark(float radius, fvec3 colour);      ///< team ember
MeshData triangle_mark(float radius, fvec3 colour);  ///< team tide

/// A flat sheet at y = 0 facing +y, cut into cells so that lights per vertex show; not closed.
MeshData grid(fvec2 half, int cells_x, int cells_z, fvec3 colour);

}  // namespace thaum::render
