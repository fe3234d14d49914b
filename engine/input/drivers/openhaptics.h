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
#pragma once
#include <memory>
#include <string>

#include "core/error.h"
#include "input/arm.h"
#include "input/tick_times.h"

namespace thaum::input {

class OpenHaptics {
public:
    /// Loads the library, opens the default arm, starts its thread and calibrates it. library: file or path; empty: what
    /// $THAUM_LIBHD says, else libHD.so. The error says what to do: no library, one that is too old, no arm, no permission, no
    /// calibration.
    static Expected<std::unique_ptr<OpenHaptics>> open(const std::string& library = {});

    OpenHaptics(const OpenHaptics&) = delete;
    OpenHaptics& operator=(const OpenHaptics&) = delete;
    /// Leaves the arm without force, and ends its thread.
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
    explicit OpenHaptics(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace thaum::input
