// Tests matches with random input: the state must stay finite and within bounds. Also tests logs that this
// program must refuse to play.
#include "core/file.h"
#include "game/data/wand_slots.h"
#include "game/match/playback.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

/// A random integer, mostly large, sometimes one of the extreme values.
std::int32_t wild(Random& random) {
    switch (random.below(6)) {
        case 0: return std::numeric_limits<std::int32_t>::min();
        case 1: return std::numeric_limits<std::int32_t>::max();
        case 2: return 0;
        default: return static_cast<std::int32_t>(random.below(600)) - 300;
    }
}

input::InputFrame wild_frame(Random& random) {
    input::InputFrame frame;
    for (std::size_t d = 0; d < players; ++d) {
        auto& sample = frame.devices[d];
        for (auto& count : sample.counts) count = wild(random);
        sample.buttons = static_cast<std::uint32_t>(random.next());
        sample.wand = static_cast<std::uint8_t>(random.next());
        // Pause is rarely pressed, because a match that is paused most of the time would test little.
        if (random.below(50) != 0) sample.buttons &= ~input::bit(input::Button::pause);
    }
    return frame;
}

void expect_sane(const Simulation& match) {
    match.world().view<const Motion>().each([](ecs::Entity e, const Motion& m) {
        ASSERT_TRUE(is_finite(m.position) && is_finite(m.velocity) && is_finite(m.spin)) << e.index;
        ASSERT_LT(glm::length(m.position), 100) << e.index;
        ASSERT_LT(glm::length(m.velocity), 250) << e.index;
    });
    match.world().view<const Health, const Gaze>().each([](const Health& h, const Gaze& g) {
        ASSERT_TRUE(h.points >= -100 && h.points <= 150) << h.points;
        ASSERT_LE(std::abs(g.pitch), pi / 2);
        ASSERT_LE(std::abs(g.yaw), pi);
    });
    const auto full = full_belt(match.data()).energy;
    match.world().view<const WandBelt>().each([&full](const WandBelt& belt) {
        for (std::size_t slot = 0; slot < wand_slots; ++slot)
            ASSERT_TRUE(belt.energy[slot] >= 0 && belt.energy[slot] <= full[slot]) << belt.energy[slot];
    });
}

