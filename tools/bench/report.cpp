#include "tools/bench/report.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <thread>

#include "core/json.h"
#include "core/text.h"

namespace thaum::bench {
namespace {

std::string cpu_name() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

bool competes(const Row& row) {
    return row.time_us && row.error && std::isfinite(row.error->value) && std::isfinite(row.time_us->median);
}

bool same_case(const Row& a, const Row& b) { return a.area == b.area && a.name == b.name; }

bool beats(const Row& a, const Row& b) {
    const double dt = b.time_us->median - a.time_us->median;
    const double de = b.error->value - a.error->value;
    return dt >= 0 && de >= 0 && (dt > 0 || de > 0);
}

Json row_json(const Row& row) {
    auto settings = Json::object(), metrics = Json::object();
    for (const auto& setting : row.setting) {
        std::visit([&](const auto& v) { settings.set(setting.first, v); }, setting.second);
    }
    for (const auto& [name, value] : row.metrics) metrics.set(name, value);
    Json out{{"area", row.area}, {"case", row.name}, {"setting", settings}};
    if (row.time_us) {
        out.set("time_us",
                {{"min", row.time_us->min}, {"median", row.time_us->median}, {"p99", row.time_us->p99}});
    }
    if (row.error) out.set("error", {{"name", row.error->name}, {"value", row.error->value}});
    out.set("front", row.front);
    out.set("default", row.is_default);
    if (!row.metrics.empty()) out.set("metrics", metrics);
    if (row.hash) out.set("hash", *row.hash);
    if (!row.fault.empty()) out.set("fault", row.fault);
    return out;
}

/// Texts in rows and columns. The first row holds the headings, and other rows may be shorter.
class Grid {
public:
    void begin_row() { rows_.emplace_back(headings_.size()); }
    /// Sets the cell in the column with this heading. A new name adds a column at the right.
    void put(std::string_view column, std::string cell) {
        auto at = static_cast<std::size_t>(std::ranges::find(headings_, column) - headings_.begin());
        if (at == headings_.size()) headings_.emplace_back(column);
        auto& row = rows_.back();
        if (row.size() <= at) row.resize(at + 1);
        row[at] = std::move(cell);
    }
    std::string print() const {
        std::vector<std::size_t> widths;
        for (std::size_t c = 0; c < headings_.size(); ++c) widths.push_back(width(c));
        std::string out;
        print_row(out, headings_, widths);
        for (const auto& row : rows_) print_row(out, row, widths);
        return out;
    }

private:
    std::size_t width(std::size_t column) const {
        auto widest = headings_[column].size();
        for (const auto& row : rows_) {
            if (column < row.size()) widest = std::max(widest, row[column].size());
        }
        return widest;
    }
    /// Appends a row. The first column is left-aligned, the others right-aligned.
    static void print_row(std::string& out, const std::vector<std::string>& cells,
                          const std::vector<std::size_t>& widths) {
        const auto line = out.size();
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const std::string gap(widths[c] - cells[c].size(), ' ');
            append_text(out, c == 0 ? text(cells[c], gap) : text("  ", gap, cells[c]));
        }
        while (out.size() > line && out.back() == ' ') out.pop_back();
        out += '\n';
    }

    std::vector<std::string> headings_;
    std::vector<std::vector<std::string>> rows_;
};

void put_row(Grid& grid, const Row& row) {
    grid.begin_row();
    grid.put("case", row.name);
    for (const auto& [name, value] : row.setting) grid.put(name, shown(value));
    if (row.time_us) {
        grid.put("median us", shown(row.time_us->median));
        grid.put("min us", shown(row.time_us->min));
        grid.put("p99 us", shown(row.time_us->p99));
    }
    if (row.error) grid.put(row.error->name, shown(row.error->value));
    if (row.front || row.is_default || !row.fault.empty()) {
        grid.put("mark", text(row.fault.empty() ? "" : "!", row.front ? "*" : "", row.is_default ? "d" : ""));
    }
    for (const auto& [name, value] : row.metrics) grid.put(name, shown(value));
    if (row.hash) grid.put("hash", *row.hash);
}

std::string area_table(const Report& report, const std::string& area) {
    Grid grid;
    for (const auto& row : report.rows) {
        if (row.area == area) put_row(grid, row);
    }
    return text(area, "\n", grid.print());
}

}  // namespace

std::string shown(double value) {
    std::array<char, 64> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 4).ptr;
    return {buffer.data(), end};
}

std::string shown(const Value& value) {
    if (const auto* s = std::get_if<std::string>(&value)) return *s;
    if (const auto* i = std::get_if<std::int64_t>(&value)) return std::to_string(*i);
    return shown(std::get<double>(value));
}

Report empty_report() {
    return {THAUM_VERSION, {cpu_name(), std::thread::hardware_concurrency(), THAUM_BUILD_TYPE}, {}};
}

void mark_fronts(std::vector<Row>& rows) {
    for (auto& row : rows) {
        row.front = competes(row) && std::ranges::none_of(rows, [&](const Row& other) {
                        return same_case(row, other) && competes(other) && beats(other, row);
                    });
    }
}

std::string to_json(const Report& report) {
    const auto& m = report.machine;
    auto rows = Json::array();
    for (const auto& row : report.rows) rows.push_back(row_json(row));
    Json out{{"thaum", report.version},
             {"machine", {{"cpu", m.cpu}, {"cores", m.cores}, {"build", m.build}}}};
    out.set("rows", std::move(rows));
    if (!report.faults.empty()) out.set("faults", report.faults);
    return dump(out, 1) + "\n";
}

std::string to_table(const Report& report) {
    const auto& m = report.machine;
    std::string out = text("thaum ", report.version, ", ", m.build, ", ", m.cpu, ", ", m.cores, " cores\n");
    std::vector<std::string> areas;
    for (const auto& row : report.rows) {
        if (std::ranges::find(areas, row.area) != areas.end()) continue;
        areas.push_back(row.area);
        append_text(out, text("\n", area_table(report, row.area)));
    }
    return out;
}

}  // namespace thaum::bench
