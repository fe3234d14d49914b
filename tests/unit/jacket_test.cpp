// Tests of the players' jackets: the words of the setting, which player has which jacket, and that each
// jacket gets its own player's frames. Tests wait for the threads' actions, not for a fixed time.
#include "game/jackets/jacket.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <thread>

#include "core/file.h"
#include "core/text.h"
#include "game/jackets/net_address.h"
#include "game/jackets/osc_message.h"
#include "game/live/tactile.h"
#include "tactile/layout.h"
#include "unit/felt_output_rig.h"
#include "unit/udp_receiver.h"

namespace thaum::game {
namespace {

using input::rig::FakeOutput;
using input::rig::Felt;
using input::rig::jacket_frame;
using input::rig::UdpReceiver;

/// Maker, layout and place of a jacket, in one line.
std::string read_as(std::string_view words) {
    const auto jacket = parse_jacket(words);
    if (!jacket) return jacket.error().message;
    return *jacket ? text(jacket->maker->name, " ", jacket->layout().name, " ", jacket->place) : "none";
}

TEST(Jacket, WordsOfTheSettingAreRead) {
    EXPECT_EQ(read_as(""), "none");
    EXPECT_EQ(read_as("osc:192.168.1.7:1027"), "osc x40 192.168.1.7:1027");
    EXPECT_EQ(read_as("bhaptics"), "bhaptics x40 127.0.0.1:15881");
    EXPECT_EQ(read_as("bhaptics:box:2"), "bhaptics x40 box:2");
    EXPECT_EQ(read_as("osc16:my-vest_2.local:65535"), "osc x16 my-vest_2.local:65535");
    EXPECT_EQ(read_as("osc:[fe80::1%eth0]:1"), "osc x40 [fe80::1%eth0]:1");
    EXPECT_EQ(read_as("osc:[vest]:01"), "osc x40 vest:1") << "one place, one name";
    EXPECT_EQ(read_as("osc:[vest%eth0]:1"), "osc x40 [vest%eth0]:1");
    EXPECT_EQ(read_as("hid:1209:C0de"), "hid x40 1209:c0de");
    EXPECT_EQ(read_as("audio"), "audio speakers ");
    EXPECT_EQ(read_as("audio8"), "audio shakers8 ");
    EXPECT_EQ(read_as("audio:Box: 7.1 (left)"), "audio speakers Box: 7.1 (left)");
    EXPECT_EQ(read_as("audio8:Box"), "audio shakers8 Box");
    EXPECT_EQ(read_as("record:/tmp/felt.csv"), "recorder abstract_4x5 /tmp/felt.csv");
}

TEST(Jacket, WordsOfNoFormAreAnsweredWithAllForms) {
    EXPECT_EQ(read_as("drum:1"),
              "'drum:1' is no jacket: use \"\", \"bhaptics\", \"osc:HOST:PORT\", \"osc16:HOST:PORT\", "
              "\"hid:VVVV:PPPP\", \"audio\", \"audio8\", \"audio:DEVICE\" or \"record:FILE.csv\"");
}

/// All quoted words of a file between the texts `from` and `to`.
std::vector<std::string> quoted_in(const std::string& file, std::string_view from, std::string_view to) {
    const auto all = read_text_file(std::string(THAUM_SOURCE_DIR) + file, 1U << 20U).value_or("");
    const auto begin = all.find(from);
    std::istringstream part(all.substr(begin, all.find(to, begin) - begin));
    std::vector<std::string> words;
    for (std::string word; std::getline(part, word, '"') && std::getline(part, word, '"');)
        if (!word.empty()) words.push_back(word);
    return words;
}

TEST(Jacket, TheManualAndTheSettingsFileNameFormsThatThereAre) {
    auto words = quoted_in("/assets/settings.toml", "jacket = \"\"", "\njacket_layout");
    const auto table = quoted_in("/game/MANUAL.md", "| `jacket = ` |", "\n\n");
    EXPECT_EQ(words.size(), 8U);
    EXPECT_EQ(table.size(), 6U);
    words.insert(words.end(), table.begin(), table.end());
    for (const auto& one : words) {
        const auto word = one.substr(0, one.find(':'));
        EXPECT_TRUE(std::ranges::any_of(jacket_makers(), [&](const JacketMaker& maker) {
            return std::ranges::find(maker.forms, word, &JacketForm::word) != maker.forms.end();
        })) << one;
    }
}

constexpr const char* no_jackets[] = {"osc",
                                      "osc:",
                                      "osc:vest",
                                      "osc:vest:",
                                      "osc:vest:0",
                                      "osc:vest:65536",
                                      "osc:vest:-1",
                                      "osc:vest:+1",
                                      "osc:vest: 1",
                                      "osc::1",
                                      "osc:[]:1",
                                      "osc:::1:1027",
                                      "osc:a b:1",
                                      "osc:a\n:1",
                                      "osc:\xFF:1",
                                      "osc:a\":1",
                                      "OSC:vest:1",
                                      "osc17:vest:1",
                                      "none",
                                      " ",
                                      "bhaptics:",
                                      "bhaptics ",
                                      "hid",
                                      "hid:",
                                      "hid:1209",
                                      "hid:1209:",
                                      "hid:1209:c0d",
                                      "hid:12090:c0de",
                                      "hid:1209:c0de:1",
                                      "hid:0x12:c0de",
                                      "hid:-209:c0de",
                                      "audio:",
                                      "audio8:",
                                      "audio 8",
                                      "audio7:x",
                                      "audio:a\nb",
                                      "record",
                                      "record:",
                                      "record:.csv",
                                      "record:felt",
                                      "record:a/.csv",
                                      "record:a\n.csv"};

TEST(Jacket, WordsThatNameNoJacketAreRefusedInOneLine) {
    for (const auto* words : no_jackets) {
        const auto jacket = parse_jacket(words);
        ASSERT_FALSE(jacket) << words;
        EXPECT_EQ(jacket.error().message.find('\n'), std::string::npos);
        EXPECT_NE(jacket.error().message.find("is no jacket: "), std::string::npos);
    }
    EXPECT_FALSE(parse_jacket("osc:" + std::string(254, 'a') + ":1"));
    EXPECT_LT(parse_jacket(std::string(100'000, 'a')).error().message.size(), 300U);
}

TEST(Jacket, EachLayoutIsAShippedFileWithItsMotors) {
    for (const auto& layout : jacket_layouts()) {
        const auto file = std::filesystem::path(THAUM_SOURCE_DIR) / "assets/tactile/layouts" /
                          (std::string(layout.name) + ".toml");
        const auto read = tactile::load_layout(file).value();
        EXPECT_EQ(read.actuators.size(), layout.motors);
    }
    EXPECT_EQ(Jacket{}.layout().name, "");
    EXPECT_EQ(Jacket{}.layout().motors, 0U);
}

TEST(Jacket, AnOwnLayoutIsAFileWithNoMoreActuatorsThanTheJacketHasMotors) {
    const std::filesystem::path assets = THAUM_SOURCE_DIR "/assets";
    const auto load = [&](const char* jacket, const std::string& words) {
        return load_own_layout(words, parse_jacket(jacket).value(), assets);
    };
    for (const auto* jacket : {"osc:vest:1", "hid:1209:c0de", "bhaptics"}) {
        EXPECT_EQ(load(jacket, "sleeves").value().name, "suit with sleeves") << jacket;
        EXPECT_TRUE(load(jacket, (assets / "tactile/layouts/x16.toml").string()));
    }
    const auto fault = [&](const char* jacket, const std::string& words) {
        const auto read = load(jacket, words);
        EXPECT_FALSE(read) << jacket;
        return read ? std::string() : read.error().message;
    };
    EXPECT_NE(fault("osc16:vest:1", "x40").find("has 40 actuators, and the jacket 16 motors"),
              std::string::npos);
    EXPECT_NE(fault("audio8", "sleeves").find("8 motors"), std::string::npos);
    EXPECT_NE(fault("record:a.csv", "sleeves").find("the figure"), std::string::npos);
    EXPECT_NE(fault("bhaptics", "nowhere").find("nowhere.toml"), std::string::npos);
    EXPECT_NE(fault("bhaptics", "/").size(), 0U);
    EXPECT_NE(fault("bhaptics", (assets / "settings.toml").string()).find("settings.toml"),
              std::string::npos);
}

std::string fault_of(const std::string& file) {
    const auto read = read_settings(file, "settings.toml");
    return read && read->fault ? read->fault->message : "";
}

TEST(Jacket, TheSettingsFileRefusesNonsenseAndOneJacketForTwoPlayers) {
    EXPECT_EQ(
        fault_of("version = 1\n[player_1]\njacket = \"osc:vest\""),
        "settings.toml:3: 'jacket': 'osc:vest' is no jacket: write \"osc:HOST:PORT\", with a port of 1 to "
        "65535 and an IPv6 address in brackets");
    EXPECT_NE(fault_of("version = 1\n[player_1]\njacket = 7"), "");
    const auto both = [](std::string_view first, std::string_view second) {
        return text("version = 1\n[player_1]\njacket = \"", first, "\"\n[player_2]\njacket = \"", second,
                    "\"\n");
    };
    const auto shared = read_settings(both("osc:vest:1", "osc16:vest:1"), "s");
    ASSERT_TRUE(shared && shared->fault);
    EXPECT_EQ(shared->fault->message, "s:5: 'jacket': it is player 1's; give each player another");
    EXPECT_EQ(shared->settings.players[0].jacket, "osc:vest:1");
    EXPECT_EQ(shared->settings.players[1].jacket, "");
    EXPECT_TRUE(read_settings(both("hid:1209:c0de", "hid:1209:C0DE"), "s")->fault);
    EXPECT_TRUE(read_settings(both("audio:Box", "audio8:Box"), "s")->fault);
    EXPECT_TRUE(read_settings(both("record:a.csv", "record:a.csv"), "s")->fault);
    EXPECT_FALSE(read_settings(both("record:a.csv", "record:b.csv"), "s")->fault);
    const auto apart = read_settings(both("osc:vest:1", "osc:vest:2"), "s").value();
    EXPECT_FALSE(apart.fault);
    EXPECT_EQ(apart.settings.players[1].jacket, "osc:vest:2");
}

/// Fake jackets, by the port at which each receives.
class Jackets {
public:
    LiveTactile::MakeJacket maker() {
        return [this](const Jacket& jacket, std::uint32_t) -> std::unique_ptr<input::TactileOutput> {
            ++made;
            if (!jacket) return nullptr;
            return std::make_unique<FakeOutput>(of(read_address(jacket.place).value().port));
        };
    }
    const std::shared_ptr<Felt>& of(std::uint16_t port) {
        auto& felt = felt_[port];
        if (felt == nullptr) felt = std::make_shared<Felt>();
        return felt;
    }
    int made = 0;

private:
    std::map<std::uint16_t, std::shared_ptr<Felt>> felt_;
};

LiveTactile::MakeOutput no_pads() {
    return [](const input::PadState&) { return nullptr; };
}

TEST(LiveJacket, WithoutAJacketNothingRuns) {
    Jackets jackets;
    LiveTactile tactile(no_pads(), jackets.maker());
    tactile.apply(Settings{});
    tactile.feel_jacket(0, jacket_frame(40, {{0, 1.0F}}));
    tactile.tell_status();
    EXPECT_EQ(tactile.jacket_layout(0), "");
    EXPECT_EQ(jackets.made, 0);
    EXPECT_EQ(tactile.jacket_report(0).frames_lost, 0U) << "no thread was started";
}

TEST(LiveJacketThreads, AJacketIsConnectedChangedAndTakenAway) {
    Jackets jackets;
    const auto first = jackets.of(1), second = jackets.of(2);
    LiveTactile tactile(no_pads(), jackets.maker());
    Settings settings;
    settings.players[1].jacket = "osc:vest:1";
    for (int i = 0; i < 5; ++i) tactile.apply(settings);
    EXPECT_EQ(jackets.made, 1) << "nothing new is no change";
    while (tactile.jacket_layout(1) != "x40") std::this_thread::yield();
    EXPECT_EQ(tactile.jacket_layout(0), "");
    tactile.feel_jacket(1, jacket_frame(40, {{20, 1.0F}}, 500));
    first->wait([&] { return first->frames.size() == 1; });
    EXPECT_EQ(first->with([&] { return first->frames[0].amplitude[20]; }), 1);
    settings.players[1].jacket = "osc16:vest:2";
    tactile.apply(settings);
    first->wait([&] { return first->closed == 1; });
    second->wait([&] { return second->opened == 1; });
    while (tactile.jacket_layout(1) != "x16") std::this_thread::yield();
    tactile.feel_jacket(1, jacket_frame(40, {{20, 1.0F}}, 500));
    tactile.feel_jacket(1, jacket_frame(16, {{3, 1.0F}}, 500));
    second->wait([&] { return !second->frames.empty(); });
    EXPECT_EQ(second->with([&] { return second->frames[0].count; }), 16U) << "a frame of the former layout";
    settings.players[1].jacket.clear();
    tactile.apply(settings);
    second->wait([&] { return second->closed == 1; });
    EXPECT_FALSE(second->with([&] { return second->on; }));
    EXPECT_EQ(tactile.jacket_layout(1), "");
}

TEST(LiveJacketThreads, OneThatCannotBeOpenedCostsOneLineAndNoFrames) {
    Jackets jackets;
    const auto felt = jackets.of(1);
    felt->present = false;
    LiveTactile tactile(no_pads(), jackets.maker());
    Settings settings;
    settings.players[0].jacket = "osc:vest:1";
    tactile.apply(settings);
    felt->wait([&] { return felt->opened == 1; });
    std::string said;
    while (said.empty()) {
        testing::internal::CaptureStderr();
        tactile.tell_status();
        said = testing::internal::GetCapturedStderr();
    }
    EXPECT_EQ(said, "player 1: fake: it is not there\n");
    EXPECT_EQ(tactile.jacket_layout(0), "");
}

/// Passes tactile frames until the receiver has got a certain message.
bool reaches(LiveTactile& tactile, std::uint32_t player, UdpReceiver& receiver,
             const tactile::TactileFrame& frame) {
    const auto wanted = osc_message(frame, frame.count);
    for (int i = 0; i < input::rig::patience_ms; ++i) {
        tactile.feel_jacket(player, frame);
        if (receiver.next(1) == wanted) return true;
    }
    return false;
}

TEST(LiveJacketThreads, TwoPlayersHaveTwoJacketsOnTheWire) {
    UdpReceiver first, second;
    LiveTactile tactile(no_pads());
    Settings settings;
    settings.players[0].jacket = "osc:127.0.0.1:" + std::to_string(first.port());
    settings.players[1].jacket = "osc16:127.0.0.1:" + std::to_string(second.port());
    tactile.apply(settings);
    const auto large = jacket_frame(40, {{39, 1.0F}}, 500), small = jacket_frame(16, {{2, 0.5F}}, 500);
    EXPECT_TRUE(reaches(tactile, 0, first, large));
    EXPECT_TRUE(reaches(tactile, 1, second, small));
    while (const auto message = first.next(0))
        EXPECT_EQ(message->size(), 8U + 160 + 4) << "the other's message";
}

}  // namespace
}  // namespace thaum::game
