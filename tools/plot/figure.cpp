#include "tools/plot/figure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/text.h"

namespace thaum::plot {
namespace {

using bench::Row;
using Rows = std::vector<const Row*>;

bool can_be_drawn(const Row& row) {
    return row.time_us && row.error && std::isfinite(row.time_us->median) && std::isfinite(row.error->value);
}

std::string item_text(const std::pair<std::string, bench::Value>& item) {
    return text(item.first, " ", bench::shown(item.second));
}

/// Names of the settings that differ between rows.
std::set<std::string> varying(const Rows& rows) {
    std::map<std::string, std::map<std::string, std::size_t>> seen;
    for (const Row* row : rows) {
        for (const auto& item : row->setting) ++seen[item.first][bench::shown(item.second)];
    }
    std::set<std::string> names;
    for (const auto& [name, values] : seen) {
        if (values.size() > 1 || values.begin()->second < rows.size()) names.insert(name);
    }
    return names;
}

/// Text of those settings of a row that are words (they name the series), or of those that are numbers (they
/// distinguish the points of a series).
std::string part_of(const Row& row, const std::set<std::string>& names, bool words) {
    std::string out;
    for (const auto& item : row.setting) {
        const auto* word = std::get_if<std::string>(&item.second);
        if ((word != nullptr) != words || !names.contains(item.first)) continue;
        if (!out.empty()) out += ", ";
        out += words ? *word : item_text(item);
    }
    return out;
}

std::string tooltip_of(const Row& row) {
    return text(setting_text(row), ": ", bench::shown(row.time_us->median), " us, ", row.error->name, " ",
                bench::shown(row.error->value), row.front ? ", on the front" : "",
                row.is_default ? ", default" : "");
}

/// Names of the series, sorted; one empty name if there are too many series.
std::vector<std::string> series_of(const Rows& rows, const std::set<std::string>& names) {
    std::set<std::string> series;
    for (const Row* row : rows) series.insert(part_of(*row, names, true));
    if (series.size() > max_series) return {""};
    return {series.begin(), series.end()};
}

Point point_of(const Row& row, const std::set<std::string>& names, const std::vector<std::string>& series) {
    const auto found = std::ranges::find(series, part_of(row, names, true));
    return {.time_us = row.time_us->median,
            .error = row.error->value,
            .label = part_of(row, names, false),
            .tooltip = tooltip_of(row),
            .series = found == series.end() ? 0 : static_cast<std::size_t>(found - series.begin()),
            .front = row.front,
            .is_default = row.is_default};
}

FrontFigure front_figure(const std::string& error_name, const Rows& rows) {
    const auto names = varying(rows);
    FrontFigure figure{rows.front()->name, error_name, series_of(rows, names), {}};
    for (const Row* row : rows) figure.points.push_back(point_of(*row, names, figure.series));
    std::ranges::stable_sort(figure.points, {}, &Point::time_us);
    return figure;
}

std::string bar_label(const Row& row) {
    const auto setting = setting_text(row);
    return setting.empty() ? row.name : text(row.name, ": ", setting);
}

}  // namespace

std::string setting_text(const Row& row) {
    std::string out;
    for (const auto& item : row.setting) {
        if (!out.empty()) out += ", ";
        out += item_text(item);
    }
    return out;
}

std::vector<FrontFigure> front_figures(std::span<const Row* const> rows) {
    std::map<std::string, Rows> by_error;
    for (const Row* row : rows) {
        if (can_be_drawn(*row)) by_error[row->error->name].push_back(row);
    }
    std::vector<FrontFigure> figures;
    for (const auto& [name, those] : by_error) figures.push_back(front_figure(name, those));
    return figures;
}

std::vector<RatioFigure> ratio_figures(std::span<const Row* const> rows) {
    std::map<std::string, RatioFigure> by_metric;
    for (const Row* row : rows) {
        if (row->error) continue;
        for (const auto& [name, value] : row->metrics) {
            if (!name.starts_with("ratio_to_") || !std::isfinite(value) || value <= 0) continue;
            auto& figure = by_metric[name];
            figure.title = text(row->area, ": ", name);
            if (figure.bars.size() == max_bars) {
                ++figure.left_out;
            } else {
                figure.bars.push_back({bar_label(*row), value});
            }
        }
    }
    std::vector<RatioFigure> figures;
    for (auto& item : by_metric) figures.push_back(std::move(item.second));
    return figures;
}

}  // namespace thaum::plot
