// Tests of the practice range: what dummies do, that no round ends there, and data files that are read again
// during practice.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/file.h"
#include "core/text.h"
#include "game/range/range_files.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

namespace fs = std::filesystem;
namespace hand = input::hand;

RangeData range_data(std::vector<std::string> overrides = {}) {
    return load_range(assets(), {.overrides = std::move(overrides)}).value();
}

RangeMatch range_with(DummyKind kind, std::vector<std::string> overrides = {}) {
    return make_range(range_data(std::move(overrides)), bot_device(practising, "level_1"), kind, 3);
}

const input::DeviceSample idle{};

input::DeviceSample firing() {
    input::DeviceSample sample;
    sample.press(input::Button::fire);
    return sample;
}

void run(RangeMatch& range, double duration, const input::DeviceSample& sample = idle) {
    for (Tick t = 0; t < ticks(duration); ++t) range.tick(sample);
}

template <class C>
const C& of(const RangeMatch& range, std::uint32_t player) {
    const auto& world = range.match->world();
    return world.get<C>(wizard_of(world, player));
}

template <class C>
C& change(RangeMatch& range, std::uint32_t player) {
    auto& world = range.match->world_to_change();
    return world.get<C>(wizard_of(world, player));
}

vec3 place(const RangeMatch& range, std::uint32_t player) { return of<Motion>(range, player).position; }

MatchStats bolts(const RangeMatch& range, std::uint32_t player) {
    return range.match->world().single<EventLog>().match_stats[player][cause_of(hit_kind("bolt_hit"))];
}

// ---- dummies of the practice range ------------------------------------------------------------------------

TEST(Range, BothBeginFaceToFaceWithNothingBetween) {
    auto range = range_with(DummyKind::still);
    run(range, 0.5, firing());
    run(range, 1);
    EXPECT_EQ(bolts(range, practising).hits, bolts(range, practising).shots);
    EXPECT_GE(bolts(range, practising).hits, 4U);
}

TEST(Range, AStillDummyStaysAndDoesNothing) {
    auto range = range_with(DummyKind::still);
    const auto before = place(range, dummys);
    run(range, 10);
    EXPECT_LT(glm::distance(before, place(range, dummys)), 0.02);
    EXPECT_EQ(bolts(range, dummys).shots, 0U);
    EXPECT_EQ(of<Health>(range, practising).points, 100);
}

/// Largest distances of a dummy that walks to and fro from its first place, to the west (negative), to the
/// east and along z (m), and the number of its turns.
struct Strafed {
    double west = 0, east = 0, along = 0;
    int turns = 0;
};

Strafed watch_strafing(RangeMatch& range, double duration) {
    const auto home = place(range, dummys);
    Strafed seen;
    double way = 0;
    for (Tick t = 0; t < ticks(duration); ++t) {
        range.tick(idle);
        const auto off = place(range, dummys) - home;
        seen.west = std::min(seen.west, off.x);
        seen.east = std::max(seen.east, off.x);
        seen.along = std::max(seen.along, std::abs(off.z));
        const double speed = of<Motion>(range, dummys).velocity.x;
        if (std::abs(speed) < 1) continue;
        if (speed * way < 0) ++seen.turns;
        way = speed;
    }
    return seen;
}

TEST(Range, AStrafingDummyWalksToAndFroWithinItsBounds) {
    auto range = range_with(DummyKind::strafing);
    const auto seen = watch_strafing(range, 12);
    const double stride = range_data().dummy.stride;
    EXPECT_NEAR(seen.east, stride, 0.4);
    EXPECT_NEAR(seen.west, -stride, 0.4);
    EXPECT_LT(seen.along, 0.1);
    // At 4.5 m/s the dummy needs a little more than 2 stride / 4.5 s between turns.
    EXPECT_GE(seen.turns, 7);
    EXPECT_LE(seen.turns, 11);
    EXPECT_EQ(bolts(range, dummys).shots, 0U);
}

