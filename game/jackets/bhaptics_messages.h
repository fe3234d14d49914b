// game/jackets/bhaptics_messages.h: texts that the bHaptics Player (its second
// interface, a WebSocket) takes and sends.
//
// Each request is absolute: both sides of the vest, lit or turned off. A lit side has a duration, so it goes
// dark by itself when the connection is lost.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "tactile/frame.h"

namespace thaum::game::inline jackets {

/// Address of the Player on this machine.
inline constexpr std::string_view bhaptics_place = "127.0.0.1:15881";
inline constexpr std::string_view bhaptics_path = "/v2/feedbacks?app_id=thaum&app_name=Thaum";
inline constexpr std::size_t max_reply_bytes = 1U << 16U;

/// Request that plays a frame of the layout `x40`. Amplitudes may be anything; they become 0 to 100.
std::string bhaptics_request(const tactile::TactileFrame& frame);

/// The part of a reply that is used.
struct BhapticsReply {
    std::optional<std::int64_t> devices{};  ///< number of devices that the Player is connected to
    std::optional<bool> vest{};             ///< whether a vest is among them
    /// Whether there is a vest, as far as the reply tells; it tells nothing of older Players' devices.
    bool may_have_vest() const { return vest.value_or(devices.value_or(1) > 0); }
};
/// Reads a reply of at most max_reply_bytes. Unknown keys are ignored. The error says why it is none.
Expected<BhapticsReply> read_bhaptics_reply(std::string_view json);

}  // namespace thaum::game::inline jackets
