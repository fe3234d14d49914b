#include "game/scene/orb_look.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "game/data/teams.h"
#include "game/scene/brew_look.h"
#include "game/scene/furniture.h"
#include "game/stations/orb/orb.h"
#include "render/colour.h"
#include "render/ribbons.h"

namespace thaum::game::inline scene {
namespace {

using render::colour;
using render::Instance;
using render::MeshData;
using render::translated;

constexpr double shown_m = 12;  ///< distance beyond which the painted ball is shown instead of the flow (m)
constexpr int lines = 16;
// The following lengths are shares of the orb's radius.
/// Radius of the ball, and of the part of it in which the flow is drawn.
constexpr double glass = 0.96, filled = 0.9;
constexpr double seeds_within = 0.72, flow_length = 2.4, flow_step = 0.06, moved = 0.004;
constexpr float flow_glow = 0.75F, glass_glow = 0.7F;
constexpr double fast = 1.1;              ///< flow speed that is drawn in the brightest colour (m/s)
constexpr double min_force_share = 0.02;  ///< share of the force limit below which no force is drawn
constexpr float line_width = 0.036F, probe_line_width = 0.05F, core_thick = 0.018F;

/// Colours by speed: deep violet, violet, light blue, white.
const render::SpeedColours& flow_colours() {
    static const auto table = [] {
        constexpr std::array stops{0x6A4AE8U, 0xB070FFU, 0x50C8FFU, 0xD8F8FFU};
        render::SpeedColours out;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const float at = 3 * static_cast<float>(i) / 255;
            const auto stop = std::min(static_cast<std::size_t>(at), std::size_t{2});
            out.at(i) =
                glm::mix(colour(stops.at(stop)), colour(stops.at(stop + 1)), at - static_cast<float>(stop));
        }
        return out;
    }();
    return table;
}

/// Points that fill a ball evenly: a spiral over spheres whose radii grow with the cube root of `i`.
vec3 seed_at(int i, double radius) {
    const double share = (i + 0.5) / lines, up = 1 - 2 * share, angle = i * pi * (3 - std::sqrt(5.0));
    const double flat = std::sqrt(1 - up * up);
    const double away = seeds_within * radius * std::cbrt((((7 * i) % lines) + 0.5) / lines);
    return away * vec3(flat * std::cos(angle), up, flat * std::sin(angle));
}

/// Traces the flow from a point as far as the glass, and adds the line to a mesh as a ribbon.
void add_line(OrbLook& look, vec3 from, double radius, const render::RibbonLook& ribbon, MeshData& out) {
    const vec3 box(filled * radius);
    const field::StreamlineSettings settings{.length = flow_length * radius,
                                             .tolerance = 1e-3 * radius,
                                             .longest_step = flow_step * radius,
                                             .max_points = 96,
                                             .low = -box,
                                             .high = box};
    field::trace(field::field_of<field::Vector>(look.vortices), from, settings, look.line);
    const auto outside = std::find_if(look.line.begin(), look.line.end(), [&](const auto& point) {
        return glm::length(point.place) > filled * radius;
    });
    look.line.erase(outside, look.line.end());
    render::append(out, render::ribbon(look.line, ribbon));
}

void trace_flow(const OrbPicture& orb, OrbLook& look) {
    look.seed = orb.seed;
    look.vortices = flow_of(Orb{.middle = orb.middle, .radius = orb.radius, .seed = orb.seed});
    look.flow.triangles = {};
    ++look.flow.version;
    for (int i = 0; i < lines; ++i)
        add_line(look, seed_at(i, orb.radius), orb.radius,
                 {.width = line_width * static_cast<float>(orb.radius),
                  .colours = &flow_colours(),
                  .slowest = 0,
                  .fastest = fast},
                 look.flow.triangles);
}

/// Traces the flow line that starts at a probe, the tip that a hand moves in the orb (position in the orb's
/// frame).
void trace_probe(std::size_t player, vec3 at, double radius, OrbLook& look) {
    auto& mesh = look.probe_flow.at(player);
    look.probe_seed.at(player) = at;
    mesh.triangles = {};
    ++mesh.version;
    add_line(look, at, radius, {.width = probe_line_width * static_cast<float>(radius)}, mesh.triangles);
}

/// Stretches a mesh that lies along -z from the origin so that it covers the vector `way`.
fmat4 stretched(vec3 from, vec3 way, double thick) {
    const auto turn = look_rotation(std::atan2(-way.x, -way.z), std::atan2(way.y, std::hypot(way.x, way.z)));
    return glm::scale(translated(fvec3(from)) * glm::mat4_cast(fquat(turn)),
                      fvec3(vec3(thick, thick, glm::length(way))));
}

/// Adds the axis of the strongest vortex inside the ball.
void add_core(const OrbLook& look, const OrbPicture& orb, std::vector<Instance>& out) {
    const auto core = core_within(look.vortices, orb.middle, filled * orb.radius);
    if (!(core.half > 0)) return;
    const vec3 half = core.half * core.axis;
    const double thick = static_cast<double>(core_thick) * orb.radius;
    for (const double side : {-1.0, 1.0})
        out.push_back({.mesh = look.arrow,
                       .model = stretched(core.middle, side * half, thick),
                       .tint = colour(0xFFE090),
                       .glow = 1});
}

/// The inside of a ball, dark in the middle. Seen from outside, the near half is culled and the far half is
/// the background of the flow.
MeshData far_half(float radius) {
    auto mesh = render::sphere(static_cast<float>(glass) * radius, 24, fvec3(1));
    for (auto& v : mesh.vertices) {
        const float up = 0.5F + 0.5F * v.position.y / radius;
        v.colour = glm::mix(colour(0x140C30), colour(0x43308C), up * up);
        v.normal = -v.normal;
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i], mesh.indices[i + 1]);
    return mesh;
}

