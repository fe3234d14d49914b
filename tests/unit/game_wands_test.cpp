// Tests of the wands blast and lob: forces on the hand for any device and force limit, what ends a charge or
// draw, stones that never gain energy, and random input.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.h"
#include "core/text.h"
#include "game/components/hand_state.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

using input::Button;

constexpr Tick blast_full = ticks(1.6) + 2 * gameplay_period;

/// A match of two players whose input the test gives. The test presses the buttons of the first.
struct WandRig {
    explicit WandRig(std::vector<std::string> overrides = {}, const char* length = "quick")
        : match(data_of(std::move(overrides), length), two_hands()) {}

    static std::shared_ptr<const MatchData> data_of(std::vector<std::string> overrides, const char* length) {
        return std::make_shared<const MatchData>(
            load_match_data(assets(), {.match = length, .overrides = std::move(overrides)}).value());
    }

    template <class Each>
    void hold(Tick count, std::uint32_t buttons, Each each) {
        for (Tick t = 0; t < count; ++t) {
            input::InputFrame frame;
            frame.devices[0].buttons = buttons;
            frame.devices[0].wand = wand_key;
            frame.devices[0].counts[input::hand::trigger] = (buttons & bit(Button::fire)) != 0 ? 255 : 0;
            match.tick(frame);
            each();
        }
    }
    void hold(Tick count, Button button) {
        hold(count, bit(button), [] {});
    }
    void wait(Tick count) {
        hold(count, 0, [] {});
    }
    void take(std::uint8_t wand) {
        wand_key = wand;
        wait(2 * gameplay_period);
        wand_key = 0;
        wait(gameplay_period);
    }
    void look_up(double pitch) { match.world_to_change().get<Gaze>(me()).pitch = pitch; }

    ecs::Entity me() const { return wizard_of(match.world(), 0); }
    const HandState& hand_state() const { return match.world().get<HandState>(me()); }
    std::uint32_t shots() const { return match.world().get<WandBelt>(me()).fired; }
    std::vector<Missile> missiles() const {
        std::vector<Missile> all;
        for (const auto& wand : match.data().wands)
            wand.rules->show(match.world(), [&](const Missile& m) { all.push_back(m); });
        return all;
    }
    double readiness() const {
        const auto& belt = match.world().get<WandBelt>(me());
        for (const auto& wand : match.data().wands) {
            if (wand.stats.slot == belt.selected)
                return wand.rules->readiness(match.world(), me()).value_or(0);
        }
        return 0;
    }

    Simulation match;
    std::uint8_t wand_key = 0;  ///< number of the wand whose key is down; 0: none
};

TEST(Blast, LeansByTheDevicesPeakAndThePlayersCap) {
    for (const auto& [device, peak] :
         {std::pair{"touch", 3.3}, {"premium", 8.5}, {"falcon", 8.0}, {"omega3", 12.0}}) {
        // Larger shares would warm the motors of the premium device, and warm motors give less force.
        for (const double share : {0.1, 0.3}) {
            WandRig w({text("haptics.device=\"", device, "\""), text("haptics.share=", share)});
            w.take(2);
            w.hold(blast_full, Button::fire);
            const double cap = peak * share;
            EXPECT_NEAR(w.hand_state().servo.safety.output.z, 2.6 / 3.3 * cap, 1e-9)
                << device << " " << share;
            w.wait(500);
            EXPECT_EQ(w.shots(), 1U);
            EXPECT_EQ(w.hand_state().servo.safety.output, vec3(0));
        }
    }
}

TEST(Blast, KicksByThePlayersCap) {
    for (const double share : {0.1, 0.45, 1.0}) {
        WandRig w({text("haptics.share=", share)});
        w.take(2);
        w.hold(blast_full, Button::fire);
        double greatest = 0;
        w.hold(gameplay_period, 0, [] {});  // the charge continues until the wand reads the fire button again
        w.hold(80, 0, [&] { greatest = std::max(greatest, w.hand_state().servo.safety.output.z); });
        EXPECT_NEAR(greatest, 3.0 * share, 0.002 * share) << share;
    }
}

