// Tests of the scenario runner, which plays scripted experiments: what it accepts and what it reports.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/file.h"
#include "game/components/hand_state.h"
#include "game/match/record.h"
#include "game/scenario/runner.h"

namespace thaum::game {
namespace {

ScenarioOptions options_for(const TemporaryFolder& folder) {
    ScenarioOptions options;
    options.assets = std::filesystem::path(THAUM_SOURCE_DIR) / "assets";
    options.scripts = scenarios_beside(options.assets);
    options.out = folder.path();
    return options;
}

ScenarioResult run(std::string_view source, const TemporaryFolder& folder) {
    return run_scenario_source(source, "test", options_for(folder));
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

constexpr std::string_view walk = R"(
match {players = {"script", "script"}}
wizard(1):move(0, 1)
wait(1)
expect(distance(wizard(1):position(), {-15, 0, 15}) > 3, "walked")
)";

class ScenarioRunner : public testing::Test {
protected:
    const TemporaryFolder folder;
    ScenarioOptions options = options_for(folder);
};

TEST_F(ScenarioRunner, AScenarioThatDoesSomethingPasses) {
    const auto result = run(walk, folder);
    EXPECT_TRUE(result.passed) << result.message;
    EXPECT_EQ(result.ticks, 1000U);
    EXPECT_EQ(result.message, "");
    EXPECT_EQ(result.files, (std::vector<std::string>{"test.thaumlog", "test.json"}));
}

TEST_F(ScenarioRunner, LogReplaysToTheSameState) {
    const auto result = run(walk, folder);
    auto log = input::LogReader::open(folder.path() / "test.thaumlog").value();
    EXPECT_TRUE(log.ended_cleanly());
    EXPECT_EQ(log.ticks(), 1000U);
    const auto match = match_of_log(log.header(), options.assets).value();
    for (input::InputFrame frame; log.next(frame);) match->tick(frame);
    EXPECT_EQ(match->state_hash(), result.hash);
}

TEST_F(ScenarioRunner, TheReportIsTheDocumentedOne) {
    const auto result = run(walk, folder);
    const auto report = nlohmann::json::parse(read_text_file(folder.path() / "test.json", 10000).value());
    const auto& one = report.at("scenarios").at(0);
    EXPECT_EQ(one.at("name"), "test");
    EXPECT_EQ(one.at("passed"), true);
    EXPECT_EQ(one.at("ticks"), 1000);
    EXPECT_EQ(one.at("hash").get<std::string>().size(), 16U);
    EXPECT_EQ(one.at("message"), "");
    EXPECT_EQ(one.at("files").size(), 2U);
    EXPECT_EQ(report.size(), 1U);
    EXPECT_EQ(one.size(), 6U);
}

TEST_F(ScenarioRunner, NothingChangedIsAFailure) {
    for (const auto* source : {"match {} wait(5)", "match {} wizard(1):hold('stir') wait(1)"}) {
        const auto result = run(source, folder);
        EXPECT_FALSE(result.passed);
        EXPECT_TRUE(has(result.message, "nothing has changed")) << result.message;
    }
    EXPECT_EQ(run("local x = 1", folder).message, "it has played no match");
    EXPECT_EQ(run("match {}", folder).message, "it has played no match");
}

TEST_F(ScenarioRunner, ADifferenceBetweenTheRunsIsFoundAndNamed) {
    options.same_again = SameAgain::by_second_run;
    options.spoil = [](Simulation& match, int number) {
        if (number != 2 || match.now() != 700) return;
        const auto wizard = wizard_of(match.world(), 1);
        match.world_to_change().get<Health>(wizard).points -= 1e-9;
    };
    const auto result = run_scenario_source(walk, "test", options);
    EXPECT_FALSE(result.passed);
    EXPECT_TRUE(has(result.message, "tick 768: the two runs have different states: Health"))
        << result.message;
    EXPECT_TRUE(has(result.message, "points: 100 and 99.99")) << result.message;
}

/// The log holds only input, and not a change that the test makes to the state directly, so its replay cannot
/// repeat the change.
TEST_F(ScenarioRunner, ADifferenceBetweenTheRunAndItsReplayIsFound) {
    options.spoil = [](Simulation& match, int) {
        if (match.now() == 700)
            match.world_to_change().get<Health>(wizard_of(match.world(), 1)).points -= 1e-9;
    };
    const auto result = run_scenario_source(walk, "test", options);
    EXPECT_FALSE(result.passed);
    EXPECT_TRUE(has(result.message, "the replay of its log differs: tick 768: state")) << result.message;
    options.same_again = SameAgain::unchecked;
    EXPECT_TRUE(run_scenario_source(walk, "test", options).passed);
}

/// A change that is not in the input must be seen by the checks that replay the input.
TEST_F(ScenarioRunner, SeekingAndLateFramesDetectChangesOutsideTheInput) {
    options.same_again = SameAgain::by_second_run;
    options.spoil = [](Simulation& match, int) {
        if (match.now() == 700) match.world_to_change().single<Dice>().spread.next();
    };
    const auto message = [&](std::string_view check) {
        return run_scenario_source(std::string(walk) + std::string(check), "test", options).message;
    };
    EXPECT_EQ(message(""), "");
    const auto sought = message("check_seek {ticks = {600}}");
    EXPECT_TRUE(has(sought, "the match and its replay differ: Dice")) << sought;
    const auto late = message("check_late {}");
    EXPECT_TRUE(has(late, "tick 768: the late match has another state")) << late;
}

TEST_F(ScenarioRunner, FailuresNameLineAndTick) {
    const auto message = [&](std::string_view source) {
        const auto result = run(source, folder);
        EXPECT_FALSE(result.passed) << source;
        return result.message;
    };
    EXPECT_EQ(message("match {}\nwait(0.25)\nexpect(1 == 2, 'one is two')"),
              "test.lua:3: expected otherwise: one is two (tick 250)");
    EXPECT_EQ(message("match {}\n\nexpect_near(1, 2, 0.5)"), "test.lua:3: 1 is not 2 within 0.5 (tick 0)");
    EXPECT_EQ(message("match {}\nwait_until(function() return false end, 0.5)"),
              "test.lua:2: not within 0.5 s (tick 500)");
    EXPECT_EQ(message("match {}\nexpect_event {kind = 'death', within = 0.1}"),
              "test.lua:2: no such event within 0.1 s: death (tick 100)");
    EXPECT_EQ(message("\nwait(1)"), "test.lua:2: there is no match yet: match{...} comes first");
    EXPECT_TRUE(has(message("match {}\nx()"), "test.lua:2: attempt to call a nil value"));
    EXPECT_TRUE(has(message("match {"), "test.lua:1:"));
    EXPECT_TRUE(has(message("match {}\ncoroutine.yield()"), "coroutine.yield outside"));
}

/// Faulty scripts, with a part of the message for each.
using Misuse = std::pair<const char*, const char*>;

/// Faulty lines after the line match{...} of a script, each with a part of its message.
constexpr Misuse misused_verbs[] = {
    {"match {}", "match{...} stands once in a scenario"},
    {"wizard(3)", "there are wizard(1) and wizard(2)"},
    {"wizard(1):hold('shoot')", "there is no button 'shoot'"},
    {"wizard(1):move(2, 0)", "strafe = 2 must be in -1 .. 1"},
    {"wizard(1):aim(5)", "a place must be {x, y, z}, not number"},
    {"wizard(1):aim {1, 2}", "z must be a number, not nil"},
    {"wizard(1):place {0, 1e9, 0}", "place.y = 1e+09 must be in"},
    {"wizard(1):place {0, 0 / 0, 0}", "place.y = "},
    {"wizard(2):move(0, 1)", "player 2 is a bot"},
    {"spawn {kind = 'box', size = {1, 1, 1}, mass = 1}", "'at' is missing"},
    {"spawn {kind = 'cone'}", "none of box, sphere, cylinder"},
    {"spawn {colour = 1}", "spawn knows no 'colour'"},
    {"spawn {kind = 'sphere', radius = 0, mass = 1, at = {0, 5, 0}}", "radius = 0 must be in"},
    {"wait(-1)", "must be in 0 .."},
    {"wait('x')", "seconds must be a number"},
    {"tick(1.5)", "must be a whole number"},
    {"events('explosion')", "there is no event 'explosion'"},
    {"trace('../x', {})", "name must be made of a-z, 0-9 and _"},
    {"trace('x', {'3.x'})", "'3.x' is no column"},
    {"trace('x', {'t1.x'})", "'t1.x' is no column"},
    {"changes(1)", "a state = 1 must be in 1 .. 0"},
    {"picture {split = 'diagonal'}", "side_by_side or top_bottom"},
    {"check_seek {count = 3}", "nothing has been played yet"},
    {"wizard(1):place {0, 0, 16} tick() check_late {}", "this scenario has set the scene itself"},
    {"spawn {kind = 'sphere', radius = 0.1, mass = 1, at = {0, 5, 0}}:push {1000, 0, 0}", "faster than"},
    {"wizard(1):reach {0, 0, 0}", "player 1 holds no arm"},
    {"wizard(1):told()", "player 1 holds no arm"},
    {"stall(1)", "must be in 0 .. 250"},
    {"stall(0.1) stall(0.1)", "has not made up for the last one"},
    {"on_screen('x')", "no picture function here"},
    {"raw_wait(1)", "a nil value (global 'raw_wait')"},
};

TEST_F(ScenarioRunner, MisuseOfVerbsIsSaidAtTheLine) {
    for (const auto& [source, wanted] : misused_verbs) {
        const auto result = run(std::string("match {players = {'script', 'bot 1'}}\n") + source, folder);
        EXPECT_FALSE(result.passed) << source;
        EXPECT_TRUE(result.message.starts_with("test.lua:2: ")) << source << ": " << result.message;
        EXPECT_TRUE(has(result.message, wanted)) << source << ": " << result.message;
    }
}

TEST_F(ScenarioRunner, MisuseOfMatchIsSaid) {
    for (const auto& [source, wanted] :
         {Misuse{"match {arena = 'nowhere'}", "nowhere"}, Misuse{"match {set = {'quick.kils=1'}}", "kils"},
          Misuse{"match {players = {'script', 'bot 9'}}", "no bot '9'"},
          Misuse{"match {arms = {true}, players = {'bot 1', 'script'}}", "holds no arm"},
          Misuse{"match {arms = 3}", "arms must be a list"}, Misuse{"match {players = {'me'}}", "neither"},
          Misuse{"match(5)", "match takes a table"}}) {
        const auto result = run(source, folder);
        EXPECT_FALSE(result.passed) << source;
        EXPECT_TRUE(has(result.message, wanted)) << source << ": " << result.message;
    }
}

TEST_F(ScenarioRunner, MisuseOfSensesIsSaid) {
    for (const auto& [source, wanted] :
         {Misuse{"match {} body(1)", "senses{...} comes first"},
          Misuse{"match {} senses {layouts = {'coat'}}", "coat.toml"},
          Misuse{"match {} senses {layouts = {'../x16'}}", "must be made of a-z"},
          Misuse{"match {} senses {} body(1, 'x16')", "has no 'x16'"},
          Misuse{"match {} senses {} body(3)", "a player"},
          Misuse{"match {} senses {} sound()", "senses{sound = true}"},
          Misuse{"match {} happen {kind = 'rain'}", "no event 'rain'"},
          Misuse{"match {} happen {kind = 'fall', amount = 0/0}", "amount"},
          Misuse{"match {} happen {kind = 'fall', subject = 1} check_senses {}", "has set the scene"}}) {
        const auto result = run(source, folder);
        EXPECT_FALSE(result.passed) << source;
        EXPECT_TRUE(has(result.message, wanted)) << source << ": " << result.message;
    }
}

TEST_F(ScenarioRunner, AScenarioThatSetsTheSceneLeavesNoLog) {
    const auto result =
        run("match {} trace('way', {'1.x', '2.health'}) wizard(1):place {0, 0, 16} wait(0.2)", folder);
    EXPECT_TRUE(result.passed) << result.message;
    EXPECT_EQ(result.message, "no log: the scenario has set the scene itself");
    EXPECT_EQ(result.files, (std::vector<std::string>{"test.way.csv", "test.json"}));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "test.thaumlog"));
    const auto csv = read_text_file(folder.path() / "test.way.csv", 1U << 20U).value();
    EXPECT_TRUE(csv.starts_with("time_s,wizard_1_x_m,wizard_2_health_hp\n0.001,")) << csv.substr(0, 100);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 201);
}

