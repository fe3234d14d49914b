#include "game/match/highlight.h"

namespace thaum::game::inline match {
namespace {

constexpr Tick opening = 2000;   ///< length of the opening, in which nothing interesting happens (ticks)
constexpr double too_close = 3;  ///< distance below which the wizards are too close for a good picture (m)
/// cosine of the largest angle between a gaze and the other wizard
constexpr double in_view = 0.95;

bool something_flies(const Simulation& match) {
    std::size_t missiles = 0;
    for (const auto& wand : match.data().wands)
        wand.rules->show(match.world(), [&](const Missile&) { ++missiles; });
    return missiles > 0;
}

/// Whether a wizard has the other one in view, with nothing between them.
bool sees(const Simulation& match, ecs::Entity who, ecs::Entity whom) {
    const auto& world = match.world();
    const vec3 from = eye_of(match.data().wizard, world.get<Motion>(who).position);
    const vec3 to = eye_of(match.data().wizard, world.get<Motion>(whom).position);
    const auto& gaze = world.get<Gaze>(who);
    const vec3 ahead = look_rotation(gaze.yaw, gaze.pitch) * vec3(0, 0, -1);
    if (glm::distance(from, to) < too_close || glm::dot(glm::normalize(to - from), ahead) < in_view)
        return false;
    const auto hit = match.physics().ray(from, to, physics::all_layers, who.index);
    return !hit || hit->key == whom.index;
}

}  // namespace

void watch_for_highlight(const Simulation& match, Highlight& best) {
    if (match.now() < opening || match.now() % highlight_interval != 0) return;
    const auto& world = match.world();
    const auto a = wizard_of(world, 0);
    const auto b = wizard_of(world, 1);
    if (world.has<Dead>(a) || world.has<Dead>(b)) return;
    const double distance = glm::distance(world.get<Motion>(a).position, world.get<Motion>(b).position);
    if (distance < best.distance && sees(match, a, b) && sees(match, b, a) && something_flies(match))
        best = {distance, match.now()};
}

}  // namespace thaum::game::inline match
