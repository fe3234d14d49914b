// Tests of the practice range in a live session: its files, which are read again when they change, the thread
// that watches them, the messages on the screen, and that a recorded match has none of these.
#include "game/range/practice.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "core/clock.h"
#include "core/text.h"
#include "game/components/cauldron.h"
#include "game/components/hand_state.h"
#include "game/hud/layout.h"
#include "game/hud/stroke_words.h"
#include "game/live/shared.h"
#include "unit/copied_assets.h"
#include "unit/overlay_items.h"
#include "unit/wall_player.h"

namespace thaum::game {
namespace {

namespace fs = std::filesystem;

// No recorded match can read changed files: a value of this type holds either a log or a range's files, never
// both, and a session can be started with nothing else (MatchStart).
static_assert(std::is_same_v<Recording, std::variant<std::monostate, input::LogWriter, game::RangeFiles>>);
static_assert(std::is_same_v<decltype(MatchStart::recording), Recording>);

class PracticeTest : public testing::Test {
protected:
    game::RangeFiles files() const { return game::RangeFiles::open(folder_, {}).value(); }
    void set_damage(std::string_view value) {
        std::ofstream(folder_ / "wands" / "bolt.toml")
            << bolt_.substr(0, at_) << value << bolt_.substr(at_ + 1);
    }
    /// Polls the files as the watching thread does. A change is read at the second poll after it.
    static void look(game::RangeFiles& files, Practice& practice) {
        for (int i = 0; i < 2; ++i) {
            if (const auto reload = files.look()) practice.adopt(*reload);
        }
    }
    static Practice practice_of(const game::RangeFiles& files,
                                game::DummyKind dummy = game::DummyKind::still) {
        return {files.data(), {input::DeviceSpec{}}, dummy, 1};
    }
    /// Hash of the bolt wand's values in the match.
    static std::uint64_t bolt_hash(Practice& practice) {
        for (const auto& file : practice.match().data().files) {
            if (file.name == "wands/bolt.toml") return file.hash;
        }
        ADD_FAILURE() << "the match has no bolt";
        return 0;
    }
    static game::Picture picture(Practice& practice) {
        auto picture = game::make_picture();
        game::take_picture(practice.match(), picture);
        practice.show(picture);
        return picture;
    }
    static game::Caption caption(Practice& practice) { return picture(practice).caption; }
    static void play(Practice& practice, double duration) {
        for (Tick t = 0; t < ticks(duration); ++t) {
            input::InputFrame frame;
            frame.devices[game::dummys] = practice.dummy_sample();
            practice.match().tick(frame);
        }
    }

