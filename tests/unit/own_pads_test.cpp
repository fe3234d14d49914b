// Tests of the file of joystick mappings that players have made.
#include "game/settings/own_pads.h"

#include <gtest/gtest.h>

#include "core/file.h"
#include "core/text.h"

namespace thaum::game {
namespace {

constexpr auto one = "0a000000aabb00001122000001000000", two = "0b000000aabb00001122000001000000";

using Lines = std::vector<std::string>;

class OwnPadsTest : public testing::Test {
protected:
    OwnPads load(std::string_view words) const {
        EXPECT_TRUE(write_text_file(file_, words));
        return load_own_pads(file_);
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "pads.txt";
};

TEST_F(OwnPadsTest, AMappingReplacesThatOfItsModelAndLeavesTheRest) {
    const auto file = own_pads_file(folder_.path() / "thaum" / "settings.toml");
    EXPECT_EQ(file.filename(), "pads.txt");
    EXPECT_TRUE(load_own_pads(file).mappings.empty()) << "no file, no mappings";
    ASSERT_TRUE(save_own_pad(file, text(one, ",One,a:b0,platform:Linux,")));
    ASSERT_TRUE(save_own_pad(file, text(two, ",Two,a:b1,platform:Linux,")));
    ASSERT_TRUE(save_own_pad(file, text(one, ",One,a:b2,platform:Linux,")));
    EXPECT_EQ(load_own_pads(file).mappings,
              (Lines{text(two, ",Two,a:b1,platform:Linux,"), text(one, ",One,a:b2,platform:Linux,")}));
    EXPECT_TRUE(read_text_file(file, 10'000)->starts_with('#'));
    ASSERT_TRUE(forget_own_pad(file, two));
    EXPECT_EQ(load_own_pads(file).mappings, (Lines{text(one, ",One,a:b2,platform:Linux,")}));
    ASSERT_TRUE(forget_own_pad(file, "0A000000AABB00001122000001000000"));
    EXPECT_TRUE(load_own_pads(file).mappings.empty());
}

TEST_F(OwnPadsTest, LinesOfAnyEditorAreReadAndKept) {
    const auto words = text("\xef\xbb\xbf  ", one, ",One,a:b0,\r\n\r\n\t# Linux\r\n", two,
                            ",Two, a:b1 ,platform:Windows,\n", two, ",Two,leftx:-a3~,+lefty:h0.4\n",
                            "0B000000AABB00001122000001000000,Two,b:b9,platform:linux,");
    const auto own = load(words);
    EXPECT_EQ(own.faults, Lines{});
    EXPECT_EQ(own.mappings,
              (Lines{text(one, ",One,a:b0,"), "0B000000AABB00001122000001000000,Two,b:b9,platform:linux,"}))
        << "the last line for a pad counts";
    ASSERT_TRUE(save_own_pad(file_, text(two, ",New,a:b1,")));
    EXPECT_EQ(*read_text_file(file_, 10'000), text("  ", one, ",One,a:b0,\r\n\r\n\t# Linux\r\n", two,
                                                   ",Two, a:b1 ,platform:Windows,\n", two, ",New,a:b1,\n"));
}

TEST_F(OwnPadsTest, AFaultyLineIsLeftOutAndToldWithItsPlace) {
    const std::string control_character = text(one, ",One\x1b,a:b0,");
    for (const auto& [line, words] : std::vector<std::pair<std::string, std::string>>{
             {"rubbish", "'rubbish' is no mapping of a pad: "},
             {",,,", "',,,' is no mapping of a pad: "},
             {"0a0b,One,a:b0,", "'0a0b,One,a:b0,' is no mapping of a pad: "},
             {control_character, "is no mapping of a pad: "},
             {text(one, ",One,platform:Linux,"), "maps no control of a pad"},
             {one, "maps no control of a pad"},
             {text(one, ",One,leftX:a0,"), "maps no control of a pad"},
             {text(one, ",One,a:zz,"), "'a:zz' must be a control and a part of the joystick"},
             {text(one, ",One,a:b0,b"), "'b' must be"},
             {text(one, ",One,a:b1000,"), "'a:b1000' must be"},
             {text(one, ",One,a:", std::string(5000, 'b'), ","), "'a:bbb"}}) {
        const auto own = load(text("# mine\n", line, "\n", two, ",Two,a:b1,\n"));
        EXPECT_EQ(own.mappings, (Lines{text(two, ",Two,a:b1,")})) << line;
        ASSERT_EQ(own.faults.size(), 1U) << line;
        EXPECT_TRUE(own.faults[0].starts_with(text(file_.string(), ":2: "))) << own.faults[0];
        EXPECT_NE(own.faults[0].find(words), std::string::npos) << own.faults[0];
        EXPECT_LT(own.faults[0].size(), 400U + file_.string().size());
    }
    const auto own = load(std::string(100'000, '\n') + std::string("x\ny\nz\nu\nv\nw\n"));
    ASSERT_EQ(own.faults.size(), 6U);
    EXPECT_EQ(own.faults.back(), text(file_.string(), ": 1 more line is faulty"));
}

TEST_F(OwnPadsTest, ALongMappingIsTaken) {
    std::string line = text(two, ",", std::string(4000, 'n'), ",");
    for (int i = 0; i < 300; ++i) line += text("paddle", i, ":b", i, ",");
    EXPECT_EQ(load(line + "a:b1,").mappings, (Lines{line + "a:b1,"}));
}

TEST_F(OwnPadsTest, FaultsOfTheFileAreTold) {
    EXPECT_EQ(load_own_pads(folder_.path()).faults.size(), 1U) << "a folder";
    EXPECT_TRUE(load_own_pads({}).mappings.empty() && load_own_pads({}).faults.empty());
    EXPECT_FALSE(save_own_pad({}, text(one, ",One,a:b0,")));
    EXPECT_FALSE(save_own_pad(folder_.path(), text(one, ",One,a:b0,")));
    EXPECT_TRUE(own_pads_file({}).empty());
    // A file that cannot be read is not overwritten.
    const std::string large(std::size_t{2} << 20U, '#');
    ASSERT_TRUE(write_text_file(file_, large));
    EXPECT_FALSE(save_own_pad(file_, text(one, ",One,a:b0,")));
    EXPECT_EQ(std::filesystem::file_size(file_), large.size());
}

}  // namespace
}  // namespace thaum::game
