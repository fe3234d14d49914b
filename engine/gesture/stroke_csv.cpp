#include "gesture/stroke_csv.h"

#include <array>
#include <charconv>
#include <map>
#include <optional>

#include "core/one_line.h"
#include "core/text.h"

namespace thaum::gesture {
namespace {

constexpr std::size_t most_columns = 16;
constexpr std::size_t longest_name = 200;
constexpr std::size_t absent = most_columns;

using Cells = std::array<std::string_view, most_columns>;

/// Reads a table line by line and keeps the first fault.
class CsvTable {
public:
    CsvTable(std::string_view csv, std::string_view name) : rest_(csv), name_(name) {}

    /// Splits the next line that is not empty. Returns false at the end.
    bool next() {
        while (!rest_.empty()) {
            ++line_;
            const auto end = rest_.find('\n');
            auto line = rest_.substr(0, end);
            rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
            if (line.ends_with('\r')) line.remove_suffix(1);
            if (line.empty()) continue;
            split(line);
            return !fault_;
        }
        return false;
    }

    /// Column of a title; `absent` if the table has none.
    std::size_t column(std::string_view title, bool required) {
        for (std::size_t c = 0; c < count_; ++c) {
            if (cells_[c] == title) return c;
        }
        if (required) report(text("no column '", title, "' in the first line"));
        return absent;
    }

    void end_of_titles() { width_ = count_; }

    std::string_view cell(std::size_t column) const { return cells_[column]; }

    double number(std::size_t column) {
        if (column == absent) return 0;
        const auto word = cells_[column];
        double value = 0;
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (code != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            report(text("'", printable(word, 40), "' is not a finite number"));
        return value;
    }

    std::string label(std::size_t column) {
        const auto word = cells_[column];
        if (word.empty() || word.size() > longest_name)
            report(text("a name must have 1 to ", longest_name, " characters"));
        return std::string(word);
    }

    void report(std::string_view what) {
        if (!fault_) fault_ = text(printable(name_, 200), ":", line_, ": ", what);
    }
    bool good() const { return !fault_.has_value(); }
    Error fault() const { return fail(*fault_); }

private:
    void split(std::string_view line) {
        count_ = 0;
        for (;;) {
            const auto comma = line.find(',');
            if (count_ == most_columns) return report(text("more than ", most_columns, " columns"));
            cells_[count_++] = line.substr(0, comma);
            if (comma == std::string_view::npos) break;
            line.remove_prefix(comma + 1);
        }
        if (width_ > 0 && count_ != width_)
            report(text(count_, " cells instead of ", width_, " as in the first line"));
    }

    std::string_view rest_, name_;
    std::size_t line_ = 0, count_ = 0, width_ = 0;
    Cells cells_{};
    std::optional<std::string> fault_;
};

struct PointColumns {
    std::size_t t{}, x{}, y{}, z{}, force{};
};

PointColumns point_columns(CsvTable& table) {
    return {table.column("t", true), table.column("x", true), table.column("y", true),
            table.column("z", false), table.column("force", false)};
}

StrokePoint point_of(CsvTable& table, const PointColumns& c) {
    return {
        table.number(c.t), {table.number(c.x), table.number(c.y), table.number(c.z)}, table.number(c.force)};
}

/// Adds a point to a stroke or session.
void append(CsvTable& table, std::vector<StrokePoint>& points, const StrokePoint& p) {
    if (!points.empty() && p.t < points.back().t)
        return table.report(text("time runs backwards, from ", points.back().t, " to ", p.t, " s"));
    points.push_back(p);
}

}  // namespace

Expected<StrokeSet> read_strokes(std::string_view csv, std::string_view name) {
    CsvTable table(csv, name);
    if (!table.next()) table.report("the file is empty");
    const auto user = table.column("user", true), gesture = table.column("gesture", true),
               sample = table.column("sample", true);
    const auto columns = point_columns(table);
    table.end_of_titles();
    StrokeSet set;
    std::map<std::array<std::string, 3>, std::size_t> places;
    std::array<std::string, 3> key;
    std::size_t points = 0, at = 0;
    while (table.good() && table.next()) {
        if (points == 0 || table.cell(user) != key[0] || table.cell(gesture) != key[1] ||
            table.cell(sample) != key[2]) {
            key = {table.label(user), table.label(gesture), table.label(sample)};
            at = places.try_emplace(key, set.strokes.size()).first->second;
            if (at == set.strokes.size()) set.strokes.push_back({key[0], key[1], key[2], {}});
            if (set.strokes.size() > most_csv_strokes) table.report("too many strokes");
        }
        const auto p = point_of(table, columns);
        append(table, set.strokes[at].points, p);
        set.has_depth = set.has_depth || p.at.z != 0;
        set.has_force = set.has_force || p.force != 0;
        if (++points > most_csv_points) table.report("too many points");
    }
    if (table.good() && set.strokes.empty()) table.report("no stroke");
    if (!table.good()) return table.fault();
    return set;
}

Expected<SessionSet> read_sessions(std::string_view csv, std::string_view name) {
    CsvTable table(csv, name);
    if (!table.next()) table.report("the file is empty");
    const auto user = table.column("user", true);
    const auto columns = point_columns(table);
    table.end_of_titles();
    SessionSet set;
    std::map<std::string, std::size_t, std::less<>> places;
    std::size_t points = 0;
    while (table.good() && table.next()) {
        auto found = places.find(table.cell(user));
        if (found == places.end()) {
            found = places.emplace(table.label(user), set.sessions.size()).first;
            set.sessions.push_back({found->first, {}});
        }
        const auto p = point_of(table, columns);
        append(table, set.sessions[found->second].points, p);
        set.has_depth = set.has_depth || p.at.z != 0;
        set.has_force = set.has_force || p.force != 0;
        if (++points > most_csv_points) table.report("too many points");
    }
    if (table.good() && set.sessions.empty()) table.report("no session");
    if (!table.good()) return table.fault();
    return set;
}

Expected<std::vector<SessionLabel>> read_labels(std::string_view csv, std::string_view name) {
    CsvTable table(csv, name);
    if (!table.next()) table.report("the file is empty");
    const auto user = table.column("user", true), gesture = table.column("gesture", true),
               start = table.column("t_start", true), end = table.column("t_end", true);
    table.end_of_titles();
    std::vector<SessionLabel> labels;
    while (table.good() && table.next()) {
        labels.push_back({table.label(user), table.label(gesture), table.number(start), table.number(end)});
        if (labels.back().end < labels.back().start) table.report("the gesture ends before it starts");
        if (labels.size() > most_csv_strokes) table.report("too many labels");
    }
    if (!table.good()) return table.fault();
    return labels;
}

std::string to_csv(std::span<const Stroke> strokes) {
    std::string out = "user,gesture,sample,t,x,y,z,force\n";
    for (const auto& s : strokes) {
        for (const auto& p : s.points)
            out += text(s.user, ",", s.gesture, ",", s.sample, ",", p.t, ",", p.at.x, ",", p.at.y, ",",
                        p.at.z, ",", p.force, "\n");
    }
    return out;
}

}  // namespace thaum::gesture
