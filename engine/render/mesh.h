// render/mesh.h: triangle meshes as plain data, and the generators of every shape in the game. They need no
// OpenGL, so a mesh can be made, joined and tested without a context.
//
//   MeshData robe = cone(0.35F, 0.12F, 1.2F, 16, violet);
//   append(robe, sphere(0.14F, 12, skin), translated({0, 0.75F, 0}));   // robe = robe + head
//
// Lengths are in m. Unless stated otherwise, a generated mesh is closed (except `grid` and `flat_frame`) and
// wound counter-clockwise seen from outside. Its bounding box is centred on the origin and +y is its axis, as
// for physics shapes.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/maths.h"

namespace thaum::render {

/// A corner of a triangle.
struct Vertex {
    fvec3 position;
    fvec3 normal;  ///< normal of the surface (unit)
    fvec3 colour;  ///< colour in linear light (render/colour.h)

    // Baked lighting, which depends on where the mesh stands (render/occlusion.h computes some of it). The
    // defaults suit an object in the open.
    fvec3 lamps{0};  ///< constant light from lamps, added to the other light
    float open = 1;  ///< share of the ambient light that reaches the vertex, 0 to 1
    float sun = 1;   ///< 1 if sunlight reaches the vertex, else 0; ignored where a shadow map decides
    /// Factor of the colour at a great distance. It gives fine lines the colour around them, because single
    /// lines would flicker there.
    float far_away = 1;
};

/// Indexed triangles, three indices each.
struct MeshData {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// A piece of a large mesh that never changes. For each view it is drawn in full detail, in a plain form with
/// fewer triangles, or not at all.
struct Patch {
    MeshData full;
    /// The piece of `full` with fewer triangles. It is drawn if the missing detail is smaller than finest_px,
    /// the least size (px) of detail that the quality shows, and has faded (Vertex::far_away). Empty if there
    /// is no plain form.
    MeshData plain{};
    float detail{};  ///< size of the detail that `plain` lacks (m)
    // `full` is empty for a patch that lies behind other patches of the mesh. It is drawn, in its plain form,
    // only if one of those in front may be drawn in its plain form, too.
    bool sunless{};  ///< true: the sun never reaches the patch, so no shadow map look-up is needed
};

/// A large fixed mesh that is drawn in one call, the nearest patches first.
using Patchwork = std::vector<Patch>;

/// A sphere that contains the mesh, for culling.
struct Bounds {
    fvec3 centre{0};
    float radius{};
};
/// Sphere that encloses a mesh, about the middle of its bounding box.
Bounds bounds(const MeshData& mesh);

// Functions that combine meshes.

/// Matrix that moves by a vector.
fmat4 translated(fvec3 by);
fmat4 rotated(fvec3 axis, float angle);  ///< Matrix of a rotation about a unit axis by an angle (rad).
/// Matrix that scales along the three axes.
fmat4 scaled(fvec3 by);
/// Applies an invertible matrix; normals use the inverse transpose. A mirroring matrix also reverses the
/// winding, so that the outside stays outside.
MeshData transformed(MeshData mesh, const fmat4& by);
/// Adds a part to a mesh, moved by a matrix.
void append(MeshData& to, const MeshData& part, const fmat4& placed = fmat4(1));
/// Gives all vertices one colour.
MeshData painted(MeshData mesh, fvec3 colour);
/// Gives each triangle its own vertices and normal.
MeshData flat_shaded(const MeshData& mesh);

// Generators. `segments` is the number of sides around the axis, >= 3.

/// A box. `bevel` (m) is from 0 (12 triangles) to the smallest half size (44 triangles, softly shaded edges).
MeshData box(fvec3 half, fvec3 colour, float bevel = 0);
/// A cylinder about the y axis, centred on the origin.
MeshData cylinder(float radius, float height, int segments, fvec3 colour);
/// A cone, or a frustum if the top radius is not 0.
MeshData cone(float bottom_radius, float top_radius, float height, int segments, fvec3 colour);
/// A sphere, centred on the origin, with `segments` sides around the y axis.
MeshData sphere(float radius, int segments, fvec3 colour);
/// A capsule. `height` is the height of the cylinder between the two half spheres, as in Bullet.
MeshData capsule(float radius, float height, int segments, fvec3 colour);

/// A surface of revolution about +y. The profile is a line of points (radius, y) with the outside on its
/// right. A solid therefore starts at its lowest point on the axis and runs outwards and up. The surface is
/// closed if the profile starts and ends on the axis, or ends where it started. Edges that turn by less than
/// `crease` (rad) are shaded round. The mesh is not centred: it keeps the y of the profile.
MeshData revolve(std::span<const fvec2> profile, int segments, fvec3 colour, float crease = 0.7F);

/// A frame of `sides` sides, one corner up, that faces +z. It makes the marks of the teams: a ring has many
/// sides, a triangle three.
MeshData frame(int sides, float outer_radius, float inner_radius, float thickness, fvec3 colour);
/// Only the side of a frame that faces +z, at z = 0, for marks flush on a surface. Not closed.
MeshData flat_frame(int sides, float outer_radius, float inner_radius, fvec3 colour);
MeshData ring_mark(float radius, fvec3 colour);      ///< a ring, the mark of one of the two teams (ember)
MeshData triangle_mark(float radius, fvec3 colour);  ///< a triangle, the mark of the other team (tide)

/// A flat sheet at y = 0 that faces +y, cut into cells so that lights per vertex show. Not closed.
MeshData grid(fvec2 half, int cells_x, int cells_z, fvec3 colour);

}  // namespace thaum::render
