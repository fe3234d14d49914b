// input/osc_jacket.h: a jacket that takes OSC messages by UDP, such as the Wi-Fi vests of the VRCH server.
//
// Each message is absolute: the strengths of all motors. One goes out when they have changed, and after half of the
// frame's time to live. UDP loses messages, so the message of silence goes out several times. At first, as by
// the VRCH server, it gets "/ping" with our port, to which it may send heartbeats. Nothing is read, and nobody knows
// whether a jacket listens: a dead one costs only its small messages.
//
// The jacket itself must stop its motors when messages stay out. The program cannot do it over a dead link.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "input/tactile_output.h"

namespace thaum::input {

/// Address at which a jacket listens.
struct NetAddress {
    std::string host{};  ///< name, or IPv4 or IPv6 address without brackets
    std::uint16_t port{};
    bool operator==(const NetAddress&) const = default;
};
/// "192.168.1.7:1027", "[::1]:1027".
std::string words_of(const NetAddress& address);

/// A jacket with motors in the order of the frame's actuators. `open` looks up the name, which may take long.
std::unique_ptr<TactileOutput> osc_jacket(const NetAddress& address, std::size_t motors);

}  // namespace thaum::input
