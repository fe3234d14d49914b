#include "game/data/orb_rules.h"

#include <algorithm>

#include "core/text.h"
#include "field/field_config.h"
#include "game/components/orb.h"
#include "haptics/modes.h"

namespace thaum::game::inline data {
namespace {

constexpr Range any{-1e6, 1e6};

std::vector<field::Filter> read_filters(const ConfigTable& table) {
    std::vector<field::Filter> filters;
    for (const auto& one : table.tables("filter")) {
        filters.push_back(field::read_filter(one, any));
        if (filters.back().kind == field::FilterKind::smooth)
            one.report("kind", "the orb's flow has no samples that could be smoothed");
    }
    return filters;
}

/// Reports a haptic mode (a way to feel the orb's flow) that is unknown. Also reports one that cannot read
/// the field, of numbers or of vectors, into which its filters turn the flow.
void check_mode(const ConfigTable& table, const OrbMode& mode) {
    const auto* kind = haptics::find_mode(mode.name);
    if (kind == nullptr) {
        std::string names;
        for (const auto& each : haptics::modes()) names += text(names.empty() ? "" : ", ", each.name);
        return table.report("name", text("there is no mode '", mode.name, "'; there are ", names));
    }
    const auto vector = field::checked_filters(mode.filters, true);
    if (!vector) return table.report("filter", text("filter: ", vector.error().message));
    if (*vector != (kind->reads == haptics::FieldKind::vector))
        table.report("name", text("mode '", mode.name, "' reads ", *vector ? "scalars" : "vectors",
                                  "; its filters make ", *vector ? "vectors" : "scalars"));
}

OrbMode read_mode(const ConfigTable& table) {
    OrbMode mode{.name = table.string("name"),
                 .filters = read_filters(table),
                 .strength = field::read_transfer(table, "strength", any, {}),
                 .friction = field::read_transfer(table, "friction", any, {0, 0}),
                 .max_property = table.number("most_property", {1e-3, 1e6}),
                 .least = table.number("least_n", {-1000, 0}, 0)};
    check_mode(table, mode);
    return mode;
}

}  // namespace

OrbRules read_orb_rules(const Config& file) {
    const auto root = file.root();
    const auto probe = root.table("probe");
    const auto core = root.table("core");
    const auto curve = root.table("curve");
    OrbRules rules{.metres_per_metre = probe.number("metres_per_metre", {0.1, 1000}),
                   .reach = probe.number("reach_m", {0, 10}),
                   .core_share = core.number("near", {0.001, 0.5}),
                   .hold = ticks(core.number("hold_s", {0.01, 60})),
                   .effects = read_effects(root),
                   .focus = probe.number("focus_per_s", {0, 1e4}),
                   .stiffness = probe.number("stiffness_n_per_m", {1, 1e4}),
                   .most = curve.number("most_n", {0.01, 1000}),
                   .column_share = curve.number("column", {0.001, 0.5}),
                   .begins = curve.number("begins_m", {0, 0.1}),
                   .modes = {}};
    const auto tables = root.tables("mode");
    for (const auto& table : tables) {
        const auto same = std::ranges::find(rules.modes, table.string("name"), &OrbMode::name);
        if (same != rules.modes.end()) table.report("name", text("there are two modes '", same->name, "'"));
        rules.modes.push_back(read_mode(table));
    }
    if (tables.empty()) root.report("mode", "there must be a mode at least");
    if (tables.size() > max_orb_modes)
        root.report("mode", text("there are more than ", max_orb_modes, " modes"));
    return rules;
}

}  // namespace thaum::game::inline data
