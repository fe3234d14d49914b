#include "game/jackets/bhaptics_messages.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/json.h"
#include "core/text.h"

namespace thaum::game::inline jackets {
namespace {

constexpr std::size_t motors_of_side = 20;
constexpr Tick longest_duration_ms = 500;

struct Side {
    std::string_view key;  ///< key of the request's effect; a later request with the same key replaces the
                           ///< effect
    std::string_view position;  ///< name that the bHaptics Player has for the side
    std::size_t first_actuator;
};
constexpr std::array<Side, 2> sides{
    {{"thaum-front", "VestFront", 0}, {"thaum-back", "VestBack", motors_of_side}}};

long percent_of(const tactile::TactileFrame& frame, std::size_t actuator) {
    if (actuator >= frame.count) return 0;
    const float amplitude = frame.amplitude[actuator];
    // NaN fails this comparison and becomes 0.
    return amplitude > 0 ? std::lround(std::min(amplitude, 1.0F) * 100) : 0;
}

/// The motors of a side that run, as members of a JSON list; empty if all are off.
std::string dots_of(const tactile::TactileFrame& frame, const Side& side) {
    std::string dots;
    for (std::size_t i = 0; i < motors_of_side; ++i) {
        const auto percent = percent_of(frame, side.first_actuator + i);
        if (percent == 0) continue;
        dots += text(dots.empty() ? "" : ",", R"({"index":)", i, R"(,"intensity":)", percent, "}");
    }
    return dots;
}

std::string part_of(const tactile::TactileFrame& frame, const Side& side) {
    const auto dots = dots_of(frame, side);
    if (dots.empty()) return text(R"({"type":"turnOff","key":")", side.key, R"("})");
    return text(R"({"type":"frame","key":")", side.key, R"(","Frame":{"durationMillis":)",
                std::min(frame.time_to_live, longest_duration_ms), R"(,"position":")", side.position,
                R"(","dotPoints":[)", dots, R"(],"pathPoints":[]}})");
}

/// Whether the position of a device in a reply, given by name or by number, is that of a vest.
bool is_vest(const Json& position) {
    constexpr std::array<std::string_view, 3> names{"Vest", "VestFront", "VestBack"};
    constexpr std::array<std::int64_t, 3> numbers{3, 201, 202};
    if (position.is_string()) return std::count(names.begin(), names.end(), position.string()) > 0;
    return position.is_integer() && std::count(numbers.begin(), numbers.end(), position.integer()) > 0;
}

}  // namespace

std::string bhaptics_request(const tactile::TactileFrame& frame) {
    return text(R"({"Register":[],"Submit":[)", part_of(frame, sides[0]), ",", part_of(frame, sides[1]),
                "]}");
}

Expected<BhapticsReply> read_bhaptics_reply(std::string_view json) {
    if (json.size() > max_reply_bytes) return fail("the Player's reply is too long");
    const auto reply = parse_json(json);
    if (!reply || !reply->is_object()) return fail("the Player's reply is no JSON object");
    BhapticsReply read;
    const auto* count = reply->find("ConnectedDeviceCount");
    if (count != nullptr && count->is_integer()) read.devices = count->integer();
    const auto* positions = reply->find("ConnectedPositions");
    if (positions != nullptr && positions->is_array())
        read.vest = std::ranges::any_of(positions->elements(), is_vest);
    return read;
}

}  // namespace thaum::game::inline jackets
