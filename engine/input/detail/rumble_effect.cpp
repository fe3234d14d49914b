#include "input/detail/rumble_effect.h"

#include <algorithm>
#include <cmath>

namespace thaum::input::detail {
namespace {

constexpr double pad_steps = 255;
constexpr long step_magnitude = 257;  ///< 255 steps make 65,535

std::uint16_t magnitude(const tactile::TactileFrame& frame, std::size_t actuator) {
    if (actuator >= frame.count) return 0;
    const auto amplitude = static_cast<double>(frame.amplitude.at(actuator));
    // Written so that what is no number fails the test.
    if (!(amplitude > 0)) return 0;
    return static_cast<std::uint16_t>(std::lround(std::min(amplitude, 1.0) * pad_steps) * step_magnitude);
}

void append_hex(std::string& out, unsigned byte) {
    constexpr std::string_view digits = "0123456789abcdef";
    out += digits[(byte >> 4U) & 15U];
    out += digits[byte & 15U];
}

/// A number of two bytes, the lower one first.
void append_number(std::string& out, unsigned number) {
    append_hex(out, number);
    append_hex(out, number >> 8U);
}

}  // namespace

ff_effect rumble_effect(const tactile::TactileFrame& frame, std::int16_t id) {
    ff_effect effect{};
    effect.type = FF_RUMBLE;
    effect.id = id;
    // A length of 0 would mean: for ever.
    effect.replay.length =
        static_cast<std::uint16_t>(std::clamp<Tick>(frame.time_to_live, 1, longest_rumble_ms));
    effect.u.rumble.strong_magnitude = magnitude(frame, 0);
    effect.u.rumble.weak_magnitude = magnitude(frame, 1);
    return effect;
}

std::string pad_guid(const input_id& id, std::string_view name) {
    constexpr std::string_view gap = "0000";
    constexpr std::size_t named_bytes = 11;
    std::string guid;
    append_number(guid, id.bustype);
    guid += gap;
    if (id.vendor != 0 && id.product != 0 && id.version != 0) {
        for (const unsigned number : {id.vendor, id.product, id.version}) {
            append_number(guid, number);
            guid += gap;
        }
        return guid;
    }
    for (std::size_t i = 0; i < named_bytes; ++i)
        append_hex(guid, i < name.size() ? static_cast<unsigned char>(name[i]) : 0U);
    append_hex(guid, 0);
    return guid;
}

}  // namespace thaum::input::detail
