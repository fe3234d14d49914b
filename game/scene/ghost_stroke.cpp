// The shape of the next stroke of a recipe, on the surface of the brew, at the size of the stroke that was
// recorded for the gesture. A ball of light marks its start, and another one runs along the shape.
#include <cmath>

#include "game/data/teams.h"
#include "game/scene/arena_parts.h"

namespace thaum::game::inline scene {
namespace {

constexpr double above = 0.06;  ///< height of the shape above the level of the brew (m)
constexpr double thick = 0.012;
constexpr double period_s = 1.6;

}  // namespace

void add_ghost_stroke(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t player,
                      std::vector<render::Instance>& out) {
    const auto& p = picture.wizards[player];
    const auto& recipe = p.stations.recipe;
    if (!p.stations.stirs || p.vitals.dead || recipe.step != RecipeStep::stroke || !recipe.in_time() ||
        recipe.ghost_points < 2 || arena_scene.brew == nullptr)
        return;
    const auto turn = look_rotation(recipe.yaw, 0);
    const auto at = [&](std::size_t i) {
        const auto& point = recipe.ghost.at(i);
        return arena_scene.brew->place.middle + turn * vec3(point.x, above, -point.y);
    };
    const fvec3 tint = team_colours(player).light;
    for (std::size_t i = 1; i < recipe.ghost_points; ++i)
        add_beam(arena_scene, at(i - 1), at(i), thick, tint, out);
    out.push_back(bead_at(arena_scene, at(0), 0.05F, tint, 0.8F));
    const double share = std::fmod(picture.played_s, period_s) / period_s;
    const auto runner = static_cast<std::size_t>(share * (recipe.ghost_points - 1));
    out.push_back(bead_at(arena_scene, at(runner), 0.07F, fvec3(1, 0.75F, 0.3F), 0.9F));
}

}  // namespace thaum::game::inline scene
