// Hostile values, times and rates: tactile frames must keep their limits, and every invalid value must be
// counted.
#include <cmath>
#include <limits>

#include "unit/tactile_rig.h"

namespace thaum::tactile {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
constexpr double hostile[] = {nan, inf, -inf, 1e308, -1e308, -1, 2, 1e-320, -0.0};

void expect_sound(const TactileRig& rig, const TactileFrame& frame) {
    for (std::size_t i = 0; i < frame_capacity; ++i) {
        ASSERT_TRUE(frame.amplitude[i] >= 0 && frame.amplitude[i] <= 1);
        ASSERT_TRUE(std::isfinite(frame.carrier_hz[i]));
        if (i >= frame.count) {
            ASSERT_EQ(frame.amplitude[i], 0);
        } else if (frame.amplitude[i] > 0) {
            ASSERT_GE(frame.carrier_hz[i], rig.layout.actuators[i].lowest_hz);
            ASSERT_LE(frame.carrier_hz[i], rig.layout.actuators[i].highest_hz);
        }
    }
    ASSERT_LE(energy_of(frame), 1.5);
}

TEST(TactileHostile, BadStrengthsPlacesAndFadersAreClippedAndCounted) {
    for (const double bad : hostile) {
        TactileRig rig("x40");
        const auto bolt = rig.effect("bolt_hit");
        const bool is_strength = bad >= 0 && bad <= 1;
        rig.mixer->start(bolt, Where::own(), bad, rig.now);
        EXPECT_EQ(rig.mixer->counts().clipped, is_strength ? 0U : 1U) << bad;
        const auto before = rig.mixer->counts().clipped;
        const bool is_place = std::isfinite(bad) && std::abs(bad) < 10;
        rig.mixer->start(bolt, Where::on({Part::front, {bad, 1, 0.1}}), 1, rig.now);
        rig.mixer->start(bolt, Where::touching({0, bad, 0}), 1, rig.now);
        rig.mixer->start(bolt, Where::from({0, 0, 1}, bad), 1, rig.now);
        EXPECT_EQ(rig.mixer->counts().clipped - before, is_place ? 0U : 3U) << bad;
        rig.mixer->start(bolt, Where::from({bad, bad, bad}), 1, rig.now);
        rig.mixer->drive(9, bolt, Where::from({bad, 0, 0}), bad, rig.now);
        Faders faders;
        faders.values.fill(bad);
        rig.mixer->set_faders(faders);
        for (int f = 0; f < 20; ++f) expect_sound(rig, rig.frame());
        EXPECT_EQ(rig.mixer->counts().offered, rig.mixer->counts().started + rig.mixer->counts().merged);
    }
}

TEST(TactileHostile, APoseThatIsNotFiniteIsIgnored) {
    TactileRig rig("sleeves");
    const vec3 wrist = posed(pose_with_arms(0, 1), Part::arm_right, {0.22, 0.9, 0});
    rig.mixer->set_pose(pose_with_arms(0, 1));
    rig.mixer->set_pose(pose_with_arms(0, nan));
    EXPECT_EQ(rig.mixer->counts().clipped, 1U);
    rig.start("bolt_hit", Where::touching(wrist));
    EXPECT_GT(rig.frame().amplitude[19], 0.2);
}

TEST(TactileHostile, RandomCallsKeepAllLimits) {
    for (const auto* name : layout_names) {
        TactileRig rig(name);
        Random random = random_stream(6, 1);
        const auto number = [&random] {
            return random.below(4) == 0 ? hostile[random.below(std::size(hostile))] : random.uniform(-2, 2);
        };
        for (int f = 0; f < 3000; ++f) {
            for (auto n = random.below(12); n > 0; --n) {
                const auto e = static_cast<std::uint32_t>(random.below(rig.bank.effects.size()));
                const vec3 v(number(), number(), number());
                const auto part = static_cast<Part>(random.below(part_count));
                const Where where[] = {Where::own(), Where::on({part, v}), Where::touching(v),
                                       Where::from(v, number())};
                const auto& chosen = where[random.below(4)];
                const Tick when = random.below(50) == 0 ? random.next() : rig.now - random.below(60);
                if (random.below(3) == 0)
                    rig.mixer->drive(1 + static_cast<std::uint32_t>(random.below(80)), e, chosen, number(),
                                     when);
                else
                    rig.mixer->start(e, chosen, number(), when);
            }
            if (random.below(100) == 0) rig.mixer->set_pose(pose_with_arms(number(), number()));
            if (random.below(300) == 0) rig.now = random.below(100'000);
            if (random.below(300) == 0) rig.mixer->stop();
            ASSERT_NO_FATAL_FAILURE(expect_sound(rig, rig.frame())) << name;
            const auto& counts = rig.mixer->counts();
            ASSERT_EQ(counts.offered, counts.started + counts.merged);
            ASSERT_LE(rig.mixer->playing(), max_playing);
        }
        EXPECT_GT(rig.mixer->counts().clipped, 1000U);
    }
}

TEST(TactileHostile, EventsOfTheFutureTakeNoPlace) {
    TactileRig rig("x40");
    for (const Tick ahead : {Tick{81}, Tick{100'000}, ~Tick{0} / 2}) {
        rig.mixer->start(rig.effect("bolt_hit"), Where::own(), 1, rig.now + ahead);
        rig.mixer->drive(1, rig.effect("stir"), Where::own(), 1, rig.now + ahead);
        EXPECT_TRUE(rig.frame().is_silent());
        EXPECT_EQ(rig.mixer->playing(), 0U) << ahead;
        rig.mixer->stop();
    }
}

TEST(TactileHostile, NothingIsLeftOnWhenEventsEnd) {
    for (const auto* name : layout_names) {
        TactileRig rig(name);
        Random random = random_stream(6, 2);
        for (int f = 0; f < 200; ++f) {
            for (int n = 0; n < 20; ++n) {
                const auto e = static_cast<std::uint32_t>(random.below(rig.bank.effects.size()));
                rig.mixer->start(e, Where::from({random.uniform(-1, 1), 0, random.uniform(-1, 1)}), 1,
                                 rig.now);
                rig.mixer->drive(1 + e, e, Where::own(), 1, rig.now);
            }
            rig.frame();
        }
        for (int f = 0; f < 500; ++f) rig.frame();
        EXPECT_TRUE(rig.frame().is_silent()) << name;
        EXPECT_EQ(rig.mixer->playing(), 0U) << name;
    }
}

}  // namespace
}  // namespace thaum::tactile
