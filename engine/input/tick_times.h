// input/tick_times.h: how well a device's thread keeps time, measured by that thread itself without a lock: how evenly its ticks
// come, how many are missed, and how long it takes from a measurement to the force that answers it.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace thaum::input {

/// Counts of whole microseconds. One thread adds, any may ask.
class TimeCounts {
public:
    void add(std::int64_t ns);
    /// us below or at which this share (0 to 1) of all lies; what is beyond the range counts as the worst. 0: nothing yet.
    double at(double share) const;
    double worst() const { return static_cast<double>(worst_ns_.load(std::memory_order_relaxed)) * 1e-3; }

private:
    static constexpr std::size_t range = 4096;
    std::array<std::atomic<std::uint32_t>, range> counts_{};  ///< the last: as long or longer
    std::atomic<std::int64_t> worst_ns_{0};
};

/// In us.
struct TickReport {
    std::uint64_t ticks{};
    std::uint64_t missed{};                                ///< periods that passed without a tick
    double jitter_median{}, jitter_p99{}, jitter_worst{};  ///< between two ticks: how far from the period
    double answer_median{}, answer_p99{}, answer_worst{};  ///< from the measurement to the force handed over
};

/// With names that carry the unit.
std::vector<std::pair<std::string, double>> metrics_of(const TickReport& times);

/// One thread tells; any may ask for the report.
class TickTimes {
public:
    explicit TickTimes(std::int64_t period_ns = 1'000'000) : period_ns_(period_ns) {}

    /// A tick begins, that is, measures.
    void begins(std::int64_t now_ns);
    /// Its force was handed over.
    void ends(std::int64_t now_ns);
    /// When the newest tick began; 0: none has.
    std::int64_t newest_ns() const { return began_ns_.load(std::memory_order_relaxed); }
    TickReport report() const;

private:
    std::int64_t period_ns_;
    TimeCounts jitter_, answer_;
    std::atomic<std::int64_t> began_ns_{0};
    std::atomic<std::uint64_t> ticks_{0}, missed_{0};
};

}  // namespace thaum::input