TEST(Range, AStrafingDummyTurnsBackAtAPitAndAtAWall) {
    auto data = range_data();
    data.dummy.stride = 30;
    auto match = *data.match;
    match.arena.pads[dummys].feet = {-12, 0, -9};
    data.match = std::make_shared<const MatchData>(match);
    auto range = make_range(data, bot_device(practising, "level_1"), DummyKind::strafing, 3);
    const auto seen = watch_strafing(range, 20);
    EXPECT_GE(seen.turns, 5);
    EXPECT_NEAR(-12 + seen.west, -19.6, 1.2) << "the wall is on this side";
    EXPECT_NEAR(-12 + seen.east, -9, 1) << "the pit begins 1 m farther";
    EXPECT_GT(place(range, dummys).y, 0.5) << "the dummy fell";
    EXPECT_EQ(of<Health>(range, dummys).points, 100);
}

TEST(Range, AStrafingDummyKeepsItsBoundsWhenDataIsReadOnTheWay) {
    auto range = range_with(DummyKind::strafing);
    const auto home = place(range, dummys);
    const double stride = range_data().dummy.stride;
    for (int i = 0; i < 12; ++i) {
        run(range, 0.4 + 0.05 * i);
        range.adopt(range_data());
        EXPECT_LT(glm::distance(home, place(range, dummys)), stride + 0.4);
    }
    run(range, 1);
    const auto again = watch_strafing(range, 5);
    EXPECT_NEAR(again.east - again.west, 2 * stride, 0.8);
}

TEST(Range, AShootingDummyStandsAndHitsSometimes) {
    auto range = range_with(DummyKind::shooting, {"bolt.shot.damage=0.01"});
    const auto before = place(range, dummys);
    run(range, 20);
    const auto shot = bolts(range, dummys);
    EXPECT_LT(glm::distance(before, place(range, dummys)), 0.1);
    EXPECT_GT(shot.shots, 25U);
    EXPECT_GT(shot.hits, shot.shots / 5);
    EXPECT_LT(shot.hits, shot.shots);
}

TEST(Range, AShootingDummyDoesNotSeeBehindItsBack) {
    auto range = range_with(DummyKind::shooting);
    change<Gaze>(range, dummys).yaw = 0;
    run(range, 5);
    EXPECT_EQ(bolts(range, dummys).shots, 0U);
}

TEST(Range, ADummyCanBecomeAnotherOne) {
    auto range = range_with(DummyKind::still);
    run(range, 1);
    range.dummy.become(DummyKind::shooting);
    run(range, 5);
    EXPECT_GT(bolts(range, dummys).shots, 0U);
    range.dummy.become(DummyKind::strafing);
    const auto seen = watch_strafing(range, 4);
    EXPECT_GT(seen.turns, 0);
}

TEST(Range, TheSameInputComesToTheSameState) {
    for (const auto kind : {DummyKind::still, DummyKind::strafing, DummyKind::shooting}) {
        auto first = range_with(kind), second = range_with(kind);
        run(first, 5, firing());
        run(second, 5, firing());
        EXPECT_EQ(first.match->state_hash(), second.match->state_hash());
    }
}

// ---- rounds never end on the practice range ---------------------------------------------------------------

TEST(Range, NoRoundEndsByKillsOrTime) {
    auto range =
        range_with(DummyKind::still, {"quick.seconds=5", "quick.respawn_s=0.5", "bolt.shot.damage=50",
                                      "bolt.energy.regain_per_s=100", "bolt.shot.spread_deg=0"});
    run(range, 40, firing());
    EXPECT_GT(of<Score>(range, practising).kills, 5) << "a quick match ends after three";
    EXPECT_EQ(range.match->match().phase, Phase::playing);
    EXPECT_EQ(of<Health>(range, practising).points, 100);
}

TEST(Range, AKilledPlayerReturnsAndGoesOn) {
    auto range = range_with(DummyKind::shooting, {"bolt.shot.damage=60", "bolt.energy.regain_per_s=100"});
    run(range, 60);
    EXPECT_GT(of<Score>(range, practising).deaths, 3);
    EXPECT_EQ(range.match->match().phase, Phase::playing);
}

