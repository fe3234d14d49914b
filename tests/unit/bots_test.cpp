// Tests of bots: each value of a bot's skill has the effect that it stands for, and the results of many
// matches are right.
#include <cmath>

#include "game/bots/aim.h"
#include "game/bots/bot_file.h"
#include "game/bots/league.h"
#include "game/bots/swinging.h"
#include "game/data/wand_slots.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

/// Levels of the shipped bots level_0 to level_3.
constexpr int easiest_bot = 0, hardest_bot = 3;

BotSkill skill_of(int level) {
    const auto skill = load_bot_skill(assets(), text("level_", level));
    EXPECT_TRUE(skill) << skill.error().message;
    return skill.value();
}

/// A bot (player 0) and a scripted wizard (player 1).
struct Scene {
    explicit Scene(const BotSkill& skill, std::vector<std::string> overrides = {}, std::uint64_t seed = 3)
        : Scene(skill, duel_data(std::move(overrides)), seed) {}
    Scene(const BotSkill& skill, std::shared_ptr<const MatchData> data, std::uint64_t seed = 3)
        : match(std::move(data), {seed, {bot_device(0, "level_1"), bot_device(1, "level_1")}}) {
        bots.add(match, 0, 0, skill, seed);
    }

    void put(std::uint32_t player, vec3 feet, double yaw_degrees) {
        auto& world = match.world_to_change();
        const auto wizard = wizard_of(world, player);
        world.get<Motion>(wizard).position = feet + vec3(0, match.data().wizard.height / 2, 0);
        world.get<Gaze>(wizard) = {yaw_degrees * radians_per_degree, 0};
        match.physics().set_state(wizard.index, std::as_const(world).get<Motion>(wizard));
    }

    template <class Foe>
    void run(double duration, Foe&& foe) {
        for (Tick t = 0; t < ticks(duration); ++t) {
            input::InputFrame frame;
            bots.sample(match, frame);
            foe(t, frame.devices[1]);
            match.tick(frame);
            held = frame.devices[0].down(input::Button::fire) ? held + 1 : 0;
            longest_held = std::max(longest_held, held);
        }
    }

    const MatchStats& bolts_of(std::uint32_t player) const {
        return match.world().single<EventLog>().match_stats[player][cause_of(hit_kind("bolt_hit"))];
    }

    /// Number of shots with any wand.
    double shots_of(std::uint32_t player) const {
        double sum = 0;
        for (const MatchStats& match_stats : match.world().single<EventLog>().match_stats[player])
            sum += match_stats.shots;
        return sum;
    }

    std::optional<PowerUpKind> picked_up() const {
        const auto& event_log = match.world().single<EventLog>();
        for (const auto& event : event_log.events) {
            if (event.kind == EventKind::power_up && event.subject == 0)
                return static_cast<PowerUpKind>(event.detail);
        }
        return {};
    }

    Simulation match;
    Bots bots;
    Tick held = 0, longest_held = 0;  ///< longest time for which player 0 has held fire so far (ticks)
};

void stands_still(Tick, input::DeviceSample&) {}

TEST(BotSkill, AHigherLevelSeesAimsAndTurnsBetter) {
    BotSkill before;
    for (int level = easiest_bot; level <= hardest_bot; ++level) {
        const auto skill = skill_of(level);
        EXPECT_EQ(skill.level, static_cast<std::uint32_t>(level));
        if (level > easiest_bot) {
            EXPECT_LT(skill.reaction, before.reaction);
            EXPECT_LT(skill.aim_error, before.aim_error);
            EXPECT_GT(skill.turn_speed, before.turn_speed);
        }
        before = skill;
    }
}

TEST(Bot, FetchesHealthWhenHurtAndEnergyWhenDry) {
    for (int level = 1; level <= hardest_bot; ++level) {
        const auto skill = skill_of(level);
        Scene scene(skill);
        auto& world = scene.match.world_to_change();
        world.get<Health>(wizard_of(world, 0)).points = 0.2 * skill.vial_below;
        scene.put(1, {15, 0, -15}, 0);
        scene.run(12, stands_still);
        EXPECT_EQ(scene.picked_up(), PowerUpKind::vial) << level;
    }
    for (int level = 1; level <= hardest_bot; ++level) {
        Scene dry(skill_of(level), {"bolt.energy.regain_per_s=0"});
        auto& world = dry.match.world_to_change();
        world.get<WandBelt>(wizard_of(world, 0)).energy.fill(0);
        dry.put(1, {15, 0, -15}, 0);
        dry.run(12, stands_still);
        EXPECT_EQ(dry.picked_up(), PowerUpKind::spark) << level;
    }
}

