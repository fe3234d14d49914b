#include "game/data/casting_rules.h"

namespace thaum::game::inline data {

CastingRules read_casting_rules(const Config& file) {
    const auto root = file.root();
    const auto focus = root.table("focus");
    const auto stroke = root.table("stroke");
    const auto force = root.table("force");
    const auto free = root.table("free");
    CastingRules rules{.focus_cap = focus.number("cap", {0, 1e6}),
                       .focus_regain = focus.number("regain_per_s", {0, 1e6}),
                       .viscosity = stroke.number("viscosity_n_s_per_m", {0, 100}),
                       .stick_reach = stroke.number("stick_reach_m", {0, 0.5}),
                       .gentle_below = force.number("gentle_below_n", {0, 1000}),
                       .harsh_from = force.number("harsh_from_n", {0, 1000}),
                       .harsh_strength = force.number("harsh_strength", {0, 100}),
                       .harsh_cost = force.number("harsh_cost", {0, 100}),
                       .shortest = ticks(stroke.number("shortest_s", {0, 10})),
                       .smallest = stroke.number("smallest_m", {0, 1}),
                       .free_rest = ticks(free.number("rest_s", {0.04, 1})),
                       .free_rest_way = free.number("rest_m", {0, 1}),
                       .free_pause = ticks(free.number("pause_s", {0.04, 3})),
                       .free_least_probability = free.number("least_probability", {0, 1}),
                       .free_quiet_probability = free.number("quiet_probability", {0, 1}),
                       .free_quiet_pace = free.number("quiet_pace", {0, 10}),
                       .free_most_pace = free.number("most_pace", {0, 1000}),
                       .free_loop = free.number("loop_m", {0, 10}),
                       .free_stop = free.number("stop_s", {0, 10}),
                       .free_stop_share = free.number("stop_share", {0, 1}),
                       .free_near_probability = free.number("near_probability", {0, 1}),
                       .free_smallest = free.number("smallest_m", {0, 1}),
                       .free_shortest = free.number("shortest_s", {0, 3}),
                       .free_apart = ticks(free.number("apart_s", {0, 60}))};
    if (rules.harsh_from < rules.gentle_below)
        force.report("harsh_from_n", "'harsh_from_n' must not be below gentle_below_n");
    if (rules.free_pause <= rules.free_rest) free.report("pause_s", "'pause_s' must be longer than rest_s");
    return rules;
}

std::string_view force_word(const CastingRules& rules, double force) {
    if (force < rules.gentle_below) return "gentle";
    return force < rules.harsh_from ? "normal" : "harsh";
}

}  // namespace thaum::game::inline data
