// game/jackets/makers/osc.h: a jacket that takes OSC messages by UDP, such as the Wi-Fi vests of the VRCH server.
//
// Each message is absolute: the strengths of all motors. One goes out when they have changed, and after half of the
// frame's time to live. UDP loses messages, so the message of silence goes out several times. At first, as by
// the VRCH server, it gets "/ping" with our port, to which it may send heartbeats. Nothing is read, and nobody knows
// whether a jacket listens: a dead one costs only its small messages.
//
// The jacket itself must stop its motors when messages stay out. The program cannot do it over a dead link.
#pragma once
#include <cstddef>
#include <memory>

#include "game/jackets/net_address.h"
#include "input/tactile_output.h"

namespace thaum::app {

/// A jacket with motors in the order of the frame's actuators. `open` looks up the name, which may take long.
std::unique_ptr<input::TactileOutput> osc_jacket(const NetAddress& address, std::size_t motors);

}  // namespace thaum::app
