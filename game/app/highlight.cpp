#include "game/app/highlight.h"

namespace thaum::app {
namespace {

constexpr Tick opening = 2000;   ///< ticks after the start in which the wizards only begin to move
constexpr double too_close = 3;  ///< smallest distance of the wizards (m)
/// cosine of the largest angle between player 1's gaze and the other wizard
constexpr double in_view = 0.95;

bool something_flies(const game::Simulation& match) {
    std::size_t missiles = 0;
    for (const auto& wand : match.data().wands)
        wand.rules->show(match.world(), [&](const game::Missile&) { ++missiles; });
    return missiles > 0;
}

}  // namespace

void watch_for_highlight(const game::Simulation& match, Highlight& best) {
    if (match.now() < opening || match.now() % highlight_interval != 0) return;
    const auto& world = match.world();
    const auto a = game::wizard_of(world, 0);
    const auto b = game::wizard_of(world, 1);
    if (world.has<game::Dead>(a) || world.has<game::Dead>(b)) return;
    const vec3 from = world.get<game::Motion>(a).position;
    const vec3 to = world.get<game::Motion>(b).position;
    const auto& gaze = world.get<game::Gaze>(a);
    const vec3 ahead = look_rotation(gaze.yaw, gaze.pitch) * vec3(0, 0, -1);
    const double distance = glm::distance(from, to);
    const bool faces = distance > too_close && glm::dot(glm::normalize(to - from), ahead) > in_view;
    if (faces && distance < best.distance && something_flies(match)) best = {distance, match.now()};
}

}  // namespace thaum::app