TEST(Range, ADeadDummyComesBackInFrontOfThePlayer) {
    auto range = range_with(DummyKind::strafing);
    const auto home = place(range, dummys);
    change<Health>(range, dummys).points = 0;
    run(range, 1);
    EXPECT_TRUE(range.match->world().has<Dead>(wizard_of(range.match->world(), dummys)));
    const auto seen = watch_strafing(range, 3);
    EXPECT_FALSE(range.match->world().has<Dead>(wizard_of(range.match->world(), dummys)));
    EXPECT_LT(glm::distance(home, place(range, dummys)), range_data().dummy.stride + 0.5);
    EXPECT_GT(seen.east - seen.west, 1) << "the dummy does not strafe again";
}

TEST(Range, TheWandFollowsItsRules) {
    auto range = range_with(DummyKind::still, {"bolt.energy.regain_per_s=0", "bolt.shot.damage=0"});
    run(range, 20, firing());
    EXPECT_EQ(bolts(range, practising).shots, 40U);
    EXPECT_LT(of<WandBelt>(range, practising).energy[0], 1.5);
}

TEST(Range, TheScoreCountsFromTheFirstShotAfterAReset) {
    auto range = range_with(DummyKind::still);
    RangeScorer scorer;
    EXPECT_EQ(words_of(scorer.score(*range.match)), "0 of 0 hit, 0 HP, 0 kills, 0 HP a minute");
    run(range, 5);
    EXPECT_EQ(scorer.score(*range.match).minutes, 0) << "no shot was fired yet";
    for (int i = 0; i < 1000; ++i) {
        range.tick(firing());
        scorer.score(*range.match);
    }
    run(range, 1);
    const auto score = scorer.score(*range.match);
    EXPECT_EQ(score.shots, 8U);
    EXPECT_EQ(score.damage, 6 * score.hits);
    EXPECT_NEAR(score.minutes, 2.0 / 60, 0.01);
    EXPECT_NEAR(score.damage_per_minute(), score.damage * 30, 0.3 * score.damage * 30);
    scorer.reset(*range.match);
    EXPECT_EQ(scorer.score(*range.match).shots, 0U);
    EXPECT_EQ(words_of({.shots = 64, .hits = 12, .kills = 1, .damage = 72, .minutes = 0.5}),
              "12 of 64 hit (18 %), 72 HP, 1 kill, 144 HP a minute");
}

// ---- continuing a match with other data -------------------------------------------------------------------

TEST(CarryOver, BySameDataTheStateIsTheSame) {
    auto range = range_with(DummyKind::strafing);
    run(range, 3.217, firing());
    const auto next = range.match->continued_with(range_data().match);
    EXPECT_EQ(next->state_hash(), range.match->state_hash());
    EXPECT_EQ(next->now(), range.match->now());
}

TEST(CarryOver, FromAKeyframeItGoesOnToTheSameBits) {
    auto range = range_with(DummyKind::still);
    for (Tick t = 0; t < 2 * keyframe_interval; ++t) range.tick(firing());
    const auto next = range.match->continued_with(range_data().match);
    input::InputFrame frame;
    frame.devices[practising] = firing();
    for (int t = 0; t < 3000; ++t) {
        next->tick(frame);
        range.match->tick(frame);
    }
    EXPECT_EQ(next->state_hash(), range.match->state_hash());
}

TEST(CarryOver, AnotherBodySizeKeepsTheFeetInPlace) {
    auto range = range_with(DummyKind::still);
    run(range, 1);
    change<Gaze>(range, practising) = {0.3, -0.2};
    const double feet = place(range, practising).y - 0.9;
    range.adopt(range_data({"wizard.body.height_m=2.4", "wizard.body.eye_m=2.2", "wizard.walk.speed_m_s=9"}));
    EXPECT_NEAR(place(range, practising).y, feet + 1.2, 1e-9);
    EXPECT_NEAR(of<Body>(range, practising).size.y, 1.2 - of<Body>(range, practising).size.x, 1e-9);
    EXPECT_EQ(of<Gaze>(range, practising).yaw, 0.3);
    run(range, 0.5);
    EXPECT_NEAR(place(range, practising).y, feet + 1.2, 0.02);
    input::DeviceSample walking;
    walking.counts[hand::forward] = 127;
    run(range, 0.5, walking);
    EXPECT_NEAR(glm::length(of<Motion>(range, practising).velocity), 9, 0.5);
}

