#include "game/lab/stir_path.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/file.h"
#include "core/text.h"

namespace thaum::game::inline lab {
namespace {

constexpr double turn_s = 2.5;
constexpr double radius_share = 0.6, depth_share = 0.4;
// How the ladle enters from above, to which the surface reacts: duration (s), and start height above the
// level surface (m).
constexpr double dip_s = 0.5, dip_from = 0.1;
constexpr std::size_t max_path_file = 16U << 20U;
constexpr double max_time = 1e6, max_place = 100;  // largest time (s) and coordinate (m) in a file

bool is_sound(const StirPath::Point& p) {
    return p.time >= 0 && p.time <= max_time && glm::length(p.place) <= max_place;
}

std::optional<vec3> on_points(const std::vector<StirPath::Point>& points, double seconds) {
    const auto after = std::find_if(points.begin(), points.end(),
                                    [&](const StirPath::Point& p) { return p.time >= seconds; });
    if (after == points.end()) return std::nullopt;
    if (after->time == seconds) return after->place;
    if (after == points.begin()) return std::nullopt;
    const auto& before = *(after - 1);
    const double share = (seconds - before.time) / (after->time - before.time);
    return before.place + share * (after->place - before.place);
}

}  // namespace

Expected<StirPath> read_stir_path(TableReader& table) {
    const auto time = table.column("time_s"), x = table.column("x_m"), y = table.column("y_m"),
               z = table.column("z_m");
    StirPath path{.kind = Stirring::file};
    while (table.next()) {
        const StirPath::Point point{table.number(time), {table.number(x), table.number(y), table.number(z)}};
        if (!is_sound(point))
            table.report(text("times are 0 to ", max_time, " s, places within ", max_place, " m"));
        if (!path.points.empty() && !(point.time > path.points.back().time)) table.report("times must rise");
        path.points.push_back(point);
    }
    if (path.points.empty()) table.report("no places in it");
    if (!table.good()) return table.fault();
    return path;
}

Expected<StirPath> parse_stir_path(std::string_view csv, std::string_view name) {
    TableReader table(csv, name, stir_path_titles);
    return read_stir_path(table);
}

Expected<StirPath> stir_path(std::string_view word) {
    if (word == "none") return StirPath{};
    if (word == "circle") return StirPath{.kind = Stirring::circle};
    if (word == "figure8") return StirPath{.kind = Stirring::figure8};
    const auto csv = read_text_file(word, max_path_file);
    if (csv) return parse_stir_path(*csv, word);
    if (std::filesystem::exists(word)) return csv.error();
    return fail(text("--stir takes none, circle, figure8 or a file: ", csv.error().message));
}

std::optional<vec3> ladle_at(const StirPath& path, const Basin& basin, double seconds) {
    if (path.kind == Stirring::none) return std::nullopt;
    if (path.kind == Stirring::file) return on_points(path.points, seconds);
    const double turn = 2 * pi * seconds / turn_s;
    const double across = radius_share * basin.radius;
    const double z = path.kind == Stirring::circle ? det::sin(turn) : det::sin(2 * turn) / 2;
    const double dipped = std::min(1.0, seconds / dip_s);
    const double y = dip_from * (1 - dipped) - depth_share * basin.depth * dipped;
    return vec3(across * det::cos(turn), y, across * z);
}

}  // namespace thaum::game::inline lab
