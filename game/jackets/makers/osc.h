// game/jackets/makers/osc.h: a jacket that takes OSC messages by UDP, such as
// the Wi-Fi vests of the VRCH server.
//
// Each message is absolute: the strengths of all motors. A message is sent when they have changed, and again
// after half of the frame's time to live. UDP loses messages, so the message that stops all motors is sent
// several times. When it is opened, the jacket gets "/ping" with our port, as from the VRCH server, and may
// send heartbeats to that port. The program reads none, so it cannot know whether a jacket listens; sending
// to a dead one costs only small messages.
//
// The jacket itself must stop its motors when no more messages arrive, because the program cannot do it over
// a dead link.
#pragma once
#include <cstddef>
#include <memory>

#include "game/jackets/net_address.h"
#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

/// A jacket with motors in the order of the frame's actuators. `open` looks up the name, which may take long.
std::unique_ptr<input::TactileOutput> osc_jacket(const NetAddress& address, std::size_t motors);

}  // namespace thaum::game::inline jackets
