// Tests of the places and times at which effects are felt: sides of hits, waves, apparent motion, heartbeats,
// poses.
#include <cmath>

#include "unit/tactile_rig.h"

namespace thaum::tactile {
namespace {

vec3 direction(int sixteenth) {
    // Angle of the hit's direction, from the front to the right.
    const double angle = 2 * pi * sixteenth / 16;
    return {std::sin(angle), 0, std::cos(angle)};
}

/// Expects the peaks that a hit from this direction must cause: the largest in the nearest cell (actuator) of
/// the jacket, and none on the far side.
void expect_hit(const TactileRig& rig, const std::vector<double>& peaks, vec3 from, const std::string& what) {
    const vec3 at = rig.layout.torso.facing(from, 1.15);
    double nearest = 1e9, strongest = 0;
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        nearest = std::min(nearest, glm::length(rig.layout.actuators[i].place.at - at));
        strongest = std::max(strongest, peaks[i]);
    }
    EXPECT_GT(strongest, 0.1) << what;
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        const vec3 place = rig.layout.actuators[i].place.at;
        if (peaks[i] > 0.98 * strongest) {
            EXPECT_LT(glm::length(place - at), nearest + 0.02) << what << ", cell " << i;
        }
        const vec3 outwards = glm::normalize(vec3(place.x, 0, place.z));
        if (glm::dot(outwards, from) < -0.05) {
            EXPECT_EQ(peaks[i], 0) << what << ": the far side must be still, cell " << i;
        }
    }
}

TEST(TactileDirection, SixteenHitsAreFeltOnTheirSideOnly) {
    for (const auto* name : {"abstract_4x5", "x40", "x16"}) {
        for (const auto* effect : {"bolt_hit", "blast_hit", "object_hit"}) {
            for (int d = 0; d < 16; ++d) {
                TactileRig rig(name);
                rig.start(effect, Where::from(direction(d)));
                // The wave of a blast is checked only where it begins.
                const auto peaks = rig.peaks(effect == std::string("blast_hit") ? 6 : 10);
                expect_hit(rig, peaks, direction(d),
                           std::string(name) + ", " + effect + " from " + std::to_string(d));
            }
        }
    }
}

TEST(TactileDirection, TheHeightOfAHitIsFelt) {
    TactileRig rig("abstract_4x5");
    rig.start("bolt_hit", Where::from({0, 0, 1}, 1.30));
    auto peaks = rig.peaks(10);
    EXPECT_GT(peaks[1], 0.1);
    EXPECT_EQ(peaks[17], 0);
    rig.start("bolt_hit", Where::from({0, 0, 1}, 0.5));  // a hit below the jacket, which the lowest row feels
    peaks = rig.peaks(10);
    EXPECT_GT(peaks[17], 0.1);
    EXPECT_EQ(peaks[1], 0);
}

TEST(TactileDirection, APadFeelsTheSide) {
    TactileRig rig("pad");
    rig.start("bolt_hit", Where::from({-1, 0, 0.01}));
    auto peaks = rig.peaks(20);
    EXPECT_GT(peaks[0], 0.3);
    EXPECT_LT(peaks[1], 0.05);
    rig.start("bolt_hit", Where::from({0, 0, -1}));
    peaks = rig.peaks(20);
    EXPECT_NEAR(peaks[0], peaks[1], 1e-3);
    EXPECT_NEAR(peaks[0], 0.35 * std::sqrt(0.5), 1e-3) << "two motors share the energy";
}

TEST(TactileSpread, TheWaveRunsOverTheSkinAtItsSpeed) {
    TactileRig rig("abstract_4x5");
    const std::size_t origin = 5;
    rig.start("blast_hit", Where::on(rig.layout.actuators[origin].place));
    const Tick begin = rig.now;
    std::vector<Tick> onset(40);
    for (int f = 0; f < 70; ++f) {
        const auto& frame = rig.frame();
        for (std::size_t i = 0; i < 40; ++i) {
            if (onset[i] == 0 && frame.amplitude[i] > 0) onset[i] = frame.tick;
        }
    }
    int reached = 0;
    for (std::size_t i = 0; i < 40; ++i) {
        const vec2 way = rig.layout.between(Region::torso, rig.layout.chart_of(Region::torso, origin),
                                            rig.layout.chart_of(Region::torso, i));
        const double distance = glm::length(way);
        if (distance > 0.235) {
            EXPECT_EQ(onset[i], 0U) << "beyond the reach of the wave, cell " << i;
        } else {
            const double late =
                static_cast<double>(onset[i]) - static_cast<double>(begin) - 1000 * distance / 0.6;
            EXPECT_GE(late, -1e-6) << i;
            EXPECT_LE(late, 8) << i;
            ++reached;
        }
    }
    EXPECT_GT(reached, 15);
}

TEST(TactileSpread, TheWaveFadesWithDistance) {
    TactileRig rig("abstract_4x5");
    rig.start("blast_hit", Where::on(rig.layout.actuators[4].place), 0);
    const auto peaks = rig.peaks(70);
    EXPECT_NEAR(peaks[4], 0.3, 1e-5);
    EXPECT_NEAR(peaks[5], 0.3 * 0.75, 2e-3);
    EXPECT_NEAR(peaks[6], 0.3 * 0.5, 2e-3);
}

/// Centroid of the energies of a frame (m, on the flat map of the torso).
vec2 felt(const TactileRig& rig, const TactileFrame& frame) {
    std::array<double, max_actuators> amplitudes{};
    std::copy(frame.amplitude.begin(), frame.amplitude.end(), amplitudes.begin());
    return felt_offset(rig.layout, Region::torso, vec2(0), amplitudes);
}