/// Hits and misses of a bot's bolts in 40 s at a foe who walks to and fro 10 m away. `lead`: share of the
/// foe's motion for which the bot aims ahead.
MatchStats shots_at_a_walker(double lead) {
    auto skill = skill_of(3);
    skill.lead = lead;
    skill.aim_error = skill.variety = 0;
    skill.reserve = skill.vial_below = skill.spark_below = 0;
    Scene scene(skill, {"bolt.energy.regain_per_s=100", "bolt.shot.damage=0.01", "bolt.shot.spread_deg=0"});
    scene.put(0, {-14, 0, 18.5}, -90);  // a place with no table between bot and foe
    scene.put(1, {-14, 0, 8.5}, 180);
    scene.run(40, [](Tick t, input::DeviceSample& foe) {
        foe.counts[input::hand::strafe] = t / 1500 % 2 == 0 ? 127 : -127;
    });
    return scene.bolts_of(0);
}

TEST(Bot, LeadingTheFoeHitsMore) {
    const auto plain = shots_at_a_walker(0), leading = shots_at_a_walker(1);
    ASSERT_GT(plain.shots, 40U);
    ASSERT_GT(leading.shots, 40U);
    const double before = plain.hits / static_cast<double>(plain.shots);
    const double after = leading.hits / static_cast<double>(leading.shots);
    EXPECT_GT(after, 1.3 * before) << plain.hits << "/" << plain.shots << " " << leading.hits << "/"
                                   << leading.shots;
}

/// Number of shots of a bot in 45 s by kind, 9 m from a foe who stands still.
std::array<std::uint32_t, max_causes> shots_of(int level) {
    auto skill = skill_of(level);
    skill.variety = 0.9;
    skill.throws = 0.3;
    skill.lift.share = 0;
    skill.vial_below = skill.spark_below = skill.cover_below = 0;
    Scene scene(skill,
                {"bolt.energy.regain_per_s=100", "blast.energy.regain_per_s=100",
                 "lob.energy.regain_per_s=100", "wizard.health.start=100000", "wizard.health.cap=100000"});
    scene.put(0, {-14, 0, 8}, 0);
    scene.put(1, {-14, 0, -1}, 180);
    scene.run(45, stands_still);
    std::array<std::uint32_t, max_causes> shots{};
    for (std::size_t cause = 0; cause < causes().size(); ++cause)
        shots[cause] = scene.match.world().single<EventLog>().match_stats[0][cause].shots;
    return shots;
}

TEST(Bot, HigherLevelsUseMoreWands) {
    for (int level = 1; level <= hardest_bot; ++level) {
        const auto shots = shots_of(level);
        EXPECT_GT(shots[cause_of(hit_kind("bolt_hit"))], 5U) << level;
        EXPECT_GT(shots[cause_of(hit_kind("blast_hit"))], 2U) << level;
        EXPECT_EQ(shots[cause_of(hit_kind("lob_hit"))] > 0, level > 1) << level;
    }
}

TEST(Bot, AShotInAnArcComesDownOnTheTarget) {
    Self self{.tip = {1, 1.2, 0}, .shot = {.speed = 15, .fall = 9.81}};
    for (const vec3 target : {vec3(1, 1.2, -10), vec3(4, 3, -7), vec3(-6, -4, 8)}) {
        const auto aim = aim_of_shot(self, target);
        const vec3 to = target - self.tip;
        const double flat = std::hypot(to.x, to.z), flight = flat / (15 * std::cos(aim.pitch));
        EXPECT_NEAR(15 * std::sin(aim.pitch) * flight - 9.81 / 2 * flight * flight, to.y, 1e-9);
        EXPECT_LT(aim.pitch, pi / 4 + 0.3) << "the lower way";
    }
    EXPECT_NEAR(aim_of_shot(self, {1, 1.2, -100}).pitch, pi / 4, 1e-12) << "beyond the largest range";
}

