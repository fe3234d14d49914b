#include "game/data/crystal_rules.h"

#include <algorithm>

#include "core/text.h"
#include "game/components/wizard.h"

namespace thaum::game::inline data {
namespace {

CarvingHandRules read_hand(const ConfigTable& table) {
    return {.metres_per_metre = table.number("metres_per_metre", {0.1, 100}),
            .in_front = table.number("in_front_m", {-1, 1}),
            .stiffness = table.number("stiffness_n_per_m", {1, 1e4}),
            .damping = table.number("damping_n_s_per_m", {0, 100})};
}

std::vector<std::string> read_tool_names(const ConfigTable& root) {
    std::vector<std::string> names;
    for (const auto& table : root.tables("tool")) {
        names.push_back(table.string("name"));
        if (std::find(names.begin(), names.end() - 1, names.back()) != names.end() - 1)
            table.report("name", text("tool '", names.back(), "' is there twice"));
    }
    if (names.empty() || names.size() > wand_slots)
        root.report("tool", text("there must be 1 to ", wand_slots, " [[tool]], one for each wand key"));
    return names;
}

/// The tool that melts a ball out of a crystal where something hits it. `radius`: radius of the ball
/// (voxels).
field::Tool melt_of_hit(double radius) {
    return {
        .name = "chip",
        .operations = {{.method = field::Method::constant,
                        .extent = {.shape = field::ExtentShape::sphere, .half = vec3(radius), .stamp = {}},
                        .changes = {.density = true}}}};
}

}  // namespace

CrystalRules read_crystal_rules(const Config& file) {
    const auto root = file.root();
    const auto surface = root.table("surface"), chip = root.table("chip"), work = root.table("great_work");
    return {.reach = root.number("reach_m", {0.1, 10}),
            .tool_names = read_tool_names(root),
            .tools = {},
            .focus_per_second = root.number("focus_per_s", {0, 1000}),
            .against_key = root.number("against_key", {0, 1}),
            .turning = glm::radians(root.number("turn_deg_per_s", {0, 720})),
            .overlap = root.number("overlap", {0.01, 1}),
            .effects = read_effects(root),
            .hand = read_hand(root.table("hand")),
            .surface = {.strength = surface.number("strength_n", {0, 100}),
                        .depth = surface.number("depth_voxels", {0.1, 20}),
                        .friction = surface.number("friction", {0, 2})},
            .chip = melt_of_hit(chip.number("radius_voxels", {0.5, 20})),
            .chip_burst_reach = chip.number("burst_reach_m", {0, 10}),
            .chip_least_impulse = chip.number("least_n_s", {0, 1e6}),
            .chip_again = ticks(chip.number("again_s", {0, 60})),
            .lens_share = root.table("lens").number("blast_share", {1, 10}),
            .work_lasts = ticks(work.number("hold_s", {0.1, 3600}))};
}

void check_crystal_tools(const ConfigTable& root, const CrystalRules& rules) {
    const auto tables = root.tables("tool");
    for (std::size_t i = 0; i < rules.tools.size(); ++i) {
        const bool fits = std::none_of(rules.tools[i].operations.begin(), rules.tools[i].operations.end(),
                                       [](const field::Operation& o) { return o.changes.material; });
        if (!fits)
            tables[i].report("name", text("carving/", rules.tool_names[i],
                                          ".toml changes the material; crystals of a match have only one"));
    }
}

}  // namespace thaum::game::inline data
