// game/jackets/hid_port.h: access to the computer's devices that take HID reports, by the library hidapi.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"

namespace thaum::game::inline jackets {

/// The vendor and product numbers by which USB identifies a kind of device.
struct HidId {
    std::uint16_t vendor{}, product{};
    bool operator==(const HidId&) const = default;
};
/// Text of the two numbers, hexadecimal: "1234:abcd".
std::string words_of(const HidId& id);
/// Reads "1234:abcd", two numbers of four hexadecimal digits each; std::nullopt for any other text.
std::optional<HidId> read_hid_id(std::string_view words);

/// An open HID device. Tests implement a fake. Each call may block.
class HidPort {
public:
    HidPort() = default;
    HidPort(const HidPort&) = delete;
    HidPort& operator=(const HidPort&) = delete;
    virtual ~HidPort() = default;

    /// Sends a report, whose first byte is the report's number. Returns false if the device refuses it or is
    /// gone.
    virtual bool write(std::span<const std::uint8_t> report) = 0;
    /// Returns false once the device has been unplugged. Also discards the reports that the device has sent.
    virtual bool is_there() = 0;
};

using OpenHidPort = std::function<Expected<std::unique_ptr<HidPort>>(const HidId&)>;
/// Opens a device by hidapi. The error is one line without the device's name.
Expected<std::unique_ptr<HidPort>> open_hid_port(const HidId& id);

/// Devices that have an interface with a maker-defined usage page (so no keyboards), with their names.
std::vector<std::pair<HidId, std::string>> hid_devices();

}  // namespace thaum::game::inline jackets
