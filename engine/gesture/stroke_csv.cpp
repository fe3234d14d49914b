#include "gesture/stroke_csv.h"

#include <array>
#include <map>

#include "core/table.h"
#include "core/text.h"

namespace thaum::gesture {
namespace {

constexpr std::size_t longest_name = 200;

std::string name_in(TableReader& table, std::size_t column) {
    const auto word = table.cell(column);
    if (word.empty() || word.size() > longest_name)
        table.report(text("a name must have 1 to ", longest_name, " characters"));
    return std::string(word);
}

struct PointColumns {
    std::size_t t{}, x{}, y{}, z{}, force{};
};

PointColumns point_columns(TableReader& table) {
    return {table.column("t"), table.column("x"), table.column("y"), table.column("z", false),
            table.column("force", false)};
}

StrokePoint point_of(TableReader& table, const PointColumns& c) {
    return {
        table.number(c.t), {table.number(c.x), table.number(c.y), table.number(c.z)}, table.number(c.force)};
}

/// Adds a point to a stroke or session (continuous motion), or reports a fault of the table.
void append(TableReader& table, std::vector<StrokePoint>& points, const StrokePoint& p) {
    if (!points.empty() && p.t < points.back().t)
        return table.report(text("time runs backwards, from ", points.back().t, " to ", p.t, " s"));
    points.push_back(p);
}

}  // namespace

Expected<StrokeSet> read_strokes(std::string_view csv, std::string_view name) {
    TableReader table(csv, name);
    const auto user = table.column("user"), gesture = table.column("gesture"),
               sample = table.column("sample");
    const auto columns = point_columns(table);
    StrokeSet set;
    std::map<std::array<std::string, 3>, std::size_t> places;
    std::array<std::string, 3> key;
    std::size_t points = 0, at = 0;
    while (table.good() && table.next()) {
        if (points == 0 || table.cell(user) != key[0] || table.cell(gesture) != key[1] ||
            table.cell(sample) != key[2]) {
            key = {name_in(table, user), name_in(table, gesture), name_in(table, sample)};
            at = places.try_emplace(key, set.strokes.size()).first->second;
            if (at == set.strokes.size()) set.strokes.push_back({key[0], key[1], key[2], {}, table.line()});
            if (set.strokes.size() > max_csv_strokes) table.report("too many strokes");
        }
        const auto p = point_of(table, columns);
        append(table, set.strokes[at].points, p);
        set.has_depth = set.has_depth || p.at.z != 0;
        set.has_force = set.has_force || p.force != 0;
        if (++points > max_csv_points) table.report("too many points");
    }
    if (table.good() && set.strokes.empty()) table.report("no stroke");
    if (!table.good()) return table.fault();
    return set;
}

Expected<SessionSet> read_sessions(std::string_view csv, std::string_view name) {
    TableReader table(csv, name);
    const auto user = table.column("user");
    const auto columns = point_columns(table);
    SessionSet set;
    std::map<std::string, std::size_t, std::less<>> places;
    std::size_t points = 0;
    while (table.good() && table.next()) {
        auto found = places.find(table.cell(user));
        if (found == places.end()) {
            found = places.emplace(name_in(table, user), set.sessions.size()).first;
            set.sessions.push_back({found->first, {}});
        }
        const auto p = point_of(table, columns);
        append(table, set.sessions[found->second].points, p);
        set.has_depth = set.has_depth || p.at.z != 0;
        set.has_force = set.has_force || p.force != 0;
        if (++points > max_csv_points) table.report("too many points");
    }
    if (table.good() && set.sessions.empty()) table.report("no session");
    if (!table.good()) return table.fault();
    return set;
}

Expected<std::vector<SessionLabel>> read_labels(std::string_view csv, std::string_view name) {
    TableReader table(csv, name);
    const auto user = table.column("user"), gesture = table.column("gesture"),
               start = table.column("t_start"), end = table.column("t_end");
    std::vector<SessionLabel> labels;
    while (table.good() && table.next()) {
        labels.push_back(
            {name_in(table, user), name_in(table, gesture), table.number(start), table.number(end)});
        if (labels.back().end < labels.back().start) table.report("the gesture ends before it starts");
        if (labels.size() > max_csv_strokes) table.report("too many labels");
    }
    if (!table.good()) return table.fault();
    return labels;
}

std::string to_csv(std::span<const Stroke> strokes) {
    std::string out = "user,gesture,sample,t,x,y,z,force\n";
    for (const auto& s : strokes) {
        std::string names;
        for (const auto& name : {s.user, s.gesture, s.sample}) {
            append_cell(names, name);
            names += ',';
        }
        for (const auto& p : s.points)
            append_text(out, text(names, p.t, ",", p.at.x, ",", p.at.y, ",", p.at.z, ",", p.force, "\n"));
    }
    return out;
}

}  // namespace thaum::gesture