TEST(Blast, TheWholeRecoilIsFeltOnEveryDevice) {
    // When the blast is fired, the steady force L of its charge falls as L (1 - half sine) while the recoil
    // rises, so the sum stays below the larger of the two. The impulse of the recoil alone is 2/pi times its
    // peak times its length.
    for (const auto& [device, peak] :
         {std::pair{"touch", 3.3}, {"omni", 3.3}, {"premium", 8.5}, {"falcon", 8.0}, {"omega3", 12.0}}) {
        for (const double share : {0.1, 0.3, 1.0}) {
            // At the full share the charge alone heats this device's motors so much that the limit for heat
            // holds the recoil back.
            if (share == 1 && device == std::string("premium")) continue;
            WandRig w({text("haptics.device=\"", device, "\""), text("haptics.share=", share)});
            w.take(2);
            w.hold(blast_full, Button::fire);
            const double felt = share * peak / 3.3, leaning = 2.6 * felt;
            while (w.shots() == 0) w.wait(1);
            double impulse = 0, greatest = 0;
            w.hold(200, 0, [&] {
                impulse += w.hand_state().servo.safety.output.z * tick_seconds;
                greatest = std::max(greatest, w.hand_state().servo.safety.output.z);
            });
            double left = 0;
            for (std::uint32_t at = 0; at < 30; ++at) left += 1 - haptics::half_sine(at, 60);
            EXPECT_NEAR(impulse, 2 / pi * 3.0 * felt * 0.06 + leaning * left * tick_seconds, 1e-9 * felt)
                << device << " " << share;
            EXPECT_LE(greatest, 3.0 * felt * (1 + 1e-12)) << device << " " << share;
            EXPECT_EQ(w.hand_state().servo.safety.output, vec3(0)) << device << " " << share;
        }
    }
}

TEST(Wands, DyingOrChangingTheWandEndsADrawWithoutAShot) {
    for (const std::uint8_t wand : {std::uint8_t{2}, std::uint8_t{3}}) {
        for (const bool dies : {false, true}) {
            WandRig w;
            w.take(wand);
            w.hold(1000, Button::fire);
            ASSERT_GT(w.readiness(), 0.5);
            ASSERT_GT(glm::length(w.hand_state().servo.safety.output), 0.3);
            if (dies) {
                w.match.world_to_change().get<Health>(w.me()).points = 0;
                // Fire stays held: a release in the tick of death would still shoot.
                w.hold(2 * gameplay_period, Button::fire);
            } else {
                w.take(1);
            }
            w.wait(500);
            EXPECT_EQ(w.shots(), 0U) << dies;
            EXPECT_EQ(w.readiness(), 0);
            EXPECT_EQ(w.hand_state().servo.safety.output, vec3(0));
            EXPECT_EQ(w.hand_state().pull, vec3(0));
            EXPECT_TRUE(w.missiles().empty());
        }
    }
}

TEST(Wands, NothingIsLeftOfARoundInTheNext) {
    WandRig w({"standard.seconds=3", "standard.interval_s=1", "standard.boil_over.seconds=0"}, "standard");
    w.take(3);
    w.hold(1500, Button::fire);
    w.wait(gameplay_period);
    w.hold(3000 - static_cast<Tick>(w.match.match().played) - 100, Button::fire);
    EXPECT_EQ(w.missiles().size(), 1U);
    while (w.match.match().round == 0) w.wait(1);
    EXPECT_TRUE(w.missiles().empty());
    EXPECT_EQ(w.readiness(), 0);
    EXPECT_EQ(w.hand_state().pull, vec3(0));
    w.wait(2500);
    EXPECT_EQ(w.shots(), 0U);
}

TEST(Lob, AStoneNeverGainsEnergyAndNeverLeavesTheArena) {
    WandRig w({"lob.energy.cost=0", "lob.shot.fuse_s=6", "lob.burst.damage=0", "lob.burst.impulse_n_s=0",
               "quick.seconds=600"});
    w.take(3);
    Random random{11};
    std::size_t followed = 0, bounces = 0;
    std::map<std::uint32_t, double> energies;
    const auto follow = [&] {
        for (const auto& m : w.missiles()) {
            const double energy = glm::dot(m.velocity, m.velocity) / 2 + 9.81 * m.position.y;
            const auto [known, fresh] = energies.try_emplace(m.entity.index, energy);
            // A straight step of time dt is up to g dt^2 / 8 (gravity g) off the parabola, less than 1e-3.
            if (!fresh) {
                EXPECT_LE(energy, known->second + 1e-3);
                bounces += energy < known->second - 0.1 ? 1 : 0;
            }
            known->second = energy;
            EXPECT_LT(std::max(std::abs(m.position.x), std::abs(m.position.z)), 20);
            EXPECT_GT(m.position.y, -5);
            ++followed;
        }
    };
    for (int i = 0; i < 24; ++i) {
        w.match.world_to_change().get<Gaze>(w.me()) = {random.uniform(-pi, pi), random.uniform(-0.5, 0.6)};
        energies.clear();
        w.hold(200 + random.below(800), bit(Button::fire), follow);
        w.hold(6200, 0, follow);
        ASSERT_FALSE(HasFailure()) << i;
        ASSERT_TRUE(w.missiles().empty());
    }
    EXPECT_EQ(w.shots(), 24U);
    EXPECT_GT(followed, 24U * 5000);
    EXPECT_GT(bounces, 48U);
}

