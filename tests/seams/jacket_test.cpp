// Adds a maker of tactile jackets (here of drums) by this source file alone, without a change of the game's
// files. The makers of the game are in game/jackets/makers/NAME.cpp.
#include <gtest/gtest.h>

#include <thread>

#include "core/text.h"
#include "game/jackets/jacket.h"
#include "game/live/tactile.h"
#include "unit/felt_output_rig.h"
#include "unit/jacket_rig.h"

namespace thaum::game {
namespace {

/// Frames that the drum has got. All jackets of this maker share one drum.
const std::shared_ptr<input::rig::Felt>& drum() {
    static const auto felt = std::make_shared<input::rig::Felt>();
    return felt;
}

Expected<std::string> read_drum(std::string_view word, std::string_view place) {
    if (place == "left" || place == "right") return std::string(place);
    return fail(text("write \"", word, ":left\" or \"", word, ":right\""));
}

const JacketRegistration registration_of_drum(
    {.name = "drum",
     .forms = {{"drum", {"x16", 16}}},
     .shown = {"drum:SIDE"},
     .read = read_drum,
     .make = [](const Jacket&, std::uint32_t) -> std::unique_ptr<input::TactileOutput> {
         return std::make_unique<input::rig::FakeOutput>(drum());
     },
     .find =
         [] {
             return std::vector<FoundJacket>{{"drum", "\"drum:left\" is there"}};
         }});

std::string fault_of_settings(std::string_view first, std::string_view second) {
    const auto read = read_settings(
        text("version = 1\n[player_1]\njacket = \"", first, "\"\n[player_2]\njacket = \"", second, "\"\n"),
        "s");
    return read && read->fault ? read->fault->message : std::string();
}

TEST(NewJacket, TheSettingsKnowIt) {
    EXPECT_EQ(fault_of_settings("drum:left", "drum:right"), "");
    EXPECT_EQ(fault_of_settings("drum:left", "drum:left"),
              "s:5: 'jacket': it is player 1's; give each player another");
    EXPECT_EQ(fault_of_settings("drum:top", ""),
              "s:3: 'jacket': 'drum:top' is no jacket: write \"drum:left\" or \"drum:right\"");
    EXPECT_NE(fault_of_settings("drum", "").find("\"record:FILE.csv\" or \"drum:SIDE\""), std::string::npos);
    EXPECT_EQ(jacket_makers().back().find().front().words, "\"drum:left\" is there");
}

TEST(NewJacketThreads, AMatchIsFeltOnIt) {
    LiveTactile tactile([](const input::PadState&) { return nullptr; });
    Settings settings;
    settings.players[1].jacket = "drum:left";
    tactile.apply(settings);
    while (tactile.jacket_layout(1) != "x16") std::this_thread::yield();
    tactile.feel_jacket(1, input::rig::jacket_frame(16, {{3, 1.0F}}, 500));
    drum()->wait([&] { return !drum()->frames.empty(); });
    EXPECT_EQ(drum()->with([&] { return drum()->frames[0].amplitude[3]; }), 1);
}

}  // namespace
}  // namespace thaum::game
