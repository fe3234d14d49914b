// input/detail/hd_ticks.h: the ticks of an arm, called by the vendor's library at 1 kHz. The library may call at any time: twice at once,
// from inside one of its own functions, after it was told to stop. So what it is given is a number and no address, and a call whose
// number is not that of the open arm does nothing.
#pragma once
#include <array>
#include <atomic>
#include <memory>

#include "input/arm.h"
#include "input/detail/hd_api.h"
#include "input/tick_times.h"

namespace thaum::input::hd {

/// One arm's ticks, from `open` until `close`.
struct Ticks {
    const Api* api{};
    Handle handle{invalid_handle};
    double peak_force{};  ///< N
    ArmTick tick{};
    std::uint64_t number{};  ///< of the opened arm in this process, from 1
    TickTimes times{};
    std::array<char, 96> error_said{};  ///< the library's name of `code`; written before that
    std::atomic<unsigned int> code{0};  ///< the error that ended the ticks
    std::atomic<bool> accepted{false};  ///< the library has taken them up; before, they give no force
    std::atomic<bool> ending{false};    ///< the next tick is the last
    std::atomic<bool> ended{false};
    std::atomic<bool> without_force{false};  ///< the ticks have ended, and the library took their last zero
    std::atomic<bool> preferred{false};
    std::atomic<bool> silent{false};  ///< the newest tick gave no force, since it shall; none runs
};

/// Makes these the ticks that count. Only one arm's do.
void open_ticks(Ticks& ticks);

/// For hdScheduleAsynchronous: the function, and its argument for these ticks.
unsigned int run_tick(void* number);
void* argument_of(const Ticks& ticks);

/// After it the step of the ticks is never called again, whatever the library does. False where the library hangs within a tick: then
/// the ticks must live on for ever.
bool close_ticks(Ticks& ticks);

}  // namespace thaum::input::hd
