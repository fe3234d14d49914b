#include "input/detail/stall_watch.h"

#include "core/clock.h"

namespace thaum::input {

void watch_for_stalls(ArmTicks& ticks, AtHang at_hang, const std::function<void()>& give_up) {
    // Priority above the servo thread's, because a driver that hangs in a loop may take a whole core.
    constexpr int above_the_servo = 51;
    prefer_this_thread(above_the_servo);
    std::uint64_t done = 0;
    int looks = 0;
    while (!ticks.unwatched && !ticks.ended) {
        sleep_until_ns(monotonic_ns() + stall_look_ns);
        const auto ticks_done = ticks.done.load();
        looks = ticks_done == done ? looks + 1 : 0;
        done = ticks_done;
        if (looks < stall_looks || !ticks.pushes) continue;
        if (at_hang == AtHang::write_zero) {
            ticks.stalled = true;  // set before the zero is sent, so that the next tick ramps its force up
            ticks.driver->write_zero();
        } else {
            give_up();
            looks = 0;
        }
    }
}

}  // namespace thaum::input
