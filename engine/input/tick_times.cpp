#include "input/tick_times.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace thaum::input {
namespace {

/// Adds to a counter. Only one thread writes, so load and store need not be one operation.
template <class T>
void raise(std::atomic<T>& count, T by) {
    count.store(count.load(std::memory_order_relaxed) + by, std::memory_order_relaxed);
}

}  // namespace

void TimeCounts::add(std::int64_t ns) {
    const auto us = static_cast<std::size_t>(std::max<std::int64_t>(ns, 0) / 1000);
    raise(counts_[std::min(us, range - 1)], std::uint32_t{1});
    if (ns > worst_ns_.load(std::memory_order_relaxed)) worst_ns_.store(ns, std::memory_order_relaxed);
}

double TimeCounts::at(double share) const {
    std::uint64_t all = 0;
    for (const auto& count : counts_) all += count.load(std::memory_order_relaxed);
    if (all == 0) return 0;
    auto left = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(all)));
    for (std::size_t us = 0; us + 1 < range; ++us) {
        const std::uint64_t here = counts_[us].load(std::memory_order_relaxed);
        if (here >= left) return static_cast<double>(us);
        left -= here;
    }
    return worst();
}

void TickTimes::begins(std::int64_t now_ns) {
    const auto before = began_ns_.load(std::memory_order_relaxed);
    began_ns_.store(now_ns, std::memory_order_relaxed);
    raise(ticks_, std::uint64_t{1});
    if (before == 0) return;
    const auto interval = now_ns - before;
    jitter_.add(std::abs(interval - period_ns_));
    const auto periods = (interval + period_ns_ / 2) / period_ns_;
    if (periods > 1) raise(missed_, static_cast<std::uint64_t>(periods - 1));
}

void TickTimes::ends(std::int64_t now_ns) { answer_.add(now_ns - newest_ns()); }

TickReport TickTimes::report() const {
    return {.ticks = ticks_.load(std::memory_order_relaxed),
            .missed = missed_.load(std::memory_order_relaxed),
            .jitter_median = jitter_.at(0.5),
            .jitter_p99 = jitter_.at(0.99),
            .jitter_worst = jitter_.worst(),
            .answer_median = answer_.at(0.5),
            .answer_p99 = answer_.at(0.99),
            .answer_worst = answer_.worst()};
}

std::vector<std::pair<std::string, double>> metrics_of(const TickReport& times) {
    return {{"ticks", static_cast<double>(times.ticks)}, {"missed", static_cast<double>(times.missed)},
            {"jitter_us_median", times.jitter_median},   {"jitter_us_p99", times.jitter_p99},
            {"jitter_us_worst", times.jitter_worst},     {"pose_to_force_us_median", times.answer_median},
            {"pose_to_force_us_p99", times.answer_p99},  {"pose_to_force_us_worst", times.answer_worst}};
}

}  // namespace thaum::input
