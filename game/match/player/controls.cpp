#include "game/match/player/controls.h"

#include <algorithm>
#include <cmath>

#include "game/casting/casting.h"
#include "game/components/fog.h"
#include "game/context/aim_assist.h"
#include "game/context/arms.h"
#include "game/context/stations.h"
#include "input/stick.h"

namespace thaum::game::inline match {
namespace {

using input::Button;
namespace hand = input::hand;

/// Limit of mouse counts per tick: more than any mouse reports, and small enough that no product overflows.
constexpr std::int32_t max_counts = 10'000;

double wrapped(double angle) {
    if (angle > pi) return angle - 2 * pi;
    if (angle < -pi) return angle + 2 * pi;
    return angle;
}

/// Turns the view by the mouse or stick motion in the sample, and by aim assist.
void turn(const input::DeviceSample& sample, const input::DeviceSpec& spec, double pitch_limit,
          const ViewHelp& help, Gaze& gaze) {
    const double step = spec.turn_rad_per_s * tick_seconds;
    const auto& counts = sample.counts;
    const double right = help.turn_share * (spec.look_rad_per_count * counts[hand::look_right] +
                                            step * stick_curve(counts[hand::turn_right]));
    double up = help.turn_share *
                (spec.look_rad_per_count * counts[hand::look_up] + step * stick_curve(counts[hand::turn_up]));
    if (spec.invert_y) up = -up;
    gaze.yaw = wrapped(gaze.yaw - std::clamp(right, -pi, pi) + help.left);
    gaze.pitch = std::clamp(gaze.pitch + up + help.up, -pitch_limit, pitch_limit);
}

/// Whether the player gives any input, without which aim assist does nothing.
bool acts(const input::DeviceSample& sample) {
    const auto& counts = sample.counts;
    return counts[hand::look_right] != 0 || counts[hand::look_up] != 0 || counts[hand::turn_right] != 0 ||
           counts[hand::turn_up] != 0 || counts[hand::strafe] != 0 || counts[hand::forward] != 0 ||
           sample.down(Button::fire);
}

/// Displacement of the hand in one tick by a deflected stick (um).
std::int32_t stick_step(const HapticRules& rules, std::int32_t deflection) {
    return static_cast<std::int32_t>(std::lround(rules.clutch_per_tick * stick_curve(deflection)));
}

/// Moves the hand by mouse and stick while the clutch is held, the button for moving the hand instead of the
/// view. The view stands still.
void move_hand(const input::DeviceSample& sample, const HapticRules& rules, Controls& controls) {
    const auto& counts = sample.counts;
    const auto moved = [&](std::size_t look, std::size_t turning) {
        return std::clamp(counts[look], -max_counts, max_counts) * rules.clutch_per_count +
               stick_step(rules, counts[turning]);
    };
    controls.hand_right = moved(hand::look_right, hand::turn_right);
    controls.hand_up = moved(hand::look_up, hand::turn_up);
}

/// Share of its full deflection from which on a stick draws a stroke.
constexpr double stick_begins = 0.8;

/// Moves a hand that draws a stroke. Mouse counts move the hand in proportion to how they turn the view, so
/// the player's sensitivity applies to both. A stick sets the hand's position, so turning the stick draws a
/// circle. The stick's first motion, from its middle to its rim, is left out of the stroke, because all
/// gestures begin away from their middle.
void move_tracing_hand(const input::DeviceSample& sample, const input::DeviceSpec& spec,
                       const HapticRules& rules, double stick_reach, Controls& controls) {
    const auto& counts = sample.counts;
    const double pace =
        rules.clutch_per_count * spec.look_rad_per_count / input::DeviceSpec{}.look_rad_per_count;
    const auto by_mouse = [&](std::size_t look) {
        const double way = pace * std::clamp(counts[look], -max_counts, max_counts);
        return static_cast<std::int32_t>(std::lround(std::clamp(way, -1e6, 1e6)));
    };
    const auto stick_place = [&](std::size_t turning) {
        const double deflection = std::clamp(counts[turning] / 127.0, -1.0, 1.0);
        return static_cast<std::int32_t>(std::lround(1e6 * stick_reach * deflection));
    };
    const std::int32_t right = stick_place(hand::turn_right), up = stick_place(hand::turn_up);
    if (controls.stick_draws == 0) {
        controls.stick_right = right;
        controls.stick_up = up;
        const double out = std::sqrt(static_cast<double>(right) * right + static_cast<double>(up) * up);
        controls.stick_draws = out >= 1e6 * stick_reach * stick_begins ? 1 : 0;
    }
    controls.hand_right = by_mouse(hand::look_right) + right - controls.stick_right;
    controls.hand_up = by_mouse(hand::look_up) + up - controls.stick_up;
    controls.stick_right = right;
    controls.stick_up = up;
}

/// Moves the hand of a wizard at a station, who stands still meanwhile. Mouse and stick move a ladle in the
/// plane of the brew's surface, and the keys or stick for walking forward and back lift and sink it. At orb
/// and crystal, mouse and stick move the hand across the view, and walking forward and back moves it in and
/// out. Walking sideways turns a crystal (game/stations/crystal/chisel.h).
void move_hand_at(StationKind station, const input::DeviceSample& sample, const HapticRules& rules,
                  Controls& controls) {
    move_hand(sample, rules, controls);
    const auto walking = stick_step(rules, controls.forward);
    if (station == StationKind::cauldron) {
        controls.hand_back = -controls.hand_up;
        controls.hand_up = walking;
    } else {
        controls.hand_back = -walking;
    }
    if (station != StationKind::crystal) controls.strafe = 0;
    controls.forward = 0;
    controls.pressed &= ~bit(Button::jump);
}

/// Adds the buttons of a player's arm to the sample of the player's other device. The arm controls hand and
/// wand; the other device controls view and walking.
input::DeviceSample with_arm(input::DeviceSample hands, std::uint32_t buttons) {
    hands.buttons |= buttons;
    if ((buttons & bit(Button::fire)) != 0) hands.counts[hand::trigger] = 255;
    return hands;
}

std::uint32_t arm_buttons(const MatchContext& context, std::uint32_t player) {
    std::uint32_t buttons = 0;
    const auto& devices = context.input.devices;
    for (std::size_t d = 0; d < devices.size(); ++d) {
        const bool arm = devices[d].kind == input::DeviceKind::arm;
        if (arm && devices[d].player == player) buttons |= context.input.frame.devices[d].buttons;
    }
    return buttons;
}

/// Buttons of the sample. If fire is pressed while the button Trace is held, a spell cast by a wand's key
/// becomes harsh (stronger). No shot is then fired until fire is released and pressed again.
std::uint32_t buttons_of(const input::DeviceSample& sample, Controls& controls) {
    constexpr auto fire = bit(Button::fire);
    const bool fired_before = (controls.held & fire) != 0;
    const bool chord = !fired_before && (sample.down(Button::trace) || controls.harsh != 0);
    controls.harsh = chord && sample.down(Button::fire) ? 1 : 0;
    return chord ? sample.buttons & ~fire : sample.buttons;
}

void take(const input::DeviceSample& sample, bool has_spells, Controls& controls) {
    const auto buttons = has_spells ? buttons_of(sample, controls) : sample.buttons;
    controls.pressed |= buttons & ~controls.held;
    controls.held = buttons;
    if (sample.wand != controls.wand_held && sample.wand <= wand_slots && sample.wand != 0)
        controls.wand_pressed = sample.wand;
    controls.wand_held = sample.wand;
    const auto& counts = sample.counts;
    controls.strafe = std::clamp(counts[hand::strafe], -127, 127);
    controls.forward = std::clamp(counts[hand::forward], -127, 127);
    controls.trigger = std::clamp(counts[hand::trigger], 0, 255);
    controls.hand_right = controls.hand_up = controls.hand_back = 0;
    controls.wheel = std::clamp(controls.wheel + std::clamp(counts[hand::wheel], -100, 100), -100, 100);
}

/// The wizard whose controls are applied, and the number of its player.
struct Player {
    ecs::Entity wizard;
    std::uint32_t number{};
};

/// Moves hand or view by the sample, depending on the held buttons.
void apply(MatchContext& context, const Player& player, const input::DeviceSample& sample,
           const input::DeviceSpec& spec, Controls& controls, Gaze& gaze) {
    auto& world = context.world;
    const auto& rules = context.data.haptic_rules;
    const bool arm = plays_by_arm(world, player.number);
    const bool traces = context.data.gestures && (controls.held & bit(Button::trace)) != 0;
    if (traces && !std::as_const(world).has<Dead>(player.wizard) &&
        (controls.pressed & bit(Button::trace)) != 0)
        begin_stroke(context, player.wizard);
    if (!traces) {
        controls.stick_right = controls.stick_up = 0;
        controls.stick_draws = 0;
    }
    if (const auto* station = std::as_const(world).find<AtStation>(player.wizard); station != nullptr) {
        move_hand_at(station->kind, sample, rules, controls);
    } else if (traces && !arm) {
        move_tracing_hand(sample, spec, rules, context.data.casting->stick_reach, controls);
    } else if (!arm && (controls.held & bit(Button::clutch)) != 0) {
        move_hand(sample, rules, controls);
    } else {
        turn(sample, spec, context.data.wizard.pitch_limit,
             acts(sample) ? view_help(context, player.wizard) : ViewHelp{}, gaze);
    }
}

}  // namespace

double stick_curve(std::int32_t deflection) {
    const double x = std::clamp(static_cast<double>(deflection) / 127.0, -1.0, 1.0);
    return input::turn_share(x);
}

void add_controls_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "controls",
                  .reads = world.mask<Wizard, Match, Arm, AtStation, WandBelt, Dead, HandState, Fog, Motion,
                                      resource::Physics>(),
                  .writes = world.mask<Controls, Gaze, DrawnStroke>(),
                  .needs = world.mask<Controls>(),
                  .run = [&context](ecs::World& w, Tick) {
                      const auto& match = std::as_const(w).single<Match>();
                      const bool live = match.paused == 0 && match.phase == Phase::playing;
                      w.view<const Wizard, Controls, Gaze>().each(
                          [&](ecs::Entity e, const Wizard& wizard, Controls& controls, Gaze& gaze) {
                              const auto buttons = arm_buttons(context, wizard.player);
                              for (std::size_t d = 0; d < context.input.devices.size(); ++d) {
                                  const auto& spec = context.input.devices[d];
                                  if (spec.player != wizard.player || spec.kind == input::DeviceKind::arm)
                                      continue;
                                  const auto sample = with_arm(context.input.frame.devices[d], buttons);
                                  take(sample, context.data.gestures != nullptr, controls);
                                  if (live) apply(context, {e, wizard.player}, sample, spec, controls, gaze);
                              }
                          });
                  }});
}