TEST(GameHostile, WildInputLeavesEverythingFiniteAndInBounds) {
    Random random{12};
    Simulation match(duel_data({"quick.kills=1000", "wizard.health.start=20"}),
                     {5, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    auto frame = wild_frame(random);
    for (Tick t = 0; t < 40'000; ++t) {
        if (random.below(20) == 0) frame = wild_frame(random);
        match.tick(frame);
        if (t % 100 == 0) expect_sane(match);
        if (HasFatalFailure()) FAIL() << "at tick " << t;
    }
    EXPECT_GT(match.match().played, 5000U);
}

TEST(GameHostile, PowerUpsRespectTheCapsInAnyState) {
    Random random{31};
    const auto data = duel_data(
        {"quick.kills=1000", "thaum.vial.again_s=0.1", "thaum.heart.again_s=0.1", "thaum.spark.again_s=0.1"});
    Simulation match(data, {6, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    auto frame = wild_frame(random);
    for (Tick t = 0; t < 20'000; ++t) {
        if (random.below(20) == 0) frame = wild_frame(random);
        for (auto& sample : frame.devices)
            sample.buttons &= ~static_cast<std::uint32_t>(input::Button::pause);
        if (t % 200 == 0) {  // moves a wizard onto a power-up and sets a random health
            const auto wizard = wizard_of(match.world(), static_cast<std::uint32_t>(t / 200 % players));
            if (match.world().has<Dead>(wizard)) continue;
            const auto& place = data->arena.power_ups[random.below(data->arena.power_ups.size())];
            auto& world = match.world_to_change();
            world.get<Health>(wizard).points = random.uniform(-5, 150);
            world.get<Motion>(wizard).position = place.position + vec3(0, data->wizard.height / 2, 0);
            match.physics().set_state(wizard.index, std::as_const(world).get<Motion>(wizard));
        }
        match.tick(frame);
        if (t % 8 == 7) expect_sane(match);
        if (HasFatalFailure()) FAIL() << "at tick " << t;
    }
    EXPECT_GT(match.world().single<EventLog>().count, 100U);
}

TEST(GameHostile, ALogOfOtherRulesOrDataIsRefusedInOneLineThatNamesTheDifference) {
    const auto data = duel_data();
    const MatchSetup setup{1, {bot_device(0, "level_1"), bot_device(1, "level_1")}};
    const auto header = log_header(*data, setup, {"bot 1", "bot 1"});
    ASSERT_TRUE(match_of_log(header, assets()).has_value());
    const auto refusal = [](const input::LogHeader& changed) {
        return message_of(match_of_log(changed, assets()), "accepted");
    };
    auto other = header;
    ++other.rules_version;
    EXPECT_NE(refusal(other).find(text("recorded under rules version ", other.rules_version)),
              std::string::npos)
        << refusal(other);
    other = header;
    other.files[0].hash ^= 1;
    EXPECT_NE(refusal(other).find("arenas/boiling_court.toml has changed"), std::string::npos)
        << refusal(other);
    other = header;
    other.files.push_back({"wands/lost.toml", 1});
    EXPECT_NE(refusal(other).find("wands/lost.toml is not part"), std::string::npos) << refusal(other);
    other = header;
    std::erase_if(other.files, [](const auto& file) { return file.name == "haptics.toml"; });
    EXPECT_NE(refusal(other).find("did not exist"), std::string::npos) << refusal(other);
    other = header;
    other.arena = "../../etc/passwd";
    EXPECT_NE(refusal(other).find("no name of an arena"), std::string::npos) << refusal(other);
    other = header;
    other.overrides = {"bolt.shot.damage=nan"};
    EXPECT_NE(refusal(other).find("damage"), std::string::npos) << refusal(other);
}

TEST(GameHostile, ALogThatNumbersItsKindsDifferentlyIsRefusedInOneLineThatNamesTheKind) {
    const auto header = log_header(*duel_data(), {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}},
                                   {"bot 1", "bot 1"});
    const auto refusal = [&](auto change) {
        auto other = header;
        change(other.kinds);
        return message_of(match_of_log(other, assets()), "accepted");
    };
    using Tables = std::vector<input::KindTable>;
    constexpr std::string_view advice = ": replay the log with the program that recorded it";
    EXPECT_EQ(refusal([](Tables&) {}), "accepted");
    EXPECT_EQ(refusal([](Tables& t) { t.clear(); }), "accepted") << "format 1 has no tables";
    EXPECT_EQ(refusal([](Tables& t) { t[1].kinds[2].name = "arrow_hit"; }),
              text("event 2 is 'arrow_hit' in the log and 'bolt_hit' in this program", advice));
    EXPECT_EQ(refusal([](Tables& t) {
                  t.back().kinds.push_back({6, "hail\x1b[2J\n"});
              }),
              text("wand 6 is 'hail\\x1b[2J ' in the log and nothing in this program", advice));
    EXPECT_EQ(refusal([](Tables& t) { t[0].kinds.erase(t[0].kinds.begin()); }),
              text("cause 0 is nothing in the log and 'bolt' in this program", advice));
    EXPECT_EQ(refusal([](Tables& t) { t.pop_back(); }), "accepted")
        << "no state of the log has a wand that only this program has";
    EXPECT_EQ(refusal([](Tables& t) { std::swap(t[2].kinds[0].name, t[2].kinds[1].name); }),
              text("ingredient 0 is '", header.kinds[2].kinds[1].name, "' in the log and '",
                   header.kinds[2].kinds[0].name, "' in this program", advice));
    EXPECT_EQ(refusal([](Tables& t) { t[4].kinds[2].number = 3; }),
              text("power_up 3 is 'spark' in the log and nothing in this program", advice));
    EXPECT_EQ(refusal([](Tables& t) {
                  t.push_back({"wounds", {{0, "cut"}}});
              }),
              text("wounds 0 is 'cut' in the log and nothing in this program", advice));
}

TEST(GameHostile, ALogThatNamesNoKindsIsRefused) {
    const TemporaryFolder folder;
    auto header = log_header(*duel_data(), {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}},
                             {"bot 1", "bot 1"});
    const auto refusal = [&](const char* name) {
        auto log = input::LogWriter::create(folder.path() / name, header).value();
        EXPECT_TRUE(log.close(""));
        return message_of(Playback::open(folder.path() / name, assets()), "accepted");
    };
    EXPECT_EQ(refusal("whole"), "accepted");
    header.kinds.clear();
    EXPECT_NE(refusal("none").find("names no kinds"), std::string::npos);
}

TEST(GameHostile, ALogOfAnotherBuildIsReplayedWithAWarning) {
    const auto header = log_header(*duel_data(), {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}},
                                   {"bot 1", "bot 1"});
    EXPECT_EQ(build_warning(header), "");
    EXPECT_TRUE(header.physics_library.starts_with("Bullet ")) << header.physics_library;
    EXPECT_EQ(header.physics_precision, "double");
    const auto warning = [&](auto change) {
        auto other = header;
        change(other);
        return build_warning(other);
    };
    EXPECT_NE(warning([](input::LogHeader& h) { ++h.maths_probe; }), "");
    EXPECT_EQ(warning([](input::LogHeader& h) { h.physics_library = "Bullet 2.0"; }),
              text("recorded with Bullet 2.0 (double), this program has ", header.physics_library,
                   " (double): the replay may differ"));
    EXPECT_NE(warning([](input::LogHeader& h) { h.physics_precision = "single"; }), "");
    EXPECT_EQ(warning([](input::LogHeader& h) { h.physics_library = h.physics_precision = ""; }), "")
        << "format 1 does not say";
}

/// Names of stored logs must be right, because tests/scenario.cmake selects logs by the rules version in
/// their names.
TEST(ReplayCorpus, EveryNameSaysTheRulesVersionOfItsHeaderAndThisVersionIsAmongThem) {
    bool current = false;
    for (const auto& entry : std::filesystem::directory_iterator(THAUM_SOURCE_DIR "/tests/replays")) {
        if (entry.path().extension() != ".thaumlog") continue;  // skips the folder of force traces
        const auto header = input::read_log_header(entry.path()).value();
        EXPECT_TRUE(entry.path().stem().string().ends_with(text("_rules_", header.rules_version)))
            << entry.path();
        EXPECT_LE(header.rules_version, rules_version) << entry.path();
        current = current || header.rules_version == rules_version;
    }
    EXPECT_TRUE(current) << "record one: see tests/scenario.cmake";
}

/// A complete log of an older rules version. Its header is enough to refuse it in one line.
TEST(ReplayCorpus, ALogOfAnOlderRulesVersionIsRefusedByName) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "older_rules.thaumlog";
    auto header = log_header(*duel_data(), {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}},
                             {"bot 1", "bot 1"});
    header.rules_version = rules_version - 1;
    header.program = "0.0.9";
    ASSERT_TRUE(input::LogWriter::create(file, header)->close("").has_value());
    EXPECT_EQ(message_of(Playback::open(file, assets())),
              text(file.string(), ": recorded under rules version ", rules_version - 1,
                   ", this program plays version ", rules_version,
                   "; it replays only in a build of Thaum whose rules version is ", rules_version - 1));
}

}  // namespace
}  // namespace thaum::game::test
