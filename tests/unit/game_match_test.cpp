#include "ecs/snapshot.h"
#include "game/context/effects.h"
#include "game/data/wand_slots.h"
#include "game/match/result.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

std::uint64_t events_of(const Simulation& match) { return match.world().single<EventLog>().count; }

TEST(GameMatch, TwoBotsFindEachOtherAndFightToTheEnd) {
    auto duel = make_duel(1);
    for (int s = 0; s < 245 && duel.match->match().phase == Phase::playing; ++s) duel.run(1000);
    EXPECT_EQ(duel.match->match().phase, Phase::over);
    std::uint32_t shots = 0;
    duel.match->world().view<const WandBelt>().each([&](const WandBelt& belt) { shots += belt.fired; });
    EXPECT_GT(shots, 50U);
    EXPECT_GT(events_of(*duel.match), 50U);
}

TEST(GameMatch, TheSameSeedGivesTheSameMatchAndAnotherSeedAnother) {
    auto a = make_duel(7), b = make_duel(7), c = make_duel(8);
    a.run(10000);
    b.run(10000);
    c.run(10000);
    EXPECT_EQ(a.match->state_hash(), b.match->state_hash());
    EXPECT_NE(a.match->state_hash(), c.match->state_hash());
}

TEST(GameMatch, TheArenaFollowsTheDesign) {
    const auto data = duel_data();
    std::size_t props = 0;
    for (const auto& thing : data->arena.things) props += thing.prop ? 1U : 0U;
    EXPECT_EQ(props, 14U);
    EXPECT_EQ(data->arena.anchors.size(), 8U);
    EXPECT_EQ(data->arena.pads.size(), 4U);
    std::array<int, power_up_names.size()> kinds{};
    double power_ups = 0;
    for (const auto& p : data->arena.power_ups) {
        ++kinds[static_cast<std::size_t>(p.kind)];
        power_ups += p.position.z;
    }
    EXPECT_EQ(kinds, (std::array<int, 3>{4, 1, 3}));
    EXPECT_EQ(power_ups, 0.0) << "the power-ups are not mirror-symmetric";
    double total = 0;
    for (const auto& thing : data->arena.things) total += thing.position.z;
    EXPECT_EQ(total, 0.0) << "the arena is not mirror-symmetric";
}

TEST(GameMatch, AnOverrideReplacesAValueAndAWrongOneIsOneClearLine) {
    EXPECT_EQ(duel_data({"quick.kills=7"})->round.kills, 7);
    const auto message = [](std::string override_text) {
        return message_of(load_match_data(assets(), {.overrides = {std::move(override_text)}}), "accepted");
    };
    EXPECT_NE(message("quick.kils=7").find("rules/quick.toml: has no key 'kils'"), std::string::npos);
    EXPECT_NE(message("quick.kills=0").find("'kills' is 0"), std::string::npos);
    EXPECT_NE(message("wizard.body.height_m=0.6").find("must be more than twice radius_m"),
              std::string::npos);
    EXPECT_NE(message("nothing.kills=3").find("--set nothing.kills=3"), std::string::npos);
    EXPECT_NE(message("quick.kills=[").find("no value"), std::string::npos);
}

// ---- rules of a match -------------------------------------------------------------------------------------

TEST(GameRules, TheRuleSetFollowsItsFile) {
    const auto thaum = duel_data();
    auto classic = load_match_data(assets(), {.rules = "classic", .match = "standard"}).value();
    EXPECT_GT(wand_of(*thaum, "bolt").stats.energy_regain, 0);
    EXPECT_EQ(wand_of(classic, "bolt").stats.energy_regain, 0);
    EXPECT_GT(thaum->round.spawn_shield, 0U);
    EXPECT_EQ(classic.round.spawn_shield, 0U);
    EXPECT_EQ(thaum->round.rounds, 1U);
    EXPECT_EQ(classic.round.rounds, 3U);
    EXPECT_EQ(classic.round.kills, 5);
}

TEST(GameRules, SurgesFollowTheirTimesAndFallsDoNotGrow) {
    const auto data = duel_data();
    const auto& rules = data->round;
    ASSERT_EQ(rules.surges.size(), 2U);
    EXPECT_EQ(surge_at(rules, 0), 1);
    EXPECT_EQ(surge_at(rules, ticks(120.0) - 1), 1);
    EXPECT_EQ(surge_at(rules, ticks(120.0)), 1.5);
    EXPECT_EQ(surge_at(rules, ticks(180.0)), 2);
    EXPECT_EQ(surge_at(rules, ticks(3600.0)), 2);
    Simulation match(data, two_hands());
    auto& context = match.context_to_change();
    const auto wizard = wizard_of(match.world(), 0);
    auto& health = context.world.get<Health>(wizard);
    health.surge = 3;
    hurt(context, wizard, 1, {.points = 2, .by = 1, .how = EventKind::object_hit});
    EXPECT_EQ(health.points, 94);
    hurt(context, wizard, 1, {.points = 2, .by = 0, .how = EventKind::object_hit});
    hurt(context, wizard, 1, {.points = 2, .how = EventKind::fall});
    EXPECT_EQ(health.points, 90) << "own mistakes do no more harm";
    const auto classic = load_match_data(assets(), {.rules = "classic"}).value();
    EXPECT_TRUE(classic.round.surges.empty());
    EXPECT_EQ(classic.round.boil_over.length, 0U);
}

