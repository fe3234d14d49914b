#include "game/lab/hand_path.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/file.h"
#include "core/text.h"
#include "core/units.h"

namespace thaum::game {
namespace {

constexpr double round_s = 4;
constexpr double width_share = 0.25;   // of the narrower horizontal edge
constexpr double height_share = 0.45;  // of the height: start and turning point of a press

constexpr std::size_t trace_most = 512U << 20U;  // bytes of a file with a hand's path
constexpr std::array<std::string_view, 6> trace_columns{"time_s",   "hand_x_m", "hand_y_m",
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

/// Cuts the next part off a text, up to a mark.
std::string_view cut(std::string_view& words, char mark) {
    const auto end = std::min(words.find(mark), words.size());
    auto part = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    if (part.ends_with('\r')) part.remove_suffix(1);
    return part;
}

/// Numbers of trace_columns in a line; std::nullopt if one is missing. `places` are those of the line's columns.
std::optional<std::array<double, 6>> numbers_of(std::string_view line,
                                                const std::vector<std::size_t>& places) {
    std::array<double, 6> numbers{};
    std::size_t found = 0;
    for (const std::size_t place : places) {
        const auto word = cut(line, ',');
        if (place == trace_columns.size()) continue;
        double& number = numbers.at(place);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
        found += std::isfinite(number) ? 1U : 0U;
    }
    return found == trace_columns.size() ? std::optional(numbers) : std::nullopt;
}

/// The place in trace_columns of each column of a header; trace_columns.size(): it is none of them.
std::vector<std::size_t> places_of_columns(std::string_view header) {
    std::vector<std::size_t> places;
    while (!header.empty())
        places.push_back(static_cast<std::size_t>(std::ranges::find(trace_columns, cut(header, ',')) -
                                                  trace_columns.begin()));
    return places;
}

/// Adds a row of a trace. Its time is that of the step's end; the hand wants the place at the step's beginning. Returns
/// whether the row is sound.
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

}  // namespace

Expected<HandPath> hand_path(std::string_view word) {
    if (word == "rest") return HandPath{HandWay::rest, {}, {}};
    if (word == "press") return HandPath{HandWay::press, {}, {}};
    if (word == "circle") return HandPath{HandWay::circle, {}, {}};
    if (!word.ends_with(".csv"))
        return fail(text("'", word, "': must be rest, press, circle or a .csv file"));
    const auto csv = read_text_file(word, trace_most);
    if (!csv) return csv.error();
    if (csv->starts_with("time_s,tip_")) return parse_hand_trace(*csv, word);
    auto path = parse_stir_path(*csv, word);
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
    HandPath path{HandWay::file, {.kind = Stirring::file}, {}};
    const auto places = places_of_columns(cut(csv, '\n'));
    for (std::size_t column = 0; column < trace_columns.size(); ++column)
        if (std::ranges::find(places, column) == places.end())
            return fail(text(name, ": a trace without ", trace_columns.at(column), " cannot lead the hand"));
    for (std::size_t line = 2; !csv.empty(); ++line) {
        const auto row = numbers_of(cut(csv, '\n'), places);
        if (!row || !add_row(*row, path)) return fail(text(name, ":", line, ": no row of a trace"));
    }
    if (path.file.points.empty()) return fail(text(name, ": no places in it"));
    return path;
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

}  // namespace thaum::game
