#include "game/scene/brew_look.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "game/picture/force_colour.h"
#include "game/scene/brew_flow.h"
#include "game/scene/brew_texels.h"

namespace thaum::game::inline scene {
namespace {

using render::MeshData;
using render::translated;

constexpr float right_angle = 1.5707963F;
constexpr float thickness = 9;  // opacity of the volume: optical thickness per length (1/m)
// Optical thickness per length while arrows or streamlines are shown, which must stay visible (1/m).
constexpr float thickness_with_flow = 3.5F;
constexpr double rod_radius = 0.022, cup_radius = 0.085;  // radii of the ladle's rod and cup (m)
/// Factor by which the volume is wider than the brew. Rays end at the opaque bowl, so the volume must cover
/// the bowl's whole inside.
constexpr float beyond_wall = 1.4F;

/// Rotates a mesh that stands along +y so that it lies along -z, starting at the origin.
MeshData laid(const MeshData& mesh) {
    return render::transformed(mesh, render::rotated({1, 0, 0}, -right_angle) * translated({0, 0.5F, 0}));
}

MeshData arrow() {
    MeshData mesh = render::cylinder(0.035F, 0.6F, 5, fvec3(1));
    mesh = render::transformed(mesh, translated({0, -0.2F, 0}));
    render::append(mesh, render::cone(0.13F, 0, 0.42F, 6, fvec3(1)), translated({0, 0.29F, 0}));
    return laid(mesh);
}

/// A hollow half sphere of radius 1 m, open at the top.
MeshData cup() {
    std::vector<fvec2> profile;
    constexpr int parts = 6;
    for (int i = 0; i <= parts; ++i) {
        const float angle = -right_angle * (1 - static_cast<float>(i) / parts);
        profile.emplace_back(i == 0 ? 0.0F : std::cos(angle), std::sin(angle));
    }
    for (int i = parts; i >= 0; --i) {
        const float angle = -right_angle * (1 - static_cast<float>(i) / parts);
        profile.emplace_back(i == 0 ? 0.0F : 0.86F * std::cos(angle), 0.86F * std::sin(angle));
    }
    return render::revolve(profile, 14, fvec3(1));
}

/// Stretches a mesh along -z so that it reaches from one position to another.
fmat4 between(vec3 from, vec3 to, double width) {
    const vec3 way = to - from;
    const auto turn = look_rotation(std::atan2(-way.x, -way.z), std::atan2(way.y, std::hypot(way.x, way.z)));
    return glm::scale(translated(fvec3(from)) * glm::mat4_cast(fquat(turn)),
                      fvec3(vec3(width, width, glm::length(way))));
}

float smooth_step(double from, double to, double x) {
    const auto t = static_cast<float>(std::clamp((x - from) / (to - from), 0.0, 1.0));
    return t * t * (3 - 2 * t);
}

}  // namespace

BrewPlace brew_place(const BowlPlace& bowl, const CauldronRules& rules) {
    return {.middle = bowl.centre + vec3(0, level_of(bowl.size, rules.filled), 0),
            .basin = basin_of(bowl.size, rules.filled)};
}

BrewLook make_brew_look(render::Renderer& renderer, const BrewPlace& place) {
    BrewLook look;
    look.meshes = {.arrow = renderer.upload(arrow()),
                   .thread = renderer.upload(laid(render::cylinder(1, 1, 4, fvec3(1)))),
                   .rod = renderer.upload(laid(render::cylinder(1, 1, 8, fvec3(1)))),
                   .cup = renderer.upload_with_copies(cup())};
    look.place = place;
    auto& volume = look.volume;
    volume.id = renderer.make_volume();
    volume.centre = fvec3(place.middle);
    volume.radii = beyond_wall * fvec3(vec3(place.basin.radius, place.basin.depth, place.basin.radius));
    volume.brightness = brew_brightest;
    volume.foam = render::colour(0xF4E8D8);
    make_skin_indices(look.skin_indices);
    return look;
}

bool show_brew(const BrewPicture& picture, const BrewOverlay& overlay, BrewLook& look) {
    if (picture.state == look.shown && overlay == look.overlay) return false;
    look.shown = picture.state;
    look.overlay = overlay;
    look.flow.clear();
    if (picture.state == 0) return false;
    make_texels(picture, look.place, look.scratch, look.texels);
    make_skin(picture.surface, look.place, look.skin);
    if (overlay.arrows) add_arrows(picture, look.place, look.meshes, look.flow);
    if (overlay.streamlines) add_streamlines(picture, look.place, look.meshes, look.flow);
    auto& volume = look.volume;
    ++volume.version;
    volume.cells = picture.lattice.cells;
    volume.texels = look.texels;
    volume.origin = fvec3(look.place.middle + corner_of(picture, look.place));
    volume.size = fvec3(picture.lattice.h *
                        vec3(picture.lattice.cells[0], picture.lattice.cells[1], picture.lattice.cells[2]));
    volume.thickness = overlay == BrewOverlay{} ? thickness : thickness_with_flow;
    volume.skin = look.skin;
    volume.skin_indices = look.skin_indices;
    return true;
}

void add_brew(const BrewLook& look, std::vector<render::Instance>& out) {
    out.insert(out.end(), look.flow.begin(), look.flow.end());
}

fvec3 ladle_colour(double force_share) {
    constexpr double edge = 0.03;  // half width of a soft border between colours, against flicker
    const float yellow = smooth_step(1.0 / 3 - edge, 1.0 / 3 + edge, force_share),
                red = smooth_step(2.0 / 3 - edge, 2.0 / 3 + edge, force_share);
    return force_colour(0.5 * static_cast<double>(yellow + red));
}

void add_ladle(const BrewMeshes& meshes, const LadlePicture& ladle, std::vector<render::Instance>& out) {
    const fvec3 shown = ladle_colour(ladle.force_share);
    const fvec3 tint = shown * shown;  // converts screen colours to linear light
    const vec3 way = ladle.top - ladle.bowl;
    if (!(glm::length(way) > 1e-6)) return;
    out.push_back({.mesh = meshes.rod,
                   .model = between(ladle.bowl, ladle.top, rod_radius),
                   .tint = tint,
                   .glow = 0.3F});
    // The rod is fixed to the cup's rim.
    const vec3 middle = ladle.bowl - cup_radius * glm::normalize(vec3(way.x, 0, way.z) + vec3(1e-9, 0, 0));
    out.push_back({.mesh = meshes.cup,
                   .model = glm::scale(translated(fvec3(middle)), fvec3(static_cast<float>(cup_radius))),
                   .tint = tint,
                   .glow = 0.3F});
}

}  // namespace thaum::game::inline scene
