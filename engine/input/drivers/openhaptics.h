// input/drivers/openhaptics.h: arms of the Phantom class (Touch, Omni, Premium) through the vendor's libHD.so, which is looked
// for when it is wanted, never linked. The declarations are our own, from documented constants and signatures of its C
// functions; what we hold to be its rules, tests/drivers/fake_hd enforces.
//
//     auto arm = OpenHaptics::open();            // or one line that says what to do
//     (*arm)->start({step, &context});           // step is called at 1 kHz in the library's thread
//     (*arm)->status();                          // present, lost, fault
//
// The library has its own thread and calls us: that is the servo thread. It holds one arm; a second `open` while one is open is
// an error. It is never unloaded: it does not bear to be loaded twice.
//
// The library is not trusted. Calls that never return are given up after a limit; ticks that do not come are a loss; ticks that come
// when they should not do nothing (input/detail/hd_ticks.h); and what it says is checked before it is shown or used.
#pragma once
#include <atomic>
#include <memory>
#include <string>

#include "core/error.h"
#include "input/arm.h"
#include "input/tick_times.h"

namespace thaum::input {

/// How long a library may take before it is said to hang.
struct ArmPatience {
    std::int64_t open_ns = 15'000'000'000;  ///< all that is done to find an arm, or to start its ticks
    std::int64_t close_ns = 3'000'000'000;  ///< all that is done to let go of it
    const std::atomic<bool>*
        enough{};  ///< true: somebody wants to end, so waiting to open ends at once; null: nobody
};

class OpenHaptics {
public:
    /// Loads the library, opens the default arm, starts its thread and calibrates it. library: file or path; empty: what
    /// $THAUM_LIBHD says, else libHD.so. The error says what to do: no library, one that is too old, no arm, no permission, no
    /// calibration.
    static Expected<std::unique_ptr<OpenHaptics>> open(const std::string& library = {},
                                                       const ArmPatience& patience = {});
    /// Whether a call of the library has not returned. Then the program must end by _Exit: the library's own clearing up may hang, too.
    static bool hangs();

    OpenHaptics(const OpenHaptics&) = delete;
    OpenHaptics& operator=(const OpenHaptics&) = delete;
    /// Leaves the arm without force, and ends its thread. The step of its ticks is never called again.
    ~OpenHaptics();

    const ArmFacts& facts() const;

    /// From now on `tick` is called at 1 kHz. Once only.
    Expected<void> start(ArmTick tick);
    /// Any thread. After lost or fault no more ticks come.
    ArmStatus status() const;
    TickReport times() const;
    /// Whether the system let the arm's thread go before others (SCHED_FIFO); not before the first tick.
    bool preferred() const;

private:
    struct State;
    explicit OpenHaptics(std::shared_ptr<State> state);
    std::shared_ptr<State> state_;  ///< shared with the threads that call the library
};

}  // namespace thaum::input
