#include "render/pass_times.h"

#include "render/detail/gl.h"

namespace thaum::render {

using Clock = std::chrono::steady_clock;

void PassClock::start() {
    times_ = {};
    if (!on) return;
    glFinish();
    last_ = Clock::now();
}

void PassClock::end(Pass pass) {
    if (!on) return;
    glFinish();
    const auto now = Clock::now();
    times_.ms[static_cast<std::size_t>(pass)] +=
        std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
}

}  // namespace thaum::render
