#include "game/scene/brew_flow.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "fluid/fields.h"
#include "game/scene/brew_texels.h"
#include "render/colour.h"

namespace thaum::game::inline scene {
namespace {

constexpr double still = 1e-3;                         // speed below which flow is not drawn (m/s)
constexpr double full_speed = 1.5;                     // speed of the longest and brightest arrow (m/s)
constexpr double arrow_spacing = 0.26;                 // distance between arrows (m)
constexpr double line_length = 1.6, line_step = 0.08;  // length of a streamline, and of one step along it (m)
constexpr float thread_width = 0.011F;                 // width at the head of a streamline (m)
constexpr float tail = 0.4F;                           // width at the tail, as a share of the head's

field::StaggeredGrid flow_of(const BrewPicture& picture) {
    field::StaggeredGrid grid;
    for (std::size_t axis = 0; axis < 3; ++axis)
        grid.component[axis] = fluid::grid_of(picture.lattice, picture.velocity[axis],
                                              picture.velocity_places[axis], field::Kernel::linear);
    return grid;
}

/// Whether a position lies in the brew and away from the wall (m, brew frame).
bool in_brew(const BrewPlace& place, vec3 at) {
    return at.y < 0 && off_axis(at) < 0.95 * width_at(place.basin, at.y);
}

/// Moves a mesh to `at`, turns its -z axis to `way` and stretches it to `length`.
fmat4 along(vec3 at, vec3 way, double length, double width) {
    const double flat = std::hypot(way.x, way.z);
    const auto turn = look_rotation(std::atan2(-way.x, -way.z), std::atan2(way.y, flat));
    return glm::scale(glm::translate(fmat4(1), fvec3(at)) * glm::mat4_cast(fquat(turn)),
                      fvec3(vec3(width, width, length)));
}

fvec3 speed_colour(double speed) {
    const auto s = static_cast<float>(std::clamp(speed / full_speed, 0.0, 1.0));
    return glm::mix(render::colour(0x7FB8FF), render::colour(0xFFFFFF), s);
}

}  // namespace

void follow(const BrewPicture& picture, vec3 from, double length, double step, std::vector<vec3>& out) {
    const auto flow = flow_of(picture);
    // The integration uses equal steps of arc length, not of time, so that slow and fast flow are drawn with
    // equal detail.
    bool moves = true;
    const auto towards = [&](vec3 at) {
        const vec3 v = flow(at).value;
        const double speed = glm::length(v);
        if (!(speed > still)) moves = false;
        return speed > still ? v / speed : vec3(0);
    };
    out.assign(1, from);
    const int steps = std::max(1, static_cast<int>(std::lround(length / step)));
    const double ds = length / steps;
    for (int i = 0; i < steps && moves; ++i) {
        const vec3 at = out.back();
        const vec3 k1 = towards(at), k2 = towards(at + ds / 2 * k1), k3 = towards(at + ds / 2 * k2),
                   k4 = towards(at + ds * k3);
        if (moves) out.push_back(at + ds / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + k4));
    }
}

void add_arrows(const BrewPicture& picture, const BrewPlace& place, const BrewMeshes& meshes,
                std::vector<render::Instance>& out) {
    const auto flow = flow_of(picture);
    const vec3 corner = corner_of(picture, place);
    const int across = static_cast<int>(place.basin.radius / arrow_spacing),
              down = static_cast<int>(place.basin.depth / arrow_spacing);
    for (int j = 0; j <= down; ++j) {
        for (int k = -across; k <= across; ++k) {
            for (int i = -across; i <= across; ++i) {
                const vec3 at = arrow_spacing * vec3(i, -(j + 0.4), k);
                if (!in_brew(place, at)) continue;
                const vec3 v = flow(at - corner).value;
                const double speed = glm::length(v);
                if (!(speed > still)) continue;
                const double length = arrow_spacing * (0.15 + 0.8 * std::min(speed / full_speed, 1.0));
                out.push_back(
                    {.mesh = meshes.arrow,
                     .model = along(place.middle + at - 0.5 * length * v / speed, v, length, length),
                     .tint = speed_colour(speed),
                     .glow = 0.45F});
            }
        }
    }
}

void add_streamlines(const BrewPicture& picture, const BrewPlace& place, const BrewMeshes& meshes,
                     std::vector<render::Instance>& out) {
    const auto flow = flow_of(picture);
    const vec3 corner = corner_of(picture, place);
    std::vector<vec3> line;
    // The seeds of streamlines are arranged like sunflower seeds, in three layers: they cover the disc
    // evenly, and none lies above another.
    constexpr int seeds = 30;
    for (int s = 0; s < seeds; ++s) {
        const double out_by = 0.9 * std::sqrt((s + 0.5) / seeds), angle = s * pi * (3 - std::sqrt(5.0));
        const double layer = 0.08 + 0.28 * (s % 3);
        const vec3 from(place.basin.radius * out_by * std::cos(angle), -place.basin.depth * layer,
                        place.basin.radius * out_by * std::sin(angle));
        if (!in_brew(place, from)) continue;
        follow(picture, from - corner, line_length, line_step, line);
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const vec3 way = line[i + 1] - line[i];
            const auto share = static_cast<float>(i + 1) / static_cast<float>(line.size() - 1);
            const double width = static_cast<double>(glm::mix(tail, 1.0F, share) * thread_width);
            out.push_back({.mesh = meshes.thread,
                           .model = along(place.middle + corner + line[i], way, glm::length(way), width),
                           .tint = glm::mix(picture.colours.base,
                                            speed_colour(glm::length(flow(line[i]).value)), share),
                           .glow = 0.6F});
        }
    }
}

}  // namespace thaum::game::inline scene