/// Number of hits in 30 s on a bot 28 m from a foe who always shoots straight at the place where the bot
/// began.
std::uint32_t hits_on_a_target(std::uint32_t dodges) {
    auto skill = skill_of(3);
    skill.dodges = dodges;
    skill.strafe = 0;
    skill.range = skill.reserve = skill.vial_below = skill.spark_below = skill.cover_below = 0;
    skill.keep = 28;
    skill.reaction = ticks(0.2);
    Scene scene(skill, {"bolt.energy.regain_per_s=100", "bolt.shot.damage=0.01", "bolt.shot.spread_deg=0"});
    scene.put(0, {-14.5, 0, 14}, 0);
    scene.put(1, {-14.5, 0, -14}, 180);
    scene.run(30, [](Tick, input::DeviceSample& foe) { foe.press(input::Button::fire); });
    return scene.bolts_of(1).hits;
}

TEST(Bot, EveryWayLeadsOn) {
    Scene scene(skill_of(3));
    const WalkGrid grid(scene.match.physics(), ground_bounds(scene.match.data().arena));
    WalkGrid::Ways ways;
    std::size_t cells = 0;
    for (const vec3 goal : {vec3(19.5, 0, -19.5), vec3(-19.5, 0, 19.5), vec3(6.5, 0, -5.5), vec3(0, 0, 15)}) {
        grid.find_ways(grid.cell_at(goal), ways);
        for (int cell = 0; cell < grid.cells(); ++cell) {
            const auto steps = ways.steps[static_cast<std::size_t>(cell)];
            if (steps == WalkGrid::unreachable || steps == 0) continue;
            const auto next = static_cast<std::size_t>(grid.next(cell, ways));
            EXPECT_EQ(ways.steps[next] + 1, steps) << cell;
            ++cells;
        }
    }
    EXPECT_GT(cells, 3000U);
}

TEST(Bot, WaitsNowhereWhileItsFoeStandsInACorner) {
    // The bot neither lifts, stirs nor strafes. It starts at 12 places of the narrow path along the pit.
    auto skill = skill_of(3);
    skill.lift = {};
    skill.stir = {};
    skill.strafe = 0;
    for (int place = 0; place < 12; ++place) {
        Scene scene(skill);
        scene.put(0, {5.5 + 0.13 * place, 0, -5.497}, -45);
        scene.put(1, {19.65, 0, -19.65}, 135);
        scene.run(10, stands_still);
        EXPECT_GT(scene.shots_of(0), 3) << place;
    }
}

TEST(Bot, DoesNotWaitForAChargeThatItCannotPay) {
    auto skill = skill_of(3);
    skill.variety = skill.charge = 1;
    skill.throws = skill.strafe = skill.lift.share = skill.stir.share = skill.over_cover = 0;
    skill.vial_below = skill.spark_below = skill.reserve = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Scene scene(skill, {"blast.energy.regain_per_s=0", "bolt.energy.regain_per_s=0", "quick.seconds=60"},
                    seed);
        scene.put(0, {-14, 0, 18.5}, 0);
        scene.put(1, {-14, 0, 8.5}, 180);
        scene.run(15, stands_still);
        EXPECT_GT(scene.longest_held, ticks(0.5)) << seed;
        EXPECT_LT(scene.longest_held, ticks(4.0)) << seed;
    }
}

TEST(Bot, DodgingIsHitLess) {
    const auto stands = hits_on_a_target(0), dodges = hits_on_a_target(1);
    EXPECT_GT(stands, 100U);
    EXPECT_LT(dodges, stands / 2);
}

TEST(Bot, KeepsItsReserveForANearFoe) {
    auto skill = skill_of(3);
    skill.aim_error = 0;
    skill.reserve = 0.5;
    skill.spark_below = skill.vial_below = skill.variety = skill.lift.share = 0;
    Scene scene(skill, {"bolt.energy.regain_per_s=0", "wizard.health.start=100000",
                        "wizard.health.cap=100000", "quick.seconds=60"});
    scene.put(0, {-14, 0, 18.5}, 0);
    scene.put(1, {-14, 0, 7.5}, 180);
    scene.run(20, stands_still);
    const double far = scene.match.world().get<WandBelt>(wizard_of(scene.match.world(), 0)).energy[0];
    EXPECT_NEAR(far, 30, 1.5) << "half of 60 is kept";
    for (int i = 0; i < 40; ++i) {  // the foe comes near again and again, wherever the bot goes
        const auto& world = scene.match.world();
        const auto bot = world.get<Motion>(wizard_of(world, 0)).position;
        const auto yaw = world.get<Gaze>(wizard_of(world, 0)).yaw;
        const vec3 near = bot + look_rotation(yaw, 0) * vec3(0, 0, -3);
        if (std::abs(near.x) < 19 && std::abs(near.z) < 19) scene.put(1, {near.x, 0, near.z}, 0);
        scene.run(0.5, stands_still);
    }
    EXPECT_LT(scene.match.world().get<WandBelt>(wizard_of(scene.match.world(), 0)).energy[0], 25);
}

