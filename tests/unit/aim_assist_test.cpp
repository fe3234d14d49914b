// Tests of the aim assist: how far it turns a shot, where it slows the view, when it does nothing, and how
// many more hits it gives a player with keys alone.
#include "game/context/aim_assist.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <deque>

#include "game/bots/bot_file.h"
#include "game/context/shot.h"
#include "game/range/range.h"
#include "input/collector.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

namespace hand = input::hand;

/// A match between a player with aim assist (help with aiming), who looks along -z, and a foe 12 m away.
class AimAssist : public testing::Test {
protected:
    explicit AimAssist(int percent = 100, std::vector<std::string> overrides = {},
                       std::string rules = "thaum") {
        auto data =
            load_match_data(assets(), {.rules = std::move(rules), .overrides = std::move(overrides)}).value();
        input::DeviceSpec helped{.player = 0, .kind = input::DeviceKind::pad, .name = "pad"};
        helped.aim_assist = static_cast<std::uint8_t>(percent);
        const input::DeviceSpec foe{.player = 1, .kind = input::DeviceKind::script, .name = "script"};
        match_ = std::make_unique<Simulation>(std::make_shared<const MatchData>(std::move(data)),
                                              MatchSetup{.seed = 1, .devices = {helped, foe}});
        put(0, {0, 0, 16});
        put(1, {0, level, 4});
        look(0, 0);
    }

    /// Height of the foe's feet at which the middle of the foe is as high as the player's eye (m).
    static constexpr double level = 0.75;

    ecs::Entity wizard(std::uint32_t player) const { return wizard_of(match_->world(), player); }
    void put(std::uint32_t player, vec3 feet) {
        match_->physics().set_state(wizard(player).index, standing(feet));
    }
    physics::BodyState standing(vec3 feet) const {
        physics::BodyState state;
        state.position = feet + vec3(0, match_->data().wizard.height / 2, 0);
        return state;
    }
    void look(double yaw, double pitch) { match_->world_to_change().get<Gaze>(wizard(0)) = {yaw, pitch}; }
    vec3 centre(std::uint32_t player) const { return match_->physics().state(wizard(player).index).position; }
    vec3 eye() const { return eye_of(match_->data().wizard, centre(0)); }
    /// Direction that lies to the left of the foe's vertical axis by `angle`, on the horizon.
    static vec3 beside(double angle) { return look_rotation(angle, 0) * vec3(0, 0, -1); }
    vec3 helped(vec3 aim, double speed = 1e6) const {
        return helped_aim(match_->context(), wizard(0), eye(), aim, speed);
    }
    static double angle(vec3 a, vec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }
    double half_width() const { return std::atan(match_->data().wizard.radius / 12); }

    std::unique_ptr<Simulation> match_;
};

class AimAssistOff : public AimAssist {
protected:
    AimAssistOff() : AimAssist(0) {}
};

class AimAssistClassic : public AimAssist {
protected:
    AimAssistClassic() : AimAssist(100, {}, "classic") {}
};

TEST_F(AimAssist, TurnsAShotToTheFoeByTwoDegreesAtMost) {
    for (const double off : {0.0, 0.3, 1.0, 1.9, -1.9}) {
        const auto aim = helped(beside(off * radians_per_degree));
        EXPECT_LT(angle(aim, beside(0)), 1e-9) << off;
    }
    const double far = max_pull + 0.9 * half_width();
    EXPECT_NEAR(angle(helped(beside(far)), beside(far)), max_pull, 1e-9);
    EXPECT_NEAR(angle(helped(beside(-far)), beside(0)), 0.9 * half_width(), 1e-9);
}

TEST_F(AimAssist, LeavesAShotThatWouldMissByMoreAsItIs) {
    for (const double off : {max_pull + 1.01 * half_width(), 0.3, 1.5, 3.1}) {
        EXPECT_EQ(helped(beside(off)), beside(off)) << off;
        EXPECT_EQ(helped(beside(-off)), beside(-off)) << off;
    }
}

TEST_F(AimAssist, TurnsAShotToWhereItMeetsAFoeWhoWalks) {
    const double speed = 40;
    auto state = standing({0, level, 4});
    state.velocity = {2, 0, 0};
    match_->physics().set_state(wizard(1).index, state);
    const vec3 to = centre(1) - eye();
    const double flight = glm::length(to) / speed;
    const vec3 meets = glm::normalize(vec3(2 * flight, 0, to.z));
    const auto aim = helped(glm::normalize(meets + vec3(0.01, 0, 0)), speed);
    EXPECT_LT(angle(aim, meets), 1e-9);
}

