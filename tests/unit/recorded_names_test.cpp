// Tests of the players' names in a log: a replay shows the same names as the match.
#include "game/settings/recorded_names.h"

#include "game/bots/bot.h"
#include "game/match/record.h"
#include "unit/live_session_rig.h"

namespace thaum::game {
namespace {

using game::PlayerNames;

class RecordedNames : public LiveSessionTest {};

TEST_F(RecordedNames, TheLogOfAMatchHasTheNamesOfItsScreen) {
    plan_.settings.players[0].name = "Jos\u00e9";
    plan_.seats = {rig::mouse_seat, live::Seat{.kind = SeatKind::bot, .bot = "level_3"}};
    begin();
    step();
    const auto header = session_->log_header(7);
    EXPECT_EQ(header.players, (std::vector<std::string>{"human", "bot level_3"}));
    EXPECT_EQ(recorded_names(header), screen().hud.names);
    EXPECT_EQ(recorded_names(header), (PlayerNames{"Jos\u00e9", "Expert"}));
}

TEST_F(RecordedNames, AMatchWithoutNamesHasNoneInItsLog) {
    plan_.seats = {rig::bot_seat, rig::bot_seat};
    begin();
    EXPECT_TRUE(session_->log_header(7).names.empty());
    EXPECT_EQ(recorded_names(session_->log_header(7)), PlayerNames());
}

TEST_F(RecordedNames, ABotOfAnOlderLogHasItsLevelAgainstAPersonOnly) {
    const auto names = [](std::vector<std::string> players) {
        input::LogHeader header;
        header.players = std::move(players);
        return recorded_names(header);
    };
    EXPECT_EQ(names({"human", "bot 3"}), (PlayerNames{"", "Bot 3"}));
    EXPECT_EQ(names({"bot 0", "human"}), (PlayerNames{"Bot 0", ""}));
    EXPECT_EQ(names({"bot 1", "bot 3"}), PlayerNames());
    EXPECT_EQ(names({"human", "bot \n1"}), PlayerNames());
    EXPECT_EQ(names({"human", "bot 12345678"}), PlayerNames());
    EXPECT_EQ(names({"human"}), PlayerNames());
    EXPECT_EQ(names({}), PlayerNames());
}

TEST_F(RecordedNames, NamesThatNoPlayerCouldHaveAreLeftOut) {
    input::LogHeader header;
    header.players = {"human", "human", "human"};
    header.names = {std::string(10'000, 'a'), "two\nlines", "third"};
    EXPECT_EQ(recorded_names(header), PlayerNames());
    header.names = {"Ada"};
    EXPECT_EQ(recorded_names(header), (PlayerNames{"Ada", ""}));
}

}  // namespace
}  // namespace thaum::game
