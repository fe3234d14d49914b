// game/jackets/makers/hid.h: a jacket of 40 motors that takes HID reports
// (game/jackets/hid_report.h) by USB or Bluetooth.
//
// A report is sent when it has changed, and again after half of the time for which a frame (the amplitudes of
// all motors at one moment) holds. Only an interface with a maker-defined usage page is opened, so no
// keyboard gets reports by mistake. A device that takes longer than 100 ms for a report gets one report with
// all motors off and is closed, because its motors would run too late.
#pragma once
#include <functional>
#include <memory>

#include "game/jackets/hid_port.h"
#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

/// Returns the time of a clock that never jumps (s).
using ClockSeconds = std::function<double()>;
double steady_seconds();

/// Output to a HID jacket. Tests pass a fake device in `open` and a clock of their own in `clock`.
std::unique_ptr<input::TactileOutput> hid_jacket(const HidId& id, OpenHidPort open = open_hid_port,
                                                 ClockSeconds clock = steady_seconds);

}  // namespace thaum::game::inline jackets