TEST(GameRules, BothFallInTheBoilOverAndItGoesOnWithTheSameHealth) {
    Simulation match(duel_data({"quick.seconds=1", "quick.respawn_s=0.1", "quick.spawn_shield_s=0"}),
                     two_hands());
    auto& world = match.context_to_change().world;
    const auto run = [&](Tick length) {
        for (Tick t = 0; t < length; ++t) match.tick({});
    };
    const auto strike_both = [&] {
        for (std::uint32_t player = 0; player < players; ++player)
            hurt(match.context_to_change(), wizard_of(world, player), match.now(),
                 {.points = 1000, .by = 1 - player, .how = EventKind::object_hit});
    };
    run(900);
    strike_both();  // nobody is there when the time is up
    run(300);
    EXPECT_NE(match.match().boils_over_since, 0U);
    EXPECT_EQ(match.match().phase, Phase::playing);
    for (std::uint32_t player = 0; player < players; ++player)
        EXPECT_EQ(world.get<Health>(wizard_of(world, player)).points, 30) << player;
    world.get<Health>(wizard_of(world, 0)).points = 80;
    run(8);
    EXPECT_EQ(world.get<Health>(wizard_of(world, 0)).points, 30) << "nothing gives more";
    const auto glass = duel_data({"wizard.health.start=20"});
    EXPECT_EQ(glass->round.boil_over.health, 20) << "nobody is healed by it";
    strike_both();
    run(200);
    EXPECT_EQ(match.match().phase, Phase::playing) << "equal kills decide nothing";
    hurt(match.context_to_change(), wizard_of(world, 0), match.now(),
         {.points = 1000, .how = EventKind::fall});  // a death of one's own making
    run(16);
    EXPECT_EQ(match.match().ending, Ending::boil_over);
    EXPECT_EQ(match.match().winner, 1U);
    EXPECT_EQ(result_line(match).substr(0, 30), "player 2 wins in the Boil-over");

    Simulation idle(duel_data({"quick.seconds=1", "quick.boil_over.seconds=2"}), two_hands());
    for (Tick t = 0; t < 2990; ++t) idle.tick({});
    EXPECT_EQ(idle.match().phase, Phase::playing);
    for (Tick t = 0; t < 20; ++t) idle.tick({});
    EXPECT_EQ(idle.match().ending, Ending::boil_over);
    EXPECT_EQ(idle.match().winner, no_player) << "if nobody falls, the round is nobody's";
}

TEST(GameRules, TheLogRemembersRuleSetAndMatch) {
    auto data = load_match_data(assets(), {.rules = "classic", .match = "standard"}).value();
    const auto header =
        log_header(data, {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}}, {"bot 1", "bot 1"});
    EXPECT_EQ(header.rule_set, "classic");
    const auto match = match_of_log(header, assets()).value();
    EXPECT_EQ(match->data().choice.rules, "classic");
    EXPECT_EQ(match->data().choice.match, "standard");
    auto other = header;
    other.rule_set = "draughts";
    EXPECT_NE(match_of_log(other, assets()).error().message.find("no rule set 'draughts'"),
              std::string::npos);
}

TEST(GameMatchLog, AnotherDataFileIsRefusedAndOnlyMaterialsMayBeUnnamed) {
    const auto data = load_match_data(assets(), {}).value();
    const auto header = log_header(data, {.seed = 1, .devices = {}}, {"a", "b"});
    const auto named = [](input::LogHeader& log, std::string_view name) {
        return std::ranges::find(log.files, name, &input::DataFile::name);
    };
    for (const auto& file : header.files) {
        auto changed = header;
        ++named(changed, file.name)->hash;
        EXPECT_EQ(match_of_log(changed, assets()).error().message,
                  text("data file ", file.name, " has changed since the recording"));
    }
    auto older = header;
    older.files.erase(named(older, "materials.toml"));
    EXPECT_TRUE(match_of_log(older, assets())) << "logs of this rules version do not name it";
    older.files.erase(named(older, "crystal.toml"));
    EXPECT_EQ(match_of_log(older, assets()).error().message,
              "data file crystal.toml did not exist when this was recorded");
}

