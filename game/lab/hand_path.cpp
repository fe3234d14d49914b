#include "game/lab/hand_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/file.h"
#include "core/table.h"
#include "core/text.h"
#include "core/units.h"

namespace thaum::game::inline lab {
namespace {

constexpr double round_s = 4;
// radius of the circle, as a share of the workspace's narrower horizontal edge
constexpr double width_share = 0.25;
// height of a press's start and turning point above and below the middle, as a share of the workspace's
// height
constexpr double height_share = 0.45;

constexpr std::size_t max_trace = 512U << 20U;  // maximum size of a file with a hand's path (bytes)
constexpr std::array<std::string_view, 6> trace_titles{"time_s",   "hand_x_m", "hand_y_m",
                                                       "hand_z_m", "tool",     "history"};

vec3 on_file(const std::vector<StirPath::Point>& points, double seconds) {
    if (points.empty()) return vec3(0);
    const auto after = std::ranges::lower_bound(points, seconds, {}, &StirPath::Point::time);
    if (after == points.end()) return points.back().place;
    if (after == points.begin() || after->time == seconds) return after->place;
    const auto& before = *(after - 1);
    return before.place +
           (seconds - before.time) / (after->time - before.time) * (after->place - before.place);
}

/// Adds a row of a trace (the table of a session of the lab) to the path. A time in a trace is the end of a
/// step, but a path needs its beginning. Returns whether the row is valid.
bool add_row(const std::array<double, 6>& row, HandPath& path) {
    const auto [time, x, y, z, tool, history] = row;
    const bool sound = time > 0 && time < 1e6 && tool >= 0 && tool < 1000 && std::abs(history) <= 1;
    const vec3 place(x, y, z);
    if (!sound || glm::length(place) > 100) return false;
    const double from = seconds(static_cast<Tick>(std::llround(time / tick_seconds) - 1));
    if (!path.file.points.empty() && !(from > path.file.points.back().time)) return false;
    path.file.points.push_back({from, place});
    path.uses.push_back({static_cast<std::size_t>(tool), static_cast<int>(history)});
    return true;
}

Expected<HandPath> read_hand_trace(TableReader& table) {
    HandPath path{HandWay::file, {.kind = Stirring::file}, {}};
    std::array<std::size_t, trace_titles.size()> columns{};
    std::ranges::transform(trace_titles, columns.begin(),
                           [&](std::string_view title) { return table.column(title); });
    while (table.next()) {
        std::array<double, trace_titles.size()> row{};
        std::ranges::transform(columns, row.begin(),
                               [&](std::size_t column) { return table.number(column); });
        if (!add_row(row, path)) table.report("no row of a trace");
    }
    if (path.file.points.empty()) table.report("no places in it");
    if (!table.good()) return table.fault();
    return path;
}

}  // namespace

Expected<HandPath> hand_path(std::string_view word) {
    if (word == "rest") return HandPath{HandWay::rest, {}, {}};
    if (word == "press") return HandPath{HandWay::press, {}, {}};
    if (word == "circle") return HandPath{HandWay::circle, {}, {}};
    const auto csv = read_text_file(word, max_trace);
    const bool names_file = word.find_first_of("./") != std::string_view::npos;
    if (!csv && names_file) return csv.error();
    if (!csv) return fail(text("takes rest, press, circle or a table: ", csv.error().message));
    TableReader table(*csv, word, stir_path_titles);
    const bool is_trace = table.column("x_m", false) == TableReader::no_column;
    if (is_trace && table.column("tip_x_m", false) != TableReader::no_column) return read_hand_trace(table);
    auto path = read_stir_path(table);
    if (!path) return path.error();
    return HandPath{HandWay::file, std::move(*path), {}};
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

Expected<HandPath> parse_hand_trace(std::string_view csv, std::string_view name) {
    TableReader table(csv, name);
    return read_hand_trace(table);
}

HandUse use_at(const HandPath& path, double seconds) {
    const auto& points = path.file.points;
    const auto at = std::ranges::lower_bound(points, seconds, {}, &StirPath::Point::time);
    if (at == points.end() || at->time != seconds || path.uses.empty()) return {};
    return path.uses[static_cast<std::size_t>(at - points.begin())];
}

vec3 place_before(vec3 to_viewer, vec3 workspace) {
    double most = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        if (to_viewer[axis] != 0) most = std::min(most, 0.5 * workspace[axis] / std::abs(to_viewer[axis]));
    return 0.98 * most * to_viewer;
}

}  // namespace thaum::game::inline lab
