// game/jackets/hid_jacket.h: a jacket of 40 motors that takes HID reports (hid_report.h) by USB or Bluetooth.
//
// A report goes out when it has changed, and after half of the frame's time to live. Only an interface of the device
// with reports of its maker's own kind is opened, so no keyboard gets one by mistake. A device that takes longer than
// 100 ms for a report gets one of silence and is closed: what it would play would come too late.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "input/tactile_output.h"

namespace thaum::app {

/// The numbers by which USB names a kind of device.
struct HidId {
    std::uint16_t vendor{}, product{};
    bool operator==(const HidId&) const = default;
};
/// "1234:abcd".
std::string words_of(const HidId& id);

/// An open device. Tests have a fake. Each call may block.
class HidPort {
public:
    HidPort() = default;
    HidPort(const HidPort&) = delete;
    HidPort& operator=(const HidPort&) = delete;
    virtual ~HidPort() = default;

    /// Sends a report, whose first byte is its number. Returns false if the device refuses it, or is gone.
    virtual bool write(std::span<const std::uint8_t> report) = 0;
    /// False once the device is pulled out. Reports that it has sent are thrown away.
    virtual bool is_there() = 0;
};

using OpenHidPort = std::function<Expected<std::unique_ptr<HidPort>>(const HidId&)>;
/// Opens a device by hidapi. The error is one line without the device's name.
Expected<std::unique_ptr<HidPort>> open_hid_port(const HidId& id);

/// Devices that have an interface with reports of their maker's own kind, with their names.
std::vector<std::pair<HidId, std::string>> hid_devices();

/// A steady clock (s).
using ClockSeconds = std::function<double()>;
double steady_seconds();

/// Tests pass a fake of the device, and a clock.
std::unique_ptr<input::TactileOutput> hid_jacket(const HidId& id, OpenHidPort open = open_hid_port,
                                                 ClockSeconds clock = steady_seconds);

}  // namespace thaum::app
