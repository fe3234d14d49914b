#include "game/casting/free_casting.h"

#include <algorithm>
#include <memory>

#include "game/casting/casting.h"
#include "game/casting/free_reading.h"
#include "game/components/hand_state.h"
#include "game/context/arms.h"
#include "game/context/stations.h"

namespace thaum::game::inline casting {
namespace {

using input::Button;
namespace hand = input::hand;

/// Limit of mouse counts (the smallest steps that a mouse reports) per tick, equal to the limit in
/// player/controls.cpp.
constexpr std::int32_t max_counts = 10'000;

const input::DeviceSpec* free_device(const MatchContext& context, std::uint32_t player, std::size_t& number) {
    const auto& devices = context.input.devices;
    for (number = 0; number < devices.size(); ++number) {
        const auto& spec = devices[number];
        if (spec.player == player && spec.casts_freely && spec.kind != input::DeviceKind::arm) return &spec;
    }
    return nullptr;
}

/// Moves the hand of a mouse player by the mouse counts of one tick, with the same scale as in a stroke.
void move_along(const MatchContext& context, std::uint32_t player, FreeHand& free) {
    std::size_t number = 0;
    const auto* spec = free_device(context, player, number);
    if (spec == nullptr) return;
    const auto& counts = context.input.frame.devices[number].counts;
    const double um = context.data.haptic_rules.clutch_per_count * spec->look_rad_per_count /
                      input::DeviceSpec{}.look_rad_per_count;
    const auto way = [&](std::size_t look) {
        return 1e-6 * um * std::clamp(counts[look], -max_counts, max_counts);
    };
    free.path += vec3(way(hand::look_right), way(hand::look_up), 0);
}

/// Position of the hand (m): from a real arm, or else from mouse and stick together.
vec3 place_of(const MatchContext& context, ecs::Entity wizard, std::uint32_t player, const FreeHand& free) {
    if (plays_by_arm(context.world, player)) return context.world.get<HandState>(wizard).device.position;
    std::size_t number = 0;
    const auto* spec = free_device(context, player, number);
    if (spec == nullptr) return free.path;
    const auto& counts = context.input.frame.devices[number].counts;
    const auto stick_place = [&](std::size_t turn) {
        return context.data.casting->stick_reach * std::clamp(counts[turn] / 127.0, -1.0, 1.0);
    };
    return free.path + vec3(stick_place(hand::turn_right), stick_place(hand::turn_up), 0);
}

/// Whether the hand is in use for something else, so that its motion casts no spell without a button.
bool is_busy(const ecs::World& world, ecs::Entity wizard) {
    constexpr auto other = bit(Button::fire) | bit(Button::trace) | bit(Button::clutch) | bit(Button::stir);
    return (world.get<Controls>(wizard).held & other) != 0 || world.has<Dead>(wizard) ||
           at_station(world, wizard);
}

/// Records a motion that casts nothing, if it was similar to a gesture, so that the screen can say so.
void note_miss(const CastingRules& rules, Tick tick, const FreeWindow& window, Miss reason, NearMiss& miss) {
    if (window.gesture == no_gesture || window.probability < rules.free_near_probability) return;
    miss = {.at = std::max<Tick>(tick, 1),
            .probability = window.probability,
            .gesture = window.gesture,
            .reason = reason};
}

/// Casts the spell of the gesture drawn before the hand came to rest, if the reading is certain enough and no
/// spell was cast just before.
void cast_drawn(MatchContext& context, const GestureSet& gestures, const Caster& caster, FreeHand& hand) {
    const auto& rules = *context.data.casting;
    const auto& drawn = hand.best;
    auto& miss = context.world.get<NearMiss>(caster.wizard);
    const bool sure =
        drawn.gesture != no_gesture && drawn.miss == Miss::none && drawn.probability >= drawn.needed;
    const bool soon = hand.cast_at != 0 && caster.tick < hand.cast_at + rules.free_apart;
    if (!sure) {
        // The hand is still ending the motion that has just cast a spell, so this is no near miss.
        if (soon) return;
        const auto& odd = hand.odd;
        if (odd.gesture != no_gesture && odd.miss != Miss::unclear && odd.probability >= odd.needed)
            return note_miss(rules, caster.tick, odd, odd.miss, miss);
        const auto reason = is_too_fast(rules, drawn.force) ? Miss::too_fast : Miss::unclear;
        return note_miss(rules, caster.tick, drawn, reason, miss);
    }
    const auto& gesture = gestures.gestures()[drawn.gesture];
    if (spell_of(context.data, gesture.name) == nullptr) return;
    if (soon) return note_miss(rules, caster.tick, drawn, Miss::too_soon, miss);
    Reading reading{
        .stroke = {.gesture = drawn.gesture, .probability = drawn.probability, .force = drawn.force},
        .nearest = drawn.gesture};
    if (gesture.options.closed) reading.stroke.turns = 1;
    hand.cast_at = std::max<Tick>(caster.tick, 1);
    act_on(context, caster, reading, gestures);
}

void follow(MatchContext& context, ReadingSpace& space, const Caster& caster, FreeHand& hand) {
    if (is_busy(std::as_const(context.world), caster.wizard)) return forget_motion(hand);
    const auto& rules = *context.data.casting;
    const auto& gestures = *gestures_of(context, caster.player);
    add_place(rules, place_of(context, caster.wizard, caster.player, hand), caster.tick, hand);
    if (read_windows(rules, gestures, space, hand)) cast_drawn(context, gestures, caster, hand);
}

}  // namespace

bool casts_freely(const MatchContext& context, std::uint32_t player) {
    const auto& devices = context.input.devices;
    return context.data.gestures != nullptr &&
           std::any_of(devices.begin(), devices.end(),
                       [&](const auto& d) { return d.player == player && d.casts_freely; });
}

void add_free_casting_systems(MatchContext& context, ecs::Schedule& schedule) {
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
    access.writes |= world.mask<FreeHand, NearMiss>();
    schedule.add({.name = "free casting",
                  .period = gameplay_period,
                  .reads = access.reads,
                  .writes = access.writes,
                  .needs = world.mask<FreeHand>(),
                  .run = [&context, space = std::make_shared<ReadingSpace>()](ecs::World& w, Tick tick) {
                      w.view<const Wizard, FreeHand>().each(
                          [&](ecs::Entity e, const Wizard& wizard, FreeHand& hand) {
                              follow(context, *space, {e, wizard.player, tick}, hand);
                          });
                  }});
}

}  // namespace thaum::game::inline casting
