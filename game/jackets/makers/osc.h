// game/jackets/makers/osc.h: a jacket that takes OSC messages by UDP, such as
// the Wi-Fi vests of the VRCH server.
//
// Each message is absolute: it has the strengths of all motors. A message is sent when they have changed, and
// again after half of the time for which a frame (the strengths at one moment) holds. UDP loses messages, so
// the message that stops all motors is sent several times. When it is opened, the jacket gets "/ping" with
// the port of this program, as the VRCH server sends it, and may send heartbeats to that port. The program
// reads none, so it cannot know whether a jacket listens. If none does, only some small messages are wasted.
//
// The jacket itself must stop its motors when no more messages arrive, because over a broken connection the
// program cannot.
#pragma once
#include <cstddef>
#include <memory>

#include "game/jackets/net_address.h"
#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

/// Output to a jacket whose motors have the order of the frame's actuators. `open` looks up the name of the
/// host, which may take long.
std::unique_ptr<input::TactileOutput> osc_jacket(const NetAddress& address, std::size_t motors);

}  // namespace thaum::game::inline jackets