    const CopiedAssets copied_;
    const fs::path folder_ = copied_.path;
    const std::string bolt_ = [] {
        std::ifstream in(THAUM_SOURCE_DIR "/assets/wands/bolt.toml");
        return std::string(std::istreambuf_iterator<char>(in), {});
    }();
    const std::size_t at_ = bolt_.find("damage = 6") + 9;
};

/// Counts how often a thread that sleeps 1 ms at a time wakes up. On a busy machine this count grows more
/// slowly, as the work of other threads does.
class WakeUps {
public:
    ~WakeUps() { stop_ = true; }
    int count() const { return count_; }

private:
    std::atomic<bool> stop_{false};
    std::atomic<int> count_{0};
    std::jthread thread_{[this] {
        for (; !stop_; ++count_) sleep_until_ns(monotonic_ns() + 1'000'000);
    }};
};

TEST_F(PracticeTest, ThreadReadsChangedFilesWithinASecondAndEndsAtOnce) {
    const WakeUps since;
    {
        DataWatcher watcher(files());
        EXPECT_EQ(watcher.take(), nullptr);
        set_damage("12");
        const game::Reload* reload = nullptr;
        const auto hangs = monotonic_ns() + 60'000'000'000;
        while (reload == nullptr && monotonic_ns() < hangs) {
            sleep_until_ns(monotonic_ns() + 1'000'000);
            reload = watcher.take();
        }
        ASSERT_NE(reload, nullptr);
        EXPECT_TRUE(reload->data);
        EXPECT_EQ(reload->line, "read wands/bolt.toml");
    }
    EXPECT_LT(since.count(), 1500) << "400 on a machine that is not loaded";
}

/// Energy of the wand in hand after two seconds of shots.
double energy_after_shots(Practice& practice) {
    for (Tick t = 0; t < ticks(2.0); ++t) {
        input::InputFrame frame;
        frame.devices[game::practising].press(input::Button::fire);
        frame.devices[game::practising].counts[input::hand::trigger] = 255;
        practice.match().tick(frame);
    }
    auto picture = game::make_picture();
    game::take_picture(practice.match(), picture);
    return picture.wizards[game::practising].wand.energy;
}

TEST_F(PracticeTest, EndlessEnergyKeepsWandsFullAlsoAfterAReload) {
    auto watched = files();
    auto practice = practice_of(watched);
    const auto full = picture(practice).wizards[game::practising].wand.energy_cap;
    EXPECT_LT(energy_after_shots(practice), full - 5);
    EXPECT_TRUE(practice.set_changes({.endless_energy = true}));
    EXPECT_FALSE(practice.set_changes({.endless_energy = true})) << "nothing has changed";
    EXPECT_GT(energy_after_shots(practice), full - 1.5) << "the last shot may have just been taken";
    set_damage("7");
    look(watched, practice);
    EXPECT_GT(energy_after_shots(practice), full - 1.5);
    EXPECT_TRUE(practice.set_changes({}));
    EXPECT_LT(energy_after_shots(practice), full - 5);
}

TEST_F(PracticeTest, AHarmlessBrewNeitherSlowsNorLiftsNorScalds) {
    auto watched = files();
    const auto& data = watched.data();
    ASSERT_TRUE(data.match->cauldron);
    EXPECT_EQ(changed(data, {}).match, data.match);
    const auto harmless = *changed(data, {.harmless_brew = true}).match->cauldron;
    EXPECT_GT(harmless.aura.thick_above, 1e9);
    EXPECT_EQ(harmless.aura.light_below, 0);
    EXPECT_EQ(harmless.spoil_harm, 0);
    EXPECT_EQ(harmless.spoil_push, 0);
    EXPECT_EQ(harmless.aura.refill, data.match->cauldron->aura.refill);
}

TEST_F(PracticeTest, ShowsAReloadForAWhileAndAFaultUntilItIsCorrected) {
    auto watched = files();
    auto practice = practice_of(watched);
    EXPECT_NE(caption(practice).words.find("nothing is recorded"), std::string::npos);
    play(practice, 9);
    EXPECT_EQ(caption(practice).words, "");
    look(watched, practice);
    EXPECT_EQ(caption(practice).words, "") << "no file has changed";
    set_damage("9.5");
    look(watched, practice);
    EXPECT_EQ(caption(practice).words, "read wands/bolt.toml");
    EXPECT_FALSE(caption(practice).fault);
    play(practice, 5);
    EXPECT_EQ(caption(practice).words, "");
    set_damage("-9");
    look(watched, practice);
    EXPECT_NE(caption(practice).words.find("wands/bolt.toml:10: 'damage' is -9"), std::string::npos);
    EXPECT_TRUE(caption(practice).fault);
    play(practice, 30);
    EXPECT_TRUE(caption(practice).fault) << "the file is still faulty";
    set_damage("8");
    look(watched, practice);
    EXPECT_EQ(caption(practice).words, "read wands/bolt.toml");
    EXPECT_FALSE(caption(practice).fault);
}

TEST_F(PracticeTest, TheMatchGoesOnWithTheNewNumbersAndAFaultKeepsTheOldOnes) {
    auto watched = files();
    auto practice = practice_of(watched);
    play(practice, 1);
    const auto at_first = bolt_hash(practice);
    set_damage("9.5");
    EXPECT_FALSE(watched.look()) << "the file may still be changing";
    EXPECT_EQ(bolt_hash(practice), at_first);
    look(watched, practice);
    const auto changed = bolt_hash(practice);
    EXPECT_NE(changed, at_first);
    EXPECT_EQ(practice.match().now(), ticks(1.0)) << "the match goes on";
    set_damage("-9");
    look(watched, practice);
    EXPECT_EQ(bolt_hash(practice), changed);
    play(practice, 1);
    EXPECT_EQ(practice.match().now(), ticks(2.0));
    set_damage("6");
    look(watched, practice);
    EXPECT_EQ(bolt_hash(practice), at_first);
}

TEST_F(PracticeTest, AnotherDummyResetsTheScore) {
    auto practice = practice_of(files());
    input::InputFrame firing;
    firing.devices[game::practising].press(input::Button::fire);
    for (int t = 0; t < 1500; ++t) practice.match().tick(firing);
    EXPECT_EQ(practice.score().find("0 of 0"), std::string::npos) << practice.score();
    EXPECT_EQ(practice.last_words(), text("range: ", practice.score()));
    EXPECT_EQ(picture(practice).practice.below.find("still dummy: "), 0U);
    practice.set_dummy(game::DummyKind::strafing);
    EXPECT_EQ(practice.score().find("0 of 0"), 0U);
    EXPECT_EQ(picture(practice).practice.score, "0 of 0 hit, 0 HP, 0 kills") << "short, for one line";
    EXPECT_EQ(picture(practice).practice.below.find("strafing dummy: "), 0U);
}

TEST_F(PracticeTest, ScoreStandsInThePlaceOfAMatchsAndCaptionInTheWindow) {
    auto practice = practice_of(files(), game::DummyKind::shooting);
    auto shown = picture(practice);
    using namespace game::hud_tests;
    auto overlay = overlay_of(shown, {.watch = game::Watch::first});
    EXPECT_TRUE(has_text(overlay, "0 of 0 hit"));
    EXPECT_TRUE(has_text(overlay, "shooting dummy: 100 HP"));
    EXPECT_FALSE(has_text(overlay, "first to"));
    shown.caption.words = std::string(300, 'm');
    for (const double scale : {1.0, 2.5}) {
        overlay = overlay_of(shown, {.watch = game::Watch::first, .text_scale = scale});
        std::size_t letters = 0;
        for (const auto* words : items_of<render::TextItem>(overlay)) {
            if (words->text.find_first_not_of('m') != std::string::npos) continue;
            letters += words->text.size();
            EXPECT_LT(game::width_of(words->text, words->size), 1280) << "a long line is broken";
        }
        for (const auto* panel : items_of<render::RectItem>(overlay)) EXPECT_GE(panel->low.x, 0);
        EXPECT_EQ(letters, 2 * shown.caption.words.size()) << "every word, and its dark copy";
    }
}

// ---- finding the largest force by feel --------------------------------------------------------------------

class ForceTrialTest : public PracticeTest {
protected:
    /// Plays one tick of the trial that finds the largest force. Returns its result when it has ended.
    std::optional<std::uint32_t> tick(bool fire) {
        input::InputFrame frame;
        if (fire) frame.devices[0].press(input::Button::fire);
        practice_.hold_fire_back(frame);
        const auto found = practice_.try_force(frame);
        EXPECT_FALSE(runs_ && frame.devices[0].down(input::Button::fire)) << "nothing is shot meanwhile";
        practice_.match().tick(frame);
        const auto& hand = practice_.match().world().get<game::HandState>(
            game::wizard_of(practice_.match().world(), game::practising));
        strongest_ = std::max(strongest_, glm::length(hand.servo.safety.output));
        runs_ = runs_ && !found;
        return found;
    }

