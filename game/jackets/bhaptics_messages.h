// game/jackets/bhaptics_messages.h: texts that the bHaptics Player, a program which drives vests, takes and
// sends through version 2 of its WebSocket interface.
//
// Each request is absolute: it says for both sides of the vest which motors run, or that all are off. Running
// motors have a duration, so they stop by themselves when the connection is lost.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "tactile/frame.h"

namespace thaum::game::inline jackets {

/// Address of the bHaptics Player on this machine.
inline constexpr std::string_view bhaptics_place = "127.0.0.1:15881";
inline constexpr std::string_view bhaptics_path = "/v2/feedbacks?app_id=thaum&app_name=Thaum";
inline constexpr std::size_t max_reply_bytes = 1U << 16U;

/// Request that plays a frame (the amplitudes of all motors at one moment) of the layout `x40` (40 motors).
/// Amplitudes may have any value; in the request they are 0 to 100.
std::string bhaptics_request(const tactile::TactileFrame& frame);

/// The part of a Player's reply that the game uses.
struct BhapticsReply {
    std::optional<std::int64_t> devices{};  ///< number of devices that the Player is connected to
    std::optional<bool> vest{};             ///< whether the Player is connected to a vest
    /// Whether a vest may be connected. Also true if the reply does not say so, as from older versions of the
    /// Player.
    bool may_have_vest() const { return vest.value_or(devices.value_or(1) > 0); }
};
/// Reads a reply of at most max_reply_bytes. Unknown keys are ignored. The error says why the text is no
/// reply.
Expected<BhapticsReply> read_bhaptics_reply(std::string_view json);

}  // namespace thaum::game::inline jackets
