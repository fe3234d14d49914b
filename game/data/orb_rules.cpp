#include "game/data/orb_rules.h"

#include <algorithm>

#include "core/text.h"
#include "game/components/orb.h"
#include "haptics/modes.h"

namespace thaum::game {
namespace {

constexpr Range any{-1e6, 1e6};

/// Reads a transfer function, a list x0, y0, x1, y1 and so on.
field::TransferFunction read_curve(const ConfigTable& table, std::string_view key,
                                   const std::vector<double>& fallback) {
    const auto numbers = table.numbers(key, any, 2 * field::most_transfer_points, fallback);
    if (numbers.size() % 2 != 0) {
        table.report(key, text("'", key, "' must be pairs of a property and a value"));
        return {};
    }
    std::vector<vec2> points;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) points.emplace_back(numbers[i], numbers[i + 1]);
    const auto curve = field::transfer_function(points);
    if (curve) return *curve;
    table.report(key, text("'", key, "': ", curve.error().message));
    return {};
}

std::vector<field::Filter> read_filters(const ConfigTable& table) {
    const auto names = field::filter_names();
    std::vector<field::Filter> filters;
    for (const auto& one : table.tables("filter")) {
        const auto kind = static_cast<field::FilterKind>(one.choice("kind", {names.begin(), names.end()}));
        if (kind == field::FilterKind::smooth)
            one.report("kind", "the orb's flow has no samples that could be smoothed");
        filters.push_back({kind, one.number("a", any, 0), one.number("b", any, 0)});
    }
    return filters;
}

/// Reports a mode that does not exist, or does not read what its filters make of a flow.
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
                 .strength = read_curve(table, "strength", {}),
                 .friction = read_curve(table, "friction", {0, 0}),
                 .most_property = table.number("most_property", {1e-3, 1e6}),
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
                   .healing = core.number("health", {0, 1e4}),
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
    if (tables.size() > most_orb_modes)
        root.report("mode", text("there are more than ", most_orb_modes, " modes"));
    return rules;
}

}  // namespace thaum::game
