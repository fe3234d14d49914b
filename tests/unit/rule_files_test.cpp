// Tests of the files of assets/rules: which are rule sets, and which are lengths of a match.
#include "game/data/rule_files.h"

#include <gtest/gtest.h>

#include "core/file.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

using Names = std::vector<std::string>;

TEST(RuleFiles, AreToldApartByTheirKeys) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "thaum_rule_files" / "assets";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::filesystem::copy(assets(), folder, std::filesystem::copy_options::recursive);
    EXPECT_EQ(rule_sets(folder), (Names{"classic", "thaum"}));
    EXPECT_EQ(match_lengths(folder), (Names{"quick", "standard"}));
    const auto rules = folder / "rules";
    std::filesystem::copy_file(rules / "classic.toml", rules / "mild.toml");
    std::filesystem::copy_file(rules / "quick.toml", rules / "blink.toml");
    ASSERT_TRUE(write_text_file(rules / "broken.toml", "version = 1\nkills =\n"));
    ASSERT_TRUE(write_text_file(rules / "Odd Name.toml", "version = 1\n"));
    EXPECT_EQ(rule_sets(folder), (Names{"classic", "mild", "thaum"}));
    EXPECT_EQ(match_lengths(folder), (Names{"blink", "broken", "quick", "standard"}));
    const auto data = load_match_data(folder, {.rules = "mild", .match = "blink"}).value();
    EXPECT_FALSE(data.rules.cauldron);
    EXPECT_EQ(message_of(load_match_data(folder, {.rules = "quick"})),
              "there is no rule set 'quick'; there are: classic, mild, thaum");
    EXPECT_EQ(message_of(load_match_data(folder, {.rules = "clasic"})),
              "there is no rule set 'clasic'; there are: classic, mild, thaum; did you mean 'classic'?");
    EXPECT_EQ(message_of(load_match_data(folder, {.match = "thaum"})).find("there is no match 'thaum'"), 0U);
    std::filesystem::remove_all(rules);
    EXPECT_NE(message_of(load_match_data(folder, {})).find("there is no rule set 'thaum'; there are: none"),
              std::string::npos);
}

}  // namespace
}  // namespace thaum::game::test