/// Statistics of the objects that the bot throws in 12 s. A stone of 120 kg lies between the bot and a foe
/// who stands still 10 m away.
MatchStats throws_of(int level) {
    auto skill = skill_of(level);
    if (skill.lift.share > 0) skill.lift.share = 1;
    skill.vial_below = skill.spark_below = skill.cover_below = 0;
    Scene scene(skill, {"wizard.health.start=100000", "wizard.health.cap=100000"});
    scene.put(0, {7, 0, 15.5}, -90);
    scene.put(1, {17, 0, 15}, 90);
    scene.run(12, stands_still);
    return scene.match.world().single<EventLog>().match_stats[0][cause_of(EventKind::object_hit)];
}

TEST(Bot, FromLevelTwoItTakesThingsUpAndThrowsThem) {
    for (int level = 1; level <= hardest_bot; ++level) {
        const auto blows = throws_of(level);
        EXPECT_EQ(blows.hits > 0, level > 1) << level;
        EXPECT_EQ(blows.damage > 8, level > 1) << level;
    }
}

TEST(Bot, HoldsNothingWithoutTheSkillToLiftOrSwing) {
    for (const bool may : {false, true}) {
        auto skill = skill_of(3);
        skill.lift.share = may ? 1 : 0;
        skill.swing_gain = 0;
        Scene scene(skill);
        scene.put(0, {7, 0, 15.5}, -90);
        scene.put(1, {17, 0, 15}, 90);
        bool held = false;
        for (int i = 0; i < 60; ++i) {
            scene.run(0.1, stands_still);
            const auto& world = scene.match.world();
            const auto wizard = wizard_of(world, 0);
            const auto* wand = wand_in_hand(scene.match.data(), world.get<WandBelt>(wizard));
            held = held || (wand->name == "lift" && wand->rules->held_at(world, wizard));
        }
        EXPECT_EQ(held, may);
    }
}

TEST(Bot, KnowsTheGapsThatAnAnchorSpans) {
    const Simulation match(duel_data(), {1, {bot_device(0, "level_1"), bot_device(1, "level_1")}});
    const WalkGrid grid(match.physics(), ground_bounds(match.data().arena));
    const auto crossings = find_crossings(match, grid);
    ASSERT_EQ(crossings.size(), 8U) << "four anchors over the two pits, both ways";
    for (const auto& c : crossings) {
        EXPECT_TRUE(grid.walkable(grid.cell_at(c.from)) && grid.walkable(grid.cell_at(c.to)));
        EXPECT_FALSE(grid.straight(c.from, c.to));
        EXPECT_NEAR(glm::distance(c.from, c.anchor), glm::distance(c.to, c.anchor), 1e-9);
        const auto back = std::any_of(crossings.begin(), crossings.end(), [&](const Crossing& other) {
            return other.from == c.to && other.to == c.from && other.anchor == c.anchor;
        });
        EXPECT_TRUE(back);
    }
}

/// Lowest height of the wizard's feet (m) within `duration` (s).
template <class Foe>
double lowest_feet(Scene& scene, std::uint32_t player, double duration, Foe&& foe) {
    double lowest = 100;
    for (Tick t = 0; t < ticks(duration); t += gameplay_period) {
        scene.run(gameplay_dt, foe);
        const auto& world = scene.match.world();
        const double middle = world.get<Motion>(wizard_of(world, player)).position.y;
        lowest = std::min(lowest, middle - scene.match.data().wizard.height / 2);
    }
    return lowest;
}