TEST(Wands, RestoredInTheMiddleOfAChargeADrawAndAFlight) {
    for (const std::uint8_t wand : {std::uint8_t{2}, std::uint8_t{3}}) {
        const auto buttons_at = [&](Tick t) {
            return (t >= 16 && t < 1800) || (t > 1850 && t < 2900) ? bit(Button::fire) : 0;
        };
        const auto play = [&](Simulation& match, Tick from, Tick to) {
            for (Tick t = from; t < to; ++t) {
                input::InputFrame frame;
                frame.devices[0].buttons = buttons_at(t);
                frame.devices[0].wand = t < 16 ? wand : std::uint8_t{0};
                frame.devices[0].counts[input::hand::trigger] =
                    (buttons_at(t) & bit(Button::fire)) != 0 ? 200 : 0;
                frame.devices[0].counts[input::hand::look_up] = t < 300 ? 1 : 0;
                match.tick(frame);
            }
        };
        WandRig w;
        play(w.match, 0, keyframe_interval);
        EXPECT_EQ(w.shots(), 1U);
        EXPECT_FALSE(w.missiles().empty());
        if (wand == 3) {
            EXPECT_GT(w.readiness(), 0);
        }
        Bytes state;
        w.match.save(state);
        play(w.match, keyframe_interval, keyframe_interval + 1500);
        WandRig other;
        ASSERT_TRUE(other.match.restore(state, keyframe_interval));
        play(other.match, keyframe_interval, keyframe_interval + 1500);
        EXPECT_EQ(other.match.state_hash(), w.match.state_hash());
        EXPECT_EQ(other.shots(), 2U);
    }
}

TEST(Wands, AnyInputLeavesForcesEnergiesAndPlacesInRange) {
    Random random{4};
    WandRig w({"quick.seconds=600", "quick.kills=1000", "blast.energy.regain_per_s=20",
               "lob.energy.regain_per_s=20"});
    const double cap = w.match.haptic_setup().servos[0].limits.cap;
    constexpr std::array buttons{Button::fire, Button::fire, Button::clutch, Button::jump};
    input::InputFrame frame;
    std::size_t flown = 0;
    for (Tick t = 0; t < 60'000; ++t) {
        for (auto& device : frame.devices) {
            if (random.below(350) == 0) device.wand = static_cast<std::uint8_t>(random.below(4));
            if (random.below(260) == 0) device.buttons ^= bit(buttons[random.below(buttons.size())]);
            if (random.below(50) == 0)
                device.counts[input::hand::trigger] = static_cast<std::int32_t>(random.below(1000)) - 300;
            device.counts[input::hand::look_right] = static_cast<std::int32_t>(random.below(21)) - 10;
            device.counts[input::hand::look_up] = static_cast<std::int32_t>(random.below(21)) - 10;
        }
        w.match.tick(frame);
        w.match.world().view<const HandState, const WandBelt>().each(
            [&](const HandState& hand_state, const WandBelt& belt) {
                ASSERT_LE(glm::length(hand_state.servo.safety.output), cap);
                ASSERT_TRUE(is_finite(hand_state.device.position));
                for (const auto& wand : w.match.data().wands) {
                    ASSERT_GE(belt.energy[wand.stats.slot], 0);
                    ASSERT_LE(belt.energy[wand.stats.slot], wand.stats.energy_cap);
                }
            });
        ASSERT_GE(w.readiness(), 0);
        ASSERT_LE(w.readiness(), 1);
        for (const auto& m : w.missiles()) {
            ASSERT_TRUE(is_finite(m.position) && is_finite(m.velocity));
            ASSERT_LT(glm::length(m.position), 200);
        }
        flown += w.missiles().size();
    }
    EXPECT_GT(w.shots(), 20U);
    EXPECT_GT(flown, 5000U);
}

TEST(Wands, AContradictionInAFileIsNamedInOneLine) {
    for (const auto& [change, words] : {std::pair{"blast.energy.cost_full=3", "wands/blast.toml"},
                                        {"blast.charge.full_s=0.2", "'full_s'"},
                                        {"blast.shot.speed_full_m_s=2", "'speed_full_m_s'"},
                                        {"lob.draw.axis=[0, 0, 0]", "'axis'"},
                                        {"lob.spring.detent_width_m=0.05", "'detent_width_m'"},
                                        {"lob.slot=1", "'slot' is 1, where bolt is"},
                                        {"lob.shot.bounce=1.5", "'bounce' is 1.5"}}) {
        const auto message = message_of(load_match_data(assets(), {.overrides = {change}}));
        EXPECT_NE(message.find(words), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace thaum::game::test
