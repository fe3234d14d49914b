#include "game/arena/basin.h"

#include <algorithm>

namespace thaum::game::inline arena {

Basin basin_of(const BowlSize& bowl, double filled) {
    const auto whole = bowl_profile(bowl);
    const double level = level_of(bowl, filled);
    Basin basin;
    // The profile, the outline of half of the bowl's cross-section, first follows the outside up to the rim,
    // its highest point. After that point it follows the inside down.
    const auto top = std::max_element(whole.begin(), whole.end(), [](vec2 a, vec2 b) { return a.y < b.y; });
    for (auto at = top + 1; at != whole.end(); ++at) {
        const vec2 before = *(at - 1);
        if (at->y > level) continue;
        if (before.y > level)
            basin.profile.push_back(
                {before.x + (at->x - before.x) * (level - before.y) / (at->y - before.y), 0});
        basin.profile.push_back({at->x, at->y - level});
    }
    for (const vec2 point : basin.profile) {
        basin.radius = std::max(basin.radius, point.x);
        basin.depth = std::max(basin.depth, -point.y);
    }
    return basin;
}

double width_at(const Basin& basin, double height) {
    const auto& profile = basin.profile;
    if (profile.empty() || height < profile.back().y) return 0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const vec2 high = profile[i - 1], low = profile[i];
        if (height < low.y || !(high.y > low.y)) continue;
        return low.x + (high.x - low.x) * std::min(1.0, (height - low.y) / (high.y - low.y));
    }
    return profile.front().x;
}

}  // namespace thaum::game::inline arena
