// Tests of the tactile mixer's rules: sums, limits, gaps between two effects at an actuator, merging,
// priorities, faders, time to live.
#include <cmath>

#include "unit/tactile_rig.h"

namespace thaum::tactile {
namespace {

/// A layout of `count` actuators in a row, far from each other (30 mm).
Layout apart(std::size_t count) {
    std::vector<Actuator> actuators;
    for (std::size_t i = 0; i < count; ++i)
        actuators.push_back({"a", {Part::whole, {0.03 * static_cast<double>(i), 1, 0}}, 50, 250, 1});
    return *make_layout("apart", Torso(), actuators);
}

BodyPoint at(const TactileRig& rig, std::size_t actuator) { return rig.layout.actuators[actuator].place; }

EffectBank bank_of(std::vector<Effect> effects) { return {std::move(effects)}; }

TEST(TactileFrameTest, IsSilentAfterItsTimeToLive) {
    TactileFrame frame;
    frame.tick = 1000;
    frame.time_to_live = 48;
    frame.count = 2;
    frame.amplitude[1] = 0.5F;
    for (const Tick now : {1000U, 1001U, 1047U}) EXPECT_EQ(frame_at(frame, now).amplitude[1], 0.5F);
    for (const Tick now : {0U, 999U, 1048U, 1000000U}) EXPECT_TRUE(frame_at(frame, now).is_silent()) << now;
    EXPECT_TRUE(frame_at(frame, ~Tick{0}).is_silent());
}

TEST(TactileMixerTest, EnergiesOfEffectsAddUp) {
    auto a = plain_effect("a", {.hold = 80}), b = plain_effect("b", {.hold = 80});
    b.wavelength = 5e-3;
    a.sigma_cells = b.sigma_cells = vec2(0.2);
    TactileRig rig(apart(1), bank_of({a, b}), {.sum_limit = 100, .gap = 0});
    rig.start("a", Where::on(at(rig, 0)), 0.3);
    rig.start("b", Where::on(at(rig, 0)), 0.4);
    const auto& frame = rig.frame();
    EXPECT_NEAR(frame.amplitude[0], 0.5, 1e-6);
    EXPECT_NEAR(frame.carrier_hz[0], 200, 1e-3) << "the carrier is that of the stronger";
    rig.mixer->stop();
    rig.start("b", Where::on(at(rig, 0)), 0.4);
    rig.start("a", Where::on(at(rig, 0)), 0.3);
    EXPECT_NEAR(rig.frame().carrier_hz[0], 200, 1e-3) << "in either order";
    EXPECT_EQ(frame.count, 1U);
    EXPECT_EQ(frame.time_to_live, 48U);
}

TEST(TactileMixerTest, CarriersStayWithinTheActuatorsRange) {
    auto low = plain_effect("low", {.hold = 80}), high = plain_effect("high", {.hold = 80});
    low.wavelength = 0.1;
    high.wavelength = 1e-3;
    TactileRig rig(apart(2), bank_of({high, low}));
    rig.start("low", Where::on(at(rig, 0)));
    EXPECT_EQ(rig.frame().carrier_hz[0], 50);
    rig.mixer->stop();
    rig.start("high", Where::on(at(rig, 0)));
    EXPECT_EQ(rig.frame().carrier_hz[0], 250);
}

TEST(TactileMixerTest, AnEffectIsOverAfterItsLength) {
    TactileRig rig(apart(1), bank_of({plain_effect("a", {.attack = 8, .hold = 16, .decay = 16})}));
    rig.start("a", Where::own());
    std::vector<float> course;
    for (int f = 0; f < 8; ++f) course.push_back(rig.frame().amplitude[0]);
    const std::vector<float> expected{0, 1, 1, 1, 1, 0.5, 0, 0};
    for (std::size_t i = 0; i < course.size(); ++i) EXPECT_NEAR(course[i], expected[i], 1e-6) << i;
    EXPECT_EQ(rig.mixer->playing(), 0U);
}

TEST(TactileMixerTest, AShortEffectBetweenTwoFramesIsFelt) {
    TactileRig rig(apart(1), bank_of({plain_effect("tick", {.attack = 1, .decay = 1})}));
    rig.frame();
    rig.mixer->start(0, Where::own(), 1, rig.now - 6);  // an effect that begins and ends between two frames
    EXPECT_NEAR(rig.frame().amplitude[0], 1, 1e-6);
    rig.frame();
    EXPECT_TRUE(rig.frame().is_silent());
}

TEST(TactileMixerTest, TheSumOfEnergiesIsLimited) {
    TactileRig rig(apart(20), bank_of({plain_effect("a", {.hold = 80})}));
    for (std::size_t i = 0; i < 20; ++i) rig.start("a", Where::on(at(rig, i)));
    const auto& frame = rig.frame();
    EXPECT_LE(energy_of(frame), 1.5);
    EXPECT_NEAR(energy_of(frame), 1.5, 1e-4);
    EXPECT_EQ(rig.mixer->counts().limited, 1U);
    for (std::size_t i = 0; i < 20; ++i) EXPECT_GT(frame.amplitude[i], 0.2) << "all are still felt";
}

TEST(TactileMixerTest, EachActuatorKeepsItsLimit) {
    auto layout = apart(2);
    layout.actuators[0].limit = 0.25;
    TactileRig rig(layout, bank_of({plain_effect("a", {.hold = 80})}));
    rig.start("a", Where::on(at(rig, 0)));
    EXPECT_EQ(rig.frame().amplitude[0], 0.25F);
}

TEST(TactileMixerTest, TwoEventsWithinTheGapBecomeTheStronger) {
    const auto shipped = plain_effect("a", {.hold = 20, .decay = 40});
    for (const bool stronger_first : {true, false}) {
        TactileRig rig(apart(2), bank_of({shipped}));
        rig.start("a", Where::on(at(rig, 0)), stronger_first ? 0.8 : 0.3);
        rig.frame();
        rig.start("a", Where::on(at(rig, 0)), stronger_first ? 0.3 : 0.8);
        EXPECT_NEAR(rig.frame().amplitude[0], 0.8, 1e-6);
        EXPECT_EQ(rig.mixer->counts().offered, 2U);
        EXPECT_EQ(rig.mixer->counts().started, 1U);
        EXPECT_EQ(rig.mixer->counts().merged, 1U);
        EXPECT_EQ(rig.mixer->playing(), 1U);
    }
}

TEST(TactileMixerTest, AnEventAfterAShortOneWaitsUntilTheGapIsOver) {
    TactileRig rig(apart(1), bank_of({plain_effect("a", {.hold = 5})}));
    rig.start("a", Where::own());
    std::vector<Tick> felt;
    for (int f = 0; f < 20; ++f) {
        if (f == 2) rig.start("a", Where::own());
        if (f == 3) rig.start("a", Where::own());  // this event is merged with the event that waits
        const auto& frame = rig.frame();
        if (frame.amplitude[0] > 0) felt.push_back(frame.tick - 1000);
    }
    EXPECT_EQ(felt, (std::vector<Tick>{0, 8, 40, 48})) << "5 ms reach into two frames";
    EXPECT_EQ(rig.mixer->counts().delayed, 1U);
    EXPECT_EQ(rig.mixer->counts().merged, 1U);
}

TEST(TactileMixerTest, BeginningsAtACellAreAtLeastFortyMillisecondsApart) {
    for (const auto* name : {"abstract_4x5", "x16", "pad"}) {
        TactileRig rig(name);
        Random random = random_stream(5, 1);
        std::array<Tick, max_actuators> last{};
        std::array<float, max_actuators> before{};
        int beginnings = 0;
        for (int f = 0; f < 5000; ++f) {
            for (auto n = random.below(20) == 0 ? 1 + random.below(3) : 0; n > 0; --n) {
                const auto e = static_cast<std::uint32_t>(random.below(rig.bank.effects.size()));
                const double angle = random.uniform(-pi, pi);
                rig.mixer->start(e,
                                 Where::from({std::sin(angle), 0, std::cos(angle)}, random.uniform(0.8, 1.4)),
                                 random.uniform(), rig.now - random.below(8));
            }
            const auto& frame = rig.frame();
            EXPECT_LE(energy_of(frame), 1.5);
            for (std::size_t i = 0; i < frame.count; ++i) {
                if (frame.amplitude[i] > 0 && before[i] == 0) {
                    ++beginnings;
                    if (last[i] != 0) {
                        ASSERT_GE(frame.tick - last[i], 40U) << name << ", cell " << i;
                    }
                    last[i] = frame.tick;
                }
                before[i] = frame.amplitude[i];
            }
        }
        EXPECT_GT(beginnings, 20) << name;
    }
}

TEST(TactileMixerTest, ASecondWaveAtACellWaitsUntilItsGapIsOverAndIsFeltInFull) {
    auto wave = plain_effect("wave", {.hold = 4});
    wave.pattern = Pattern::spread;
    wave.speed = 1;
    wave.reach = 10;
    TactileRig rig(apart(11), bank_of({wave}));
    rig.start("wave", Where::on(at(rig, 0)), 0.2);  // the wave reaches the middle, 150 mm away, after 150 ms
    std::vector<Tick> felt;
    float greatest = 0;
    for (int f = 0; f < 50; ++f) {
        // A second wave, which comes from the other side and arrives after 174 ms.
        if (f == 3) rig.start("wave", Where::on(at(rig, 10)), 0.6);
        const auto& frame = rig.frame();
        if (frame.amplitude[5] == 0) continue;
        felt.push_back(frame.tick - 1000);
        greatest = std::max(greatest, frame.amplitude[5]);
    }
    ASSERT_EQ(felt.front(), 152U);
    ASSERT_GE(felt.size(), 2U);
    EXPECT_EQ(*std::find_if(felt.begin(), felt.end(), [](Tick t) { return t > 165; }), 192U);
    EXPECT_NEAR(greatest, 0.6 * (1 - 0.15 / 10), 1e-5);
    EXPECT_EQ(rig.mixer->counts().held, 1U) << "no other cell meets both waves within a gap";
}

TEST(TactileMixerTest, AHundredHitsInATickAreAllFelt) {
    TactileRig rig("x40");
    Random random = random_stream(5, 2);
    std::array<bool, 40> expected{};
    for (int i = 0; i < 100; ++i) {
        const double angle = random.uniform(-pi, pi);
        const vec3 from(std::sin(angle), 0, std::cos(angle));
        const double height = random.uniform(0.9, 1.3);
        const auto place = rig.layout.chart_place(rig.layout.facing(from, height));
        expected[phantom(rig.layout, place, vec2(0.7)).strongest] = true;
        rig.start("bolt_hit", Where::from(from, height));
    }
    const auto& counts = rig.mixer->counts();
    EXPECT_EQ(counts.offered, 100U);
    EXPECT_EQ(counts.started + counts.merged, 100U) << "no event is lost";
    EXPECT_EQ(counts.replaced, 0U);
    EXPECT_GT(counts.merged, 50U);
    const auto& frame = rig.frame();
    EXPECT_LE(energy_of(frame), 1.5);
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_LE(frame.amplitude[i], 1);
        if (expected[i]) {
            EXPECT_GT(frame.amplitude[i], 0.05) << i;
        }
    }
}

TEST(TactileMixerTest, WhenAllPlacesAreTakenTheMoreImportantPlays) {
    auto low = plain_effect("low", {.hold = 500}), high = plain_effect("high", {.hold = 500});
    low.priority = 2;
    high.priority = 8;
    TactileRig rig(apart(64), bank_of({high, low}), {.gap = 0});
    for (std::size_t i = 0; i < 64; ++i) rig.start("low", Where::on(at(rig, i)), 0.1);
    rig.frame();
    rig.start("high", Where::on(at(rig, 40)), 1);
    EXPECT_EQ(rig.mixer->playing(), 64U);
    EXPECT_EQ(rig.mixer->counts().replaced, 1U);
    EXPECT_GT(rig.frame().amplitude[40], 0.5);
    for (std::size_t i = 0; i < 64; ++i) rig.start("high", Where::on(at(rig, i)), 0.1);
    const auto merged = rig.mixer->counts().merged;
    rig.start("low", Where::on(at(rig, 3)), 0.9);
    EXPECT_EQ(rig.mixer->counts().merged, merged + 1)
        << "a less important event joins what plays at its actuator";
    EXPECT_GT(rig.frame().amplitude[3], 0.3);
    const auto& counts = rig.mixer->counts();
    EXPECT_EQ(counts.offered, counts.started + counts.merged);
}

TEST(TactileMixerTest, AnEventThatHasNotBeenFeltIsNotReplaced) {
    auto low = plain_effect("low", {.hold = 500}), high = plain_effect("high", {.hold = 500});
    low.priority = 2;
    high.priority = 8;
    low.sigma_cells = high.sigma_cells = vec2(0.2);
    TactileRig rig(apart(64), bank_of({high, low}), {.gap = 0});
    for (std::size_t i = 0; i < 64; ++i) rig.start("low", Where::on(at(rig, i)), 0.1);
    rig.start("high", Where::on(at(rig, 9)), 1);
    EXPECT_EQ(rig.mixer->counts().replaced, 0U);
    EXPECT_EQ(rig.mixer->counts().merged, 1U);
    const auto& frame = rig.frame();
    for (std::size_t i = 0; i < 64; ++i) EXPECT_GT(frame.amplitude[i], 0.05) << i;
    EXPECT_GT(frame.amplitude[9], 0.5) << "the hard hit is felt at its place";
}

TEST(TactileMixerTest, FadersScaleTheirPurpose) {
    TactileRig rig("x40");
    rig.start("walk_left", Where::own());
    auto peaks = rig.peaks(12);
    EXPECT_EQ(*std::max_element(peaks.begin(), peaks.end()), 0) << "walking is off by default";
    Faders faders;
    faders.values[static_cast<std::size_t>(Purpose::walk)] = 1;
    faders.values[static_cast<std::size_t>(Purpose::impact)] = 0.5;
    rig.mixer->set_faders(faders);
    rig.start("walk_left", Where::own());
    peaks = rig.peaks(12);
    EXPECT_GT(*std::max_element(peaks.begin(), peaks.end()), 0.02);
    rig.start("bolt_hit", Where::on(at(rig, 5)));
    EXPECT_NEAR(energy_of(rig.frame()), 0.25 * 0.35 * 0.35, 1e-5);
}

TEST(TactileMixerTest, ADrivenEffectLastsUntilNobodyDrivesIt) {
    TactileRig rig(apart(1), bank_of({plain_effect("a", {.attack = 40, .decay = 80})}));
    std::vector<float> course;
    for (int f = 0; f < 60; ++f) {
        if (f < 30) rig.mixer->drive(7, 0, Where::own(), f < 20 ? 0.5 : 0.25, rig.now);
        course.push_back(rig.frame().amplitude[0]);
    }
    EXPECT_EQ(course[0], 0);
    EXPECT_NEAR(course[3], 0.3, 1e-6) << "24 of 40 ms of the attack";
    EXPECT_NEAR(course[10], 0.5, 1e-6);
    EXPECT_NEAR(course[25], 0.25, 1e-6) << "the strength follows the caller";
    EXPECT_NEAR(course[32], 0.25, 1e-6) << "a lost call or two do not interrupt it";
    EXPECT_LT(course[40], 0.2);
    EXPECT_EQ(course[50], 0);
    EXPECT_EQ(rig.mixer->playing(), 0U);
    EXPECT_EQ(rig.mixer->counts().not_driven, 0U);
}

TEST(TactileMixerTest, StopSilencesAtOnce) {
    TactileRig rig("x40");
    rig.start("blast_hit", Where::from({0, 0, 1}));
    EXPECT_FALSE(rig.frame().is_silent());
    rig.mixer->stop();
    EXPECT_TRUE(rig.frame().is_silent());
    rig.now = 8;  // time jumps back, as in a replay
    rig.start("blast_hit", Where::from({0, 0, 1}));
    EXPECT_FALSE(rig.frame().is_silent());
}

/// Hash of all frames of ten seconds with random events.
std::uint64_t hash_of_run(std::uint64_t seed) {
    TactileRig rig("x40");
    Random random = random_stream(seed, 3);
    std::uint64_t hash = 0;
    for (int f = 0; f < 1250; ++f) {
        const auto e = static_cast<std::uint32_t>(random.below(rig.bank.effects.size()));
        const double angle = random.uniform(-pi, pi);
        const vec3 from(det::sin(angle), 0, det::cos(angle));
        if (random.below(4) == 0) rig.mixer->start(e, Where::from(from), random.uniform(), rig.now);
        if (random.below(2) == 0) rig.mixer->drive(1 + e, e, Where::from(from), random.uniform(), rig.now);
        hash = hash_combine(hash, hash_value(rig.frame()));
    }
    return hash;
}

TEST(TactileMixerTest, EqualEventsGiveEqualFrames) {
    EXPECT_EQ(hash_of_run(1), hash_of_run(1));
    EXPECT_NE(hash_of_run(1), hash_of_run(2));
}

TEST(TactileMixerTest, ACopyContinuesAlike) {
    TactileRig rig("x40");
    rig.start("blast_hit", Where::from({0, 0, 1}));
    rig.start("heartbeat", Where::own());
    rig.frame();
    auto copy = std::make_unique<TactileMixer>(*rig.mixer);
    for (int f = 0; f < 200; ++f) {
        const auto hash = hash_value(copy->mix(rig.now));
        ASSERT_EQ(hash, hash_value(rig.frame()));
    }
}

}  // namespace
}  // namespace thaum::tactile
