// stability/game_hands_rig.h: a match with hands that lift and swing, and the limits that it must keep.
#pragma once
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "game/components/body.h"
#include "game/data/wand_slots.h"
#include "game/match/player/walk.h"
#include "game/match/spawn.h"
#include "haptics/audit/safety_audit.h"
#include "unit/game_duel.h"

namespace thaum::game::test {

using input::Button;

inline constexpr double wall = 20;            // distance from the middle of the arena to its walls (m)
inline constexpr double fastest_wizard = 30;  // largest allowed speed (m/s); a fall of 12 m ends with 15 m/s
// Largest energy that springs and other passive sources of force may create (J)
inline constexpr double most_created = 0.02;
// Largest energy that active sources (forces that push the hand by themselves) may give in about a second (J)
inline constexpr double max_given = 1.0;
// Speed of a hand that jumps by 10 cm within a tick, averaged over the 30 ms in which the force follows
// (m/s).
inline constexpr double jump_speed = 0.1 / 0.03;
// Index of the arm of player 0 among the devices; the arm of player 1 is 3.
inline constexpr std::uint32_t arm_device = 2;

/// Limits checked in every tick for all bodies and both hands.
struct Watch {
    std::array<haptics::SafetyAudit, players> audits{};
    double fastest = 0, created = 0, given = 0, strongest = 0, energy = 0;

    void look(const Simulation& match) {
        const auto& world = match.world();
        world.view<const Motion, const Body>().each([&](ecs::Entity e, const Motion& m, const Body& body) {
            if (body.mass <= 0) return;
            ASSERT_TRUE(is_finite(m.position) && is_finite(m.velocity) && is_finite(m.spin)) << e.index;
            const double off = std::max(std::abs(m.position.x), std::abs(m.position.z));
            ASSERT_LT(off, wall) << "through the wall";
            ASSERT_GT(m.position.y, -6) << "through the ground";
        });
        for (std::uint32_t p = 0; p < players; ++p) {
            const auto wizard = wizard_of(world, p);
            const auto& hand_state = world.get<HandState>(wizard);
            const vec3 told = hand_state.servo.safety.output;
            audits[p].record(match.haptic_setup().servos[p].limits, {.wanted = told}, told);
            strongest = std::max(strongest, glm::length(told));
            created = std::max(created, hand_state.servo.energy.most_created);
            given = std::max(given, hand_state.servo.energy.active_work);
            fastest = std::max(fastest, glm::length(world.get<Motion>(wizard).velocity));
            ASSERT_TRUE(is_finite(hand_state.device.position) && is_finite(hand_state.device.velocity));
        }
        world.view<const Prop, const Motion, const Body>().each(
            [&](const Prop&, const Motion& m, const Body& body) {
                energy = std::max(energy, body.mass * glm::dot(m.velocity, m.velocity) / 2);
            });
    }
    /// Expects that all limits have been kept. `speed`: speed of a hand that reverses within a tick (m/s).
    /// The measured velocity is an average over 8 ms, so for that time it has the wrong sign and damping
    /// drives the hand.
    void expect_tame(double speed = 0) const {
        for (const auto& audit : audits) {
            EXPECT_EQ(audit.violations(haptics::SafetyRule::finite), 0U);
            EXPECT_EQ(audit.violations(haptics::SafetyRule::cap), 0U);
            EXPECT_EQ(audit.violations(haptics::SafetyRule::budget), 0U);
        }
        EXPECT_LT(fastest, fastest_wizard) << "the player was launched";
        EXPECT_LE(created, most_created + strongest * speed * 0.03);
        EXPECT_LE(given, max_given);
    }
};

/// An arena without props (loose things) and with two scripted wizards, each of whom may hold an arm.
struct HandsRig {
    Simulation match;
    Watch watch{};
    input::InputFrame frame{};
    std::function<void(input::InputFrame&)> before{};  ///< fills the device samples of a tick
    std::uint64_t held_ticks = 0;

    explicit HandsRig(std::vector<std::string> overrides = {}, int arms = 0)
        : match(duel_data(with_energy(std::move(overrides))), setup(arms)) {
        auto& world = match.world_to_change();
        std::vector<ecs::Entity> props;
        world.view<const Prop>().each([&](ecs::Entity e, const Prop&) { props.push_back(e); });
        for (const auto e : props) world.destroy(e);
        place(0, {8, 0, 16}, {1, 0, 0});
        place(1, {-15, 0, -15}, {1, 0, 0});
    }

