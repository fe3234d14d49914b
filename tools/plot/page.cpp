#include "tools/plot/page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/file.h"
#include "core/text.h"
#include "tools/plot/figure.h"
#include "tools/plot/markup.h"
#include "tools/plot/svg.h"

namespace thaum::plot {
namespace {

using bench::Row;
using Rows = std::vector<const Row*>;
using Cases = std::map<std::string, Rows>;

constexpr std::string_view head =
    R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>Thaum: a benchmark report</title>
<style>
:root { color-scheme: light dark; }
body { font: 15px/1.45 "DejaVu Sans", Verdana, sans-serif; margin: 2em auto; max-width: 84em; padding: 0 1em;
  background: #ffffff; color: #1b1b1f; }
h2 { margin-top: 2.2em; border-bottom: 1px solid #9a9aa4; }
svg { max-width: 100%; height: auto; }
.scroll { overflow-x: auto; margin: 0.6em 0 1.4em; }
table { border-collapse: collapse; font-size: 13px; }
th, td { padding: 0.2em 0.7em; text-align: right; white-space: nowrap; border-bottom: 1px solid #d8d8de; }
th.word, td.word { text-align: left; }
tr.default td { font-weight: bold; }
@media (prefers-color-scheme: dark) {
  body { background: #17171b; color: #ececf1; }
  a { color: #56b4e9; }
  th, td { border-color: #3a3a42; }
}
</style>
</head>
<body>
)";

struct Cell {
    std::string words;
    bool is_word = false;
};

/// Cell with a number; "-" if the number is not finite.
Cell cell_of(double value) { return {std::isfinite(value) ? bench::shown(value) : "-"}; }

struct Column {
    std::string heading;
    bool is_word = false;
};

// ---- tables -----------------------------------------------------------------------------------------------

/// Columns of one table, in this order: setting, time, error, marks, metrics, hash. Settings and metrics are
/// sorted.
struct Table {
    std::vector<std::string> settings, errors, metrics;
    std::set<std::string> words;  ///< names of settings that are text in some row
    bool has_time = false, has_mark = false, has_hash = false;
};

Table table_of(const Rows& rows) {
    std::set<std::string> settings, errors, metrics;
    Table table;
    for (const Row* row : rows) {
        for (const auto& [name, value] : row->setting) {
            settings.insert(name);
            if (std::holds_alternative<std::string>(value)) table.words.insert(name);
        }
        for (const auto& item : row->metrics) metrics.insert(item.first);
        if (row->error) errors.insert(row->error->name);
        table.has_time = table.has_time || row->time_us;
        table.has_mark = table.has_mark || row->front || row->is_default;
        table.has_hash = table.has_hash || row->hash;
    }
    table.settings.assign(settings.begin(), settings.end());
    table.errors.assign(errors.begin(), errors.end());
    table.metrics.assign(metrics.begin(), metrics.end());
    return table;
}

std::vector<Column> columns_of(const Table& table) {
    std::vector<Column> columns;
    for (const auto& name : table.settings) columns.push_back({name, table.words.contains(name)});
    if (table.has_time) {
        for (const auto* name : {"median us", "min us", "p99 us"}) columns.push_back({name});
    }
    for (const auto& name : table.errors) columns.push_back({name});
    if (table.has_mark) columns.push_back({"mark", true});
    for (const auto& name : table.metrics) columns.push_back({name});
    if (table.has_hash) columns.push_back({"hash", true});
    return columns;
}

std::string mark_of(const Row& row) {
    if (row.front && row.is_default) return "front, default";
    return row.front ? "front" : row.is_default ? "default" : "";
}

/// Cell with the value of the setting or metric of this name; an empty cell if the row has none.
template <class Items, class Show>
Cell found(const Items& items, const std::string& name, const Show& show) {
    const auto at = std::ranges::find(items, name, [](const auto& item) { return item.first; });
    return at == items.end() ? Cell{} : show(at->second);
}

std::vector<Cell> cells_of(const Row& row, const Table& table) {
    std::vector<Cell> cells;
    for (const auto& name : table.settings) {
        auto cell = found(row.setting, name, [](const bench::Value& v) { return Cell{bench::shown(v)}; });
        cell.is_word = table.words.contains(name);
        cells.push_back(std::move(cell));
    }
    if (table.has_time) {
        const auto& t = row.time_us;
        for (const auto time : {&bench::Times::median, &bench::Times::min, &bench::Times::p99})
            cells.push_back(t ? cell_of((*t).*time) : Cell{});
    }
    for (const auto& name : table.errors)
        cells.push_back(row.error && row.error->name == name ? cell_of(row.error->value) : Cell{});
    if (table.has_mark) cells.push_back({mark_of(row), true});
    for (const auto& name : table.metrics) cells.push_back(found(row.metrics, name, cell_of));
    if (table.has_hash) cells.push_back({row.hash.value_or(""), true});
    return cells;
}

std::string html_cell(std::string_view tag, const std::string& words, bool is_word) {
    return text("<", tag, is_word ? " class=\"word\">" : ">", escaped(words), "</", tag, ">");
}

std::string html_table(const Rows& rows) {
    const Table table = table_of(rows);
    std::string out = "<div class=\"scroll\"><table>\n<tr>";
    for (const auto& column : columns_of(table))
        append_text(out, html_cell("th", column.heading, column.is_word));
    out += "</tr>\n";
    for (const Row* row : rows) {
        out += row->is_default ? "<tr class=\"default\">" : "<tr>";
        for (const auto& cell : cells_of(*row, table))
            append_text(out, html_cell("td", cell.words, cell.is_word));
        out += "</tr>\n";
    }
    return out + "</table></div>\n";
}

// ---- figures ----------------------------------------------------------------------------------------------

/// File name made of words: only lower-case letters, digits, '-' and '_'.
std::string safe_name(std::string_view words) {
    constexpr std::size_t longest = 100;
    std::string out;
    for (const char c : words.substr(0, longest)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
        const bool capital = c >= 'A' && c <= 'Z';
        out += plain ? c : capital ? static_cast<char>(c - 'A' + 'a') : '_';
    }
    return out;
}

/// Collects the figures and their files while the page is written.
class Figures {
public:
    explicit Figures(Page& page) : page_(page) {}

    template <class Figure>
    std::string add(std::string_view name, const Figure& figure) {
        if (page_.figures.size() == max_figures) {
            ++page_.not_drawn;
            return {};
        }
        page_.figures.push_back({unused(safe_name(name)), to_svg(figure)});
        return text("<figure>\n", page_.figures.back().svg, "</figure>\n");
    }

private:
    /// A file name that no other figure has. Two names may become equal when they are made safe.
    std::string unused(const std::string& name) {
        auto file = text(name, ".svg");
        for (int n = 2; !names_.insert(file).second; ++n) file = text(name, "-", n, ".svg");
        return file;
    }

    Page& page_;
    std::set<std::string> names_;
};

// ---- the page ---------------------------------------------------------------------------------------------

/// Time for sorting; rows without a time come last, in the report's order.
double time_of(const Row* row) {
    return row->time_us && std::isfinite(row->time_us->median) ? row->time_us->median : HUGE_VAL;
}

std::map<std::string, Cases> sorted(const bench::Report& report) {
    std::map<std::string, Cases> areas;
    for (const Row& row : report.rows) areas[row.area][row.name].push_back(&row);
    for (auto& area : areas) {
        for (auto& one : area.second) std::ranges::stable_sort(one.second, {}, time_of);
    }
    return areas;
}

std::string case_html(const std::string& area, const std::string& name, const Rows& rows, Figures& figures) {
    std::string out = text("<h3>", escaped(name), "</h3>\n");
    for (const auto& figure : front_figures(rows))
        append_text(out, figures.add(text(area, "-", name, "-", figure.error_name), figure));
    return text(out, html_table(rows));
}

std::string area_html(const std::string& area, const Cases& cases, std::size_t index, Figures& figures) {
    Rows all;
    for (const auto& one : cases) all.insert(all.end(), one.second.begin(), one.second.end());
    std::string out = text("<h2 id=\"area", index, "\">", escaped(area), "</h2>\n");
    for (const auto& figure : ratio_figures(all)) append_text(out, figures.add(figure.title, figure));
    for (const auto& [name, rows] : cases) append_text(out, case_html(area, name, rows, figures));
    return out;
}

std::string opening(const bench::Report& report, const std::map<std::string, Cases>& areas) {
    const auto& m = report.machine;
    std::string out = text("<h1>Thaum ", escaped(report.version), "</h1>\n<p>", escaped(m.build), ", ",
                           escaped(m.cpu), ", ", m.cores, " cores; ", report.rows.size(), " rows.</p>\n<p>");
    std::size_t index = 0;
    for (const auto& area : areas) {
        append_text(out, text("<a href=\"#area", index++, "\">", escaped(area.first), "</a> "));
    }
    return out + "</p>\n";
}

}  // namespace

Page make_page(const bench::Report& report) {
    const auto areas = sorted(report);
    Page page;
    Figures figures(page);
    std::string body;
    std::size_t index = 0;
    for (const auto& [area, cases] : areas) append_text(body, area_html(area, cases, index++, figures));
    if (page.not_drawn > 0)
        append_text(body, text("<p>", page.not_drawn, " more figures are not drawn.</p>\n"));
    page.html = text(head, opening(report, areas), body, "</body>\n</html>\n");
    return page;
}

Expected<void> write_page(const Page& page, const std::filesystem::path& folder) {
    if (auto made = make_folder(folder); !made) return made;
    if (auto free = check_output(folder / "index.html"); !free) return free;
    for (const auto& figure : page.figures) {
        if (auto free = check_output(folder / figure.name); !free) return free;
    }
    for (const auto& figure : page.figures) {
        if (auto written = write_text_file(folder / figure.name, figure.svg); !written) return written;
    }
    return write_text_file(folder / "index.html", page.html);
}

}  // namespace thaum::plot
