// tools/plot/figure.h: figures of a benchmark report. Cases with errors get figures of run time against
// error; other cases get bars for their ratios.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "tools/bench/report.h"

namespace thaum::plot {

/// One point of a FrontFigure: a row of the report.
struct Point {
    double time_us{};
    double error{};
    std::string label;     ///< those numbers in the row's setting that differ within the figure, as text
    std::string tooltip;   ///< the whole setting, time and error
    std::size_t series{};  ///< index of the point's series in FrontFigure::series
    bool front{};
    bool is_default{};
};

/// Run time against error for one case.
struct FrontFigure {
    std::string title;
    std::string error_name;
    /// Names of the series. A series has the rows with equal settings, as far as these are words and not
    /// numbers. One empty name if there are too many series.
    std::vector<std::string> series;
    std::vector<Point> points;  ///< points of the figure, sorted by time
};

struct Bar {
    std::string label;
    double ratio{};  ///< ratio in the row, above 0
};

/// Bars for one metric `ratio_to_...` of one area (group of benchmarks).
struct RatioFigure {
    std::string title;
    std::vector<Bar> bars;
    std::size_t left_out{};  ///< number of bars for which the figure has no room
};

inline constexpr std::size_t max_series = 6;
inline constexpr std::size_t max_bars = 60;

/// Text of a setting: "solver thaum, n 32".
std::string setting_text(const bench::Row&);

/// Figures for the rows of one case: one for each name of an error. Rows without a finite time and error are
/// left out.
std::vector<FrontFigure> front_figures(std::span<const bench::Row* const> rows);

/// Figures with bars for the rows of one area (group of benchmarks) that have no error.
std::vector<RatioFigure> ratio_figures(std::span<const bench::Row* const> rows);

}  // namespace thaum::plot