    game::RangeFiles files_ = files();
    Practice practice_{
        files_.data(), {input::DeviceSpec{.name = "hand", .moves_faders = true}}, game::DummyKind::still, 1};
    bool runs_ = true;
    double strongest_ = 0;
};

TEST_F(ForceTrialTest, KicksGrowUntilFireIsPressed) {
    const double peak = practice_.match().data().device.peak_force;
    practice_.find_force();
    double before = 0;
    for (std::uint32_t kick = 1; kick <= 8; ++kick) {
        strongest_ = 0;
        for (int i = 0; i < 500; ++i)
            ASSERT_FALSE(tick(kick == 1 && i < 100)) << "a press from before counts not";
        if (kick > 1) {
            EXPECT_NEAR(strongest_, 0.05 * (kick - 1) * peak, 0.03 * peak) << kick;
            EXPECT_GT(strongest_, before);
        }
        before = strongest_;
    }
    for (Tick i = 0; i < 2 * ForceTrial::kick_length; ++i) tick(false);
    EXPECT_EQ(tick(true), 8 * ForceTrial::percent_per_kick);
    strongest_ = 0;
    for (int i = 0; i < 1000; ++i) EXPECT_FALSE(tick(i < 200)) << "fire is still down for a while";
    EXPECT_LT(strongest_, 0.1 * peak) << "no more kicks";
}

TEST_F(ForceTrialTest, WhoNeverPressesChangesNothingAndTheMotorsStayCool) {
    practice_.find_force();
    double squares = 0;
    int ticks = 0;
    for (; practice_.finds_force() && ticks < 30'000; ++ticks) {
        EXPECT_FALSE(tick(false));
        const auto& hand = practice_.match().world().get<game::HandState>(
            game::wizard_of(practice_.match().world(), game::practising));
        squares += glm::dot(hand.servo.safety.output, hand.servo.safety.output);
    }
    const double peak = practice_.match().data().device.peak_force;
    EXPECT_NEAR(strongest_, peak, 0.03 * peak) << "the last kick is whole";
    EXPECT_LT(std::sqrt(squares / ticks), practice_.match().data().device.continuous_force);
}

TEST_F(ForceTrialTest, EachFaderOfTheForcesCanBeFelt) {
    runs_ = false;
    const auto felt = [&](input::HandFader fader) {
        strongest_ = 0;
        practice_.play_force(fader);
        for (int i = 0; i < 2500; ++i) tick(false);
        return strongest_;
    };
    const auto& hand = practice_.match().world().get<game::HandState>(
        game::wizard_of(practice_.match().world(), game::practising));
    const double share = practice_.match().haptic_setup().servos[0].limits.cap / 3.3;
    EXPECT_NEAR(felt(input::HandFader::recoil), 1.2 * share, 0.05);
    EXPECT_NEAR(felt(input::HandFader::blows), 2 * share, 0.05);
    EXPECT_NEAR(felt(input::HandFader::weight), 0.3 * share, 0.03);
    EXPECT_EQ(hand.steady_force.force, vec3(0)) << "the weight goes again";
    EXPECT_LT(felt(input::HandFader::roughness), 0.01) << "it needs something to touch";
}

TEST_F(ForceTrialTest, NothingHappensUnlessItWasAskedFor) {
    runs_ = false;
    for (int i = 0; i < 2000; ++i) EXPECT_FALSE(tick(i % 300 == 0));
}

/// A practice range in which a player draws on the gesture wall. Some ticks have passed since its start.
class WallTest : public PracticeTest {
protected:
    WallTest() { player_.play(20); }