TEST(TactileMotion, AFallRunsUpTheBody) {
    for (const auto* name : {"abstract_4x5", "x40"}) {
        TactileRig rig(name);
        rig.start("fall", Where::own());
        rig.frame();
        double before = 0;
        std::vector<double> heights;
        for (int f = 1; f < 22; ++f) {
            const auto& frame = rig.frame();
            if (frame.is_silent()) break;
            heights.push_back(felt(rig, frame).y);
            EXPECT_GE(heights.back(), before - 1e-4) << name;
            before = heights.back();
        }
        ASSERT_GT(heights.size(), 18U);
        EXPECT_NEAR(heights.front(), name == std::string("x40") ? 0.937 : 1.06, 0.03);
        EXPECT_NEAR(heights.back(), name == std::string("x40") ? 1.29 : 1.30, 0.03);
    }
}

TEST(TactileMotion, TheApparentPlaceMovesEvenly) {
    auto effect = plain_effect("stroke", {.hold = 400});
    effect.pattern = Pattern::sweep;
    effect.length_ms = 400;
    const auto layout = shipped_layout("abstract_4x5");
    effect.places = {layout.actuators[8].place};
    effect.to = layout.actuators[11].place;
    TactileRig rig(layout, {{effect}});
    rig.start("stroke", Where::own(), 0.5);
    const Tick begin = rig.now;
    rig.frame();
    for (int f = 1; f < 50; ++f) {
        const auto& frame = rig.frame();
        const double wanted = -0.09 + 0.18 * static_cast<double>(frame.tick - begin) / 400;
        EXPECT_NEAR(felt(rig, frame).x, wanted, 0.001);
        EXPECT_NEAR(felt(rig, frame).y, 1.18, 0.001);
        EXPECT_NEAR(energy_of(frame), 0.25, 1e-4) << "the strength stays the same on the way";
    }
}

TEST(TactileHeartbeat, TheRateFollowsTheStrength) {
    for (const double strength : {0.0, 0.5, 1.0}) {
        TactileRig rig("x40");
        std::vector<Tick> beats;
        float before = 0;
        for (int f = 0; f < 1250; ++f) {  // ten seconds
            rig.mixer->drive(1, rig.effect("heartbeat"), Where::own(), strength, rig.now);
            const auto& frame = rig.frame();
            const float a = *std::max_element(frame.amplitude.begin(), frame.amplitude.end());
            if (a > 0 && before == 0) beats.push_back(frame.tick);
            before = a;
        }
        const double rate = 1.2 + 1.2 * strength;
        EXPECT_NEAR(static_cast<double>(beats.size()), 2 * 10 * rate, 2) << "two beats in each period";
    }
}

TEST(TactileHeartbeat, ItStopsWhenNobodyDrivesIt) {
    TactileRig rig("x40");
    for (int f = 0; f < 100; ++f) {
        rig.mixer->drive(1, rig.effect("heartbeat"), Where::own(), 1, rig.now);
        rig.frame();
    }
    EXPECT_EQ(rig.mixer->playing(), 1U);
    rig.peaks(60);
    EXPECT_EQ(rig.mixer->playing(), 0U);
    EXPECT_TRUE(rig.frame().is_silent());
}

TEST(TactilePose, ATouchIsFeltWhereTheArmIs) {
    TactileRig rig("sleeves");
    const vec3 ahead(0.22, 1.38, 0.45);
    rig.mixer->set_pose(pose_with_arms(0, pi / 2));
    rig.start("bolt_hit", Where::touching(ahead));
    auto peaks = rig.peaks(10);
    EXPECT_GT(peaks[19], 0.25) << "the right wrist";
    for (std::size_t i = 0; i < 17; ++i) EXPECT_EQ(peaks[i], 0) << i;
    rig.mixer->set_pose({});
    rig.start("bolt_hit", Where::touching(ahead));
    peaks = rig.peaks(10);
    EXPECT_EQ(peaks[19], 0) << "the wrist hangs down now";
}

TEST(TactilePose, AWaveReachesARaisedArmLaterThanAHangingOne) {
    const auto arrival = [](double raised) {
        auto effect = plain_effect("wave", {.hold = 30});
        effect.pattern = Pattern::spread;
        effect.speed = 1;
        effect.reach = 2;
        TactileRig rig(shipped_layout("sleeves"), {{effect}});
        rig.mixer->set_pose(pose_with_arms(0, raised));
        rig.start("wave", Where::on({Part::back, {0.078, 1.1, -0.1}}));
        const Tick begin = rig.now;
        for (;;) {
            const auto& frame = rig.frame();
            if (frame.amplitude[19] > 0 || frame.tick > begin + 2000) return frame.tick - begin;
        }
    };
    EXPECT_GT(arrival(pi / 2), arrival(0) + 200);
}

TEST(TactileSuit, EveryEffectIsFeltOnEveryLayout) {
    for (const auto* name : layout_names) {
        TactileRig rig(name);
        Faders faders;
        faders.values.fill(1);
        rig.mixer->set_faders(faders);
        for (std::uint32_t e = 0; e < rig.bank.effects.size(); ++e) {
            rig.mixer->start(e, Where::from({0.3, 0, 1}), 1, rig.now);
            const auto peaks = rig.peaks(60);
            EXPECT_GT(*std::max_element(peaks.begin(), peaks.end()), 0.02)
                << name << ": " << rig.bank.effects[e].name;
            rig.mixer->stop();
        }
    }
}

}  // namespace
}  // namespace thaum::tactile
