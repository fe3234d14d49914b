// Tests the charts (flat maps) of the body, and where phantom actuators are felt.
#include <cmath>
#include <numeric>

#include "unit/tactile_rig.h"

namespace thaum::tactile {
namespace {

TEST(TactileBody, TheChartIsTheArcOfTheEllipse) {
    const Torso torso(0.16, 0.115);
    double arc = 0;
    vec3 before(0, 1, 0.115);
    for (int i = 1; i <= 3000; ++i) {  // adds up short straight pieces of the right half of the ellipse
        const double angle = pi * i / 3000;
        const vec3 at(0.16 * std::sin(angle), 1, 0.115 * std::cos(angle));
        arc += glm::length(at - before);
        before = at;
        if (i == 3000) break;
        const vec2 chart = torso.chart(at);
        ASSERT_NEAR(chart.x, arc, 3e-5);
        ASSERT_EQ(chart.y, 1);
        ASSERT_NEAR(glm::length(torso.point(chart) - at), 0, 1e-9);
        ASSERT_NEAR(torso.chart({-at.x, 1, at.z}).x, -chart.x, 1e-12);
    }
    EXPECT_NEAR(torso.round(), 2 * arc, 1e-6);
    EXPECT_NEAR(glm::length(torso.point({0.1 + torso.round(), 1}) - torso.point({0.1, 1})), 0, 1e-9);
}

TEST(TactileBody, DirectionsOfTheWorldBecomeDirectionsOfTheBody) {
    const auto expect_near = [](vec3 a, vec3 b) { EXPECT_NEAR(glm::length(a - b), 0, 1e-12); };
    expect_near(to_body_frame({0, 0, -1}, 0), {0, 0, 1});  // straight ahead of the body
    expect_near(to_body_frame({1, 0, 0}, 0), {1, 0, 0});   // to the right of the body
    // The body is turned left, so -x is ahead of it.
    expect_near(to_body_frame({-1, 0, 0}, pi / 2), {0, 0, 1});
    expect_near(to_body_frame({0, 0, 1}, pi / 2), {-1, 0, 0});
}

TEST(TactileBody, RaisedArmsMoveForwardsAndUp) {
    const vec3 wrist(0.22, 0.9, 0);
    const Pose pose = pose_with_arms(0, pi / 2);
    const vec3 raised = posed(pose, Part::arm_right, wrist);
    EXPECT_NEAR(glm::length(raised - vec3(0.22, 1.38, 0.48)), 0, 1e-12);
    EXPECT_NEAR(glm::length(at_rest(pose, Part::arm_right, raised) - wrist), 0, 1e-12);
    EXPECT_EQ(posed(pose, Part::arm_left, {-0.22, 0.9, 0}), vec3(-0.22, 0.9, 0));
    EXPECT_EQ(posed(pose, Part::front, {0, 1, 0.1}), vec3(0, 1, 0.1));
}

/// Largest error (m) of the place at which a touch is felt between actuators of the chest or the back, over a
/// grid of intended places.
double max_error(const Layout& layout, bool front, double sigma) {
    vec2 low(1e9), high(-1e9);
    for (std::size_t i = 0; i < layout.actuators.size(); ++i) {
        if ((layout.actuators[i].place.part == Part::front) != front) continue;
        low = glm::min(low, layout.chart_of(Region::torso, i));
        high = glm::max(high, layout.chart_of(Region::torso, i));
    }
    if (!front) {  // the chart is cut along the middle of the back, so only a part beside the cut is tested
        low.x = layout.torso.round() / 2 - 0.09;
        high.x = low.x + 0.18;
    }
    double worst = 0;
    for (int i = 0; i <= 30; ++i) {
        for (int k = 0; k <= 30; ++k) {
            const vec2 wanted = low + (high - low) * vec2(i / 30.0, k / 30.0);
            const auto found = phantom(layout, {Region::torso, wanted}, vec2(sigma));
            const double sum = std::accumulate(found.shares.begin(), found.shares.end(), 0.0);
            EXPECT_NEAR(sum, 1, 1e-5);
            std::array<double, max_actuators> amplitudes{};
            for (std::size_t a = 0; a < max_actuators; ++a) {
                EXPECT_GE(found.shares[a], 0);
                amplitudes[a] = std::sqrt(static_cast<double>(found.shares[a]));
            }
            const double error = glm::length(felt_offset(layout, Region::torso, wanted, amplitudes));
            EXPECT_NEAR(error, found.error, 1e-6);
            worst = std::max(worst, error);
        }
    }
    return worst;
}

TEST(TactilePhantom, PlacesBetweenActuatorsSixtyMillimetresApartAreFeltWithinOne) {
    const auto layout = shipped_layout("abstract_4x5");
    EXPECT_NEAR(layout.pitch(Region::torso), 0.06, 0.001);
    for (const double sigma : {0.3, 0.7, 1.0}) {
        EXPECT_LT(max_error(layout, true, sigma), 0.001) << sigma;
        EXPECT_LT(max_error(layout, false, sigma), 0.001) << sigma;
    }
}

TEST(TactilePhantom, PlacesOnAJacketAreFeltWithinTenMillimetres) {
    EXPECT_LT(max_error(shipped_layout("x40"), true, 0.7), 0.010);
}

TEST(TactilePhantom, TwoActuatorsShareTheEnergyByDistance) {
    const auto layout = shipped_layout("pad");
    for (const double x : {-0.15, -0.1, -0.03, 0.0, 0.06, 0.14}) {
        const auto found = phantom(layout, layout.chart_place({Part::front, {x, 1.2, 0.1}}), vec2(0.7));
        EXPECT_NEAR(found.shares[1], (x + 0.15) / 0.3, 0.01) << x;
        EXPECT_LT(found.error, 0.003);
    }
    const auto outside = phantom(layout, layout.chart_place({Part::arm_left, {-0.25, 1.2, 0}}), vec2(0.7));
    EXPECT_GT(outside.shares[0], 0.99F);
    EXPECT_EQ(outside.strongest, 0);
}

TEST(TactilePhantom, APlaceAtAnActuatorIsFeltThereAndDoesNotReachFar) {
    const auto layout = shipped_layout("x40");
    for (std::size_t i = 0; i < layout.actuators.size(); ++i) {
        const auto place = layout.chart_place(layout.actuators[i].place);
        const auto found = phantom(layout, place, vec2(0.7));
        EXPECT_EQ(found.strongest, i);
        for (std::size_t k = 0; k < layout.actuators.size(); ++k) {
            const double away =
                glm::length(layout.between(Region::torso, place.at, layout.chart_of(Region::torso, k)));
            if (away > 0.3) {
                EXPECT_EQ(found.shares[k], 0) << i << " " << k;
            }
        }
    }
}

TEST(TactilePhantom, AnyLayoutAndAnyPlaceGiveSharesThatSumToOne) {
    Random random = random_stream(4, 2);
    for (int round = 0; round < 2000; ++round) {
        std::vector<Actuator> actuators(1 + random.below(64));
        for (auto& a : actuators) {
            a = {"a", {Part::whole, {}}, 50, 250, 1};
            a.place.part = random.below(2) == 0 ? Part::front : Part::back;
            const double z = random.uniform(0.001, 0.2);
            a.place.at = {random.uniform(-1, 1), random.uniform(0, 2), a.place.part == Part::front ? z : -z};
        }
        const auto layout = make_layout("random", Torso(0.16, 0.115), actuators);
        if (!layout) continue;  // refused, because two actuators are in one place
        const BodyPoint point{Part::front,
                              {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)}};
        const auto place = layout->chart_place(point);
        const auto found = phantom(*layout, place, {random.uniform(0, 3), random.uniform(0, 30)});
        const double sum = std::accumulate(found.shares.begin(), found.shares.end(), 0.0);
        ASSERT_NEAR(sum, 1, 1e-4);
        ASSERT_TRUE(std::isfinite(found.error));
        ASSERT_LT(found.strongest, actuators.size());
    }
}

}  // namespace
}  // namespace thaum::tactile
