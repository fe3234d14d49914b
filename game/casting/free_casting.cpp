#include "game/casting/free_casting.h"

#include <algorithm>
#include <cmath>

#include "game/casting/casting.h"
#include "game/casting/reading.h"
#include "game/components/cauldron.h"
#include "game/components/hand_state.h"
#include "game/context/arms.h"

namespace thaum::game {
namespace {

using input::Button;
namespace hand = input::hand;

/// Calls of the spotter in a gameplay tick, and windows in each. Together they finish the scan of an end.
constexpr int spotter_calls = 6;
constexpr std::size_t windows_per_call = 12;
/// Limit of mouse counts per tick, as in player/controls.cpp.
constexpr std::int32_t most_counts = 10'000;

gesture::StrokePoint point_of(const FreeHand& hand, std::uint32_t number) {
    const auto& p = hand.points[(hand.first + number) % free_points];
    const auto later = hand.count - 1 - number;
    const double t = seconds(hand.newest - std::min(hand.newest, Tick{later} * gameplay_period));
    return {t, vec3(p.x, p.y, p.z), static_cast<double>(p.force)};
}

const input::DeviceSpec* free_device(const MatchContext& context, std::uint32_t player, std::size_t& number) {
    const auto& devices = context.input.devices;
    for (number = 0; number < devices.size(); ++number) {
        const auto& spec = devices[number];
        if (spec.player == player && spec.casts_freely && spec.kind != input::DeviceKind::arm) return &spec;
    }
    return nullptr;
}

/// Moves the hand of a mouse by the counts of one tick, at the pace of a stroke.
void move_along(const MatchContext& context, std::uint32_t player, FreeHand& free) {
    std::size_t number = 0;
    const auto* spec = free_device(context, player, number);
    if (spec == nullptr) return;
    const auto& counts = context.input.frame.devices[number].counts;
    const double um = context.data.haptic_rules.clutch_per_count * spec->look_rad_per_count /
                      input::DeviceSpec{}.look_rad_per_count;
    const auto way = [&](std::size_t look) {
        return 1e-6 * um * std::clamp(counts[look], -most_counts, most_counts);
    };
    free.path += vec3(way(hand::look_right), way(hand::look_up), 0);
}

/// Place of the hand (m): that of an arm, or that of a mouse with that of a stick.
vec3 place_of(const MatchContext& context, ecs::Entity wizard, std::uint32_t player, const FreeHand& free) {
    if (plays_by_arm(context.world, player)) return context.world.get<HandState>(wizard).device.position;
    std::size_t number = 0;
    const auto* spec = free_device(context, player, number);
    if (spec == nullptr) return free.path;
    const auto& counts = context.input.frame.devices[number].counts;
    const auto by_stick = [&](std::size_t turn) {
        return context.data.casting->stick_reach * std::clamp(counts[turn] / 127.0, -1.0, 1.0);
    };
    return free.path + vec3(by_stick(hand::turn_right), by_stick(hand::turn_up), 0);
}

void append(const CastingRules& rules, vec3 place, Tick tick, FreeHand& free) {
    double force = 0;
    if (free.count > 0) {
        const auto& last = free.points[(free.first + free.count - 1) % free_points];
        force = rules.viscosity * glm::distance(place, vec3(last.x, last.y, last.z)) / gameplay_dt;
    }
    if (free.count == free_points) {
        free.first = (free.first + 1) % free_points;
        --free.count;
    }
    free.points[(free.first + free.count) % free_points] = {
        static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z),
        static_cast<float>(force)};
    ++free.count;
    free.newest = tick;
}

/// Whether the hand does something else now.
bool is_busy(const ecs::World& world, ecs::Entity wizard) {
    constexpr auto other = bit(Button::fire) | bit(Button::trace) | bit(Button::clutch) | bit(Button::stir);
    return (world.get<Controls>(wizard).held & other) != 0 || world.has<Dead>(wizard) ||
           world.has<Ladle>(wizard);
}

/// Casts the spell of a gesture that was found, if it is sure enough and none was cast just now.
void cast_found(MatchContext& context, const Caster& caster, const gesture::Candidate& found,
                FreeHand& free) {
    const auto& rules = *context.data.casting;
    const auto* gestures = gestures_of(context, caster.player);
    const double probability = gestures->recogniser().probability_of(
        found.gesture, found.distance, found.runner_up != gesture::Recognition::none,
        found.runner_up_distance);
    const bool soon = free.cast_at != 0 && caster.tick < free.cast_at + rules.free_apart;
    if (soon || probability < rules.free_least_probability) return;
    const auto& gesture = gestures->gestures()[found.gesture];
    if (spell_of(context.data, gesture.name) == nullptr) return;
    Reading reading{
        .stroke = {.gesture = found.gesture, .probability = probability, .force = found.mean_force},
        .nearest = found.gesture};
    if (gesture.options.closed) reading.stroke.turns = 1;
    free.cast_at = std::max<Tick>(caster.tick, 1);
    act_on(context, caster, reading, *gestures);
}

void follow(MatchContext& context, FreeCasting& free_casting, const Caster& caster, FreeHand& free) {
    if (is_busy(std::as_const(context.world), caster.wizard)) {
        free.count = 0;
        return;
    }
    if (free.count == 0) free_casting.rebuild(context, caster.player, free);
    const vec3 place = place_of(context, caster.wizard, caster.player, free);
    append(*context.data.casting, place, caster.tick, free);
    const auto found = free_casting.feed(*context.data.casting, caster.player, free);
    if (found) cast_found(context, caster, *found, free);
}

}  // namespace