    game::RangeFiles range_ = files();
    Practice practice_ = practice_of(range_);
    WallPlayer player_{practice_};
};

TEST_F(WallTest, TheWallShowsAStrokeItsScoreAndWhatToDoBetter) {
    EXPECT_FALSE(picture(practice_).practice.wall.on) << "before the first stroke";
    player_.play(750, input::bit(input::Button::trace), circle_on_wall);
    auto wall = picture(practice_).practice.wall;
    EXPECT_TRUE(wall.on && wall.drawing);
    EXPECT_GT(wall.stroke.size(), 40U);
    player_.play(50);
    wall = picture(practice_).practice.wall;
    ASSERT_TRUE(wall.on && !wall.drawing);
    ASSERT_EQ(wall.gestures->size(), 4U);
    ASSERT_EQ((*wall.gestures)[0].name, "Circle");
    // The stroke is half a circle, which the wall must not take for Shield, the spell of the circle.
    EXPECT_EQ(wall.lines[0].find("Shield"), std::string::npos);
    ASSERT_GT(wall.lines.size(), 1U) << "what to do better";
    EXPECT_EQ(wall.chosen, 0) << wall.lines[0];
    EXPECT_EQ(wall.lines[0], "not read: it may be a part of Circle");
    EXPECT_EQ(wall.lines[1], "end where you began");
    player_.draw(1500, circle_on_wall);
    wall = picture(practice_).practice.wall;
    EXPECT_EQ(wall.chosen, 0);
    EXPECT_GT(wall.scores[0], 60);
    EXPECT_EQ(wall.lines[0].find("Shield, "), 0U) << wall.lines[0];
    EXPECT_NE(wall.lines[0].find("gentle"), std::string::npos);
    ASSERT_EQ(wall.lines.size(), 2U);
    EXPECT_EQ(wall.lines[1], "well drawn");
    player_.play(200, input::bit(input::Button::trace), circle_on_wall);
    wall = picture(practice_).practice.wall;
    EXPECT_EQ(wall.chosen, -1) << "a stroke that is being drawn belongs to no gesture yet";
    EXPECT_TRUE(wall.lines.empty()) << "what was said of the stroke before";
    EXPECT_GT(wall.scores[0], 60) << "the last score of the gesture";
    player_.play(50);
    player_.play(8100);
    EXPECT_FALSE(picture(practice_).practice.wall.on) << "some seconds after the stroke";
}

TEST_F(WallTest, TheWallSaysWhyAStrokeWasNotEvenRead) {
    player_.draw(60, triangle_on_wall);
    auto wall = picture(practice_).practice.wall;
    ASSERT_FALSE(wall.lines.empty());
    EXPECT_EQ(wall.lines[0].find("too fast"), 0U) << wall.lines[0];
    player_.draw(600, [](int t) { return t % 100 == 0 ? vec2(5, 0) : vec2(0); });
    wall = picture(practice_).practice.wall;
    ASSERT_FALSE(wall.lines.empty());
    EXPECT_EQ(wall.lines[0].find("too small"), 0U) << wall.lines[0];
}

TEST_F(WallTest, TheWallAndTheCaptionShowTheSameScore) {
    player_.draw(1500, circle_on_wall);
    const auto shown = picture(practice_);
    const auto words = game::stroke_caption(shown.wizards[game::practising].casting, *shown.shown).words;
    const auto score = text(shown.practice.wall.scores[0], " %");
    EXPECT_NE(words.find(score), std::string::npos) << words << " and " << score;
}

TEST_F(WallTest, ThreeStrokesOnTheWallAreAnOwnGesture) {
    practice_.wall().record("circle");
    EXPECT_EQ(picture(practice_).practice.wall.lines[0], "Your own Circle: draw stroke 1 of 3");
    for (int stroke = 0; stroke < 2; ++stroke) player_.draw(800, triangle_on_wall);
    player_.draw(60, triangle_on_wall);  // a stroke that is too short to count
    const auto lines = picture(practice_).practice.wall.lines;
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0].find("not counted, too fast: "), 0U) << lines[0];
    EXPECT_EQ(lines[1], "Your own Circle: draw stroke 3 of 3");
    EXPECT_NE(lines[3].find("give up"), std::string::npos);
    EXPECT_FALSE(practice_.wall().take_recorded());
    player_.draw(800, triangle_on_wall);
    const auto own = practice_.wall().take_recorded();
    ASSERT_TRUE(own);
    EXPECT_TRUE(practice_.wall().records()) << "until it is known what became of it";
    EXPECT_EQ(own->name, "circle");
    ASSERT_EQ(own->strokes.size(), 3U);
    EXPECT_NEAR(own->strokes[0].back().t, 0.8, 0.02);
    EXPECT_EQ(own->options.harsh_above, range_.data().match->gestures->gestures()[0].options.harsh_above);

