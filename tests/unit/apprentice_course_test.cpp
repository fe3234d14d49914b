// A scripted player completes all lessons of the Apprentice (the game's guided course). The player acts only
// by device samples, as a person does. Each lesson's step must stay open until the player has done what it
// asks.
#include <gtest/gtest.h>

#include <map>

#include "core/text.h"
#include "game/bots/aim.h"
#include "game/bots/senses.h"
#include "game/bots/stirring.h"
#include "game/components/cauldron.h"
#include "game/range/practice.h"

namespace thaum::game {
namespace {

using game::practising;
using input::Button;
using input::DeviceSample;
namespace hand = input::hand;

const std::filesystem::path assets_folder = THAUM_SOURCE_DIR "/assets";

/// What a scripted player perceives, and the device sample with which that player answers.
struct Player {
    Practice& practice;
    Tick tick;  ///< ticks since the player began the step
    DeviceSample sample{};

    const game::Simulation& match() const { return practice.match(); }
    game::Self self(double readiness = 0) const { return game::self_of(match(), practising, readiness); }
    vec3 place_of(std::uint32_t player) const {
        const auto& world = match().world();
        return world.get<game::Motion>(game::wizard_of(world, player)).position;
    }
    std::uint32_t slot_of(std::string_view name) const {
        for (const auto& wand : match().data().wands)
            if (wand.name == name) return wand.stats.slot;
        ADD_FAILURE() << "no wand " << name;
        return 0;
    }
    /// Turns the view towards a direction. Returns whether the view has reached it.
    bool look(game::Aim aim) {
        const auto me = self();
        const double left = game::angle_between(me.yaw, aim.yaw), up = aim.pitch - me.pitch;
        const auto counts = [](double angle) {
            return std::clamp(static_cast<std::int32_t>(std::lround(0.05 * angle / game::rad_per_count)), -4,
                              4);
        };
        sample.counts[hand::look_right] = -counts(left);
        sample.counts[hand::look_up] = counts(up);
        return std::abs(left) < 0.02 && std::abs(up) < 0.02;
    }
    bool look_at(vec3 place) { return look(game::aim_at(self().eye, place)); }
    void walk_to(vec3 place) {
        look_at({place.x, self().eye.y, place.z});
        sample.counts[hand::forward] = 127;
    }
    void hold_fire() {
        sample.press(Button::fire);
        sample.counts[hand::trigger] = 255;
    }
    /// Presses the key of a wand. Returns whether the wizard holds that wand already.
    bool take(std::string_view wand) {
        const auto slot = slot_of(wand);
        if (self().wand == slot) return true;
        sample.wand = static_cast<std::uint8_t>(slot + 1);
        return false;
    }
};

void walk_and_look(Player& p) {
    p.sample.counts[hand::strafe] = p.tick / 1500 % 2 == 0 ? 127 : -127;
    p.sample.counts[hand::look_right] = 2;
}

void shoot_bolts(Player& p) {
    if (p.take("bolt") && p.look_at(p.place_of(game::dummys))) p.hold_fire();
}

/// Holds the fire button until the wand is charged to the share `readiness`, aims, and releases the button.
void ready_and_shoot(Player& p, std::string_view wand, double readiness) {
    if (!p.take(wand)) return;
    const auto me = p.self(readiness);
    const bool aims = p.look(game::aim_of_shot(me, p.place_of(game::dummys)));
    if (me.readiness < readiness || !aims) p.hold_fire();
}

/// Lifts the small crate and holds it in front of the dummy.
void lift_and_block(Player& p) {
    if (!p.take("lift")) return;
    const auto me = p.self();
    if (me.held) {
        p.hold_fire();
        p.look_at(p.place_of(game::dummys) + vec3(0, 0.3, 0));
    } else if (p.look_at({10, 1.05, 4.5}) && p.tick % 400 < 300) {
        p.hold_fire();
    }
}

void swing_over(Player& p) {
    const vec3 anchor(-4, 7, 9), beyond(-4, 1.5, 25);
    const auto me = p.self();
    const bool passed = me.centre.z > anchor.z + 2.2;
    if (!p.take("swing")) return;
    if (passed || me.held) p.walk_to(beyond);
    if (passed) return;
    if (me.held || p.look_at(anchor)) p.hold_fire();
}

void fetch_ingredient(Player& p) { p.walk_to({7, 0, 0}); }

void brew(Player& p) {
    const auto& world = p.match().world();
    const auto wizard = game::wizard_of(world, practising);
    if (!world.has<game::Ladle>(wizard) && p.self().centre.x > 2.3) return p.walk_to({0, 0, 0});
    game::stir_hand(p.tick, p.sample);
    if (world.has<game::Pouch>(wizard) && p.tick % 200 < 100) p.hold_fire();
}

/// Draws a circle within a second, with the button Trace held, which makes the hand draw.
void draw_circle(Player& p) {
    constexpr Tick begin = 100, length = 1000;
    constexpr double radius = 350;  // radius of the circle (counts of the mouse)
    if (p.tick >= begin + length) return;
    p.sample.press(Button::trace);
    if (p.tick < begin) return;
    const auto at = [](Tick tick) {
        const double angle = 2 * pi * static_cast<double>(tick - begin) / length;
        return std::pair(std::lround(radius * std::sin(angle)), std::lround(radius * std::cos(angle)));
    };
    const auto from = at(p.tick), to = at(p.tick + 1);
    p.sample.counts[hand::look_right] = static_cast<std::int32_t>(to.first - from.first);
    p.sample.counts[hand::look_up] = static_cast<std::int32_t>(to.second - from.second);
}

const std::map<std::string, void (*)(Player&)> ways_to_do{
    {"Look and move", walk_and_look},
    {"Bolt", shoot_bolts},
    {"Blast", [](Player& p) { ready_and_shoot(p, "blast", 0.97); }},
    {"Lob", [](Player& p) { ready_and_shoot(p, "lob", 0.8); }},
    {"Lift", lift_and_block},
    {"Swing", swing_over},
    {"Ingredient", fetch_ingredient},
    {"Brew", brew},
    {"Cast", draw_circle}};

class ApprenticeCourse : public testing::Test {
protected:
    static Practice make() {
        const auto lessons = game::load_lessons(assets_folder).value();
        const auto data = game::load_range(assets_folder, {.arena = lessons.arena}).value();
        return {data, {game::bot_device(practising, "level_1")}, game::DummyKind::still, 1, lessons};
    }
    void tick(const DeviceSample& sample) {
        input::InputFrame frame;
        frame.devices[practising] = sample;
        frame.devices[game::dummys] = practice_.dummy_sample();
        practice_.hold_fire_back(frame);
        practice_.match().tick(frame);
        practice_.follow_lessons();
    }
    game::Apprentice& course() { return *practice_.apprentice(); }
    std::string step_name() { return course().is_over() ? "" : course().lessons().steps[course().at()].name; }
    void wait(Tick duration) {
        for (Tick t = 0; t < duration; ++t) tick({});
    }
    /// Skips to a step and starts it.
    void begin_step(std::string_view name) {
        while (step_name() != name) course().skip();
        wait(16);
    }
    void hold_fire(Tick duration) {
        for (Tick t = 0; t < duration; ++t) {
            Player player{practice_, t};
            player.hold_fire();
            tick(player.sample);
        }
    }
    ecs::Entity wizard() { return game::wizard_of(practice_.match().world(), practising); }
    double health() { return practice_.match().world().get<game::Health>(wizard()).points; }
    /// Distance along the ground between the player and the place to which the lesson's step sends the player
    /// (m).
    double feet_off() {
        const auto place = course().lessons().steps[course().at()].player->feet;
        const auto centre = Player{practice_, 0}.self().centre;
        return std::hypot(centre.x - place.x, centre.z - place.z);
    }
    double wand_readiness(std::string_view name) {
        for (const auto& wand : practice_.match().data().wands)
            if (wand.name == name)
                return wand.rules->readiness(practice_.match().world(), wizard()).value_or(0);
        return 0;
    }
    /// Plays until the player has done what the step asks. Returns the number of ticks that it took, at most
    /// `limit`.
    Tick do_step(void (*way)(Player&), Tick limit) {
        Tick t = 0;
        for (; t < limit && !course().is_done(); ++t) {
            Player player{practice_, t};
            way(player);
            tick(player.sample);
        }
        return t;
    }

