#include "core/colour.h"

namespace thaum {

vec3 linear_colour(std::uint32_t hex) {
    const auto channel = [hex](unsigned shift) {
        const double s = static_cast<double>((hex >> shift) & 0xFFU) / 255;
        return s <= 0.04045 ? s / 12.92 : det::pow((s + 0.055) / 1.055, 2.4);
    };
    return {channel(16), channel(8), channel(0)};
}

vec3 read_linear_colour(const ConfigTable& table, std::string_view key) {
    const auto hex = table.hex_colour(key);
    return hex ? linear_colour(*hex) : table.vector(key, {0, 1});
}

}  // namespace thaum