    practice_.use_gestures({{game::profile_of(*own, game::practising)}, {"saved"}, Verdict::kept});
    EXPECT_FALSE(practice_.wall().records());
    EXPECT_EQ(picture(practice_).practice.wall.lines[0], "saved");
    player_.draw(800, triangle_on_wall);
    auto wall = picture(practice_).practice.wall;
    EXPECT_TRUE((*wall.gestures)[0].own);
    EXPECT_EQ(wall.lines[0].find("Shield, "), 0U) << wall.lines[0];
    practice_.use_gestures({{}, {}});
    player_.draw(800, triangle_on_wall);
    wall = picture(practice_).practice.wall;
    EXPECT_FALSE((*wall.gestures)[0].own);
    EXPECT_NE(wall.lines[0].find("Shield, "), 0U);
}

TEST_F(WallTest, WhileTheWallRecordsStrokesCastNothing) {
    const auto count = [&](game::EventKind kind) {
        const auto& events = practice_.match().events();
        int found = 0;
        for (auto i = events.first(); i < events.count(); ++i) found += events[i].kind == kind ? 1 : 0;
        return found;
    };
    const auto& world = practice_.match().world();
    practice_.wall().record("v");
    for (int stroke = 0; stroke < 3; ++stroke) player_.draw(1500, circle_on_wall);
    ASSERT_TRUE(practice_.wall().take_recorded());
    practice_.use_gestures({{}, {"too like another"}, Verdict::refused});
    player_.draw(1500, circle_on_wall);
    practice_.wall().give_up(practice_.match());
    EXPECT_EQ(count(game::EventKind::cast) + count(game::EventKind::unread), 0);
    EXPECT_EQ(world.get<game::Focus>(game::wizard_of(world, game::practising)).points, 100);
    player_.draw(1500, circle_on_wall);
    EXPECT_EQ(count(game::EventKind::cast), 1) << "the next stroke is a spell again";
}

