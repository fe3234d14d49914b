#include "core/colour.h"

#include <array>

namespace thaum {

double linear_from_srgb(double s) { return s <= 0.04045 ? s / 12.92 : det::pow((s + 0.055) / 1.055, 2.4); }

vec3 linear_colour(std::uint32_t hex) {
    // Linear light of each of the 256 values of a channel, computed once, because pictures ask for hundreds
    // of colours in each frame.
    static const auto of_byte = [] {
        std::array<double, 256> light{};
        for (std::size_t i = 0; i < light.size(); ++i)
            light[i] = linear_from_srgb(static_cast<double>(i) / 255);
        return light;
    }();
    const auto channel = [hex](unsigned shift) { return of_byte[(hex >> shift) & 0xFFU]; };
    return {channel(16), channel(8), channel(0)};
}

vec3 read_linear_colour(const ConfigTable& table, std::string_view key) {
    const auto hex = table.hex_colour(key);
    return hex ? linear_colour(*hex) : table.vector(key, {0, 1});
}

}  // namespace thaum