    static std::vector<std::string> with_energy(std::vector<std::string> more) {
        for (const auto* free :
             {"lift.energy.per_s=0", "lift.energy.per_n_s=0", "lift.energy.cost=0", "swing.energy.per_s=0",
              "swing.energy.cost=0", "haptics.share=1", "quick.kills=1000", "quick.seconds=3600"})
            more.emplace_back(free);
        return more;
    }
    static MatchSetup setup(int arms) {
        MatchSetup made{.seed = 1,
                        .devices = {{.player = 0, .kind = input::DeviceKind::script, .name = "one"},
                                    {.player = 1, .kind = input::DeviceKind::script, .name = "two"}}};
        for (int i = 0; i < arms; ++i)
            made.devices.push_back(
                {.player = static_cast<std::uint32_t>(i), .kind = input::DeviceKind::arm, .name = "arm"});
        return made;
    }

    ecs::Entity wizard(std::uint32_t p) const { return wizard_of(match.world(), p); }
    const HandState& hand_state(std::uint32_t p) const { return match.world().get<HandState>(wizard(p)); }
    vec3 feet(std::uint32_t p) const { return match.world().get<Motion>(wizard(p)).position; }

    void place(std::uint32_t p, vec3 feet, vec3 way) {
        auto& world = match.world_to_change();
        world.get<Motion>(wizard(p)) = standing_at(match.data().wizard, feet);
        world.get<Stance>(wizard(p)) = {};
        match.physics().set_state(wizard(p).index, std::as_const(world).get<Motion>(wizard(p)));
        world.get<Gaze>(wizard(p)) = {det::atan2(-way.x, -way.z),
                                      det::atan2(way.y, std::sqrt(way.x * way.x + way.z * way.z))};
    }
    void look_at(std::uint32_t p, vec3 target) {
        const vec3 eye = eye_of(match.data().wizard, feet(p));
        const vec3 way = target - eye;
        match.world_to_change().get<Gaze>(wizard(p)) = {
            det::atan2(-way.x, -way.z), det::atan2(way.y, std::sqrt(way.x * way.x + way.z * way.z))};
    }
    /// Adds a box as a prop (a loose thing), or as a fixed part of the arena if the mass is 0.
    ecs::Entity box(vec3 size, double mass, vec3 at) {
        Thing thing;
        thing.prop = mass > 0;
        thing.surface = Surface::crate;
        thing.body.shape = physics::Shape::box;
        thing.body.size = size * 0.5;
        thing.body.mass = mass;
        thing.body.friction = 0.8;
        thing.body.layer = mass > 0 ? layer::prop : layer::ground;
        thing.position = at;
        return spawn_thing(match.world_to_change(), thing);
    }

    void hold(std::uint32_t p, Button button) { frame.devices[p].buttons |= bit(button); }
    void release(std::uint32_t p, Button button) { frame.devices[p].buttons &= ~bit(button); }
    void press(std::uint32_t p, Button button) {
        hold(p, button);
        run(20);
        release(p, button);
        run(8);
    }
    void choose(std::uint32_t p, std::uint8_t wand) {
        frame.devices[p].wand = wand;
        run(20);
        frame.devices[p].wand = 0;
        run(8);
    }
    bool busy(std::uint32_t p) const {
        const auto* wand = wand_in_hand(match.data(), match.world().get<WandBelt>(wizard(p)));
        return wand != nullptr && wand->rules->held_at(match.world(), wizard(p)).has_value();
    }
    void run(Tick ticks) {
        for (Tick t = 0; t < ticks && !testing::Test::HasFatalFailure(); ++t) {
            auto current = frame;
            if (before) before(current);
            match.tick(current);
            watch.look(match);
            held_ticks += busy(0) ? 1 : 0;
        }
    }
    void take(std::uint32_t p, vec3 target) {
        choose(p, 4);
        look_at(p, target);
        hold(p, Button::fire);
        run(40);
        EXPECT_TRUE(busy(p)) << "nothing is held";
    }
    /// Makes the wizard hang on a rope over the pit.
    void hang(std::uint32_t p) {
        place(p, {4, 0, 5}, {0, 0, 1});
        run(50);
        choose(p, 5);
        look_at(p, {4, 7, 9});
        hold(p, Button::fire);
        run(40);
        EXPECT_TRUE(busy(p)) << "does not hang";
    }
};

/// Sample of an arm (a haptic device) at a place, for a tick in which the arm's force came from the newest
/// haptic model.
inline input::DeviceSample arm_sample(vec3 place) {
    input::DeviceSample sample;
    for (int axis = 0; axis < 3; ++axis)
        sample.counts[static_cast<std::size_t>(input::arm::position_x) + static_cast<std::size_t>(axis)] =
            input::quantised(place[axis] * 1e6);
    sample.model_age = 1;
    return sample;
}

/// Triangle wave about 0 with a slope of `speed` (m/s) and a range of `width` (m).
inline double shaken(Tick t, double speed, double width) {
    const double way = speed * tick_seconds * static_cast<double>(t) + width / 2;
    const double phase = std::fmod(way, 2 * width);
    return (phase < width ? phase : 2 * width - phase) - width / 2;
}

}  // namespace thaum::game::test
