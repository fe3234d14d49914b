#include "game/bots/errands.h"

#include <algorithm>

// The worth of a power-up to a bot is the bot's need for health or energy that it gives, divided by the time
// to get there. While the bot sees the foe and can shoot, the worth is multiplied by `in_a_fight`. So during
// a fight a bot fetches a power-up only if it is worth about twice as much as at other times.
namespace thaum::game::inline bots {
namespace {

/// Ticks between two choices whether to fetch or hide (an errand); a multiple of gameplay_period
constexpr Tick choice_period = 256;
/// Least worth of an errand (to fetch or hide): share of the full need that it serves, per second (1/s)
constexpr double min_worth = 0.05;
constexpr double in_a_fight = 0.45;  ///< factor on the worth of a power-up while the bot sees the foe and can
                                     ///< shoot
constexpr double time_lost = 2;      ///< time that a fetch costs for turning away and back (s)
constexpr double walk_speed = 4;     ///< walking speed along a way, corners included (m/s)
constexpr int hiding_places_tried = 10;
constexpr double hiding_within = 9;  ///< largest distance of a hiding place (m)
constexpr Tick hiding_time = ticks(2.5);

bool sees_foe(const Mind& mind, Tick tick) {
    return mind.foe_seen_at != 0 && tick - mind.foe_seen_at < ticks(0.5);
}

/// How much a bot needs health or energy: 0 if it has at least `below`, 1 if nothing is left.
double need(double have, double below) {
    return below > 0 ? std::clamp((below - have) / below, 0.0, 1.0) : 0;
}

double worth(const BotTurn& turn, PowerUpKind kind) {
    const auto& self = turn.self;
    const auto& skill = turn.seat.skill;
    const BotNeeds needs{.health = need(self.health, skill.vial_below),
                         .energy = need(self.energy_share, skill.spark_below)};
    double worth = 0;
    for (const auto& one : turn.match.data().rules.power_ups[static_cast<std::size_t>(kind)].effects)
        worth += one.rules->worth(needs);
    return worth;
}

struct Choice {
    double worth = min_worth;
    vec3 place{};
    bool found = false;
};

Choice best_to_fetch(const BotTurn& turn, bool fights) {
    Choice best;
    const auto& grid = turn.grid;
    const int here = grid.cell_at(turn.self.centre);
    auto& from_here = turn.ways.from_here;
    const auto& power_ups = turn.match.data().arena.power_ups;
    for (std::size_t i = 0; i < std::min(power_ups.size(), max_power_ups); ++i) {
        const double wanted = worth(turn, power_ups[i].kind) * (fights ? in_a_fight : 1.0);
        if (wanted / time_lost <= best.worth) continue;
        if (from_here.goal != here) grid.find_ways(here, from_here);
        const auto steps = from_here.steps[static_cast<std::size_t>(grid.cell_at(power_ups[i].position))];
        if (steps == WalkGrid::unreachable) continue;
        const double way = steps / walk_speed;
        const Tick back_at = turn.eyes.back_at[i];
        const double wait = back_at > turn.tick ? seconds(back_at - turn.tick) : 0;
        const double value = wanted / (time_lost + std::max(way, wait));
        if (value > best.worth) best = {value, power_ups[i].position, true};
    }
    return best;
}

/// A place near the bot that the foe cannot see from its presumed position.
Choice hiding_place(const BotTurn& turn) {
    const auto& self = turn.self;
    const auto& grid = turn.grid;
    auto& mind = turn.mind;
    Choice best;
    double nearest = hiding_within;
    for (int i = 0; i < hiding_places_tried; ++i) {
        const vec3 off{mind.random.uniform(-hiding_within, hiding_within), 0,
                       mind.random.uniform(-hiding_within, hiding_within)};
        const vec3 place = grid.centre_of(grid.cell_at(self.centre + off));
        const double distance = glm::distance(vec2(place.x, place.z), vec2(self.centre.x, self.centre.z));
        if (distance >= nearest || !grid.walkable(grid.cell_at(place))) continue;
        const vec3 chest{place.x, self.centre.y + 0.2, place.z};
        if (!turn.match.physics().ray(mind.foe, chest, layer::ground)) continue;
        nearest = distance;
        best = {1, place, true};
    }
    return best;
}

}  // namespace

void choose_errand(const BotTurn& turn) {
    const auto& self = turn.self;
    const auto& seat = turn.seat;
    auto& mind = turn.mind;
    const Tick tick = turn.tick;
    // The bots of the two players choose in different ticks, so that the work of both does not fall into the
    // same tick.
    if (tick % choice_period / gameplay_period != seat.player * (choice_period / gameplay_period / 2)) return;
    const bool fights = sees_foe(mind, tick) && self.can_shoot && self.energy_share > seat.skill.reserve;
    const auto fetch = best_to_fetch(turn, fights);
    if (fetch.found) {
        mind.errand = Errand::fetch;
        mind.goal = fetch.place;
        return;
    }
    if (mind.errand == Errand::hide && tick < mind.errand_until) return;
    const bool is_hurt = self.health < seat.skill.cover_below;
    const auto hide = is_hurt && sees_foe(mind, tick) ? hiding_place(turn) : Choice{};
    mind.errand = hide.found ? Errand::hide : Errand::none;
    if (!hide.found) return;
    mind.goal = hide.place;
    mind.errand_until = tick + hiding_time;
}

}  // namespace thaum::game::inline bots
