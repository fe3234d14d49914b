// game/jackets/hid_report.h: the report that a HID jacket of 40 motors gets.
//
//     byte 0        0: reports of the device have no numbers
//     bytes 1 - 20  40 strengths of 4 bits, 0 (off) to 15; the first of two motors in the high half of a byte
//
// The motors are numbered in groups of two neighbouring columns. In a group, the rows follow from the top,
// each with the motor on the wearer's left first:
//
//     motors 0 - 9    front, two columns on the left       motors 10 - 19  back, two columns on the left
//     motors 30 - 39  front, two columns on the right      motors 20 - 29  back, two columns on the right
//
// Source: a bHaptics TactSuit X40 takes the same 20 bytes by Bluetooth, as the project senseshift-firmware
// reads them. No maker documents a HID jacket, so to send them as a HID report is our own choice, for jackets
// that people build.
//
// A report is absolute. It has no time to live: a jacket must stop its motors by itself when it has had no
// report for half a second. The program sends one at least every quarter of a second while a motor is on.
#pragma once
#include <array>
#include <cstdint>

#include "tactile/frame.h"

namespace thaum::game::inline jackets {

inline constexpr std::size_t hid_motors = 40;
using HidReport = std::array<std::uint8_t, 1 + hid_motors / 2>;

/// Report that plays a frame (the amplitudes of all motors at one moment) of the layout `x40` (40 motors).
/// Amplitudes may have any value; in the report they are 0 to 15.
HidReport hid_report(const tactile::TactileFrame& frame);

}  // namespace thaum::game::inline jackets
