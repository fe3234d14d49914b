#include "game/bots/stirring.h"

#include <cmath>

#include "game/cauldron/ladle.h"

namespace thaum::game {
namespace {

namespace hand = input::hand;

constexpr double beside_rim = 0.75;   ///< distance from the rim at which a bot stands (m)
constexpr double needs_energy = 0.6;  ///< share of the wand's energy below which stirring is worth the time
constexpr double has_enough = 0.97;
constexpr double unnerved = 8;  ///< loss of health at the rim after which the bot fights back (HP)
constexpr Tick way_limit = ticks(6.0);
constexpr Tick unseen = ticks(1.5);
constexpr Tick period = ticks(1.1);  ///< ticks of one circle
/// Mouse counts per tick; the circle then uses the whole reach of the hand.
constexpr double counts = 2.6;

bool foe_stirs(const Simulation& match, const Seat& seat, const Mind& mind, Tick tick) {
    const bool seen = mind.foe_seen_at != 0 && tick - mind.foe_seen_at < unseen;
    return seen && match.world().has<Ladle>(wizard_of(match.world(), 1 - seat.player));
}

bool is_worth_it(const Simulation& match, const Self& self, const Seat& seat, const Mind& mind, Tick tick) {
    if (foe_stirs(match, seat, mind, tick)) return true;
    const bool alone = mind.foe_seen_at == 0 || tick - mind.foe_seen_at > unseen;
    return alone && self.energy_share < needs_energy;
}

vec3 place_at_rim(const Simulation& match, const Cauldron& cauldron, vec3 from) {
    const vec3 way = from - cauldron.middle;
    const double far = match.data().arena.bowl->size.radius + beside_rim;
    return cauldron.middle + vec3(way.x, 0, way.z) * (far / std::max(1e-6, off_axis(way)));
}

void end(const Seat& seat, Mind& mind, StirPlan& stir_plan, Tick tick) {
    stir_plan.stage = StirStage::none;
    stir_plan.not_before = tick + seat.skill.stir.rest;
    if (mind.errand == Errand::stir) mind.errand = Errand::none;
}

}  // namespace

void plan_to_stir(const Simulation& match, const Self& self, const Seat& seat, Mind& mind,
                  StirPlan& stir_plan, Tick tick) {
    const auto& skill = seat.skill.stir;
    if (!(skill.share > 0) || !match.data().cauldron || match.world().count<Cauldron>() == 0) return;
    const auto& cauldron = match.world().single<Cauldron>();
    const bool wanted = is_worth_it(match, self, seat, mind, tick);
    switch (stir_plan.stage) {
        case StirStage::none:
            if (tick < stir_plan.not_before || !wanted || mind.errand != Errand::none) return;
            stir_plan.not_before = tick + ticks(0.5);
            if (off_axis(self.centre - cauldron.middle) > skill.seek || mind.random.uniform() >= skill.share)
                return;
            stir_plan.stage = StirStage::approach;
            stir_plan.until = tick + way_limit;
            [[fallthrough]];
        case StirStage::approach:
            if (tick >= stir_plan.until || !wanted) return end(seat, mind, stir_plan, tick);
            mind.errand = Errand::stir;
            mind.goal = place_at_rim(match, cauldron, self.centre);
            if (!within_reach(match.data(), cauldron, self.centre)) return;
            stir_plan.stage = StirStage::stir;
            stir_plan.until = tick + skill.hold;
            stir_plan.health = self.health;
            return;
        case StirStage::stir:
            const bool full = self.energy_share > has_enough && !foe_stirs(match, seat, mind, tick);
            if (tick >= stir_plan.until || full || self.health < stir_plan.health - unnerved)
                end(seat, mind, stir_plan, tick);
    }
}

void stir_hand(Tick tick, input::DeviceSample& sample) {
    sample = {};
    const double angle = 2 * pi * static_cast<double>(tick % period) / static_cast<double>(period);
    sample.press(input::Button::stir);
    sample.counts[hand::look_right] = static_cast<std::int32_t>(std::lround(counts * det::cos(angle)));
    sample.counts[hand::look_up] = static_cast<std::int32_t>(std::lround(counts * det::sin(angle)));
}

}  // namespace thaum::game
