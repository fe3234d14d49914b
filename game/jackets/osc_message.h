// game/jackets/osc_message.h: the messages that an OSC jacket receives (Open Sound Control 1.0).
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "tactile/frame.h"

namespace thaum::game::inline jackets {

/// OSC message to "/h" with one string: four hexadecimal digits for each motor, 0000 (off) to ffff. `frame`:
/// amplitudes of all actuators at one moment, which may have any value. Motors without an actuator in the
/// frame are off.
std::string osc_message(const tactile::TactileFrame& frame, std::size_t motors);

/// OSC message to "/ping" with one whole number: the port to which a jacket may send its heartbeats.
std::string osc_ping(std::uint16_t port);

}  // namespace thaum::game::inline jackets
