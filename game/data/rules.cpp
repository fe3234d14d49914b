#include "game/data/rules.h"

#include <algorithm>
#include <cmath>

#include "game/data/event_kinds.h"

namespace thaum::game::inline data {
namespace {

/// Downward acceleration where no file says otherwise (m/s^2).
constexpr double standard_gravity = 9.81;

const EventRegistration surge_begins({.name = "surge", .with = {}, .unit = "times", .has_subject = true});
const EventRegistration round_tied({.name = "tied", .with = {}, .unit = "s", .has_subject = true});

std::vector<Surge> read_surges(const ConfigTable& table) {
    std::vector<Surge> surges;
    for (const auto& name : table.keys()) {
        const auto surge = table.table(name);
        surges.push_back({ticks(surge.number("after_s", {0, 36000})), surge.number("factor", {1, 100})});
        const bool is_taken = std::ranges::count(surges, surges.back().after, &Surge::after) > 1;
        if (is_taken) surge.report("after_s", "'after_s' is that of another surge");
    }
    std::ranges::sort(surges, {}, &Surge::after);
    return surges;
}

BoilOverRules read_boil_over(const ConfigTable& table) {
    const Tick length = ticks(table.number("seconds", {0, 3600}, 0));
    if (length == 0) return {.health = table.number("health", {1, 1e6}, 1)};
    return {.length = length, .health = table.number("health", {1, 1e6})};
}

}  // namespace

RoundRules read_round_rules(const Config& file) {
    const auto root = file.root();
    const Range duration{0, 3600};
    return {.kills = static_cast<std::int32_t>(root.integer("kills", {1, 1000})),
            .length = ticks(root.number("seconds", {1, 36000})),
            .rounds = static_cast<std::uint32_t>(root.integer("rounds", {1, 99})),
            .interval = ticks(root.number("interval_s", duration)),
            .respawn = ticks(root.number("respawn_s", duration)),
            .spawn_shield = ticks(root.number("spawn_shield_s", duration)),
            .surges = read_surges(root.table("surge")),
            .boil_over = read_boil_over(root.table("boil_over"))};
}

EventKind surge_event() { return surge_begins.kind(); }
EventKind tied_event() { return round_tied.kind(); }

double surge_at(const RoundRules& rules, Tick age) {
    double factor = 1;
    for (const auto& surge : rules.surges)
        if (age >= surge.after) factor = surge.factor;
    return factor;
}

Tick round_ends_at(const RoundRules& rules, const Match& match) {
    return match.round_began + rules.length + (match.boils_over_since != 0 ? rules.boil_over.length : 0);
}

RuleSet read_rule_set(const Config& file) {
    const auto root = file.root();
    RuleSet rules;
    rules.energy_regain = root.boolean("energy_regain", true);
    rules.spawn_shield = root.boolean("spawn_shield", true);
    rules.aim_assist = root.boolean("aim_assist", true);
    rules.cauldron = root.boolean("cauldron", true);
    rules.spells = root.boolean("spells", true);
    rules.surges = root.boolean("surges", true);
    for (std::size_t kind = 0; kind < power_up_names.size(); ++kind) {
        const auto table = root.table(power_up_names[kind]);
        rules.power_ups[kind] = {.effects = read_effects(table),
                                 .again = ticks(table.number("again_s", {0, 3600})),
                                 .radius = table.number("radius_m", {0.1, 5})};
    }
    return rules;
}

WizardRules read_wizard_rules(const Config& file) {
    WizardRules rules;
    rules.gravity = file.root().number("gravity_m_s2", {0.1, 100}, standard_gravity);
    const auto body = file.root().table("body");
    rules.mass = body.number("mass_kg", {1, 1000});
    rules.radius = body.number("radius_m", {0.1, 2});
    rules.height = body.number("height_m", {0.5, 5});
    rules.eye = body.number("eye_m", {0.1, 5});
    const auto walk = file.root().table("walk");
    rules.walk.walk_speed = walk.number("speed_m_s", {0, 50});
    rules.walk.ground_acceleration = walk.number("ground_acceleration_m_s2", {0, 1000});
    rules.walk.air_acceleration = walk.number("air_acceleration_m_s2", {0, 1000});
    rules.walk.jump_speed = std::sqrt(2 * rules.gravity * walk.number("jump_height_m", {0, 50}));
    rules.walk.steepest_cos = det::cos(walk.number("max_slope_deg", {0, 89}) * radians_per_degree);
    rules.loose = ticks(walk.number("loose_s", {0, 10}));
    rules.loose_grip = walk.number("loose_grip", {0, 1});
    const auto health = file.root().table("health");
    rules.health = health.number("start", {1, 1e6});
    rules.health_cap = health.number("cap", {1, 1e6});
    rules.excess_loss = health.number("excess_loss_per_s", {0, 1e6});
    rules.fall_safe = health.number("fall_safe_m_s", {0, 1000});
    rules.fall_damage = health.number("fall_damage_per_m_s", {0, 1000});
    rules.object_safe = health.number("object_safe_n_s", {0, 1e6});
    rules.object_damage = health.number("object_damage_per_n_s", {0, 1000});
    rules.max_object_damage = health.number("object_damage_max", {0, 1e6});
    rules.object_again = ticks(health.number("object_again_s", {0, 60}));
    rules.blame = ticks(health.number("blame_s", {0, 60}));
    rules.pitch_limit = file.root().table("gaze").number("pitch_limit_deg", {1, 89}) * radians_per_degree;
    if (rules.height <= 2 * rules.radius)
        body.report("height_m", "'height_m' must be more than twice radius_m");
    return rules;
}

HapticRules read_haptic_rules(const Config& file) {
    constexpr double micrometres = 1e6;
    const auto root = file.root();
    HapticRules rules;
    rules.device = root.string("device");
    rules.share = root.number("share", {0, 1});
    const auto hand = root.table("hand");
    rules.wand_per_hand = hand.number("wand_m_per_m", {0, 100});
    rules.clutch_per_count =
        static_cast<std::int32_t>(std::lround(micrometres * hand.number("clutch_m_per_count", {0, 0.01})));
    rules.clutch_per_tick = static_cast<std::int32_t>(
        std::lround(micrometres * tick_seconds * hand.number("clutch_m_per_s", {0, 10})));
    const auto probe = root.table("probe");
    rules.probe.stiffness = probe.number("stiffness_n_per_m", {0, 1e5});
    rules.probe.damping = probe.number("damping_n_s_per_m", {0, 1000});
    rules.probe.static_friction = probe.number("static_friction", {0, 10});
    rules.probe.dynamic_friction = probe.number("dynamic_friction", {0, 10});
    rules.probe.newtons_per_newton = probe.number("n_per_n", {0, 1});
    if (rules.probe.dynamic_friction > rules.probe.static_friction)
        probe.report("dynamic_friction", "'dynamic_friction' must not be more than static_friction");
    return rules;
}

}  // namespace thaum::game::inline data
