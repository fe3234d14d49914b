// game/jackets/makers/bhaptics.h: a vest of bHaptics, driven through the WebSocket of the bHaptics Player
// that the vest is paired with. The Player is a program of bHaptics, or one that takes its place, such as the
// VRCH server.
//
// A request is sent when the frame (the amplitudes of all motors at one moment) has changed, and again after
// half of the time for which the frame holds. Requests are absolute, so a request that waits for a slow
// Player is replaced by the next one. The connection is ended if the Player takes no request for half a
// second, answers no ping for a second, or sends a message of more than 64 KiB. So a slow Player does not
// play outdated requests for long. After that, running motors stop at the end of their request's duration.
#pragma once
#include <memory>

#include "game/jackets/net_address.h"
#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

/// Output to the vest of a Player. `open` takes up to 1.3 s: it waits for the connection, and for a reply
/// that says whether a vest is connected.
std::unique_ptr<input::TactileOutput> bhaptics_jacket(const NetAddress& player);

}  // namespace thaum::game::inline jackets
