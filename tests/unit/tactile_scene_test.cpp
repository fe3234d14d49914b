// Tests of what players feel on the body during a match, by the frames for a tactile jacket.
#include "game/senses/tactile/tactile_scene.h"

#include <cmath>

#include "core/hash.h"
#include "game/components/crystal.h"
#include "game/components/potions.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

using tactile::TactileFrame;

struct Loaded {
    tactile::EffectBank effects;
    tactile::Layout figure;
};

const Loaded& loaded() {
    static const Loaded all = [] {
        auto effects = tactile::load_effects(assets() / "tactile/effects");
        auto figure = tactile::load_layout(assets() / "tactile/layouts/abstract_4x5.toml");
        EXPECT_TRUE(effects) << (effects ? "" : effects.error().message);
        EXPECT_TRUE(figure) << (figure ? "" : figure.error().message);
        return Loaded{std::move(*effects), std::move(*figure)};
    }();
    return all;
}

MatchEffects effects_of(const MatchData& data) {
    auto effects = match_effects(loaded().effects, *data.presentation);
    EXPECT_TRUE(effects.missing.empty());
    return effects;
}

/// A match in which the test triggers events that strike the first player.
struct BodyRig {
    BodyRig()
        : match(duel_data(), two_hands()),
          effects(effects_of(match.data())),
          scene(effects, loaded().effects, 0) {
        scene.add(loaded().figure);
        scene.take(match);
    }

    void play(Tick count) {
        for (Tick t = 0; t < count; ++t) {
            match.tick({});
            if (match.now() % tactile::frame_ticks == 0) scene.take(match);
        }
    }
    vec3 middle() const { return match.world().get<Motion>(wizard_of(match.world(), 0)).position; }
    void turn(double yaw) { match.world_to_change().get<Gaze>(wizard_of(match.world(), 0)).yaw = yaw; }
    /// Records a hit on the first player that comes from a place but from no player.
    void strike(std::string_view kind, vec3 from, double amount = 30) {
        record(match.context_to_change(), {.tick = match.match().played,
                                           .kind = *event_kind(kind),
                                           .subject = 0,
                                           .amount = amount,
                                           .place = from});
    }
    const TactileFrame& frame() const { return scene.frame(0); }

    Simulation match;
    MatchEffects effects;
    TactileScene scene;
};

/// Energy of a frame: the sum of its squared amplitudes.
double energy(const TactileFrame& frame) {
    double sum = 0;
    for (std::size_t i = 0; i < frame.count; ++i) sum += frame.amplitude.at(i) * frame.amplitude.at(i);
    return sum;
}

/// Mean direction of what is felt (body frame: x to the right, z to the front), weighted by squared
/// amplitude.
vec2 felt_side(const TactileFrame& frame) {
    vec2 sum{};
    for (std::size_t i = 0; i < frame.count; ++i) {
        const vec3 at = loaded().figure.actuators[i].place.at;
        sum += static_cast<double>(frame.amplitude.at(i) * frame.amplitude.at(i)) * vec2(at.x, at.z);
    }
    return sum;
}

TEST(TactileScene, AHitIsFeltOnItsSideFromSixteenDirectionsAndNotOnTheFarOne) {
    for (int i = 0; i < 16; ++i) {
        // Angle of the hit's direction, from straight ahead to the right.
        const double angle = i * 2 * pi / 16;
        BodyRig rig;
        const double yaw = 0.7;
        rig.turn(yaw);
        const vec3 ahead(-std::sin(yaw), 0, -std::cos(yaw)), right(std::cos(yaw), 0, -std::sin(yaw));
        rig.strike("bolt_hit", rig.middle() + 5.0 * (std::cos(angle) * ahead + std::sin(angle) * right));
        rig.play(2 * tactile::frame_ticks);
        ASSERT_GT(energy(rig.frame()), 0) << i;
        const vec2 side = felt_side(rig.frame());
        const bool beside = std::abs(std::sin(angle)) > 0.99;
        if (!beside) {
            EXPECT_GT(side.y * std::cos(angle), 0) << i << ": front or back";
        }
        if (std::abs(std::sin(angle)) > 0.1) {
            EXPECT_GT(side.x * std::sin(angle), 0) << i << ": left or right";
        }
        for (std::size_t cell = 0; cell < rig.frame().count; ++cell) {
            const vec3 at = loaded().figure.actuators[cell].place.at;
            const double towards =
                (at.x * std::sin(angle) + at.z * std::cos(angle)) / std::max(std::hypot(at.x, at.z), 1e-9);
            if (towards < -0.5) {
                EXPECT_LT(rig.frame().amplitude.at(cell), 0.02F) << i << ", cell " << cell;
            }
        }
    }
}

