// A vest of bHaptics: the texts of requests and replies, and the connection to a Player (the maker's program)
// that behaves, is slow, lies, or goes away. The Player is a fake. Tests wait for what it got, not for a
// time.
#include "game/jackets/makers/bhaptics.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "game/jackets/bhaptics_messages.h"
#include "game/live/tactile.h"
#include "unit/fake_bhaptics.h"
#include "unit/jacket_rig.h"
#include "unit/message_of.h"
#include "unit/two_addresses.h"

namespace thaum::game {
namespace {

using input::rig::jacket_frame;
using rig::FakeBhaptics;
using rig::Manner;

std::string text_trace(const std::string& name) {
    auto words =
        read_text_file(std::filesystem::path(THAUM_SOURCE_DIR) / "tests/tactile" / name, 1U << 16U).value();
    words.pop_back();  // removes the line break
    return words;
}
const std::string& silent() {
    static const auto words = text_trace("bhaptics_silent.json");
    return words;
}
tactile::TactileFrame front_frame() { return jacket_frame(40, {{0, 1.0F}, {19, 0.01F}}); }
tactile::TactileFrame back_frame() { return jacket_frame(40, {{20, 0.5F}, {39, 2.0F}}, 10'000); }

std::unique_ptr<input::TactileOutput> jacket_for(const FakeBhaptics& player) {
    return bhaptics_jacket({"127.0.0.1", player.port()});
}

// Texts of requests and replies -----------------------------------------------------------------------------

TEST(BhapticsMessages, RequestsAreThoseOfTheTraces) {
    EXPECT_EQ(bhaptics_request(front_frame()), text_trace("bhaptics_front.json"));
    EXPECT_EQ(bhaptics_request(back_frame()), text_trace("bhaptics_back.json"));
    EXPECT_EQ(bhaptics_request({}), silent());
}

TEST(BhapticsMessages, AnyFrameGivesALegalRequest) {
    auto frame = jacket_frame(40, {{0, std::nanf("")},
                                   {1, std::numeric_limits<float>::infinity()},
                                   {2, -std::numeric_limits<float>::infinity()},
                                   {3, 1e30F},
                                   {4, 1e-30F}});
    for (const std::uint64_t count : {0ULL, 3ULL, 40ULL, 64ULL, ~0ULL}) {
        frame.count = count;
        frame.time_to_live = count == 3 ? ~Tick{0} : 0;
        const auto request = nlohmann::json::parse(bhaptics_request(frame));
        EXPECT_EQ(request.at("Submit").size(), 2U);
        for (const auto& part : request.at("Submit")) {
            if (part.at("type") != "frame") continue;
            EXPECT_LE(part.at("Frame").at("durationMillis"), 500);
            for (const auto& dot : part.at("Frame").at("dotPoints")) {
                EXPECT_TRUE(dot.at("intensity") >= 1 && dot.at("intensity") <= 100);
                EXPECT_LT(dot.at("index"), 20);
                EXPECT_TRUE(dot.at("index") == 1 || dot.at("index") == 3);
            }
        }
    }
}

TEST(BhapticsMessages, RepliesAreReadWithinBounds) {
    EXPECT_EQ(read_bhaptics_reply(R"({"ConnectedDeviceCount":2,"Status":{"VestFront":[0,1]}})")->devices, 2);
    EXPECT_EQ(read_bhaptics_reply("{}")->devices, std::nullopt);
    EXPECT_EQ(read_bhaptics_reply(R"({"ConnectedDeviceCount":"2"})")->devices, std::nullopt);
    EXPECT_EQ(read_bhaptics_reply(R"({"ConnectedDeviceCount":1e99})")->devices, std::nullopt);
    EXPECT_EQ(read_bhaptics_reply(R"({"ConnectedPositions":["Head","VestBack"]})")->vest, true);
    EXPECT_EQ(read_bhaptics_reply(R"({"ConnectedPositions":[4,201]})")->vest, true);
    EXPECT_EQ(read_bhaptics_reply(R"({"ConnectedPositions":["Head",4,3.5,{},null]})")->vest, false);
    EXPECT_EQ(read_bhaptics_reply(R"({"ConnectedPositions":"Vest"})")->vest, std::nullopt);
    EXPECT_FALSE(
        read_bhaptics_reply(R"({"ConnectedDeviceCount":1,"ConnectedPositions":[]})")->may_have_vest());
    EXPECT_TRUE(read_bhaptics_reply(R"({"ConnectedDeviceCount":1})")->may_have_vest());
    for (const auto* words : {"", "[]", "7", "{", "null", "{\"a\":1}x", "\xFF"})
        EXPECT_FALSE(read_bhaptics_reply(words)) << words;
    EXPECT_FALSE(read_bhaptics_reply(std::string(max_reply_bytes, '[')));
    EXPECT_FALSE(read_bhaptics_reply("{}" + std::string(max_reply_bytes, ' ')));
}

// The connection to the Player ------------------------------------------------------------------------------

TEST(BhapticsJacketThreads, TheRightMotorsReachThePlayer) {
    FakeBhaptics player(Manner::replies);
    const auto jacket = jacket_for(player);
    const auto opened = jacket->open();
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(player.first_line(), "GET /v2/feedbacks?app_id=thaum&app_name=Thaum HTTP/1.1");
    player.wait_for(silent());
    jacket->write(front_frame(), 1);
    player.wait_for(text_trace("bhaptics_front.json"));
    jacket->write(back_frame(), 1.01);
    player.wait_for(text_trace("bhaptics_back.json"));
    EXPECT_TRUE(jacket->is_connected());
    EXPECT_EQ(player.texts().size(), 3U);
    jacket->close();
    player.wait_for(silent(), 3);
}

TEST(BhapticsJacketThreads, AProxyForWebPagesIsNotAsked) {
    const char* const former = std::getenv("http_proxy");
    const std::string kept = former != nullptr ? former : "";
    ::setenv("http_proxy", "http://127.0.0.1:1", 1);
    FakeBhaptics player(Manner::replies);
    EXPECT_TRUE(jacket_for(player)->open());
    if (former != nullptr)
        ::setenv("http_proxy", kept.c_str(), 1);
    else
        ::unsetenv("http_proxy");
}

TEST(BhapticsJacketThreads, EachAddressOfAHostIsTried) {
    FakeBhaptics player(Manner::replies);
    const auto opened = bhaptics_jacket({"two-addresses", player.port()})->open();
    EXPECT_TRUE(opened) << (opened ? "" : opened.error().message);
}

TEST(BhapticsJacketThreads, NoRedirectionIsFollowed) {
    FakeBhaptics other(Manner::replies), player(Manner::redirects);
    player.redirect_to(other.port());
    EXPECT_EQ(message_of(jacket_for(player)->open()), "no bHaptics Player is there; start it");
    EXPECT_EQ(player.connections(), 1U);
    EXPECT_EQ(other.connections(), 0U);
}

TEST(BhapticsJacketThreads, AFrameGoesOutAgainAfterHalfOfItsTime) {
    FakeBhaptics player(Manner::never_replies);
    const auto jacket = jacket_for(player);
    ASSERT_TRUE(jacket->open()) << "a Player need not reply";
    const auto front = text_trace("bhaptics_front.json");
    jacket->write(front_frame(), 1);
    player.wait_for(front);
    for (const double now_s : {1.01, 1.02, 1.049}) jacket->write(front_frame(), now_s);
    jacket->write(front_frame(), 1.051);
    player.wait([&](const auto& texts) { return std::count(texts.begin(), texts.end(), front) == 2; });
    for (int i = 0; i < 3; ++i) jacket->write(jacket_frame(40, {{0, 1e-3F}}), 1.06);
    player.wait_for(silent(), 3);
    jacket->write(front_frame(), 1.07);
    player.wait_for(front, 4);
    EXPECT_EQ(player.texts().size(), 5U) << "silence, twice the frame, silence, the frame";
}

TEST(BhapticsJacketThreads, APlayerThatIsNoneIsRefusedInOneLine) {
    for (const auto& [manner, words] :
         {std::pair(Manner::never_answers, "the Player does not answer; start it anew"),
          {Manner::answers_404, "no bHaptics Player is there; start it"},
          {Manner::answers_noise, "no bHaptics Player is there; start it"},
          {Manner::replies_no_vest, "the Player has no vest; switch it on and pair it"},
          {Manner::replies_head, "the Player has no vest; switch it on and pair it"},
          {Manner::hangs_up, "the Player closes the connection"}}) {
        const FakeBhaptics player(manner);
        const auto jacket = jacket_for(player);
        EXPECT_EQ(message_of(jacket->open()), words);
        jacket->silence();
        jacket->write(front_frame(), 1);
        EXPECT_FALSE(jacket->is_connected());
        jacket->close();
    }
    std::uint16_t free_port = 0;
    {
        const FakeBhaptics gone(Manner::replies);
        free_port = gone.port();
    }
    EXPECT_EQ(message_of(bhaptics_jacket({"127.0.0.1", free_port})->open()),
              "no bHaptics Player is there; start it");
    EXPECT_FALSE(bhaptics_jacket({"no..host", 1})->open());
}

TEST(BhapticsJacketThreads, AVestThatIsSwitchedOffIsToldAndItsFramesAreNotPlayed) {
    FakeBhaptics player(Manner::replies);
    const auto jacket = jacket_for(player);
    ASSERT_TRUE(jacket->open());
    player.behave(Manner::replies_head);
    for (float strength = 0.1F; jacket->is_connected(); strength = 1.1F - strength)
        jacket->write(jacket_frame(40, {{0, strength}}), 1);
    EXPECT_EQ(jacket->fault(), "the Player has no vest; switch it on and pair it");
    jacket->close();
    EXPECT_FALSE(jacket->open()) << "so no frame counts as felt";
    player.behave(Manner::replies);
    EXPECT_TRUE(jacket->open());
}

TEST(BhapticsJacketThreads, NonsenseAndPiecesDoNoHarm) {
    for (const auto manner : {Manner::sends_nonsense, Manner::sends_pieces}) {
        FakeBhaptics player(manner);
        const auto jacket = jacket_for(player);
        ASSERT_TRUE(jacket->open());
        for (int i = 0; i < 100; ++i) EXPECT_TRUE(jacket->is_connected());
        jacket->write(back_frame(), 1);
        player.wait_for(text_trace("bhaptics_back.json"));
    }
}

TEST(BhapticsJacketThreads, AMessageOfOneGibibyteEndsTheConnection) {
    FakeBhaptics player(Manner::sends_gibibyte);
    const auto jacket = jacket_for(player);
    if (jacket->open()) {
        while (jacket->is_connected()) jacket->write(front_frame(), 1);
    }
    jacket->close();
    EXPECT_LT(player.bytes_sent(), 64U << 20U) << "what the system's queues hold";
    player.behave(Manner::replies);
    EXPECT_TRUE(jacket->open());
}

TEST(BhapticsJacketThreads, NoiseInsteadOfFramesEndsTheConnection) {
    FakeBhaptics player(Manner::sends_noise);
    const auto jacket = jacket_for(player);
    if (jacket->open()) {
        while (jacket->is_connected()) std::this_thread::yield();
    }
    jacket->close();
}

TEST(BhapticsJacketThreads, APlayerThatTakesNothingIsDisconnected) {
    FakeBhaptics player(Manner::never_reads);
    const auto jacket = jacket_for(player);
    ASSERT_TRUE(jacket->open());
    // Sends frames, each unlike the last, until the system's queues are full and a request waits too long.
    for (std::size_t i = 0; jacket->is_connected(); ++i)
        jacket->write(jacket_frame(40, {{i % 40, 1.0F}, {(i / 40) % 40, 0.5F}}), 1);
    jacket->close();
}

TEST(BhapticsJacketThreads, APlayerThatAnswersNoPingIsDisconnectedLongBeforeItsQueueIsFull) {
    FakeBhaptics player(Manner::never_reads);
    const auto jacket = jacket_for(player);
    ASSERT_TRUE(jacket->open());
    jacket->write(front_frame(), 1);
    while (jacket->is_connected()) std::this_thread::yield();
}

// The vest in a session -------------------------------------------------------------------------------------

Settings settings_for(const FakeBhaptics& first, const FakeBhaptics& second) {
    Settings settings;
    settings.players[0].jacket = "bhaptics:127.0.0.1:" + std::to_string(first.port());
    settings.players[1].jacket = "bhaptics:127.0.0.1:" + std::to_string(second.port());
    return settings;
}

/// Passes tactile frames until the bHaptics Player has got the wanted request, not counting its first
/// `before` requests.
void reach(LiveTactile& tactile, std::uint32_t player, FakeBhaptics& fake, const tactile::TactileFrame& frame,
           std::size_t before = 0) {
    const auto wanted = bhaptics_request(frame);
    for (bool there = false; !there; std::this_thread::yield()) {
        tactile.feel_jacket(player, frame);
        const auto texts = fake.texts();
        there = texts.size() > before && std::find(texts.begin() + static_cast<std::ptrdiff_t>(before),
                                                   texts.end(), wanted) != texts.end();
    }
}

TEST(BhapticsJacketThreads, TwoPlayersHaveTwoVestsThatGoDarkWhenFramesStop) {
    FakeBhaptics first(Manner::replies), second(Manner::replies);
    LiveTactile tactile([](const input::PadState&) { return nullptr; });
    tactile.apply(settings_for(first, second));
    reach(tactile, 0, first, front_frame());
    reach(tactile, 1, second, back_frame());
    EXPECT_EQ(tactile.jacket_layout(0), "x40");
    first.wait([](const auto& texts) { return texts.back() == silent(); });
    second.wait([](const auto& texts) { return texts.back() == silent(); });
    const auto texts = first.texts();
    EXPECT_EQ(std::count(texts.begin(), texts.end(), text_trace("bhaptics_back.json")), 0)
        << "the other's frames";
}

TEST(BhapticsJacketThreads, ALostPlayerIsConnectedAgain) {
    FakeBhaptics player(Manner::replies), other(Manner::replies);
    LiveTactile tactile([](const input::PadState&) { return nullptr; });
    tactile.apply(settings_for(player, other));
    reach(tactile, 0, player, front_frame());
    player.behave(Manner::hangs_up);
    while (tactile.jacket_report(0).times_lost == 0) {
        tactile.feel_jacket(0, front_frame());
        std::this_thread::yield();
    }
    player.behave(Manner::replies);
    const auto before = player.texts().size();
    reach(tactile, 0, player, back_frame(), before);
    EXPECT_GE(player.connections(), 2U);
}

}  // namespace
}  // namespace thaum::game