TEST(Bot, InAPanicItStepsOverAnEdge) {
    for (const double heedless : {0.0, 1.0}) {
        for (const double panic : {0.0, 40.0}) {
            auto skill = skill_of(3);
            skill.strafe = 1;
            skill.variety = skill.lift.share = skill.stir.share = skill.over_cover = 0;
            skill.vial_below = skill.spark_below = skill.cover_below = 0;
            skill.edge.heedless = heedless;
            skill.edge.panic = panic;
            Scene scene(skill, {"wizard.health.start=39", "wizard.health.cap=39", "bolt.shot.damage=0.01",
                                "bolt.energy.regain_per_s=100"});
            scene.put(0, {-4, 0, 5.3}, -90);
            scene.put(1, {4, 0, 5.3}, 90);
            const double lowest = lowest_feet(
                scene, 0, 8, [](Tick, input::DeviceSample& foe) { foe.press(input::Button::fire); });
            const bool fell = lowest<-1, may_fall = heedless> 0 && panic > 0;
            EXPECT_EQ(fell, may_fall) << heedless << " " << panic << " " << lowest;
        }
    }
}

struct Trip {
    double seconds{};  ///< time until the spark was picked up (s)
    double lowest{};   ///< lowest height of the bot's feet on the way (m)
    double health{};   ///< health of the bot at the end (HP)
};

/// Sends a bot without bolts to the arena's only spark (a power-up with energy), on the other side of the
/// pit.
Trip errand_over_the_pit(double swing_gain) {
    auto skill = skill_of(3);
    skill.swing_gain = swing_gain;
    skill.vial_below = skill.cover_below = skill.lift.share = skill.stir.share = 0;
    skill.spark_below = 1;
    auto data = *duel_data({"bolt.energy.regain_per_s=0"});
    auto& power_ups = data.arena.power_ups;
    std::erase_if(power_ups, [](const auto& p) { return p.kind != PowerUpKind::spark || p.position.z < 10; });
    EXPECT_EQ(power_ups.size(), 1U);
    Scene scene(skill, std::make_shared<const MatchData>(std::move(data)));
    auto& world = scene.match.world_to_change();
    const auto bot = wizard_of(world, 0);
    for (const auto* shoots : {"bolt", "blast", "lob"})
        world.get<WandBelt>(bot).energy[wand_of(scene.match.data(), shoots).stats.energy_slot] = 0;
    scene.put(0, {-1, 0, 3.5}, 180);
    scene.put(1, {18, 0, -18}, 0);
    Trip errand{.lowest = 100};
    while (!scene.picked_up() && errand.seconds < 20) {
        scene.run(0.008, stands_still);
        errand.seconds += 0.008;
        const auto& motion = scene.match.world().get<Motion>(bot);
        errand.lowest = std::min(errand.lowest, motion.position.y - scene.match.data().wizard.height / 2);
    }
    errand.health = scene.match.world().get<Health>(bot).points;
    return errand;
}

TEST(Bot, SwingsOverAPitIfThatIsFaster) {
    const auto walks = errand_over_the_pit(0), swings = errand_over_the_pit(3);
    EXPECT_LT(walks.seconds, 15);
    EXPECT_LT(swings.seconds, walks.seconds - 0.5);
    EXPECT_GT(swings.lowest, -0.2) << "never in the pit";
    EXPECT_EQ(swings.health, 100);
}

TEST(Bot, SavedAndRestoredItGoesOnAsItWould) {
    auto duel = make_bot_duel(assets(), duel_data(), {"level_2", "level_3"}, 11).value();
    duel.run(4 * keyframe_interval);
    Bytes world, minds;
    duel.match->save(world);
    duel.bots.save(minds);
    auto again = make_bot_duel(assets(), duel_data(), {"level_2", "level_3"}, 11).value();
    ASSERT_TRUE(again.match->restore(world, 4 * keyframe_interval));
    ASSERT_TRUE(again.bots.restore(minds));
    duel.run(6000);
    again.run(6000);
    EXPECT_EQ(again.match->state_hash(), duel.match->state_hash());
}

// ---- the league: results of bots of all levels against each other -----------------------------------------

TEST(League, TheResultOfAMatchIsReported) {
    const auto data = duel_data({"quick.seconds=20"});
    const std::array<std::string, 3> league{"level_1", "level_3", "level_9"};
    const auto first = play_league_match(assets(), data, league, {0, 1}, 5);
    const auto second = play_league_match(assets(), data, league, {0, 1}, 5);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->rounds, 1U);
    EXPECT_LE(first->lengths[0], ticks(20.01));
    EXPECT_EQ(first->lengths, second->lengths);
    EXPECT_EQ(first->first_kills, second->first_kills);
    std::uint32_t kills = 0;
    for (const auto& player : first->match_stats)
        for (const auto& cause : player) kills += cause.kills;
    EXPECT_EQ(first->balance.kills, kills);
    for (std::uint32_t p = 0; p < players; ++p) {
        EXPECT_EQ(first->match_stats[p][0].shots, second->match_stats[p][0].shots);
        EXPECT_GT(first->alive[p], ticks(10.0));
        EXPECT_LE(first->alive[p], ticks(20.01));
        EXPECT_LE(first->dry[p], first->alive[p]);
    }
    EXPECT_FALSE(play_league_match(assets(), data, league, {0, 2}, 5));
}