TEST(TactileScene, ABurstBehindIsFeltBehindAlthoughTheFoeIsAhead) {
    BodyRig rig;
    rig.turn(0);
    const auto foe = wizard_of(rig.match.world(), 1);
    auto body = rig.match.physics().state(foe.index);
    body.position = rig.middle() + vec3(0, 0, -6);
    rig.match.physics().set_state(foe.index, body);
    rig.match.tick({});
    record(rig.match.context_to_change(), {.tick = rig.match.match().played,
                                           .kind = *event_kind("blast_hit"),
                                           .subject = 0,
                                           .by = 1,
                                           .amount = 30,
                                           .place = rig.middle() + vec3(0, 0, 2)});
    rig.play(2 * tactile::frame_ticks);
    EXPECT_LT(felt_side(rig.frame()).y, 0);
}

TEST(TactileScene, ABlastSpreadsOverTheBody) {
    BodyRig rig;
    rig.strike("blast_hit", rig.middle() + vec3(0, 0, -5), 60);
    std::vector<std::size_t> first_on(loaded().figure.actuators.size(), 1000);
    for (std::size_t frame = 0; frame < 40; ++frame) {
        rig.play(tactile::frame_ticks);
        for (std::size_t cell = 0; cell < rig.frame().count; ++cell)
            if (rig.frame().amplitude.at(cell) > 0.05F) first_on[cell] = std::min(first_on[cell], frame);
    }
    const auto earliest = *std::min_element(first_on.begin(), first_on.end());
    std::size_t later = 0;
    for (const auto frame : first_on) later += frame < 1000 && frame > earliest + 5 ? 1 : 0;
    EXPECT_GT(later, 6U) << "cells that feel it more than 40 ms later";
}

/// Largest amplitude at each actuator of the jacket with sleeves after a blast from the right, while the
/// player looks up by `pitch` (rad).
std::vector<float> blast_on_sleeves(double pitch) {
    const auto sleeves = tactile::load_layout(assets() / "tactile/layouts/sleeves.toml").value();
    BodyRig rig;
    rig.turn(0);
    rig.match.world_to_change().get<Gaze>(wizard_of(rig.match.world(), 0)).pitch = pitch;
    const auto number = rig.scene.add(sleeves);
    rig.strike("blast_hit", rig.middle() + vec3(5, 0, 0), 60);
    std::vector<float> peaks(sleeves.actuators.size());
    for (int frame = 0; frame < 60; ++frame) {
        rig.play(tactile::frame_ticks);
        for (std::size_t i = 0; i < peaks.size(); ++i)
            peaks[i] = std::max(peaks[i], rig.scene.frame(number).amplitude.at(i));
    }
    return peaks;
}

TEST(TactileScene, ABlastFromTheSideHitsAHangingWandArmAndPassesARaisedOne) {
    // Indices of actuators in sleeves.toml.
    constexpr std::size_t left_elbow = 13, right_elbow = 18;
    const auto hanging = blast_on_sleeves(-pi / 2), raised = blast_on_sleeves(0);
    EXPECT_GT(hanging[right_elbow], 0.3F);
    EXPECT_EQ(raised[right_elbow], 0) << "the elbow is 0.3 m ahead of the shoulder";
    EXPECT_EQ(hanging[left_elbow], raised[left_elbow]) << "the other arm does not move";
    // The cells at the side of the torso feel the blast equally, whether the arm hangs or is raised.
    constexpr std::size_t front_right = 3;
    EXPECT_GT(raised[front_right], 0.2F);
    EXPECT_NEAR(hanging[front_right], raised[front_right], 1e-3);
}

TEST(TactileScene, AHundredHitsInOneTickKeepTheLimitsAndLoseNone) {
    BodyRig rig;
    for (int i = 0; i < 100; ++i)
        rig.strike(i % 2 == 0 ? "bolt_hit" : "blast_hit", rig.middle() + vec3(i - 50, 0, 4));
    double most = 0;
    for (int frame = 0; frame < 100; ++frame) {
        rig.play(tactile::frame_ticks);
        most = std::max(most, energy(rig.frame()));
        for (const float amplitude : rig.frame().amplitude) EXPECT_LE(amplitude, 1.0F);
    }
    EXPECT_LE(most, 1.5 + 1e-6);
    EXPECT_GT(most, 0.5);
    const auto& counts = rig.scene.counts(0);
    EXPECT_EQ(counts.offered, 100U);
    EXPECT_EQ(counts.started + counts.merged, counts.offered);
    rig.play(ticks(1));
    EXPECT_TRUE(rig.frame().is_silent());
}

TEST(TactileScene, APauseIsSilentAtOnce) {
    BodyRig rig;
    rig.strike("blast_hit", rig.middle() + vec3(0, 0, -5), 60);
    rig.play(3 * tactile::frame_ticks);
    ASSERT_FALSE(rig.frame().is_silent());
    rig.match.world_to_change().single<Match>().paused = 1;
    rig.play(tactile::frame_ticks);
    EXPECT_TRUE(rig.frame().is_silent());
}