bool casts_freely(const MatchContext& context, std::uint32_t player) {
    const auto& devices = context.input.devices;
    return context.data.gestures != nullptr &&
           std::any_of(devices.begin(), devices.end(),
                       [&](const auto& d) { return d.player == player && d.casts_freely; });
}

namespace {

/// Way of the hand from a time up to the point of this number (m).
double way_since(const FreeHand& hand, double time, std::uint32_t number) {
    double way = 0;
    for (auto i = number; i > 0; --i) {
        const auto to = point_of(hand, i), from = point_of(hand, i - 1);
        if (to.t <= time) break;
        way += glm::distance(from.at, to.at);
    }
    return way;
}

/// Whether a candidate takes the place of an earlier one. One that ends later has more of the stroke, so it may be a
/// little farther from the recorded strokes.
bool is_better(const gesture::Candidate& candidate, const gesture::Candidate& best) {
    constexpr float allowance = 0.04F;
    return candidate.score < best.score + (candidate.end > best.end ? allowance : 0);
}

}  // namespace

/// Gives one point to the spotter, and chooses among its candidates.
std::optional<gesture::Candidate> FreeCasting::take(const CastingRules& rules, const FreeHand& hand,
                                                    std::uint32_t number, Watch& watch) const {
    const auto point = point_of(hand, number);
    for (int i = 0; i < spotter_calls; ++i) {
        for (const auto& candidate : watch.spotter->scan(point)) {
            if (static_cast<double>(candidate.score) > rules.free_most_score) continue;
            if (!watch.best || is_better(candidate, *watch.best)) watch.best = candidate;
        }
    }
    if (!watch.best) return std::nullopt;
    if (way_since(hand, watch.best->end, number) > rules.free_rest_way) watch.best.reset();
    if (!watch.best || point.t - watch.best->end < seconds(rules.free_rest)) return std::nullopt;
    const auto found = watch.best;
    watch.best.reset();
    return found;
}

std::optional<gesture::Candidate> FreeCasting::feed(const CastingRules& rules, std::uint32_t player,
                                                    const FreeHand& hand) {
    return take(rules, hand, hand.count - 1, watches_[player]);
}

void FreeCasting::rebuild(const MatchContext& context, std::uint32_t player, const FreeHand& hand) {
    auto& watch = watches_[player];
    const auto& rules = *context.data.casting;
    if (!watch.spotter)
        watch.spotter = std::make_unique<gesture::Spotter>(
            gestures_of(context, player)->recogniser(),
            gesture::SpotterSettings{.longest = seconds(rules.free_longest),
                                     .windows_per_tick = windows_per_call});
    watch.spotter->restart();
    watch.best.reset();
    for (std::uint32_t i = 0; i < hand.count; ++i) take(rules, hand, i, watch);
}

void rebuild_free_casting(const MatchContext& context, FreeCasting& free) {
    context.world.view<const Wizard, const FreeHand>().each(
        [&](ecs::Entity, const Wizard& wizard, const FreeHand& hand) {
            free.rebuild(context, wizard.player, hand);
        });
}

void add_free_casting_systems(MatchContext& context, FreeCasting& free, ecs::Schedule& schedule) {
    const bool some = casts_freely(context, 0) || casts_freely(context, 1);
    if (!some) return;
    auto& world = context.world;
    schedule.add({.name = "free hands",
                  .reads = world.mask<Wizard>(),
                  .writes = world.mask<FreeHand>(),
                  .needs = world.mask<FreeHand>(),
                  .run = [&context](ecs::World& w, Tick) {
                      w.view<const Wizard, FreeHand>().each(
                          [&](ecs::Entity, const Wizard& wizard, FreeHand& hand) {
                              move_along(context, wizard.player, hand);
                          });
                  }});
    auto access = access_of_casting(context);
    access.reads |= world.mask<Arm>();
    access.writes |= world.mask<FreeHand>();
    schedule.add({.name = "free casting",
                  .period = gameplay_period,
                  .reads = access.reads,
                  .writes = access.writes,
                  .needs = world.mask<FreeHand>(),
                  .run = [&context, &free](ecs::World& w, Tick tick) {
                      w.view<const Wizard, FreeHand>().each(
                          [&](ecs::Entity e, const Wizard& wizard, FreeHand& hand) {
                              follow(context, free, {e, wizard.player, tick}, hand);
                          });
                  }});
}

}  // namespace thaum::game
