// Tests of the file of mappings that players have made.
#include "game/settings/own_pads.h"

#include <gtest/gtest.h>

#include "core/file.h"

namespace thaum::app {
namespace {

TEST(OwnPads, AMappingReplacesThatOfItsModelAndLeavesTheRest) {
    const TemporaryFolder folder;
    const auto file = own_pads_file(folder.path() / "thaum" / "settings.toml");
    EXPECT_EQ(file.filename(), "pads.txt");
    EXPECT_TRUE(load_own_pads(file).value().empty()) << "no file, no mappings";
    ASSERT_TRUE(save_own_pad(file, "0a,One,a:b0,platform:Linux,"));
    ASSERT_TRUE(save_own_pad(file, "0b,Two,a:b1,platform:Linux,"));
    ASSERT_TRUE(save_own_pad(file, "0a,One,a:b2,platform:Linux,"));
    EXPECT_EQ(load_own_pads(file).value(),
              (std::vector<std::string>{"0b,Two,a:b1,platform:Linux,", "0a,One,a:b2,platform:Linux,"}));
    // Lines of gamecontrollerdb.txt that somebody has added.
    const auto words = read_text_file(file, 10'000).value();
    ASSERT_TRUE(write_text_file(folder.path() / "other.txt", words + "\n# Linux\r\n0c,Three,a:b3,\r\n"));
    EXPECT_EQ(load_own_pads(folder.path() / "other.txt").value().back(), "0c,Three,a:b3,");
    EXPECT_TRUE(words.starts_with('#'));
}

TEST(OwnPads, FaultsAreErrors) {
    const TemporaryFolder folder;
    EXPECT_FALSE(load_own_pads(folder.path())) << "a folder";
    EXPECT_TRUE(load_own_pads({}).value().empty());
    EXPECT_FALSE(save_own_pad({}, "0a,One,a:b0,"));
    EXPECT_TRUE(own_pads_file({}).empty());
}

}  // namespace
}  // namespace thaum::app
