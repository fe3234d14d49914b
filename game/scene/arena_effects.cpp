#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "game/data/teams.h"
#include "game/scene/arena_parts.h"

namespace thaum::game::inline scene {

using render::colour;
using render::Instance;

namespace {

constexpr int embers = 36, bubbles = 14;
/// Number of steam wisps: over a pure brew, and over a brew of the least density.
constexpr double min_wisps = 9, max_wisps = 26;
constexpr float brew_glow = 1.7F;  // brightness of the brew, the brightest thing in the arena

}  // namespace

namespace {

/// Model matrix that places a missile and turns its -z axis into its direction of flight.
fmat4 flying(const MissilePicture& missile) {
    const vec3 v = missile.velocity;
    const double flat = std::hypot(v.x, v.z);
    return render::translated(fvec3(missile.position)) *
           looking(std::atan2(-v.x, -v.z), std::atan2(v.y, flat));
}

/// Scale of a missile. The viewer's own missile starts small and grows, because at full size it would fill
/// the view.
float size_of(const Picture& picture, const MissilePicture& missile, std::uint32_t viewer) {
    if (missile.player != viewer || viewer >= players) return 1;
    const double distance = glm::length(missile.position - picture.wizards[viewer].vitals.eye);
    return static_cast<float>(std::clamp(distance / 6, 0.2, 1.0));
}

}  // namespace

void add_missile(const ArenaScene& arena_scene, const Picture& picture, const MissilePicture& missile,
                 std::uint32_t viewer, std::vector<Instance>& out) {
    const auto& team = arena_scene.teams[missile.player % players];
    const float scale = missile.size > 0 ? static_cast<float>(missile.size) : 1.0F;
    const float size = size_of(picture, missile, viewer) * scale;
    out.push_back(
        {.mesh = team.missiles[missile.wand], .model = glm::scale(flying(missile), fvec3(size)), .glow = 1});
}

/// Adds a small core that fades and a shell that grows as far as the burst reaches. Neither ever fills a
/// view: the core is limited to a share of the view, and the shell is hidden once it has passed the eye.
void add_burst(const ArenaScene& arena_scene, const Picture& picture, const BurstPicture& burst,
               std::uint32_t viewer, std::vector<Instance>& out) {
    constexpr double max_of_view = 0.15;   // largest core radius as a share of the distance from the eye
    constexpr double past_the_eye = 1.25;  // factor on the shell's radius that allows for its thick bars
    const auto& team = arena_scene.teams[burst.player % players];
    const auto age = static_cast<float>(std::clamp(burst.age_s / burst_seconds, 0.0, 1.0));
    const auto radius = static_cast<float>(burst.radius);
    const auto at = render::translated(fvec3(burst.place));
    const float shell = radius * (0.15F + 0.85F * std::sqrt(age)), core = 0.2F * radius * (1 - age);
    const double distance =
        viewer < players ? glm::distance(burst.place, picture.wizards[viewer].vitals.eye) : 100;
    const float shown = std::min(core, static_cast<float>(max_of_view * distance));
    if (distance > past_the_eye * double{shell})
        out.push_back({.mesh = team.burst,
                       .model = glm::scale(at, fvec3(shell)),
                       .tint = fvec3(1 - 0.8F * age),
                       .glow = 1});
    if (shown > 0)
        out.push_back({.mesh = arena_scene.ember, .model = glm::scale(at, fvec3(shown)), .glow = 1});
}

namespace {

void add_painted_brew(const ArenaScene& arena_scene, std::vector<Instance>& out) {
    if (!arena_scene.bowl || !arena_scene.painted_brew) return;
    out.push_back({.mesh = *arena_scene.painted_brew,
                   .model = render::translated(fvec3(*arena_scene.bowl)),
                   .tint = fvec3(brew_glow),
                   .glow = glow_share});
}

/// Distance beyond which a resting simulated brew looks the same as the painted mesh that replaces it (m).
constexpr double brew_seen_from = 14;

bool is_near_brew(const ArenaScene& arena_scene, vec3 eye) {
    return glm::distance(eye, arena_scene.brew->place.middle) < brew_seen_from;
}

/// True if the viewer sees the simulated brew and not the painted one. The empty arena behind a menu is seen
/// from far away.
bool sees_brew(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer) {
    return viewer < players &&
           visible_brew(arena_scene, picture, picture.wizards[viewer].vitals.eye) != nullptr;
}

void add_brew_of(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                 std::vector<Instance>& out) {
    if (!sees_brew(arena_scene, picture, viewer)) return add_painted_brew(arena_scene, out);
    add_brew(*arena_scene.brew, out);
    for (const auto& ladle : picture.cauldron.ladles) {
        if (ladle) add_ladle(arena_scene.brew->meshes, *ladle, out);
    }
}

/// Adds lights around the rim in the colour of the brew's owner: a plain ring for one team, a zigzag for the
/// other, so that the owner is recognised without the colour. The lights go out one by one until the brew
/// boils over.
void add_owner(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& out) {
    constexpr int lights = 30;
    constexpr float size = 0.05F;
    const auto owner = picture.cauldron.owner;
    if (!arena_scene.bowl || owner >= players) return;
    const fvec3 light = team_colours(owner).light;
    const int shown = static_cast<int>(std::ceil(lights * std::clamp(picture.cauldron.fresh, 0.0, 1.0)));
    for (int i = 0; i < shown; ++i) {
        const double angle = 2 * pi * i / lights;
        const double raised = owner == 1 && i % 2 == 1 ? 0.22 : 0.1;
        const vec3 at = *arena_scene.bowl + vec3(arena_scene.rim_radius * std::sin(angle),
                                                 arena_scene.rim_height + raised,
                                                 -arena_scene.rim_radius * std::cos(angle));
        out.push_back(bead_at(arena_scene, at, size, light, 1));
    }
}

}  // namespace

void add_niches(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& out) {
    for (const auto& niche : picture.niches) {
        const auto at = render::translated(fvec3(niche.position));
        if (niche.there)
            add_ingredient(arena_scene, at * render::translated({0, niche_height, 0}), 1, niche.shape,
                           niche.colour, out);
    }
}

namespace {

/// Adds sparks that rise from the brew, each on its own path.
void add_embers(const ArenaScene& arena_scene, double time, std::vector<Instance>& out) {
    if (!arena_scene.bowl) return;
    for (int i = 0; i < embers; ++i) {
        const double number = i;
        const double life = time * (0.10 + 0.013 * (i % 7)) + number * 0.618;
        const double age = life - std::floor(life);
        const double angle = number * 2.4 + 1.6 * age;
        const double radius = (0.25 + 0.8 * std::fmod(number * 0.37, 1.0)) * (1 + 0.9 * age);
        const vec3 at =
            *arena_scene.bowl + vec3(radius * std::cos(angle), 0.4 + 5.5 * age, radius * std::sin(angle));
        const auto size = static_cast<float>(0.035 * std::sin(pi * age) * (0.6 + 0.1 * (i % 5)));
        out.push_back({.mesh = arena_scene.ember,
                       .model = glm::scale(render::translated(fvec3(at)), fvec3(std::max(size, 1e-4F))),
                       .glow = 1});
    }
}

/// Adds bubbles that swell and sink in the brew, each at its own place and time.
void add_bubbles(const ArenaScene& arena_scene, double time, std::vector<Instance>& out) {
    if (!arena_scene.bowl) return;
    for (int i = 0; i < bubbles; ++i) {
        const double life = time * (0.35 + 0.05 * (i % 4)) + i * 0.381;
        const double round = std::floor(life), age = life - round;
        const double angle = 2.4 * (i + 3 * round),
                     radius = 0.25 + 0.75 * std::fmod(0.618 * (i + round), 1.0);
        const vec3 at = *arena_scene.bowl + vec3(radius * std::cos(angle), 0.72 - 0.10 * radius * radius,
                                                 radius * std::sin(angle));
        const auto size = static_cast<float>(0.02 + 0.13 * std::sin(pi * age));
        out.push_back({.mesh = arena_scene.bubble,
                       .model = glm::scale(render::translated(fvec3(at)), fvec3(size)),
                       .glow = 1});
    }
}

}  // namespace

void add_cauldron(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                  std::vector<Instance>& out) {
    add_brew_of(arena_scene, picture, viewer, out);
    add_owner(arena_scene, picture, out);
    add_embers(arena_scene, picture.played_s, out);
    if (!sees_brew(arena_scene, picture, viewer)) add_bubbles(arena_scene, picture.played_s, out);
}

/// Adds steam as wisps that swell, drift apart and fade. The less dense the brew, the more there are.
void add_steam(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& out) {
    if (!arena_scene.bowl) return;
    const double heat = picture.cauldron.there ? picture.cauldron.heat : 0;
    const double wanted = glm::mix(min_wisps, max_wisps, heat);
    for (int i = 0; i < wanted; ++i) {
        const double life = picture.played_s * (0.12 + 0.02 * (i % 5)) + i * 0.618;
        const double round = std::floor(life), age = life - round;
        const double angle = 2.4 * (i + 5 * round) + 1.2 * age;
        const double radius = (0.1 + 0.75 * std::fmod(0.618 * (i + 2 * round), 1.0)) * (1 - 0.3 * age);
        const vec3 at = *arena_scene.bowl + vec3(radius * std::cos(angle), 0.75 + (1.5 + 0.2 * (i % 3)) * age,
                                                 radius * std::sin(angle));
        const double dense = std::min(1.0, wanted - i) * std::min(1.0, 4 * age) * (1 - age);
        out.push_back(bead_at(arena_scene, at, static_cast<float>(0.13 + 0.28 * age), colour(0xD8CCE0),
                              0.4F * static_cast<float>(dense)));
    }
}

namespace {

/// False if the brew is surely outside of a player's view. Always true for a dead player, whose view is not
/// that of the wizard.
bool may_see_brew(const BrewPlace& place, const PlayerPicture& p) {
    // A bound for the angle between the middle of a view and its corners (rad): 74 degrees for the largest
    // field of view, 130 degrees, in a flat half of a window of 21:9.
    constexpr double corner = 80 * radians_per_degree;
    const vec3 to = place.middle - p.vitals.eye;
    const double distance = glm::length(to), radius = std::max(place.basin.radius, place.basin.depth);
    if (p.vitals.dead || distance <= radius) return true;
    const vec3 ahead = look_rotation(p.vitals.yaw, p.vitals.pitch) * vec3(0, 0, -1);
    const double angle = std::acos(std::clamp(glm::dot(ahead, to) / distance, -1.0, 1.0));
    return angle < corner + std::asin(radius / distance);
}

}  // namespace

void show_brew_near(const ArenaScene& arena_scene, const Picture& picture, const BrewOverlay& overlay) {
    const bool seen =
        std::any_of(picture.wizards.begin(), picture.wizards.end(), [&](const PlayerPicture& p) {
            return arena_scene.brew && is_near_brew(arena_scene, p.vitals.eye) &&
                   may_see_brew(arena_scene.brew->place, p);
        });
    if (seen && picture.cauldron.there) show_brew(picture.cauldron.brew, overlay, *arena_scene.brew);
}

const render::Volume* visible_brew(const ArenaScene& arena_scene, const Picture& picture, vec3 eye) {
    const bool shown = arena_scene.brew && picture.cauldron.there && arena_scene.brew->shown != 0;
    return shown && is_near_brew(arena_scene, eye) ? &arena_scene.brew->volume : nullptr;
}

}  // namespace thaum::game::inline scene
