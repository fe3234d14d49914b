// game/jackets/makers/bhaptics.h: a vest of bHaptics, by the WebSocket of the Player that it is paired with.
// The Player is a program of bHaptics, or one that takes its place, such as the VRCH server.
//
// A request goes out when the frame has changed, and after half of its time to live. Requests are absolute,
// so one that waits for a slow Player is replaced by the next. A Player is disconnected if it takes no
// request for half a second, answers no ping for a second, or sends a message of more than 64 KiB. So a slow
// Player does not play outdated requests for long. After a disconnection, running motors stop at the end of
// their request's duration.
#pragma once
#include <memory>

#include "game/jackets/net_address.h"
#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

/// `open` takes up to 1.3 s: it waits for the connection, and for a reply that tells whether there is a vest.
std::unique_ptr<input::TactileOutput> bhaptics_jacket(const NetAddress& player);

}  // namespace thaum::game::inline jackets
