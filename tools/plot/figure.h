// tools/plot/figure.h: what of a report can be drawn: time against error where there is an error, else ratios.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "tools/bench/report.h"

namespace thaum::plot {

/// One row in a FrontFigure.
struct Point {
    double time_us{};
    double error{};
    std::string label;     ///< the numbers in its setting that are not the same in the whole figure
    std::string tooltip;   ///< its whole setting, time and error
    std::size_t series{};  ///< index in FrontFigure::series
    bool front{};
    bool is_default{};
};

/// Run time against error of one case.
struct FrontFigure {
    std::string title;
    std::string error_name;
    std::vector<std::string>
        series;  ///< the words in the settings; one without a name where there are too many to tell apart
    std::vector<Point> points;  ///< by time
};

struct Bar {
    std::string label;
    double ratio{};  ///< > 0
};

/// One `ratio_to_...` of one area.
struct RatioFigure {
    std::string title;
    std::vector<Bar> bars;
    std::size_t left_out{};  ///< bars beyond what fits
};

inline constexpr std::size_t most_series = 6;
inline constexpr std::size_t most_bars = 60;

/// "solver thaum, n 32".
std::string setting_text(const bench::Row&);

/// Of the rows of one case: one figure for each name of an error. Rows without a finite time and error are in none.
std::vector<FrontFigure> front_figures(std::span<const bench::Row* const> rows);

/// Of the rows of one area that have no error.
std::vector<RatioFigure> ratio_figures(std::span<const bench::Row* const> rows);

}  // namespace thaum::plot
