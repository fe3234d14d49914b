// render/pace.h: draws pictures at an even rate. A swap interval does not block everywhere (under Xvfb it
// never does). The render thread therefore sleeps until an absolute deadline, so the errors of single sleeps
// do not add up.
#pragma once
#include <cstdint>

namespace thaum::render {

/// Returns the next deadline, one `period` after `previous` (ns). If that is more than a period in the past,
/// returns `now`, so that no burst of pictures follows a stall.
std::int64_t next_deadline(std::int64_t previous, std::int64_t now, std::int64_t period);

/// Waits between pictures so that they come at an even rate.
class Pacer {
public:
    /// At a rate of 0, wait() never sleeps.
    explicit Pacer(double frames_per_second);
    /// Sleeps until the next picture is due. Returns the time since the last call returned, 0 at first (s).
    double wait();

private:
    std::int64_t period_{};
    std::int64_t deadline_{};
    std::int64_t last_{};
};

}  // namespace thaum::render