void add_pause_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "pause",
                  .reads = world.mask<Wizard>(),
                  .writes = world.mask<Controls, Match>(),
                  .needs = world.mask<Controls>(),
                  .run = [](ecs::World& w, Tick) {
                      auto& match = w.single<Match>();
                      w.view<const Wizard, Controls>().each([&](const Wizard& wizard, Controls& controls) {
                          if ((controls.pressed & bit(Button::pause)) == 0) return;
                          controls.pressed &= ~bit(Button::pause);
                          if (match.phase != Phase::playing) return;
                          match.paused ^= 1U;
                          match.paused_by = match.paused != 0 ? wizard.player : no_player;
                      });
                      // Buttons pressed during a pause have no effect afterwards.
                      if (match.paused != 0 || match.phase != Phase::playing) {
                          w.view<Controls>().each(
                              [](Controls& c) { c.pressed = 0, c.wand_pressed = 0, c.wheel = 0; });
                      }
                  }});
}

void add_controls_used_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "controls used",
                  .period = gameplay_period,
                  .writes = world.mask<Controls>(),
                  .needs = world.mask<Controls>(),
                  .run = [](ecs::World& w, Tick) {
                      w.view<Controls>().each(
                          [](Controls& c) { c.pressed = 0, c.wand_pressed = 0, c.wheel = 0; });
                  }});
}

}  // namespace thaum::game::inline match