TEST_F(AimAssist, SlowsTheViewOnTheFoeAndBesideIt) {
    look(0, 0);
    EXPECT_NEAR(view_help(match_->context(), wizard(0)).turn_share, 0.3, 1e-9);
    double before = 0.3;
    for (const double off : {1.0, 2.0, 3.0, 5.0}) {
        look(half_width() + off * radians_per_degree, 0);
        const double left = view_help(match_->context(), wizard(0)).turn_share;
        look(-half_width() - off * radians_per_degree, 0);
        EXPECT_NEAR(view_help(match_->context(), wizard(0)).turn_share, left, 1e-9) << "both sides alike";
        EXPECT_GT(left, before) << off;
        before = left;
    }
    EXPECT_EQ(before, 1);
}

TEST_F(AimAssist, DrawsTheViewToTheFoeFromTwoDegreesBesideItOn) {
    for (const double side : {1.0, -1.0}) {
        look(side * (half_width() + 0.9 * max_pull), 0);
        EXPECT_LT(side * view_help(match_->context(), wizard(0)).left, 0) << "towards the foe";
        look(side * (half_width() + 1.1 * max_pull), 0);
        EXPECT_EQ(view_help(match_->context(), wizard(0)).left, 0) << "too far beside";
    }
    look(0, 0);
    EXPECT_NEAR(view_help(match_->context(), wizard(0)).left, 0, 1e-12);
}

TEST_F(AimAssist, LeavesTheViewOfAPlayerWhoDoesNothing) {
    look(half_width(), 0);
    input::InputFrame frame;
    for (Tick t = 0; t < 100; ++t) match_->tick(frame);
    EXPECT_EQ(match_->world().get<Gaze>(wizard(0)).yaw, half_width());
    frame.devices[0].counts[hand::strafe] = 1;
    for (Tick t = 0; t < 100; ++t) match_->tick(frame);
    EXPECT_LT(match_->world().get<Gaze>(wizard(0)).yaw, half_width());
}

TEST_F(AimAssist, DoesNothingThroughAWallOrForADeadFoe) {
    match_->physics().add(9000, {.shape = physics::Shape::box, .size = {2, 4, 0.1}}, standing({0, 0, 10}));
    EXPECT_EQ(helped(beside(0.01)), beside(0.01));
    EXPECT_EQ(view_help(match_->context(), wizard(0)).turn_share, 1);
    match_->physics().remove(9000);
    EXPECT_NE(helped(beside(0.01)), beside(0.01));
    match_->world_to_change().get<Health>(wizard(1)).points = 0;
    for (Tick t = 0; t < 2 * gameplay_period; ++t) match_->tick({});
    ASSERT_TRUE(match_->world().has<Dead>(wizard(1)));
    EXPECT_EQ(helped(beside(0.01)), beside(0.01));
}

TEST_F(AimAssist, DoesNothingForThePlayerWithout) {
    EXPECT_EQ(helped_aim(match_->context(), wizard(1), eye(), beside(0.01), 40), beside(0.01));
    EXPECT_EQ(view_help(match_->context(), wizard(1)).turn_share, 1);
}

TEST_F(AimAssistOff, ChangesNothing) {
    EXPECT_EQ(helped(beside(0.01)), beside(0.01));
    EXPECT_EQ(view_help(match_->context(), wizard(0)).turn_share, 1);
}

TEST_F(AimAssistClassic, ChangesNothing) {
    EXPECT_EQ(helped(beside(0.01)), beside(0.01));
    EXPECT_EQ(view_help(match_->context(), wizard(0)).turn_share, 1);
}

// ---- a player with keys alone -----------------------------------------------------------------------------

/// Invents a key code for each key that default_bindings names; the test has no keyboard.
std::optional<int> numbered(std::string_view name) {
    const auto names = input::default_key_names();
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? std::nullopt : std::optional<int>(static_cast<int>(found - names.begin()));
}

