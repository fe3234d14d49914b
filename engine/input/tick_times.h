// input/tick_times.h: timing of a device's thread, measured by that thread without a lock: how evenly its
// ticks come, how many are missed, and the time from a measurement to the force that answers it.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace thaum::input {

/// Histogram of durations in whole microseconds. One thread adds; any thread may read.
class TimeCounts {
public:
    /// Adds one duration to the histogram.
    void add(std::int64_t ns);
    /// Duration that a share (0 to 1) of all durations does not exceed (us). A duration beyond the range
    /// counts as the longest one. Returns 0 if there is none yet.
    double at(double share) const;
    /// Longest duration (us).
    double worst() const { return static_cast<double>(worst_ns_.load(std::memory_order_relaxed)) * 1e-3; }

private:
    static constexpr std::size_t range = 4096;
    /// Element i is the number of durations of i microseconds. The last element counts all longer ones, too.
    std::array<std::atomic<std::uint32_t>, range> counts_{};
    std::atomic<std::int64_t> worst_ns_{0};
};

/// Statistics of the times of a device's ticks (us).
struct TickReport {
    std::uint64_t ticks{};
    std::uint64_t missed{};  ///< number of periods that passed without a tick
    /// Absolute difference between tick interval and period: median, 99th percentile and largest (us).
    double jitter_median{}, jitter_p99{}, jitter_worst{};
    /// Time from the measurement of the pose to the force handed to the device: median, 99th percentile and
    /// largest (us).
    double answer_median{}, answer_p99{}, answer_worst{};
};

/// Statistics of a report with their names, which contain the unit.
std::vector<std::pair<std::string, double>> metrics_of(const TickReport& times);

/// Measures tick times. One thread records; any thread may ask for the report.
class TickTimes {
public:
    explicit TickTimes(std::int64_t period_ns = 1'000'000) : period_ns_(period_ns) {}

    /// Records the start of a tick, which is also the time of its measurement.
    void begins(std::int64_t now_ns);
    /// Records that the tick's force was handed to the device.
    void ends(std::int64_t now_ns);
    /// Start of the newest tick (ns); 0: none.
    std::int64_t newest_ns() const { return began_ns_.load(std::memory_order_relaxed); }
    /// Summary of all ticks so far.
    TickReport report() const;

private:
    std::int64_t period_ns_;
    TimeCounts jitter_, answer_;
    std::atomic<std::int64_t> began_ns_{0};
    std::atomic<std::uint64_t> ticks_{0}, missed_{0};
};

}  // namespace thaum::input