TEST_F(WallTest, WhileTheWallRecordsAChangeOfTheFilesChangesNothingOfThat) {
    practice_.wall().record("v");
    player_.play(20);
    set_damage("7");
    look(range_, practice_);
    player_.draw(1500, circle_on_wall);
    const auto& world = practice_.match().world();
    EXPECT_EQ(world.get<game::Focus>(game::wizard_of(world, game::practising)).points, 100);
}

TEST_F(PracticeTest, TheWallHasTheBandsOfForceByWhichTheMatchCasts) {
    auto range = game::RangeFiles::open(
        folder_, {.overrides = {"casting.force.gentle_below_n=0.1", "casting.force.harsh_from_n=0.2"}});
    ASSERT_TRUE(range) << range.error().message;
    auto practice = practice_of(*range);
    WallPlayer player{practice};
    player.play(20);
    player.draw(1500, circle_on_wall);
    const auto wall = picture(practice).practice.wall;
    EXPECT_NE(wall.lines[0].find("harsh"), std::string::npos) << wall.lines[0];
    practice.wall().record("circle");
    for (int stroke = 0; stroke < 3; ++stroke) player.draw(800, triangle_on_wall);
    const auto own = practice.wall().take_recorded();
    ASSERT_TRUE(own);
    EXPECT_EQ(own->options.gentle_below, 0.1);
    EXPECT_EQ(own->options.harsh_above, 0.2);
}

TEST_F(PracticeTest, WithoutSpellsThereIsNoWall) {
    auto files = game::RangeFiles::open(folder_, {.rules = "classic"}).value();
    auto practice = practice_of(files);
    WallPlayer player{practice};
    player.draw(1500, circle_on_wall);
    EXPECT_FALSE(picture(practice).practice.wall.on);
}

TEST_F(PracticeTest, TheCauldronIsFree) {
    const auto range = files();
    auto practice = practice_of(range);
    const auto& rules = *practice.match().data().cauldron;
    EXPECT_EQ(rules.niche_again, 0U);
    EXPECT_GT(rules.spoils_after, ticks(1e6));
    auto& cauldron = practice.match().world_to_change().single<game::Cauldron>();
    cauldron.begun = 1;
    play(practice, 0.1);
    EXPECT_EQ(picture(practice).cauldron.spoils_in_s, 0) << "no words of spoiling";
}

}  // namespace
}  // namespace thaum::game