TEST_F(ScenarioRunner, ThingsCanBeSetAndRead) {
    const auto result = run(R"(
        match {}
        clear_props()
        local ball = spawn {kind = "sphere", radius = 0.2, mass = 2, at = {0, 5, 16}, velocity = {0, 0, 1}}
        tick()
        expect_near(ball:velocity().z, 1, 1e-9)
        expect_near(ball:velocity().y, -9.81 * 0.001, 1e-9)
        ball:push {4, 0, 0}
        tick()
        expect_near(ball:velocity().x, 2, 1e-9)
        ball:place({1, 8, 16}, {0, 3, 0})
        expect_near(ball:position().x, 1, 0)
        tick()
        expect_near(ball:velocity().y, 3 - 9.81 * 0.001, 1e-9)
        expect(ball:there())
        clear_props()
        expect(not ball:there())
        expect(not pcall(ball.position, ball)))",
                            folder);
    EXPECT_TRUE(result.passed) << result.message;
}

TEST_F(ScenarioRunner, TooLongAScenarioIsStopped) {
    options.max_ticks = 100;
    const auto result = run_scenario_source("match {} while true do tick() end", "test", options);
    EXPECT_TRUE(has(result.message, "it takes more than 0.1 s")) << result.message;
    options.limits.steps = 100'000;
    const auto endless = run_scenario_source("match {} while true do end", "test", options);
    EXPECT_TRUE(has(endless.message, "endless loop")) << endless.message;
}