    Practice practice_ = make();
};

TEST_F(ApprenticeCourse, AScriptedPlayerDoesItAll) {
    const auto count = course().lessons().steps.size();
    for (std::size_t step = 0; step < count; ++step) {
        ASSERT_EQ(course().at(), step);
        const auto name = step_name();
        wait(ticks(1.0));
        ASSERT_FALSE(course().is_done()) << name << " is done although nothing was done";
        ASSERT_EQ(ways_to_do.count(name), 1U) << "the script does not know the step " << name;
        const auto took = do_step(ways_to_do.at(name), ticks(60.0));
        ASSERT_TRUE(course().is_done()) << name << ": " << course().share() << " after " << took << " ticks";
        std::printf("%s: %llu ticks\n", name.c_str(), static_cast<unsigned long long>(took));
        wait(ticks(1.6));
    }
    EXPECT_TRUE(course().is_over());
    const auto all = practice_.match().now();
    std::printf("the whole course: %llu ticks\n", static_cast<unsigned long long>(all));
    EXPECT_LT(all, ticks(480.0));
}

TEST_F(ApprenticeCourse, AStepThatIsNotDoneIsNeverAtAHundredPerCent) {
    int most = 0;
    double max_share = 0;
    for (Tick t = 0; t < ticks(20.0) && !course().is_done(); ++t) {
        Player player{practice_, t};
        walk_and_look(player);
        tick(player.sample);
        if (course().is_done()) break;
        most = std::max(most, course().percent());
        max_share = std::max(max_share, course().share());
        EXPECT_LE(course().percent(), 100 * course().share());
    }
    EXPECT_GT(max_share, 0.995) << "rounded, this would be 100 %";
    EXPECT_EQ(most, 99);
    ASSERT_TRUE(course().is_done());
    EXPECT_EQ(course().percent(), 100);
}

TEST_F(ApprenticeCourse, AnotherDeedThanTheStepsIsNotEnough) {
    begin_step("Blast");
    const auto uncharged = [](Player& p) {
        if (p.take("blast") && p.look_at(p.place_of(game::dummys)) && p.tick % 800 < 500) p.hold_fire();
    };
    do_step(uncharged, ticks(10.0));
    EXPECT_FALSE(course().is_done()) << "the blasts are not charged";
    do_step(shoot_bolts, ticks(3.0));
    EXPECT_FALSE(course().is_done()) << "the bolts are no blasts";
    EXPECT_LT(course().share(), 0.5);
    do_step(ways_to_do.at("Blast"), ticks(10.0));
    EXPECT_TRUE(course().is_done());
}

TEST_F(ApprenticeCourse, ADeedThatComesTooLateBeginsTheStepAgain) {
    begin_step("Blast");
    const auto charge = [](Player& p) {
        if (p.take("blast")) p.hold_fire();
        p.look({p.self().yaw, 1.2});
    };
    do_step(charge, ticks(3.0));
    EXPECT_GE(course().share(), 0.5) << "the wand is charged";
    wait(ticks(7.0));
    EXPECT_LT(course().share(), 0.1) << "the blast flew into the sky";
}

TEST_F(ApprenticeCourse, PutsThePlayerToTheStepsPlaceAgainAfterADeath) {
    begin_step("Swing");
    EXPECT_LT(feet_off(), 0.1);
    auto& world = practice_.match().world_to_change();
    world.get<game::Health>(game::wizard_of(world, practising)).points = 0;
    wait(ticks(1.0));
    EXPECT_TRUE(world.has<game::Dead>(game::wizard_of(world, practising)));
    wait(ticks(6.0));
    EXPECT_FALSE(world.has<game::Dead>(game::wizard_of(world, practising)));
    EXPECT_LT(feet_off(), 0.1);
}

TEST_F(ApprenticeCourse, TheNextStepBeginsWithoutTheRopeAndWithoutFire) {
    begin_step("Swing");
    const auto hangs = [&] { return Player{practice_, 0}.self().held.has_value(); };
    for (Tick t = 0; t < ticks(20.0) && !hangs(); ++t) {
        Player player{practice_, t};
        swing_over(player);
        tick(player.sample);
    }
    ASSERT_TRUE(hangs());
    course().skip();
    hold_fire(ticks(2.0));
    EXPECT_EQ(step_name(), "Ingredient");
    EXPECT_FALSE(hangs()) << "fire was held through the change of steps";
    EXPECT_LT(feet_off(), 0.1) << "the rope drags the player away";
}

TEST_F(ApprenticeCourse, TheNextStepStopsAChargeAndWantsANewPressOfFire) {
    begin_step("Blast");
    const auto readiness = [&] { return wand_readiness("blast"); };
    const auto charge = [](Player& p) {
        if (p.take("blast")) p.hold_fire();
    };
    do_step(charge, ticks(2.0));
    EXPECT_GT(readiness(), 0.5);
    course().repeat();
    hold_fire(ticks(2.0));
    EXPECT_EQ(readiness(), 0) << "fire was held through the begin of the step";
    wait(16);
    hold_fire(ticks(2.0));
    EXPECT_GT(readiness(), 0.5) << "fire was pressed anew";
}

TEST_F(ApprenticeCourse, AStepWithAPlaceBeginsWithEmptyHands) {
    begin_step("Ingredient");
    do_step(fetch_ingredient, ticks(20.0));
    ASSERT_TRUE(course().is_done());
    course().repeat();
    wait(ticks(1.0));
    EXPECT_FALSE(course().is_done()) << "the ingredient of the try before is still in the hand";
    do_step(fetch_ingredient, ticks(20.0));
    wait(ticks(1.6));
    ASSERT_EQ(step_name(), "Brew");
    const auto& world = practice_.match().world();
    EXPECT_TRUE(world.has<game::Pouch>(game::wizard_of(world, practising))) << "the brew needs it";
}

TEST_F(ApprenticeCourse, ALadleAtRestDoesNotStir) {
    begin_step("Ingredient");
    do_step(fetch_ingredient, ticks(20.0));
    wait(ticks(1.6));
    ASSERT_EQ(step_name(), "Brew");
    const auto rest = [](Player& p) {
        const auto& world = p.match().world();
        if (!world.has<game::Ladle>(game::wizard_of(world, practising)) && p.self().centre.x > 2.3)
            return p.walk_to({0, 0, 0});
        p.sample.press(Button::stir);
        if (p.tick % 2000 < 100) p.hold_fire();
    };
    do_step(rest, ticks(60.0));
    EXPECT_FALSE(course().is_done()) << "the ladle has not been moved";
    EXPECT_GE(course().share(), 0.5) << "the ingredient must have been dropped";
    EXPECT_LT(course().share(), 0.6) << "a ladle at rest drifts";
    const auto took = do_step(brew, ticks(20.0));
    EXPECT_TRUE(course().is_done());
    std::printf("stirred for %llu ticks\n", static_cast<unsigned long long>(took));
    EXPECT_LT(took, ticks(8.0));
}

TEST_F(ApprenticeCourse, PutsThePlayerToTheStepsPlaceAgainAfterAFall) {
    begin_step("Swing");
    const auto leap = [](Player& p) { p.walk_to({-3, 0, 25}); };
    double least = 100, deepest = 0;
    for (Tick t = 0; t < ticks(4.0); ++t) {
        Player player{practice_, t};
        leap(player);
        tick(player.sample);
        deepest = std::min(deepest, player.self().centre.y);
        least = std::min(least, health());
        if (deepest < -3 && player.self().centre.y > 0) break;
    }
    EXPECT_LT(deepest, -3) << "the player must have fallen";
    EXPECT_LT(least, 80) << "the fall must have hurt";
    EXPECT_LT(feet_off(), 0.1);
    EXPECT_EQ(health(), 100);
    EXPECT_EQ(step_name(), "Swing");
}

TEST_F(ApprenticeCourse, EachStepBeginsWithFullHealth) {
    begin_step("Lob");
    auto& world = practice_.match().world_to_change();
    world.get<game::Health>(wizard()).points = 20;
    course().skip();
    wait(16);
    EXPECT_EQ(health(), 100);
}

TEST_F(ApprenticeCourse, TheDummyOfTheLiftGivesTimeToReadAndDoesNotKill) {
    begin_step("Lift");
    wait(ticks(7.5));
    EXPECT_EQ(health(), 100) << "the dummy shoots while the player reads";
    double least = 100;
    for (int i = 0; i < 60; ++i) {
        wait(ticks(1.0));
        least = std::min(least, health());
    }
    std::printf("least health %g\n", least);
    EXPECT_LT(least, 95) << "the dummy must shoot at last";
    EXPECT_GT(least, 30);
}

TEST_F(ApprenticeCourse, TheAnchorIsInTheFirstPictureOfTheSwing) {
    begin_step("Swing");
    for (Tick t = 0; t < 16; ++t) {
        Player player{practice_, t};
        player.take("swing");
        tick(player.sample);
    }
    const auto me = Player{practice_, 0}.self();
    const auto to_anchor = game::aim_at(me.eye, {-4, 7, 9});
    const double min_half_view = 20 * radians_per_degree;  // half of the least vertical field of view
    EXPECT_LT(std::abs(to_anchor.pitch - me.pitch), min_half_view);
    EXPECT_LT(std::abs(game::angle_between(to_anchor.yaw, me.yaw)), 0.05);
    auto picture = game::make_picture();
    game::take_picture(practice_.match(), picture);
    EXPECT_EQ(picture.wizards[practising].wand.name, "swing");
    EXPECT_EQ(picture.wizards[practising].wand.target.kind, game::TargetKind::nothing)
        << "the picture offers a swing where it does not help";
}

TEST_F(ApprenticeCourse, ItsEndSaysHowFarThePlayerCame) {
    while (step_name() != "Blast") course().skip();
    EXPECT_EQ(practice_.last_words(), "apprentice: left at 3 of 9: Blast");
    while (!course().is_over()) course().skip();
    EXPECT_EQ(practice_.last_words(), "apprentice: 9 of 9: done");
}

TEST_F(ApprenticeCourse, SkipsAndRepeatsAndSaysWhatToDo) {
    const auto picture = [&] {
        auto all = game::make_picture();
        game::take_picture(practice_.match(), all);
        practice_.show(all);
        return all.practice;
    };
    wait(16);
    EXPECT_EQ(picture().score, "1 of 9: Look and move, 0 %");
    do_step(walk_and_look, 500);
    EXPECT_GT(course().share(), 0.1);
    course().repeat();
    wait(16);
    EXPECT_LT(course().share(), 0.05) << "the step begins again";
    EXPECT_EQ(course().at(), 0U);
    course().skip();
    wait(16);
    EXPECT_EQ(picture().lesson, course().lessons().steps[1].words);
    EXPECT_EQ(picture().score, "2 of 9: Bolt, 0 %");
    for (int i = 0; i < 20; ++i) course().skip();
    wait(16);
    EXPECT_EQ(picture().lesson, course().lessons().end);
    course().repeat();
    EXPECT_TRUE(course().is_over());
}

}  // namespace
}  // namespace thaum::game
