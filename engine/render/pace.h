// render/pace.h: pictures at an even rate. A swap interval does not block everywhere (under Xvfb it never does), so
// the render thread sleeps to an absolute deadline: errors of one sleep do not add up.
#pragma once
#include <cstdint>

namespace thaum::render {

/// The deadline after `previous` at `period` from it; from `now` when that has passed by more than a period, so
/// that a stall is not made up for by a burst. All in ns.
std::int64_t next_deadline(std::int64_t previous, std::int64_t now, std::int64_t period);

class Pacer {
public:
    /// frames_per_second 0 never waits.
    explicit Pacer(double frames_per_second);
    /// Sleeps until the next picture is due; returns the s since the last call's return (0 at first).
    double wait();

private:
    std::int64_t period_{};
    std::int64_t deadline_{};
    std::int64_t last_{};
};

}  // namespace thaum::render