TEST(CarryOver, EnergyFollowsItsWandToAnotherSlot) {
    auto range = range_with(DummyKind::still);
    change<WandBelt>(range, practising).energy[0] = 17;
    range.adopt(range_data({"bolt.slot=3", "lob.slot=1"}));
    EXPECT_EQ(of<WandBelt>(range, practising).energy[2], 17);
    EXPECT_EQ(of<WandBelt>(range, practising).selected, 2U);
    range.adopt(range_data({"bolt.slot=3", "lob.slot=1", "bolt.energy.cap=10"}));
    EXPECT_EQ(of<WandBelt>(range, practising).energy[2], 10);
}

TEST(CarryOver, AnotherArenaIsBuiltAroundThePlayers) {
    auto range = range_with(DummyKind::still);
    run(range, 2, firing());
    change<Gaze>(range, practising).yaw = 0.25;
    const auto stood = place(range, practising);
    const auto shots = bolts(range, practising).shots;
    auto data = range_data();
    auto match = *data.match;
    match.arena.things.erase(std::remove_if(match.arena.things.begin(), match.arena.things.end(),
                                            [](const Thing& t) { return t.prop; }),
                             match.arena.things.end());
    data.match = std::make_shared<const MatchData>(match);
    ASSERT_GT(range.match->world().count<Prop>(), 0U);
    range.adopt(data);
    EXPECT_EQ(range.match->world().count<Prop>(), 0U);
    EXPECT_EQ(glm::distance(place(range, practising), stood), 0);
    EXPECT_EQ(of<Gaze>(range, practising).yaw, 0.25);
    EXPECT_EQ(bolts(range, practising).shots, shots);
    run(range, 2);
    EXPECT_LT(glm::distance(place(range, practising), stood), 0.05);
}

TEST(CarryOver, TheDeadStayDeadAndComeBack) {
    for (const bool another_arena : {false, true}) {
        auto range = range_with(DummyKind::still);
        change<Health>(range, dummys).points = 0;
        run(range, 1);
        auto data = range_data({"wizard.body.height_m=1.6", "wizard.body.eye_m=1.5"});
        if (another_arena) {
            auto match = *data.match;
            match.arena.anchors.clear();
            data.match = std::make_shared<const MatchData>(match);
        }
        range.adopt(data);
        run(range, 1);
        EXPECT_TRUE(range.match->world().has<Dead>(wizard_of(range.match->world(), dummys)));
        run(range, 2);
        EXPECT_FALSE(range.match->world().has<Dead>(wizard_of(range.match->world(), dummys)));
        EXPECT_NEAR(place(range, dummys).y, 0.8, 0.02);
    }
}

// ---- data files that change during practice ---------------------------------------------------------------

/// A practice range with its own copy of the data files.
class RangeFilesTest : public testing::Test {
protected:
    RangeFilesTest() {
        for (const auto* part : {"arenas", "rules", "wands", "wizards", "bots", "devices", "gestures",
                                 "potions", "spells", "carving"})
            fs::copy(assets() / part, folder_ / part, fs::copy_options::recursive);
        for (const auto* file : {"range.toml", "haptics.toml", "cauldron.toml", "casting.toml",
                                 "crystal.toml", "events.toml", "materials.toml", "orb.toml"})
            fs::copy(assets() / file, folder_);
        files_.emplace(RangeFiles::open(folder_, {}).value());
        range_.emplace(make_range(files_->data(), bot_device(practising, "level_1"), DummyKind::still, 3));
    }
    std::string text_of(const std::string& file) const {
        return read_text_file(folder_ / file, 1U << 20U).value();
    }
    void write(const std::string& file, const std::string& words) const {
        std::ofstream(folder_ / file) << words;
    }
    void replace(const std::string& file, const std::string& from, const std::string& to) const {
        auto words = text_of(file);
        const auto at = words.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        write(file, words.replace(at, from.size(), to));
    }
    /// Plays half a second and polls twice for changed files. Returns the messages about reloads; empty: no
    /// file was read.
    std::string half_a_second() {
        std::string lines;
        for (int look = 0; look < 2; ++look) {
            if (const auto reload = files_->look()) {
                if (reload->data) range_->adopt(*reload->data);
                lines += reload->line;
            }
            run(*range_, 0.25);
        }
        return lines;
    }
    /// Health that one bolt takes from the dummy (HP).
    double damage() {
        run(*range_, 1);
        const double before = of<Health>(*range_, dummys).points;
        run(*range_, 0.008, firing());
        run(*range_, 1);
        return before - of<Health>(*range_, dummys).points;
    }

