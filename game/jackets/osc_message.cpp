#include "game/jackets/osc_message.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace thaum::game::inline jackets {
namespace {

constexpr float strongest = 0xFFFF;

/// Appends an OSC string: at least one NUL ends it, and its length is padded to a multiple of four.
void append_string(std::string& out, std::string_view words) {
    out.append(words);
    out.append(4 - words.size() % 4, '\0');
}

void append_strength(std::string& out, float amplitude) {
    constexpr std::string_view digits = "0123456789abcdef";
    // NaN fails this comparison and becomes 0.
    const float share = amplitude > 0 ? std::min(amplitude, 1.0F) : 0.0F;
    const auto value = static_cast<std::uint32_t>(std::lround(share * strongest));
    for (const unsigned shift : {12U, 8U, 4U, 0U}) out += digits[(value >> shift) & 0xFU];
}

}  // namespace

std::string osc_message(const tactile::TactileFrame& frame, std::size_t motors) {
    const auto known = std::min<std::size_t>(frame.count, tactile::frame_capacity);
    std::string strengths;
    for (std::size_t i = 0; i < motors; ++i) append_strength(strengths, i < known ? frame.amplitude[i] : 0);
    std::string message;
    append_string(message, "/h");
    append_string(message, ",s");
    append_string(message, strengths);
    return message;
}

std::string osc_ping(std::uint16_t port) {
    std::string message;
    append_string(message, "/ping");
    append_string(message, ",i");
    for (const unsigned shift : {24U, 16U, 8U, 0U})
        message += static_cast<char>(static_cast<std::uint32_t>(port) >> shift & 0xFFU);
    return message;
}

}  // namespace thaum::game::inline jackets