TEST_F(ScenarioRunner, PicturesComeFromTheFunctionThatIsGiven) {
    constexpr std::string_view source = R"(
        match {}
        wizard(1):move(0, 1)
        tick(100)
        local view = picture {split = "top_bottom", name = "shot"}
        expect_near(view.width, 4, 0)
        local r, g, b = view:colour(0.9, 0.9)
        expect(r == 9 and g == 5 and b == 1)
        expect_near(view:mean(0, 0, 1, 1), (3 * 1 + 9) / 8 + 4 / 8 * 0, 2)
        expect_near(view:colours(0, 0, 1, 1), 2, 0)
        fail("on purpose"))";
    const auto without = run_scenario_source(source, "test", options);
    EXPECT_TRUE(without.no_picture);
    EXPECT_TRUE(has(without.message, "no picture function here")) << without.message;
    std::vector<std::string> drawn;
    options.take_picture = [&](const Simulation&, Split split,
                               const std::filesystem::path& file) -> Expected<Pixels> {
        drawn.push_back(file.filename().string() +
                        (split == Split::top_bottom ? " top_bottom" : " side_by_side"));
        Pixels pixels{4, 2, std::vector<std::uint8_t>(24)};
        pixels.rgb[21] = 9, pixels.rgb[22] = 5, pixels.rgb[23] = 1;
        return pixels;
    };
    const auto result = run_scenario_source(source, "test", options);
    EXPECT_TRUE(has(result.message, "on purpose")) << result.message;
    EXPECT_EQ(drawn, (std::vector<std::string>{"test.shot.png top_bottom", "test.failed.png side_by_side"}));
    EXPECT_EQ(result.files[0], "test.shot.png");
    EXPECT_EQ(result.files[1], "test.failed.png");
}