    const TemporaryFolder own_;
    const fs::path folder_ = own_.path();
    std::optional<RangeFiles> files_;
    std::optional<RangeMatch> range_;
};

TEST_F(RangeFilesTest, AChangedNumberTakesEffectWhileItRuns) {
    EXPECT_EQ(half_a_second(), "");
    EXPECT_EQ(damage(), 6);
    replace("wands/bolt.toml", "damage = 6", "damage = 12");
    EXPECT_EQ(half_a_second(), "read wands/bolt.toml");
    EXPECT_EQ(damage(), 12);
    EXPECT_EQ(half_a_second(), "");
}

TEST_F(RangeFilesTest, ABadFileKeepsTheOldNumbersAndSaysSoInOneLine) {
    replace("wands/bolt.toml", "damage = 6", "damage = -6");
    const auto line = half_a_second();
    EXPECT_NE(line.find("wands/bolt.toml:10: 'damage' is -6"), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(half_a_second(), "") << "the fault is reported once";
    EXPECT_EQ(damage(), 6);
    replace("wizards/wizard.toml", "start = 100", "start = 110");
    EXPECT_NE(half_a_second().find("wands/bolt.toml:10"), std::string::npos) << "the file is still faulty";
    replace("wands/bolt.toml", "damage = -6", "damage = 7");
    EXPECT_EQ(half_a_second(), "read wands/bolt.toml, wizards/wizard.toml");
    EXPECT_EQ(damage(), 7);
    EXPECT_EQ(range_->match->data().wizard.health, 110);
}

TEST_F(RangeFilesTest, AFileThatIsStillBeingWrittenIsLeftAlone) {
    auto whole = text_of("wands/bolt.toml");
    whole.replace(whole.find("damage = 6"), 10, "damage = 9");
    for (std::size_t part = 50; part < whole.size(); part += 50) {
        write("wands/bolt.toml", whole.substr(0, part));
        EXPECT_FALSE(files_->look().has_value());
    }
    write("wands/bolt.toml", whole);
    EXPECT_EQ(half_a_second(), "read wands/bolt.toml");
    EXPECT_EQ(damage(), 9);
}

TEST_F(RangeFilesTest, AFileLeftHalfWrittenIsAnErrorUntilItIsWhole) {
    const auto whole = text_of("wands/bolt.toml");
    write("wands/bolt.toml", whole.substr(0, whole.find("damage") + 4));
    EXPECT_NE(half_a_second().find("wands/bolt.toml"), std::string::npos);
    EXPECT_EQ(damage(), 6);
    write("wands/bolt.toml", whole);
    EXPECT_EQ(half_a_second(), "read wands/bolt.toml");
}

TEST_F(RangeFilesTest, AFileThatIsGoneOrNoFileKeepsTheOldNumbers) {
    const auto whole = text_of("wands/bolt.toml");
    fs::remove(folder_ / "wands/bolt.toml");
    EXPECT_NE(half_a_second().find("No such file"), std::string::npos);
    fs::create_directory(folder_ / "wands/bolt.toml");
    EXPECT_NE(half_a_second().find("not an ordinary file"), std::string::npos);
    EXPECT_EQ(damage(), 6);
    fs::remove(folder_ / "wands/bolt.toml");
    write("wands/bolt.toml", whole);
    EXPECT_EQ(half_a_second(), "read wands/bolt.toml");
}

TEST_F(RangeFilesTest, SeveralChangesAtOnceAreOneReading) {
    replace("wands/bolt.toml", "damage = 6", "damage = 8");
    replace("wands/bolt.toml", "damage = 8", "damage = 9");
    replace("wizards/wizard.toml", "start = 100", "start = 120");
    replace("rules/quick.toml", "respawn_s = 3.0", "respawn_s = 0.5");
    replace("range.toml", "stride_m = 2.2", "stride_m = 1");
    EXPECT_EQ(half_a_second(), "read rules/quick.toml, wizards/wizard.toml, wands/bolt.toml, range.toml");
    EXPECT_EQ(damage(), 9);
    EXPECT_EQ(range_->match->data().wizard.health, 120);
    EXPECT_EQ(range_->match->data().round.respawn, ticks(0.5));
    range_->dummy.become(DummyKind::strafing);
    EXPECT_NEAR(watch_strafing(*range_, 5).east, 1, 0.4);
}

TEST_F(RangeFilesTest, ThePlayerKeepsPositionAndAim) {
    input::DeviceSample walking;
    walking.counts[hand::forward] = 127;
    run(*range_, 0.7, walking);
    change<Gaze>(*range_, practising) = {0.2, 0.1};
    run(*range_, 1);
    const auto stood = place(*range_, practising);
    for (const auto* file : {"wands/bolt.toml", "wizards/wizard.toml", "rules/thaum.toml", "range.toml",
                             "arenas/boiling_court.toml"}) {
        write(file, text_of(file) + "\n# a word more\n");
        EXPECT_EQ(half_a_second(), text("read ", file));
        EXPECT_LT(glm::distance(place(*range_, practising), stood), 1e-3) << file;
        EXPECT_EQ(of<Gaze>(*range_, practising).yaw, 0.2);
        EXPECT_EQ(of<Gaze>(*range_, practising).pitch, 0.1);
    }
    replace("arenas/boiling_court.toml", "mass = 40", "mass = 41");
    EXPECT_EQ(half_a_second(), "read arenas/boiling_court.toml");
    EXPECT_LT(glm::distance(place(*range_, practising), stood), 1e-3);
    EXPECT_EQ(of<Gaze>(*range_, practising).yaw, 0.2);
}

TEST_F(RangeFilesTest, EveryNumberOfTheRangeIsChecked) {
    const std::string range = "range.toml", arena = "arenas/boiling_court.toml";
    for (const auto& [file, from, to, said] :
         {std::array<std::string, 4>{range, "stride_m = 2.2", "stride_m = -1", "range.toml:6: 'stride_m'"},
          {range, "burst_s = 0.4", "burst_m = 0.4", "did you mean 'burst_s'?"},
          {arena, "yaw_deg = 0", "yaw_deg = 900", "'yaw_deg' is 900"}}) {
        const auto whole = text_of(file);
        replace(file, from, to);
        const auto message = message_of(load_range(folder_, {}));
        EXPECT_NE(message.find(said), std::string::npos) << message;
        write(file, whole);
    }
}

TEST_F(RangeFilesTest, EveryArenaHasItsPlaces) {
    for (const std::string arena : {"boiling_court", "the_well"}) {
        const auto data = load_range(folder_, {.arena = arena}).value();
        const auto range = make_range(data, bot_device(practising, "level_1"), DummyKind::still, 3);
        const auto& places = data.match->arena.practice;
        for (std::uint32_t player = 0; player < players; ++player)
            EXPECT_LT(glm::distance(place(range, player), places[player].feet + vec3(0, 0.9, 0)), 1e-9);
        const vec3 way = places[dummys].feet - places[practising].feet;
        EXPECT_NEAR(places[practising].yaw, det::atan2(-way.x, -way.z), 1e-9) << "the player faces the dummy";
    }
}

}  // namespace
}  // namespace thaum::game::test
