// Tests of bots' files: a base from which a file takes what it does not say, and the mistakes in it.
#include "game/bots/bot_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "core/file.h"
#include "core/text.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

/// Whether all numbers of two skills are equal. A skill has no padding.
bool is_equal(const BotSkill& a, const BotSkill& b) {
    return std::ranges::equal(std::as_bytes(std::span(&a, 1)), std::as_bytes(std::span(&b, 1)));
}

class BotFiles : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(assets_);
        std::filesystem::copy(THAUM_SOURCE_DIR "/assets/bots", assets_ / "bots",
                              std::filesystem::copy_options::recursive);
    }

    void write(const std::string& name, const std::string& lines) {
        ASSERT_TRUE(write_text_file(assets_ / "bots" / text(name, ".toml"), text("version = 1\n", lines)));
    }
    std::string refusal(const std::string& name) { return message_of(load_bot(assets_, name)); }

    const TemporaryFolder temporary_;
    const std::filesystem::path assets_ = temporary_.path() / "assets";
};

TEST_F(BotFiles, AFileHasOnlyWhatDiffersFromItsBase) {
    write("brewer",
          "base = \"level_3\"\nname = \"Brewer\"\nstyle = \"alchemist\"\nkeep_m = 11\n[stir]\nbrew = 0.9\n");
    write("calm_brewer", "base = \"brewer\"\nlevel = 2\ndodges = false\narcs = false\n");
    const auto expert = load_bot(assets_, "level_3").value(), brewer = load_bot(assets_, "brewer").value();
    EXPECT_EQ(brewer.shown, "Brewer");
    EXPECT_EQ(brewer.style, "alchemist");
    EXPECT_EQ(brewer.words, expert.words);
    auto same = expert.skill;
    same.keep = 11;
    same.stir.brew = 0.9;
    EXPECT_TRUE(is_equal(brewer.skill, same));
    same.level = 2;
    same.dodges = same.arcs = 0;
    same.throws = same.over_cover = 0;
    EXPECT_TRUE(is_equal(load_bot(assets_, "calm_brewer").value().skill, same));
}

TEST_F(BotFiles, AreListedByLevelThenNameAndFoundByEither) {
    write("another", "base = \"level_2\"\n");
    write("zealot", "base = \"level_2\"\n");
    write("odd", "base = \"level_2\"\nkep_m = 3\n");
    std::vector<std::string> names;
    for (const auto& bot : list_bots(assets_)) names.push_back(bot.name);
    EXPECT_EQ(names, (std::vector<std::string>{"level_0", "level_1", "another", "level_2", "zealot",
                                               "level_3", "odd"}));
    EXPECT_EQ(bot_named(assets_, "2").value(), "another");
    EXPECT_EQ(bot_named(assets_, "zealot").value(), "zealot");
    EXPECT_EQ(strongest_bot(assets_).value(), "level_3");
    EXPECT_NE(message_of(bot_named(assets_, "levl_2")).find("there is no bot 'levl_2'; there are: level_0"),
              std::string::npos);
    EXPECT_NE(message_of(bot_named(assets_, "../bots/level_2")).find("there is no bot"), std::string::npos);
}

TEST_F(BotFiles, MistakesInABaseAreToldAtTheirLine) {
    write("typo", "name = \"Typo\"\nbase = \"levle_2\"\n");
    EXPECT_EQ(refusal("typo"),
              "assets/bots/typo.toml:3: 'base' is 'levle_2', but there is no bots/levle_2.toml; did you mean "
              "'level_2'?");
    write("outside", "base = \"../range\"\n");
    EXPECT_EQ(refusal("outside").find("assets/bots/outside.toml:2: 'base' is '../range', but there is no"),
              0U);
    write("a", "base = \"b\"\n");
    write("b", "\nbase = \"a\"\n");
    EXPECT_EQ(refusal("a"), "assets/bots/b.toml:3: 'base' is 'a', which is based on 'b'");
    write("self", "base = \"self\"\n");
    EXPECT_EQ(refusal("self"), "assets/bots/self.toml:2: 'base' is 'self', which is based on 'self'");
    write("wrong_base", "base = \"level_2\"\nlead = 7\n");
    write("above", "base = \"wrong_base\"\n");
    EXPECT_EQ(refusal("above").find("assets/bots/wrong_base.toml:3: 'lead' is 7"), 0U) << refusal("above");
    write("wrong_key", "base = \"level_2\"\n[stir]\nbrow = 0.5\n");
    EXPECT_EQ(refusal("wrong_key").find("assets/bots/wrong_key.toml:"), 0U) << refusal("wrong_key");
    EXPECT_NE(refusal("wrong_key").find("brow"), std::string::npos);
    write("number", "base = 3\n");
    EXPECT_EQ(refusal("number").find("assets/bots/number.toml:2: 'base' must be a text"), 0U);
}

TEST_F(BotFiles, TooLongAChainOfBasesIsRefused) {
    write("chain_0", "base = \"level_3\"\n");
    for (std::size_t i = 1; i <= most_bases; ++i)
        write(text("chain_", i), text("base = \"chain_", i - 1, "\"\n"));
    EXPECT_TRUE(load_bot(assets_, text("chain_", most_bases - 1)));
    EXPECT_NE(refusal(text("chain_", most_bases)).find(text("has more than ", most_bases, " bases")),
              std::string::npos);
}

TEST_F(BotFiles, WordsForTheScreenAreChecked) {
    write("long", "base = \"level_1\"\nname = \"A name of more letters\"\n");
    EXPECT_EQ(refusal("long"), "assets/bots/long.toml:3: 'name' must be a text of 1 to 16 characters");
    write("style", "base = \"level_1\"\nstyle = \"brawller\"\n");
    EXPECT_NE(refusal("style").find("did you mean 'brawler'?"), std::string::npos);
    std::filesystem::remove_all(assets_ / "bots");
    EXPECT_TRUE(list_bots(assets_).empty());
    EXPECT_NE(message_of(strongest_bot(assets_)).find("the folder has no bot"), std::string::npos);
}

}  // namespace
}  // namespace thaum::game