Instance ball_at(render::MeshId mesh, vec3 place, double radius, fvec3 tint, float glow) {
    return {.mesh = mesh,
            .model = glm::scale(translated(fvec3(place)), fvec3(static_cast<float>(radius))),
            .tint = tint,
            .glow = glow};
}

}  // namespace

OrbLook make_orb_look(render::Renderer& renderer, double radius) {
    OrbLook look;
    look.flow.mesh = renderer.upload(MeshData{});
    for (auto& line : look.probe_flow) line.mesh = renderer.upload(MeshData{});
    look.ball = renderer.upload_with_copies(
        furniture({.surface = Surface::orb, .shape = physics::Shape::sphere, .size = vec3(radius)}).glowing);
    look.glass = renderer.upload_with_copies(far_half(static_cast<float>(radius)));
    look.bead = renderer.upload_with_copies(render::sphere(1, 12, fvec3(1)));
    look.arrow = renderer.upload(render::transformed(
        render::cone(1, 0, 1, 8, fvec3(1)),
        render::rotated({1, 0, 0}, static_cast<float>(-pi / 2)) * translated({0, 0.5F, 0})));
    return look;
}

bool sees_flow(const OrbPicture& orb, vec3 eye) { return glm::distance(eye, orb.middle) < shown_m; }

std::size_t show_orb(const OrbPicture& orb, std::span<const vec3> eyes, OrbLook& look) {
    look.changes.clear();
    const auto near = [&](vec3 eye) { return sees_flow(orb, eye); };
    if (!orb.there || std::none_of(eyes.begin(), eyes.end(), near)) return 0;
    std::size_t traced = 0;
    const bool anew = look.flow.version == 0 || look.seed != orb.seed;
    if (anew) {
        trace_flow(orb, look);
        traced += lines;
    }
    look.changes.push_back(look.flow.change());
    for (std::size_t player = 0; player < players; ++player) {
        if (!orb.probes.at(player)) continue;
        const vec3 at = orb.probes.at(player)->place - orb.middle;
        const auto& seed = look.probe_seed.at(player);
        if (anew || !seed || glm::distance(*seed, at) > moved * orb.radius) {
            trace_probe(player, at, orb.radius, look);
            ++traced;
        }
        look.changes.push_back(look.probe_flow.at(player).change());
    }
    return traced;
}

void add_orb(const OrbLook& look, const OrbPicture& orb, std::uint32_t viewer, vec3 eye,
             std::vector<Instance>& out) {
    if (!orb.there) return;
    const auto model = translated(fvec3(orb.middle));
    if (!sees_flow(orb, eye)) {
        out.push_back({.mesh = look.ball, .model = model, .glow = 0.85F});
        return;
    }
    out.push_back({.mesh = look.glass, .model = model, .glow = glass_glow});
    out.push_back({.mesh = look.flow.mesh, .model = model, .glow = flow_glow});
    for (std::uint32_t player = 0; player < players; ++player) {
        if (!orb.probes.at(player)) continue;
        out.push_back({.mesh = look.probe_flow.at(player).mesh,
                       .model = model,
                       .tint = team_colours(player).light,
                       .glow = 0.9F});
        add_tip(look, *orb.probes.at(player), player, out);
    }
    if (viewer < players && orb.found.at(viewer)) add_core(look, orb, out);
}

void add_tip(const OrbLook& look, const TipPicture& tip, std::uint32_t player, std::vector<Instance>& out) {
    constexpr double bead = 0.022;  // radius of the ball that shows a player's probe (m)
    out.push_back(ball_at(look.bead, tip.place, bead, team_colours(player).light, 0.95F));
    add_force(look, tip, out);
}

void add_force(const OrbLook& look, const TipPicture& tip, std::vector<Instance>& out) {
    // Length of the arrow at full force, and radius of its base (m)
    constexpr double longest = 0.3, thick = 0.02;
    const double force = glm::length(tip.force), share = std::min(tip.force_share, 1.0);
    if (!(force > 0) || share < min_force_share) return;
    const fvec3 shown = ladle_colour(share);
    out.push_back({.mesh = look.arrow,
                   .model = stretched(tip.place, longest * share / force * tip.force, thick),
                   .tint = shown * shown,  // converts screen colours to linear light
                   .glow = 0.8F});
}

}  // namespace thaum::game::inline scene
