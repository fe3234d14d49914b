#include "game/data/wand_look.h"

#include <charconv>

#include "core/text.h"

namespace thaum::game::inline data {
namespace {

constexpr Range size{0, 10};        // range of sizes of a drawn part (m)
constexpr Range position{-10, 10};  // range of coordinates of a drawn part (m)

void read_colour(const ConfigTable& table, LookPart& part) {
    const auto words = table.string("colour");
    if (words == "glow" || words == "core") {
        part.paint = words == "glow" ? LookPaint::glow : LookPaint::core;
        return;
    }
    if (const auto colour = hex_colour(words))
        part.colour = *colour;
    else
        table.report("colour", "'colour' must be \"#RRGGBB\", \"glow\" or \"core\"");
}

void read_shape(const ConfigTable& table, LookPart& part) {
    switch (part.shape) {
        case LookShape::rod:
            part.from = table.vector("from", position);
            part.to = table.vector("to", position);
            part.radius_end = table.number("radius_end", size, part.radius);
            part.capped = table.boolean("capped", false);
            if (part.from == part.to) table.report("to", "'to' must differ from 'from'");
            break;
        case LookShape::ball:
            part.from = table.vector("at", position, vec3(0));
            part.stretch = table.vector("stretch", {0.01, 100}, vec3(1));
            break;
        case LookShape::ring:
            part.from = table.vector("at", position, vec3(0));
            part.radius_end = table.number("inner_radius", size);
            part.thickness = table.number("thickness", size);
            part.axis = static_cast<int>(table.choice("axis", {"x", "y", "z"}, 2));
            part.turn = table.number("turn_deg", {-360, 360}, 0) * radians_per_degree;
            break;
        case LookShape::crook:
            part.from = table.vector("from", position);
            part.radius_end = table.number("radius_end", size, part.radius);
            part.bend = table.number("bend", {0.001, 10});
            part.turn = table.number("turn_deg", {1, 360}) * radians_per_degree;
            break;
        case LookShape::cage: part.thickness = table.number("thickness", size); break;
    }
}

LookPart read_part(const ConfigTable& table) {
    LookPart part;
    part.shape = static_cast<LookShape>(table.choice("shape", {"rod", "ball", "ring", "crook", "cage"}));
    part.radius = table.number("radius", size);
    const bool ring = part.shape == LookShape::ring;
    part.sides = static_cast<int>(table.integer("sides", {ring ? 0.0 : 3.0, 64}, part.sides));
    part.mirrored = table.boolean("mirrored", false);
    read_colour(table, part);
    read_shape(table, part);
    return part;
}

}  // namespace

std::optional<std::uint32_t> hex_colour(std::string_view words) {
    std::uint32_t colour = 0;
    const auto* end = words.data() + words.size();
    const bool hex = words.size() == 7 && words[0] == '#';
    if (!hex || std::from_chars(words.data() + 1, end, colour, 16).ptr != end) return {};
    return colour;
}

WandLook read_wand_look(const ConfigTable& look) {
    constexpr std::size_t max_parts = 64;
    WandLook read;
    read.flat = look.boolean("flat", false);
    read.steady_force = look.string("steady_force", read.steady_force);
    if (read.steady_force.empty() || read.steady_force.size() > 16)
        look.report("steady_force", "'steady_force' must be a word of at most 16 characters");
    for (const auto& part : look.tables("wand")) read.wand.push_back(read_part(part));
    for (const auto& part : look.tables("missile")) read.missile.push_back(read_part(part));
    if (read.wand.empty() || read.wand.size() > max_parts)
        look.report("wand", text("a wand's look needs 1 to ", max_parts, " parts [[look.wand]]"));
    if (read.missile.size() > max_parts)
        look.report("missile", text("a missile's look has at most ", max_parts, " parts"));
    return read;
}

}  // namespace thaum::game::inline data
