// Axis ends and ticks are counted in steps of the series 1, 2, 5: step 0 is 1, step 1 is 2, step 2 is 5, step
// 3 is 10, step -1 is 0.5. So no value is ever computed from a rounded logarithm.
#include "tools/plot/axis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.h"
#include "tools/bench/report.h"

namespace thaum::plot {
namespace {

constexpr std::array mantissas{1, 2, 5};
constexpr int max_ticks = 9;
constexpr double zero_margin_px = 26;
constexpr double hair = 1e-9;  ///< tolerance (decades): a value this near to a step counts as equal to it

int exponent_of(int step) { return static_cast<int>(std::floor(step / 3.0)); }
int mantissa_of(int step) { return mantissas.at(static_cast<std::size_t>(step - 3 * exponent_of(step))); }
double log_of(int step) { return exponent_of(step) + std::log10(mantissa_of(step)); }

/// Highest step that is not above the value; `log` is its decimal logarithm.
int step_below(double log) {
    int step = 3 * static_cast<int>(std::floor(log + hair));
    while (log_of(step + 1) <= log + hair) ++step;
    return step;
}

int step_above(double log) {
    const int step = step_below(log);
    return log_of(step) >= log - hair ? step : step + 1;
}

std::string label_of(int step) {
    const int exponent = exponent_of(step);
    if (exponent < -3 || exponent > 3) return text(mantissa_of(step), "e", exponent);
    return bench::shown(mantissa_of(step) * std::pow(10.0, exponent));
}

int stride_of(int first, int last) {
    if (last - first < max_ticks) return 1;
    int stride = 3;
    while ((last - first) / stride >= max_ticks) stride += 3;
    return stride;
}

}  // namespace

double LogAxis::at(double value) const {
    if (value <= 0) return zero_px;
    return low_px + (std::log10(value) - low) / (high - low) * (high_px - low_px);
}

LogAxis log_axis(std::span<const double> values, double low_px, double high_px) {
    double least = HUGE_VAL, most = 0;
    for (const double value : values) {
        if (value > 0) least = std::min(least, value);
        most = std::max(most, value);
    }
    if (most == 0) least = most = 1;
    int first = step_below(std::log10(least)), last = step_above(std::log10(most));
    if (first == last) --first, ++last;
    const bool has_zero = std::ranges::any_of(values, [](double v) { return v <= 0; });
    const double inward = high_px > low_px ? zero_margin_px : -zero_margin_px;
    return {.low = log_of(first),
            .high = log_of(last),
            .low_px = has_zero ? low_px + inward : low_px,
            .high_px = high_px,
            .zero_px = low_px + inward / 3,
            .has_zero = has_zero};
}

std::vector<Tick> ticks(const LogAxis& axis) {
    const int first = step_below(axis.low), last = step_below(axis.high);
    const int stride = stride_of(first, last);
    std::vector<Tick> result;
    if (axis.has_zero) result.push_back({axis.zero_px, "0"});
    for (int step = first; step <= last; ++step) {
        // Ticks that are whole decades apart start at a power of ten.
        if (step % stride != 0 && stride > 1) continue;
        const double along = (log_of(step) - axis.low) / (axis.high - axis.low);
        result.push_back({axis.low_px + along * (axis.high_px - axis.low_px), label_of(step)});
    }
    return result;
}

}  // namespace thaum::plot