TEST(TactileScene, ALayoutThatIsNotUsedIsSilentAndBeginsAnew) {
    BodyRig rig;
    const auto other = rig.scene.add(loaded().figure);
    rig.scene.set_used(other, false);
    rig.strike("blast_hit", rig.middle() + vec3(0, 0, -5), 60);
    rig.play(3 * tactile::frame_ticks);
    EXPECT_FALSE(rig.frame().is_silent());
    EXPECT_TRUE(rig.scene.frame(other).is_silent());
    EXPECT_EQ(rig.scene.counts(other).offered, 0U);
    rig.scene.set_used(other, true);
    rig.play(tactile::frame_ticks);
    EXPECT_TRUE(rig.scene.frame(other).is_silent()) << "what came before is not made up for";
    rig.strike("blast_hit", rig.middle() + vec3(0, 0, -5), 60);
    rig.play(2 * tactile::frame_ticks);
    EXPECT_FALSE(rig.scene.frame(other).is_silent());
}

TEST(TactileScene, TheHeartBeatsWhenHealthIsLow) {
    BodyRig rig;
    rig.play(ticks(1));
    EXPECT_TRUE(rig.frame().is_silent());
    rig.match.world_to_change().get<Health>(wizard_of(rig.match.world(), 0)).points = 5;
    bool felt = false;
    for (int i = 0; i < 125; ++i) {
        rig.play(tactile::frame_ticks);
        felt = felt || !rig.frame().is_silent();
    }
    EXPECT_TRUE(felt);
}

TEST(TactileScene, TheHeartBeatsWhileTheFoeHoldsTheGreatWork) {
    for (const std::uint32_t holder : {0U, 1U}) {
        BodyRig rig;
        rig.play(ticks(1));
        EXPECT_TRUE(rig.frame().is_silent());
        auto& world = rig.match.world_to_change();
        const auto wizard = wizard_of(rig.match.world(), holder);
        world.get<WorkHalf>(wizard).held = 1;
        world.get<Lens>(wizard).held = 1;
        bool felt = false;
        for (int i = 0; i < 125; ++i) {
            rig.play(tactile::frame_ticks);
            felt = felt || !rig.frame().is_silent();
        }
        EXPECT_EQ(felt, holder == 1) << "only the foe of the one who holds it";
    }
}

std::uint64_t frames_of_bots(std::uint64_t* state) {
    auto duel = make_bot_duel(assets(), duel_data(), {"level_3", "level_3"}, 5).value();
    const auto effects = effects_of(duel.match->data());
    TactileScene scene(effects, loaded().effects, 1);
    scene.add(loaded().figure);
    std::uint64_t hash = 0;
    for (Tick t = 0; t < ticks(30); ++t) {
        duel.run(1);
        if (duel.match->now() % tactile::frame_ticks != 0) continue;
        scene.take(*duel.match);
        hash = hash_value(scene.frame(0), hash);
    }
    *state = duel.match->state_hash();
    return hash;
}

TEST(TactileScene, EqualMatchesGiveEqualFramesAndFeelingChangesNothing) {
    std::uint64_t first = 0, second = 0;
    EXPECT_EQ(frames_of_bots(&first), frames_of_bots(&second));
    auto plain = make_bot_duel(assets(), duel_data(), {"level_3", "level_3"}, 5);
    plain->run(ticks(30));
    EXPECT_EQ(first, plain->match->state_hash());
    EXPECT_EQ(second, first);
}

TEST(TactileScene, EveryHarmHasAnEffect) {
    const auto data = duel_data();
    const auto effects = effects_of(*data);
    for (std::size_t kind = 0; kind < effects.events.size(); ++kind) {
        const auto event = static_cast<EventKind>(kind);
        if (info_of(event).name.empty() || info_of(event).cause.empty()) continue;
        EXPECT_TRUE(effects.events[kind]) << name_of(event);
    }
}

TEST(TactileScene, AMissingEffectIsNamedAndCostsNoOther) {
    const auto data = duel_data();
    auto poor = loaded().effects;
    poor.effects.erase(poor.effects.begin() + static_cast<std::ptrdiff_t>(*poor.find("bolt_hit")));
    const auto effects = match_effects(poor, *data->presentation);
    ASSERT_EQ(effects.missing.size(), 1U);
    EXPECT_EQ(effects.missing[0].file, "wands/bolt.toml");
    EXPECT_EQ(effects.missing[0].table, "event.bolt_hit");
    EXPECT_FALSE(effects.events[static_cast<std::size_t>(*event_kind("bolt_hit"))]);
    EXPECT_TRUE(effects.events[static_cast<std::size_t>(*event_kind("blast_hit"))])
        << "it costs no other one";
    EXPECT_TRUE(effects.recoil);
}

}  // namespace
}  // namespace thaum::game::test
