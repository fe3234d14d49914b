#include "field/materials.h"

#include "core/text.h"

namespace thaum::field {
namespace {

constexpr std::size_t max_materials = 256;

Material read_material(const ConfigTable& table) {
    Material m{.name = table.string("name")};
    m.stiffness = table.number("stiffness", {0, 1e5});
    m.viscosity = table.number("viscosity", {0, 1e4});
    m.opacity = table.number("opacity", {0, 1});
    m.colour = read_colour(table, "colour");
    if (m.name.empty()) table.report("name", "'name' must not be empty");
    return m;
}

}  // namespace

Rgb8 read_colour(const ConfigTable& table, std::string_view key) {
    if (const auto hex = table.hex_colour(key))
        return {static_cast<std::uint8_t>(*hex >> 16U & 0xFFU), static_cast<std::uint8_t>(*hex >> 8U & 0xFFU),
                static_cast<std::uint8_t>(*hex & 0xFFU)};
    const vec3 rgb = table.vector(key, {0, 255});
    for (int i = 0; i < 3; ++i) {
        if (rgb[i] != std::floor(rgb[i])) table.report(key, text("'", key, "' must be three whole numbers"));
    }
    return {static_cast<std::uint8_t>(rgb.x), static_cast<std::uint8_t>(rgb.y),
            static_cast<std::uint8_t>(rgb.z)};
}

Expected<Materials> read_materials(const Config& config) {
    Materials materials;
    const auto root = config.root();
    for (const auto& table : root.tables("material")) {
        Material m = read_material(table);
        if (material_index(materials, m.name))
            table.report("name", text("material '", m.name, "' stands here for the second time"));
        if (materials.size() == max_materials) {
            table.report("name", text("there are more than ", max_materials, " materials"));
            break;
        }
        materials.push_back(std::move(m));
    }
    if (materials.empty()) root.report("", "there is no [[material]]; add one");
    if (auto good = config.check(); !good) return good.error();
    return materials;
}

std::optional<std::uint8_t> material_index(const Materials& materials, std::string_view name) {
    for (std::size_t i = 0; i < materials.size() && i < max_materials; ++i) {
        if (materials[i].name == name) return static_cast<std::uint8_t>(i);
    }
    return std::nullopt;
}

}  // namespace thaum::field
