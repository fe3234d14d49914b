#include "tools/bench/measure.h"

#include <algorithm>
#include <cmath>

#include "core/clock.h"

namespace thaum::bench {
namespace {

double sample(const Contestant& contestant, std::size_t calls) {
    if (contestant.setup) contestant.setup();
    const double start = now_us();
    for (std::size_t i = 0; i < calls; ++i) contestant.run();
    return (now_us() - start) / static_cast<double>(calls);
}

}  // namespace

double now_us() { return 1e-3 * static_cast<double>(monotonic_ns()); }

double us_of(const std::function<void()>& run) {
    const double start = now_us();
    run();
    return now_us() - start;
}

std::vector<std::vector<double>> measure(std::span<const Contestant> contestants, const Plan& plan) {
    std::vector<std::vector<double>> result(contestants.size());
    for (const auto& contestant : contestants) sample(contestant, plan.calls);
    const double start = now_us();
    for (std::size_t round = 0; round < plan.most; ++round) {
        if (round >= plan.least && now_us() - start > plan.seconds * 1e6) break;
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            const auto who = (round + i) % contestants.size();
            result[who].push_back(sample(contestants[who], plan.calls));
        }
    }
    return result;
}

double percentile(std::vector<double> samples, double p) {
    const auto rank = std::ceil(p * static_cast<double>(samples.size()));
    const auto index = rank < 1 ? std::size_t{0} : static_cast<std::size_t>(rank) - 1;
    const auto at = samples.begin() + static_cast<std::ptrdiff_t>(std::min(index, samples.size() - 1));
    std::nth_element(samples.begin(), at, samples.end());
    return *at;
}

Times times(const std::vector<double>& samples) {
    return {percentile(samples, 0), percentile(samples, 0.5), percentile(samples, 0.99)};
}

double ratio(std::span<const double> a, std::span<const double> b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) ratios.push_back(a[i] / b[i]);
    return median(std::move(ratios));
}

}  // namespace thaum::bench
