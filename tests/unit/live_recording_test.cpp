// Tests of where the logs of a session's matches are stored, and of the data for the next match.
#include "game/live/recording.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/file.h"
#include "game/live/next_match.h"
#include "unit/live_rig.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

namespace fs = std::filesystem;

class RecordingTest : public testing::Test {
protected:
    RecordingTest() {
        fs::create_directories(folder_);
        header_.players = {"human", "bot 1"};
        header_.devices.resize(2);
    }

    /// Records a match without ticks. Returns the message of an error, or an empty string.
    std::string record(const LogPlace& place, std::uint64_t number) const {
        return message_of(record_match(place, number, header_));
    }
    std::vector<std::string> logs() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    }
    using Names = std::vector<std::string>;

    const rig::TestPath path_{"recordings"};
    const fs::path& folder_ = path_.path;
    const LogPlace named_{.named = folder_ / "duel.thaumlog"};
    input::LogHeader header_;
};

TEST_F(RecordingTest, TheFirstMatchGetsTheNameOfTheUser) {
    EXPECT_EQ(record(named_, 1), "");
    EXPECT_EQ(logs(), Names{"duel.thaumlog"});
    EXPECT_NE(record(named_, 1).find("duel.thaumlog"), std::string::npos) << "the name is taken";
    EXPECT_EQ(logs(), Names{"duel.thaumlog"});
}

TEST_F(RecordingTest, LaterMatchesLieBesideItWithTheNextFreeNumber) {
    EXPECT_EQ(record(named_, 1), "");
    EXPECT_EQ(record(named_, 2), "");
    EXPECT_EQ(record(named_, 3), "");
    EXPECT_EQ(logs(), (Names{"duel-2.thaumlog", "duel-3.thaumlog", "duel.thaumlog"}));
}

TEST_F(RecordingTest, TheFolderGetsOneLogAMatchAndKeepsTheNewest) {
    const LogPlace place{.folder = folder_ / "matches", .kept = 2};
    for (std::uint64_t number = 1; number <= 4; ++number) EXPECT_EQ(record(place, number), "");
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / "matches"))
        count += entry.path().extension() == ".thaumlog" ? 1 : 0;
    EXPECT_EQ(count, 2U);
}

TEST_F(RecordingTest, WithoutAPlaceNothingIsRecorded) {
    const auto recording = record_match({}, 1, header_).value();
    EXPECT_TRUE(std::holds_alternative<std::monostate>(recording));
    const auto log = record_match(named_, 1, header_).value();
    EXPECT_TRUE(std::holds_alternative<input::LogWriter>(log));
}

TEST_F(RecordingTest, AFolderThatCannotBeMadeIsAnError) {
    ASSERT_TRUE(write_text_file(folder_ / "file", "not a folder"));
    EXPECT_NE(record({.folder = folder_ / "file" / "matches"}, 1), "");
}

// ---- data for the next match ------------------------------------------------------------------------------

class NextMatchTest : public testing::Test {
protected:
    NextMatchTest() {
        fs::copy(THAUM_SOURCE_DIR "/assets", folder_, fs::copy_options::recursive);
        next_.emplace(folder_,
                      std::make_shared<const game::MatchData>(game::load_match_data(folder_, {}).value()));
    }

    const rig::TestPath path_{"assets"};
    const fs::path& folder_ = path_.path;
    std::optional<NextMatch> next_;
};

TEST_F(NextMatchTest, ReadsTheChosenFiles) {
    ASSERT_TRUE(next_->choose("standard", "the_well"));
    EXPECT_EQ(next_->data()->choice.match, "standard");
    EXPECT_EQ(next_->data()->choice.arena, "the_well");
    EXPECT_EQ(next_->data()->round.kills, 5U);
}

TEST_F(NextMatchTest, AFaultyFileIsNamedAndTheOldDataStays) {
    const auto before = next_->data();
    std::ofstream(folder_ / "rules" / "quick.toml") << "version = 1\nkills = \"many\"\n";
    const auto message = message_of(next_->choose("quick", "boiling_court"));
    EXPECT_NE(message.find("quick.toml"), std::string::npos) << message;
    EXPECT_EQ(next_->data(), before);
}

TEST_F(NextMatchTest, PracticeIsForOneMatch) {
    EXPECT_FALSE(next_->is_practice());
    EXPECT_FALSE(next_->take_range());
    ASSERT_TRUE(next_->open_range());
    EXPECT_TRUE(next_->is_practice());
    EXPECT_TRUE(next_->take_range());
    EXPECT_FALSE(next_->is_practice());
    std::ofstream(folder_ / "range.toml") << "version = 1\n";
    EXPECT_FALSE(next_->open_range());
    EXPECT_FALSE(next_->is_practice());
}

}  // namespace
}  // namespace thaum::game
