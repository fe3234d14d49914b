#include "game/bots/armoury.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline bots {
namespace {

using input::bit;
using input::Button;

/// Least distance of the foe for a shot that bursts, as a multiple of the burst's radius. A nearer burst
/// would hurt the bot.
constexpr double clear_of_burst = 1.4;
/// Largest distance of a throw (m). Beyond it the missile bursts before it arrives.
constexpr double throw_within = 14;

/// How a wand's shots fly and how fire is used: rapid bolts, charged shots, or shots on a parabola.
enum class Way : std::uint8_t { rapid, charged, arc };

Way way_of(const ShotKind& shot) {
    if (!shot.held) return Way::rapid;
    return shot.fall > 0 ? Way::arc : Way::charged;
}

/// Situation in which a wand is chosen.
struct Prospect {
    const Self& self;
    const Seat& seat;
    double distance;  ///< distance to the foe (m)
    double up;        ///< height of the foe above the bot's eye (m)
    double gravity;   ///< downward acceleration of missiles (m/s^2)
    bool hidden;      ///< true: the foe has just gone out of sight
};

bool hidden(const Mind& mind, Tick tick) {
    return mind.foe_seen_at != 0 && tick > mind.foe_seen_at + ticks(0.25) &&
           tick < mind.foe_seen_at + ticks(1.2);
}

/// How far to draw a wand (like a bow) before a throw over this distance, 0 to 1. The farther it is drawn,
/// the faster the missile. The throw is 1.5 times as fast as the slowest throw that reaches the foe, so that
/// it is flat. Over cover it is only 1.05 times as fast.
double draw_for(const LoadedWand& wand, const Prospect& prospect) {
    const double reach =
        prospect.up + std::sqrt(prospect.up * prospect.up + prospect.distance * prospect.distance);
    const auto slow = *wand.rules->shot(0, prospect.gravity), fast = *wand.rules->shot(1, prospect.gravity);
    const double least = std::sqrt(std::max(0.0, fast.fall * reach));
    const double speed = least * (prospect.hidden ? 1.05 : 1.5);
    const double range = fast.speed - slow.speed;
    return range > 0 ? std::clamp((speed - slow.speed) / range, 0.1, 1.0) : 1;
}

/// How far the bot would charge or draw this wand, 0 to 1; negative if the wand is of no use now. The wand
/// must be one that shoots.
double readiness_for(const LoadedWand& wand, const WandBelt& belt, const Prospect& prospect, Random& random) {
    const auto shot = [&](double share) { return *wand.rules->shot(share, prospect.gravity); };
    const double energy = belt.energy[wand.stats.energy_slot];
    if (energy < shot(0).energy || energy < wand.stats.energy_cost) return -1;
    const auto way = way_of(shot(0));
    if (way == Way::rapid) return 0;
    if (prospect.distance < clear_of_burst * shot(1).radius) return -1;
    if (way == Way::arc)
        return prospect.seat.skill.arcs != 0 && prospect.distance < throw_within ? draw_for(wand, prospect)
                                                                                 : -1;
    double share = prospect.seat.skill.charge * random.uniform(0.5, 1.0);
    while (share > 0.01 && shot(share).energy > energy) share -= 0.1;
    return std::max(share, 0.0);
}

/// Chooses one of the useful wands whose shots fly like `way`, and writes its slot and its wanted charge or
/// draw to `mind`. The probability of each useful wand is in proportion to how much bots like its shot
/// (ShotKind::liking).
bool take(const MatchData& data, const WandBelt& belt, const Prospect& prospect, Way way, Mind& mind) {
    double liking = 0;
    for (const auto& wand : data.wands) {
        const auto shot = wand.rules->shot(0, prospect.gravity);
        if (!shot || way_of(*shot) != way) continue;
        const double readiness = readiness_for(wand, belt, prospect, mind.random);
        if (readiness < 0) continue;
        const bool first = liking == 0;
        liking += shot->liking;
        if (!first && mind.random.uniform() * liking >= shot->liking) continue;
        mind.wand = wand.stats.slot;
        mind.readiness = readiness;
    }
    return liking > 0;
}

void choose_anew(const MatchData& data, const WandBelt& belt, const Prospect& prospect, Mind& mind,
                 Tick tick) {
    mind.wand_until = tick + ticks(mind.random.uniform(1.5, 3.0));
    const bool varies = mind.random.uniform() < prospect.seat.skill.variety;
    const bool throws = mind.random.uniform() < prospect.seat.skill.throws;
    if (varies && throws && take(data, belt, prospect, Way::arc, mind)) return;
    if (varies && take(data, belt, prospect, Way::charged, mind)) return;
    if (take(data, belt, prospect, Way::rapid, mind) || take(data, belt, prospect, Way::charged, mind))
        return;
    if (take(data, belt, prospect, Way::arc, mind)) return;
    // No wand has enough energy. The bot still chooses one that shoots; when fire has no effect, it notices
    // the missing energy.
    const auto shoots = [&](const LoadedWand& wand) {
        return wand.rules->shot(0, prospect.gravity).has_value();
    };
    const auto in_mind = [&](const LoadedWand& wand) { return shoots(wand) && wand.stats.slot == mind.wand; };
    if (std::any_of(data.wands.begin(), data.wands.end(), in_mind)) return;
    const auto first = std::find_if(data.wands.begin(), data.wands.end(), shoots);
    if (first != data.wands.end()) mind.wand = first->stats.slot;
}

}  // namespace

bool in_hand(const Self& self, Mind& mind) {
    mind.wand_key = 0;
    if (mind.wand == self.wand) return true;
    mind.buttons &= ~(bit(Button::fire) | bit(Button::throw_));
    mind.wand_key = mind.wand + 1;
    return false;
}

bool choose_wand(const BotTurn& turn) {
    const auto& match = turn.match;
    const auto& self = turn.self;
    const auto& seat = turn.seat;
    auto& mind = turn.mind;
    const Tick tick = turn.tick;
    const auto& belt = match.world().get<WandBelt>(wizard_of(match.world(), seat.player));
    const bool readying = self.shot.held && (mind.buttons & bit(Button::fire)) != 0;
    if (!readying) {
        const vec3 to = mind.foe - self.eye;
        const Prospect prospect{
            self, seat, glm::length(to), to.y, match.data().wizard.gravity, hidden(mind, tick)};
        const bool over =
            prospect.hidden && self.shot.fall == 0 && mind.random.uniform() < seat.skill.over_cover;
        if (over && take(match.data(), belt, prospect, Way::arc, mind))
            mind.wand_until = tick + ticks(2.0);
        else if (tick >= mind.wand_until || !self.can_shoot)
            choose_anew(match.data(), belt, prospect, mind, tick);
    }
    return in_hand(self, mind);
}

}  // namespace thaum::game::inline bots