/// A simulated player as good as a bot of the first level, but with the arrow keys as the only means to turn.
/// The player reacts late, errs by some degrees, and fires in bursts.
class KeypadPlayer {
public:
    KeypadPlayer() : hands_(input::default_bindings(input::DeviceKind::keyboard_half, numbered)) {
        hands_.set_turn_ramp(0.15);
        skill_ = load_bot_skill(assets(), "level_1").value();
    }

    input::DeviceSample sample(const Simulation& match) {
        const Tick now = match.match().played;
        if (now % look_period == 0) look(match, now);
        return hands_.take();
    }

private:
    static constexpr Tick look_period = 16, late = ticks(0.2);

    double normal() {
        double sum = -6;
        for (int i = 0; i < 12; ++i) sum += random_.uniform();
        return sum;
    }

    void hold(std::string_view key, bool held) { hands_.key(*numbered(key), held); }

    /// Holds the arrow keys so that the view turns to where the foe should be now, judged by what the player
    /// could see some time ago.
    void look(const Simulation& match, Tick now) {
        const auto& world = match.world();
        const auto self = wizard_of(world, practising), foe = wizard_of(world, dummys);
        seen_.push_back({world.get<Motion>(foe).position, world.get<Motion>(foe).velocity});
        if (seen_.size() > late / look_period + 1) seen_.pop_front();
        constexpr double keep = 0.96;
        error_ = keep * error_ + std::sqrt(1 - keep * keep) * skill_.aim_error * normal();
        const vec3 eye = eye_of(match.data().wizard, world.get<Motion>(self).position);
        const double flight = glm::distance(eye, seen_.front().place) / 40;
        const vec3 place = seen_.front().place + seen_.front().velocity * (seconds(late) + flight);
        const auto& gaze = world.get<Gaze>(self);
        const double yaw = std::atan2(-(place.x - eye.x), -(place.z - eye.z));
        const double left = std::remainder(yaw + error_ - gaze.yaw, 2 * pi);
        const double up = 0.3 * error_ - gaze.pitch;
        constexpr double enough = 1.5 * radians_per_degree;
        hold("left", left > enough);
        hold("right", left < -enough);
        hold("up", up > enough);
        hold("down", up < -enough);
        if (std::abs(left) < 4 * radians_per_degree && now >= fire_until_ + skill_.rest)
            fire_until_ = now + skill_.burst;
        hold("kp_0", now < fire_until_);
    }

    struct Seen {
        vec3 place{}, velocity{};
    };

    input::HandsCollector hands_;
    BotSkill skill_;
    Random random_ = random_stream(5, 1);
    std::deque<Seen> seen_;
    double error_ = 0;
    Tick fire_until_ = 0;
};

/// A player with keys alone shoots for two minutes at a dummy, 12 m away and walking sideways. Returns the
/// share of the bolts that hit. `percent` is the strength of the aim assist.
double share_of_hits(int percent) {
    const auto data =
        load_range(assets(), {.overrides = {"bolt.energy.regain_per_s=1000", "bolt.shot.damage=0.001"}})
            .value();
    input::DeviceSpec keypad{
        .player = practising, .kind = input::DeviceKind::keyboard_half, .name = "keypad"};
    keypad.turn_rad_per_s = 200 * radians_per_degree;
    keypad.aim_assist = static_cast<std::uint8_t>(percent);
    auto range = make_range(data, keypad, DummyKind::strafing, 3);
    auto& match = *range.match;
    const auto dummy = wizard_of(match.world(), dummys), player = wizard_of(match.world(), practising);
    const vec3 way =
        match.physics().state(dummy.index).position - match.physics().state(player.index).position;
    auto near = match.physics().state(player.index);
    near.position += glm::normalize(way) * (glm::length(way) - 12);
    match.physics().set_state(player.index, near);
    KeypadPlayer hands;
    for (Tick t = 0; t < ticks(120.0); ++t) range.tick(hands.sample(match));
    RangeScorer scorer;
    const auto score = scorer.score(match);
    EXPECT_GT(score.shots, 200U);
    return static_cast<double>(score.hits) / score.shots;
}

TEST(AimAssistWorth, AKeypadPlayerHitsAStrafingDummy) {
    const double without = share_of_hits(0), with = share_of_hits(60);
    std::printf("share of hits by keypad: %.3f without help, %.3f with 60 %%\n", without, with);
    EXPECT_GE(with, 0.35);
    EXPECT_GT(with, 1.5 * without);
}

}  // namespace
}  // namespace thaum::game::test
