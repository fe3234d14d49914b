// Tests of mutators: what they change, in which order, what is refused, and how a log keeps them.
#include "game/data/mutator.h"

#include <gtest/gtest.h>

#include "core/file.h"
#include "game/match/playback.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

using Names = std::vector<std::string>;

class Mutators : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        std::filesystem::copy(assets(), folder_, std::filesystem::copy_options::recursive);
    }

    void write(const std::string& name, const std::string& lines) {
        ASSERT_TRUE(write_text_file(folder_ / "mutators" / (name + ".toml"),
                                    "version = 1\nname = \"X\"\nwords = \"Y\"\n" + lines));
    }
    Expected<MatchData> load(Names mutators, Names overrides = {}) {
        return load_match_data(folder_, {.mutators = std::move(mutators), .overrides = std::move(overrides)});
    }
    std::string refusal(Names mutators) { return message_of(load(std::move(mutators))); }

    const TemporaryFolder temporary_;
    const std::filesystem::path folder_ = temporary_.path() / "assets";
};

TEST_F(Mutators, TheShippedOnesLoadAloneAndTogether) {
    Names names;
    for (const auto& one : list_mutators(folder_)) {
        ASSERT_TRUE(one.file) << one.file.error().message;
        EXPECT_TRUE(load({one.name})) << refusal({one.name});
        names.push_back(one.name);
    }
    EXPECT_EQ(names, (Names{"everything_heavy", "fog", "glass_wizards", "low_gravity", "one_wand"}));
    const auto data = load({"low_gravity", "glass_wizards", "one_wand", "fog"}).value();
    EXPECT_EQ(data.wizard.gravity, 3.7);
    EXPECT_EQ(data.wizard.health, 25);
    for (const auto& wand : data.wands)
        EXPECT_EQ(wand.stats.energy_cost <= wand.stats.energy_cap, wand.kind->name == "bolt")
            << wand.kind->name;
    EXPECT_EQ(load({}).value().overrides, Names());
}

TEST_F(Mutators, AreAppliedBeforeTheOptionSet) {
    const auto data = load({"glass_wizards"}, {"wizard.health.start=30"}).value();
    EXPECT_EQ(data.wizard.health, 30);
    EXPECT_EQ(data.overrides,
              (Names{"wizard.health.start=25", "wizard.health.cap=40", "wizard.health.start=30"}));
}

TEST_F(Mutators, TwoThatContradictEachOtherAreRefused) {
    EXPECT_EQ(
        refusal({"low_gravity", "everything_heavy"}),
        "assets/mutators/everything_heavy.toml:6: the mutator 'everything_heavy' sets "
        "'wizard.gravity_m_s2' to 19.62, and assets/mutators/low_gravity.toml:6 sets it to 3.7; choose one "
        "of the two mutators");
    write("same", "[[override]]\nset = \"wizard.gravity_m_s2=3.70\"\n");
    EXPECT_TRUE(load({"low_gravity", "same"})) << "equal values do not contradict each other";
}

TEST_F(Mutators, MistakesAreToldWithFileLineAndKey) {
    EXPECT_NE(
        refusal({"low_grvity"}).find("there is no mutator 'low_grvity'; there are: everything_heavy, fog"),
        std::string::npos);
    EXPECT_NE(refusal({"low_grvity"}).find("did you mean 'low_gravity'?"), std::string::npos);
    EXPECT_EQ(refusal({"fog", "fog"}), "the mutator 'fog' is chosen twice");
    write("no_key", "[[override]]\nset = \"wizard.health.strat=3\"\n");
    EXPECT_EQ(refusal({"no_key"})
                  .find("assets/mutators/no_key.toml:5: 'wizard.health.strat=3': "
                        "assets/wizards/wizard.toml: has no key 'health.strat'"),
              0U)
        << refusal({"no_key"});
    write("no_file", "[[override]]\nset = \"wizzard.health.start=3\"\n");
    EXPECT_EQ(refusal({"no_file"}).find("assets/mutators/no_file.toml:5: 'wizzard.health.start=3': must be"),
              0U)
        << refusal({"no_file"});
    write("twice", "[[override]]\nset = \"fog.focus=3\"\n[[override]]\nset = \"fog.focus=4\"\n");
    EXPECT_EQ(refusal({"twice"}), "assets/mutators/twice.toml:7: 'set' sets 'fog.focus' a second time");
    write("nothing", "");
    EXPECT_NE(refusal({"nothing"}).find("at least one [[override]]"), std::string::npos);
    write("unclear", "[[override]]\nset = \"fog\"\n");
    EXPECT_EQ(
        refusal({"unclear"}).find("assets/mutators/unclear.toml:5: 'set' is 'fog', must be FILE.KEY=VALUE"),
        0U);
    write("typo", "[[overide]]\nset = \"fog.focus=3\"\n");
    EXPECT_NE(refusal({"typo"}).find("'overide'"), std::string::npos) << refusal({"typo"});
    write("out_of_range", "[[override]]\nset = \"wizard.gravity_m_s2=-1\"\n");
    EXPECT_NE(refusal({"out_of_range"}).find("'gravity_m_s2' is -1"), std::string::npos);
    std::filesystem::remove_all(folder_ / "mutators");
    EXPECT_TRUE(list_mutators(folder_).empty());
    EXPECT_EQ(refusal({"fog"}), "there is no mutator 'fog'; there are: none");
}

TEST_F(Mutators, ALogHasTheirNamesAndReplaysTheirOverridesWithoutTheirFiles) {
    const auto data = std::make_shared<const MatchData>(load({"low_gravity"}, {"quick.kills=1"}).value());
    auto duel = make_bot_duel(folder_, data, {"level_3", "level_3"}, 5).value();
    const auto file = folder_.parent_path() / "log.thaumlog";
    (void)input::remove_log(file);
    auto log = input::LogWriter::create(file, log_header(*data, duel.match->setup(), {"bot", "bot"})).value();
    for (Tick t = 0; t < ticks(4.0); ++t) tick_and_record(*duel.match, duel.next_frame(), &log);
    ASSERT_TRUE(close_log(log, *duel.match));
    std::filesystem::remove_all(folder_ / "mutators");
    auto again = Playback::open(file, folder_).value();
    const auto& header = again.log().header();
    EXPECT_EQ(header.parameters, (Names{"match=quick", "mutator=low_gravity"}));
    EXPECT_EQ(header.overrides.front(), "wizard.gravity_m_s2=3.7");
    ASSERT_TRUE(again.play_to(ticks(4.0)));
    EXPECT_EQ(again.match().state_hash(), duel.match->state_hash());
}

}  // namespace
}  // namespace thaum::game::test