TEST(League, TheSummaryCountsBySidesAndLevels) {
    std::vector<LeagueMatch> matches(4);
    for (auto& m : matches) m.bots = {0, 1};
    matches[1].bots = {1, 0};  // the two players have exchanged sides
    matches[0].winner = 1;     // the second bot wins
    matches[1].winner = 0;     // the second bot wins
    matches[2].winner = 0;     // the first bot wins
    matches[0].rounds = 1, matches[0].lengths[0] = ticks(100.0);
    matches[1].rounds = 2, matches[1].lengths[0] = ticks(50.0), matches[1].lengths[1] = ticks(240.0);
    matches[1].timed_out[1] = 1;
    matches[0].match_stats[1][0] = {.shots = 10, .hits = 5, .kills = 3};
    matches[1].match_stats[0][0] = {.shots = 10, .hits = 1, .kills = 1};
    matches[1].match_stats[1][2] = {.own_deaths = 2};
    matches[0].balance = {.rounds_with = {1, 0, 0, 1}, .kills = 3, .magic_kills = 2, .for_nobody = 1};
    matches[1].balance = {.rounds_with = {2, 1, 0, 0}, .kills = 1, .lead_changes = 4, .by_great_work = 1};
    matches[0].first_kills[0] = ticks(40.0), matches[1].first_kills[1] = ticks(20.0);
    matches[0].waits = 2, matches[0].between_kills[0] = ticks(30.0),
    matches[0].between_kills[1] = ticks(10.0);
    const auto fall = cause_of(EventKind::fall);
    matches[2].match_stats[0][fall] = {.kills = 1};
    matches[2].match_stats[1][fall] = {.own_deaths = 1};
    matches[0].alive = {ticks(100.0), ticks(80.0)};
    matches[0].dry = {ticks(10.0), ticks(20.0)};
    const auto s = summarise(matches);
    EXPECT_EQ(s.balance.rounds_with, (std::array<std::uint32_t, magic_sources>{3, 1, 0, 1}));
    EXPECT_EQ(s.balance.kills, 4U);
    EXPECT_EQ(s.balance.magic_kills, 2U);
    EXPECT_EQ(s.balance.lead_changes, 4U);
    EXPECT_EQ(s.balance.by_great_work, 1U);
    EXPECT_EQ(s.balance.for_nobody, 1U);
    EXPECT_EQ(s.first_kill_s, (std::vector{20.0, 40.0})) << "rounds without a kill are left out";
    EXPECT_EQ(s.between_kills_s, (std::vector{10.0, 30.0}));
    ASSERT_EQ(s.pairs.size(), 1U);
    EXPECT_EQ(s.pairs[0].high_wins, 2U);
    EXPECT_EQ(s.pairs[0].low_wins, 1U);
    EXPECT_EQ(s.pairs[0].high_share(), 2.5 / 4) << "a draw is half a win";
    EXPECT_EQ(s.seat_wins, (std::array<std::uint32_t, players>{2, 1}));
    EXPECT_EQ(s.median_round_s(), 100);
    EXPECT_EQ(s.timed_out, 1U);
    EXPECT_EQ(s.kills[0], 4U);
    EXPECT_EQ(s.own_deaths, 3U);
    ASSERT_EQ(s.bots.size(), 2U);
    EXPECT_EQ(s.bots[1].shots, 20U);
    EXPECT_EQ(s.bots[1].hits, 6U);
    EXPECT_EQ(s.bots[0].deaths, 6U);
    EXPECT_EQ(s.bots[0].falls, 0U);
    EXPECT_EQ(s.bots[1].falls, 2U) << "with those that are nobody's kill";
    EXPECT_EQ(s.bots[0].dry, ticks(10.0));
    EXPECT_EQ(s.bots[1].dry, ticks(20.0));
}

}  // namespace
}  // namespace thaum::game::test
