// tools/plot/axis.h: a logarithmic axis that maps values to pixels.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace thaum::plot {

/// A logarithmic axis. Both ends are numbers of the series 1, 2, 5, 10, ... Values <= 0 have no place on a
/// logarithmic axis; they are drawn in a margin before the low end.
struct LogAxis {
    double low{}, high{};        ///< decimal logarithms of the ends, low < high
    double low_px{}, high_px{};  ///< pixels at which the axis ends; low_px may be the larger
    double zero_px{};            ///< pixel at which values <= 0 are drawn
    bool has_zero{};

    /// Pixel of a value, which must be finite.
    double at(double value) const;
};

struct Tick {
    double at_px;
    std::string label;
};

/// Axis for all values, which must be finite.
LogAxis log_axis(std::span<const double> values, double low_px, double high_px);

/// Ticks at 1, 2, 5, 10 ... if there are few of them; otherwise at every power of ten, or at every second,
/// third or further power. At most 9, and one for 0.
std::vector<Tick> ticks(const LogAxis&);

}  // namespace thaum::plot
