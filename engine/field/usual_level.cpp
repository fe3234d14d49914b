#include <algorithm>
#include <array>
#include <cmath>

#include "field/volume.h"

namespace thaum::field {
namespace {

constexpr std::size_t classes = 256;
constexpr double nearly_best = 1 - 1e-3;

/// Calls use(value) for each finite sample, or for the length of each vector.
template <class Use>
void for_each_value(const Volume& volume, Use use) {
    const auto step = static_cast<std::size_t>(volume.components);
    volume.samples.visit([&](const auto& samples) {
        for (std::size_t at = 0; at + step <= samples.size(); at += step) {
            const auto* sample = &samples[at];
            const double value =
                step == 3 ? glm::length(vec3(sample[0], sample[1], sample[2])) : static_cast<double>(*sample);
            if (std::isfinite(value)) use(value);
        }
    });
}

/// For each class (an interval of values), how well a level at its upper end would separate the samples: the
/// variance between the group of classes up to it and the group above it, times a constant factor. The value
/// of a class is its index.
std::array<double, classes> variances(const std::array<double, classes>& counts) {
    double all = 0, sum = 0;
    for (std::size_t i = 0; i < classes; ++i) {
        all += counts[i];
        sum += counts[i] * static_cast<double>(i);
    }
    std::array<double, classes> result{};
    double below = 0, sum_below = 0;
    for (std::size_t i = 0; i + 1 < classes; ++i) {
        below += counts[i];
        sum_below += counts[i] * static_cast<double>(i);
        const double above = all - below;
        if (!(below > 0 && above > 0)) continue;
        const double apart = sum_below / below - (sum - sum_below) / above;
        result[i] = below * above * apart * apart;
    }
    return result;
}

}  // namespace

double usual_level(const Volume& volume) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for_each_value(volume, [&](double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    });
    if (!(high > low)) return high == low ? low : 0;
    const double width = (high - low) / classes;
    std::array<double, classes> counts{};
    for_each_value(volume, [&](double value) {
        const double at = (value - low) / width;
        ++counts[std::min(static_cast<std::size_t>(at), classes - 1)];
    });
    const auto found = variances(counts);
    const double least = nearly_best * *std::ranges::max_element(found);
    std::size_t first = 0, last = classes - 1;
    while (found[first] < least) ++first;
    while (found[last] < least) --last;
    return low + width * (0.5 * static_cast<double>(first + last) + 1);
}

}  // namespace thaum::field