TEST(Match, TheResultNamesTheWinnerIfTheNameIsKnown) {
    auto duel = make_bot_duel(assets(), duel_data({"bolt.shot.damage=100", "quick.kills=1"}),
                              {"level_3", "level_3"}, 5)
                    .value();
    auto& match = *duel.match;
    EXPECT_EQ(result_line(match, {"Ada", "Bot 3"}), result_line(match)) << "nobody has won yet";
    for (Tick t = 0; t < ticks(60.0) && match.match().phase != Phase::over; ++t)
        match.tick(duel.next_frame());
    const auto line = result_line(match);
    const bool first = line.starts_with("player 1 wins by kills");
    ASSERT_TRUE(first || line.starts_with("player 2 wins by kills")) << line;
    EXPECT_EQ(result_line(match, {"Ada", "Bot 3"}),
              text(first ? "Ada" : "Bot 3", line.substr(std::string_view("player 1").size())));
    EXPECT_EQ(result_line(match, {}), line) << "names that are not known";
}

TEST(GameRules, AGiftIsLimitedByTheCap) {
    const auto data = duel_data();
    Simulation match(data, {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    const auto gift = [&](PowerUpKind kind, double health, double energy) {
        const auto wizard = wizard_of(match.world(), 0);
        auto& belt = match.world_to_change().get<WandBelt>(wizard);
        belt = full_belt(*data);
        belt.energy[wand_of(*data, "bolt").stats.slot] = energy;
        match.world_to_change().get<Health>(wizard).points = health;
        const auto& effects = data->rules.power_ups[static_cast<std::size_t>(kind)].effects;
        return gain_of(match.context_to_change(), wizard, effects, {});
    };
    EXPECT_EQ(gift(PowerUpKind::vial, 10, 0), 25);
    EXPECT_EQ(gift(PowerUpKind::vial, 100, 0), 25);
    EXPECT_EQ(gift(PowerUpKind::vial, 140, 0), 10);
    EXPECT_EQ(gift(PowerUpKind::heart, 100, 0), 50);
    EXPECT_EQ(gift(PowerUpKind::heart, 150, 0), 0);
    EXPECT_EQ(gift(PowerUpKind::heart, 151, 0), 0);
    EXPECT_EQ(gift(PowerUpKind::spark, 100, 0), 30);
    EXPECT_EQ(gift(PowerUpKind::spark, 100, 45), 15);
    EXPECT_EQ(gift(PowerUpKind::spark, 100, 60), 0);
}

TEST(GameRules, TheResultListsStatisticsByPlayerAndCause) {
    Simulation match(duel_data(), {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    auto& world = match.world_to_change();
    const auto shot = static_cast<std::uint32_t>(hit_kind("bolt_hit"));
    for (int i = 0; i < 8; ++i)
        record(match.context_to_change(), {.kind = EventKind::shot, .subject = 0, .by = 0, .detail = shot});
    const auto victim = wizard_of(world, 1);
    hurt(match.context_to_change(), victim, 0, {.points = 6, .by = 0, .how = hit_kind("bolt_hit")});
    hurt(match.context_to_change(), victim, 0, {.points = 200, .by = 0, .how = EventKind::object_hit});
    for (int i = 0; i < 16; ++i) match.tick({});
    const auto rows = result_rows(match.world().single<EventLog>().match_stats);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].cause, "bolt");
    EXPECT_EQ(rows[0].words[0], "1 of 8 hit (13 %), 6 HP");
    EXPECT_EQ(rows[0].words[1], "");
    EXPECT_EQ(rows[1].words[0], "1 hit, 200 HP, 1 kill");
    EXPECT_NE(result_table(match).find("player 2   1 death"), std::string::npos);
}

TEST(GameRules, AMatchOfSeveralRoundsRestoresInTheMiddle) {
    DataChoice choice{
        .match = "standard",
        .overrides = {"standard.seconds=2", "standard.interval_s=1", "standard.boil_over.seconds=0"}};
    const auto data = std::make_shared<const MatchData>(load_match_data(assets(), choice).value());
    auto duel = make_bot_duel(assets(), data, {"level_1", "level_1"}, 4).value();
    std::vector<input::InputFrame> frames;
    Bytes keyframe;
    while (duel.match->match().phase != Phase::over && frames.size() < 20000) {
        if (duel.match->now() == 2 * keyframe_interval) duel.match->save(keyframe);
        duel.match->tick(frames.emplace_back(duel.next_frame()));
    }
    EXPECT_EQ(duel.match->match().phase, Phase::over);
    EXPECT_EQ(duel.match->match().round, 2U);
    EXPECT_EQ(ahead(duel.match->match()), no_player);
    Simulation again(data, duel.match->setup());
    ASSERT_TRUE(again.restore(keyframe, 2 * keyframe_interval));
    for (auto t = 2 * keyframe_interval; t < frames.size(); ++t) again.tick(frames[t]);
    EXPECT_EQ(again.state_hash(), duel.match->state_hash());
}

}  // namespace
}  // namespace thaum::game::test