/// A folder laid out like the repository, with scripts and the stored traces of their forces.
struct Kept {
    TemporaryFolder folder;
    ScenarioOptions options = options_for(folder);
    std::filesystem::path script = folder.path() / "scenarios/shots.lua";
    std::filesystem::path trace = folder.path() / "replays/forces/shots.csv";

    explicit Kept(std::string_view source) {
        std::filesystem::create_directories(script.parent_path());
        std::filesystem::create_directories(trace.parent_path());
        EXPECT_TRUE(write_text_file(script, source));
    }
    std::string play() const { return run_scenario(script, options).message; }
};

constexpr std::string_view shots = R"(
match {}
trace("felt", {"1.force_z"})
wizard(1):hold("fire")
wait(1)
)";

TEST_F(ScenarioRunner, ForcesAreKeptAndComparedToTheBit) {
    Kept kept(shots);
    EXPECT_TRUE(has(kept.play(), "no force trace is kept")) << kept.play();
    kept.options.keep_forces = kept.trace.parent_path();
    EXPECT_EQ(kept.play(), "");
    kept.options.keep_forces.clear();
    EXPECT_EQ(kept.play(), "");
    // A very small force that is added in one tick must be found.
    kept.options.same_again = SameAgain::by_second_run;
    kept.options.spoil = [](Simulation& match, int) {
        if (match.now() != 500) return;
        auto& kick = match.world_to_change().get<HandState>(wizard_of(match.world(), 0)).kick;
        kick = {.peak = vec3(0, 0, 1e-12), .length = 1, .number = kick.number + 1};
    };
    EXPECT_TRUE(has(kept.play(), "forces differ: kept 384,")) << kept.play();
    kept.options.spoil = nullptr;
    const auto good = read_text_file(kept.trace, 1U << 20U).value();
    const auto with = [&](std::string_view from, std::string_view to) {
        auto changed = good;
        changed.replace(changed.find(from), from.size(), to);
        EXPECT_TRUE(write_text_file(kept.trace, changed));
        return kept.play();
    };
    EXPECT_TRUE(has(with("rules ", "rules 9"), "is of rules version 9"));
    EXPECT_TRUE(has(with(" ticks, hash ", " ticks, hash 0"), "forces differ"));
    EXPECT_TRUE(has(with("maths ", "maths 9"), "made with other elementary functions"));
    EXPECT_TRUE(write_text_file(kept.trace, ""));
    EXPECT_TRUE(has(kept.play(), "empty"));
}

