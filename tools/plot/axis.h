// tools/plot/axis.h: a logarithmic axis from a value to a pixel.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace thaum::plot {

/// Its ends are of the series 1, 2, 5, 10, ... Values from 0 down have no place on it; where there are some, they stand in a
/// margin of their own before the low end.
struct LogAxis {
    double low{}, high{};        ///< decimal logarithms, low < high
    double low_px{}, high_px{};  ///< where these are; low_px may be the larger
    double zero_px{};            ///< where values <= 0 are
    bool has_zero{};

    /// value must be finite.
    double at(double value) const;
};

struct Tick {
    double at_px;
    std::string label;
};

/// From the span of all values, which must be finite.
LogAxis log_axis(std::span<const double> values, double low_px, double high_px);

/// 1, 2, 5, 10 ... where they are few, else powers of ten or of some power of ten; at most 9, and one for 0.
std::vector<Tick> ticks(const LogAxis&);

}  // namespace thaum::plot
