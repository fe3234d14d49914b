#include "game/scene/ingredient_shapes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "game/scene/arena_parts.h"

namespace thaum::game::inline scene {

using render::append;
using render::MeshData;
using render::rotated;
using render::scaled;
using render::translated;

namespace {

constexpr fvec3 pale(1), dull(0.45F), upright{0, 1, 0}, along_z{0, 0, 1};

/// Angular lumps: a ring of four and one on top.
MeshData heap() {
    const auto lump = render::flat_shaded(render::sphere(0.13F, 5, pale));
    MeshData mesh;
    for (const float turn : {0.3F, 1.9F, 3.4F, 5.0F})
        append(mesh, lump, rotated(upright, turn) * translated({0.16F, -0.16F, 0}) * rotated(along_z, turn));
    append(mesh, lump, translated({0, 0.02F, 0}) * rotated(along_z, 0.8F));
    return mesh;
}

/// A prism with a point, standing on the origin.
MeshData crystal(float radius, float height) {
    const float point = 2.2F * radius, prism = height - point;
    auto mesh = render::cone(radius, 1.15F * radius, prism, 6, pale);
    mesh = transformed(std::move(mesh), translated({0, prism / 2, 0}));
    append(mesh, render::cone(1.15F * radius, 0, point, 6, pale), translated({0, prism + point / 2, 0}));
    return render::flat_shaded(mesh);
}

/// A tall prism among short ones that lean outwards.
MeshData crystals() {
    struct Place {
        float turn, lean, radius, height;
    };
    MeshData mesh;
    for (const auto& [turn, lean, radius, height] :
         {Place{0, 0.06F, 0.085F, 0.6F}, Place{0.5F, 0.6F, 0.06F, 0.42F}, Place{2.4F, 0.75F, 0.06F, 0.42F},
          Place{4.3F, 0.6F, 0.065F, 0.44F}, Place{5.5F, 0.9F, 0.05F, 0.28F}})
        append(mesh, crystal(radius, height),
               translated({0, -0.26F, 0}) * rotated(upright, turn) * rotated(along_z, -lean));
    return mesh;
}

/// Two bars side by side, and one across them.
MeshData ingots() {
    const auto bar = render::box({0.075F, 0.06F, 0.3F}, pale, 0.02F);
    MeshData mesh;
    append(mesh, bar, translated({-0.1F, -0.19F, 0}));
    append(mesh, bar, translated({0.1F, -0.19F, 0}));
    append(mesh, bar, translated({0, -0.07F, 0}) * rotated(upright, 1.4F));
    return mesh;
}

/// A drop of this radius, with its point above.
MeshData teardrop(float radius) {
    static constexpr std::array<fvec2, 7> outline{
        {{0, -1}, {0.7F, -0.72F}, {1, 0}, {0.72F, 0.75F}, {0.35F, 1.4F}, {0.1F, 2}, {0, 2.3F}}};
    return transformed(render::revolve(outline, 10, pale), scaled(fvec3(radius)));
}

MeshData drops() {
    MeshData mesh;
    append(mesh, teardrop(0.15F), translated({0, -0.1F, 0}));
    append(mesh, teardrop(0.075F), translated({0.24F, -0.18F, 0.06F}));
    append(mesh, teardrop(0.06F), translated({-0.2F, -0.2F, 0.14F}));
    return mesh;
}

/// A feather's blade with a bare quill, from the quill's end upwards.
MeshData feather() {
    auto mesh =
        transformed(render::sphere(1, 8, pale), translated({0, 0.4F, 0}) * scaled({0.085F, 0.25F, 0.015F}));
    append(mesh, render::cone(0.016F, 0.008F, 0.62F, 5, dull), translated({0, 0.31F, 0}));
    return mesh;
}

/// Three feathers that lean crosswise.
MeshData feathers() {
    MeshData mesh;
    for (const float turn : {0.0F, 2.1F, 4.2F})
        append(mesh, feather(),
               translated({0, -0.26F, 0}) * rotated(upright, turn) * translated({0.2F, 0, 0}) *
                   rotated(along_z, 0.75F));
    return mesh;
}

/// A cloud of flat puffs that float together.
MeshData cloud() {
    struct Puff {
        fvec3 place;
        float radius;
    };
    MeshData mesh;
    for (const auto& [place, radius] :
         {Puff{{0, 0.13F, 0}, 0.17F}, Puff{{0.2F, 0.07F, 0.04F}, 0.13F}, Puff{{-0.19F, 0.08F, 0.05F}, 0.14F},
          Puff{{0.05F, 0.08F, -0.2F}, 0.13F}, Puff{{-0.04F, 0.06F, 0.2F}, 0.14F}})
        append(mesh, render::sphere(radius, 8, pale), translated(place) * scaled({1, 0.7F, 1}));
    return mesh;
}

/// A low cushion of moss with stalks that end in buds.
MeshData cushion() {
    auto mesh = render::transformed(render::sphere(0.3F, 10, dull),
                                    translated({0, -0.26F, 0}) * scaled({1, 0.28F, 1}));
    for (int i = 0; i < 9; ++i) {
        const float turn = 2.4F * static_cast<float>(i), out = 0.075F * std::sqrt(static_cast<float>(i));
        const auto foot =
            rotated(upright, turn) * translated({out, -0.22F, 0}) * rotated(along_z, -1.6F * out);
        append(mesh, render::cylinder(0.012F, 0.3F, 5, dull), foot * translated({0, 0.15F, 0}));
        append(mesh, render::sphere(0.035F, 6, pale), foot * translated({0, 0.31F, 0}));
    }
    return mesh;
}

}  // namespace

MeshData ingredient_mesh(IngredientShape shape) {
    switch (shape) {
        case IngredientShape::heap: break;
        case IngredientShape::crystals: return crystals();
        case IngredientShape::ingots: return ingots();
        case IngredientShape::drops: return drops();
        case IngredientShape::feathers: return feathers();
        case IngredientShape::cloud: return cloud();
        case IngredientShape::cushion: return cushion();
    }
    return heap();
}

float ingredient_glow(IngredientShape shape) {
    switch (shape) {
        case IngredientShape::heap: break;
        case IngredientShape::crystals:
        case IngredientShape::feathers: return 0.12F;
        case IngredientShape::ingots: return 0.08F;
        case IngredientShape::drops: return 0.25F;
        case IngredientShape::cushion: return 0.2F;
        case IngredientShape::cloud: return 0.4F;
    }
    return 0.4F;
}

void add_ingredient(const ArenaScene& arena_scene, const fmat4& place, float scale, IngredientShape shape,
                    fvec3 paint, std::vector<render::Instance>& out) {
    out.push_back({.mesh = arena_scene.ingredients[static_cast<std::size_t>(shape)],
                   .model = glm::scale(place, fvec3(scale)),
                   .tint = paint,
                   .glow = ingredient_glow(shape)});
}

}  // namespace thaum::game::inline scene