TEST_F(ScenarioRunner, EveryHapticScenarioHasItsForceTrace) {
    const auto traces = options.scripts / "../replays/forces";
    std::size_t bytes = 0, scripts = 0, kept = 0;
    for (const auto& file : std::filesystem::directory_iterator(traces)) {
        bytes += file.file_size();
        ++kept;
        EXPECT_TRUE(std::filesystem::exists(options.scripts / (file.path().stem().string() + ".lua")))
            << file.path();
    }
    const auto all = find_scenarios({}, options).value();
    for (const auto& script : all) {
        const auto source = read_text_file(script, 1U << 20U).value();
        if (!has(source, ".force_")) continue;
        ++scripts;
        EXPECT_TRUE(std::filesystem::exists(traces / (script.stem().string() + ".csv"))) << script;
    }
    EXPECT_EQ(scripts, kept);
    EXPECT_LT(bytes, 300'000U);
}

TEST_F(ScenarioRunner, AnArmFeelsTheForcesThatTheMatchComputes) {
    constexpr std::string_view source = R"(
        match {arms = {true, false}}
        local me = wizard(1)
        me:reach({0.01, 0.02, 0}, 0.1)
        wait(0.5)
        expect_near(me:hand().x, 0.01, 1e-9)
        expect_near(me:hand().y, 0.02, 1e-9)
        me:hold("fire")
        for i = 1, 300 do
            tick()
            expect_near(distance(me:told(), me:force()), 0, 0)
        end
        stall(0.1)
        wait(0.5)
        check_seek {ticks = {700}}
        check_late {})";
    const auto result = run(source, folder);
    EXPECT_TRUE(result.passed) << result.message;
}

TEST_F(ScenarioRunner, ScenariosAreFoundByName) {
    EXPECT_GE(find_scenarios({}, options).value().size(), 12U);
    EXPECT_EQ(find_scenarios({"bolt_kill"}, options).value().front().filename(), "bolt_kill.lua");
    EXPECT_TRUE(has(find_scenarios({"no_such"}, options).error().message, "there is no scenario 'no_such'"));
}

}  // namespace
}  // namespace thaum::game
