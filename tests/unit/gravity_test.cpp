// Tests that the gravity of assets/wizards/wizard.toml acts on wizards, things, missiles and felt weights.
#include <gtest/gtest.h>

#include <utility>

#include "core/text.h"
#include "game/components/hand_state.h"
#include "game/data/wand_slots.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

constexpr double low = 3.7;

TEST(Gravity, IsThatOfTheEarthUnlessAFileSaysOtherwise) {
    EXPECT_EQ(duel_data()->wizard.gravity, 9.81);
    const Simulation match(duel_data(), two_hands());
    EXPECT_EQ(match.physics().settings().gravity, (vec3{0, -9.81, 0}));
    const Simulation light(duel_data({"wizard.gravity_m_s2=3.7"}), two_hands());
    EXPECT_EQ(light.physics().settings().gravity, (vec3{0, -low, 0}));
}

TEST(Gravity, AJumpKeepsItsHeightAndTakesLonger) {
    const auto usual = duel_data(), light = duel_data({"wizard.gravity_m_s2=3.7"});
    const auto height = [](const MatchData& data) {
        return data.wizard.walk.jump_speed * data.wizard.walk.jump_speed / (2 * data.wizard.gravity);
    };
    EXPECT_NEAR(height(*usual), 1.1, 1e-12);
    EXPECT_NEAR(height(*light), 1.1, 1e-12);
}

/// Falls are measured over half a second by a wizard who begins high above the court.
double fallen_in_half_a_second(double gravity) {
    Simulation match(duel_data({text("wizard.gravity_m_s2=", gravity)}), two_hands());
    auto& world = match.world_to_change();
    const auto wizard = wizard_of(world, 0);
    auto& motion = world.get<Motion>(wizard);
    motion.position.y += 6;
    const double from = motion.position.y;
    match.physics().set_state(wizard.index, motion);
    for (Tick t = 0; t < ticks(0.5); ++t) match.tick({});
    return from - std::as_const(match).world().get<Motion>(wizard).position.y;
}

TEST(Gravity, WizardsFallByIt) {
    EXPECT_NEAR(fallen_in_half_a_second(9.81), 9.81 / 8, 0.05);
    EXPECT_NEAR(fallen_in_half_a_second(low), low / 8, 0.02);
}

/// Weight of a thing that the lift wand holds (N): as felt in the hand, and in the world.
std::pair<double, double> weights_at(double gravity) {
    Simulation match(duel_data({text("wizard.gravity_m_s2=", gravity)}), two_hands());
    auto& context = match.context_to_change();
    const auto& lift = wand_of(match.data(), "lift");
    const auto wizard = wizard_of(match.world(), 0);
    ecs::Entity thing{};
    context.world.view<const Prop, const Body>().each([&](ecs::Entity e, const Prop&, const Body& body) {
        if (body.mass <= 20) thing = e;
    });
    input::InputFrame frame;
    frame.devices[0].wand = static_cast<std::uint8_t>(lift.stats.slot + 1);
    for (Tick t = 0; t < 2 * gameplay_period; ++t) match.tick(frame);
    EXPECT_TRUE(lift.rules->catch_thing({context, wizard, match.match().played, lift.stats}, thing));
    frame.devices[0].wand = 0;
    for (Tick t = 0; t < 2 * physics_period; ++t) match.tick(frame);
    return {-match.world().get<HandState>(wizard).steady_force.force.y,
            lift.rules->holding_force(match.world(), wizard, gravity)};
}

TEST(Gravity, HeldThingsWeighByIt) {
    const auto usual = weights_at(9.81), light = weights_at(low);
    ASSERT_GT(usual.first, 0.01);
    EXPECT_NEAR(light.first / usual.first, low / 9.81, 1e-9);
    EXPECT_NEAR(light.second / usual.second, low / 9.81, 1e-9);
}

TEST(Gravity, ShotsThatFlyInAnArcFollowIt) {
    const auto data = duel_data();
    const auto& lob = wand_of(*data, "lob");
    EXPECT_EQ(lob.rules->shot(1, low)->fall, low);
    EXPECT_EQ(wand_of(*data, "bolt").rules->shot(1, low)->fall, 0);
}

}  // namespace
}  // namespace thaum::game::test
