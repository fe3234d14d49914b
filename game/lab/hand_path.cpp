#include "game/lab/hand_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.h"

namespace thaum::game {
namespace {

constexpr double round_s = 4;
constexpr double width_share = 0.25;   // of the narrower horizontal edge
constexpr double height_share = 0.45;  // of the height: start and turning point of a press

vec3 on_file(const std::vector<StirPath::Point>& points, double seconds) {
    if (points.empty()) return vec3(0);
    const auto after = std::ranges::find_if(points, [&](const auto& p) { return p.time >= seconds; });
    if (after == points.begin()) return after->place;
    if (after == points.end()) return points.back().place;
    const auto& before = *(after - 1);
    return before.place +
           (seconds - before.time) / (after->time - before.time) * (after->place - before.place);
}

}  // namespace

Expected<HandPath> hand_path(std::string_view word) {
    if (word == "rest") return HandPath{HandWay::rest, {}};
    if (word == "press") return HandPath{HandWay::press, {}};
    if (word == "circle") return HandPath{HandWay::circle, {}};
    if (!word.ends_with(".csv"))
        return fail(text("'", word, "': must be rest, press, circle or a .csv file"));
    auto path = load_stir_path(word);
    if (!path) return tl::unexpected(path.error());
    return HandPath{HandWay::file, std::move(*path)};
}

vec3 wanted_place(const HandPath& path, vec3 workspace, double seconds) {
    const double turn = 2 * pi * seconds / round_s;
    switch (path.way) {
        case HandWay::press: return {0, height_share * workspace.y * det::cos(turn), 0};
        case HandWay::circle:
            return width_share * std::min(workspace.x, workspace.z) * vec3(det::cos(turn), 0, det::sin(turn));
        case HandWay::file: return on_file(path.file.points, seconds);
        case HandWay::rest: break;
    }
    return {0, height_share * workspace.y, 0};
}

vec3 place_before(vec3 to_viewer, vec3 workspace) {
    double most = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        if (to_viewer[axis] != 0) most = std::min(most, 0.5 * workspace[axis] / std::abs(to_viewer[axis]));
    return 0.98 * most * to_viewer;
}

}  // namespace thaum::game
