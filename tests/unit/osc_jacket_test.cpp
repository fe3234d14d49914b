// Tests of jackets that get OSC messages by UDP: the bytes, when they go out, and that a jacket that is
// switched off costs nothing. The byte traces in tests/tactile are of the VRCH server's protocol, and were
// not made by this program.
#include "game/jackets/makers/osc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <thread>

#include "game/jackets/osc_message.h"
#include "input/tactile_player.h"
#include "unit/message_of.h"
#include "unit/two_addresses.h"
#include "unit/udp_receiver.h"

namespace thaum::game {
namespace {

using input::rig::jacket_frame;
using input::rig::trace;
using input::rig::UdpReceiver;

const std::string& silent_message() {
    static const auto bytes = trace("osc_x16_silent.hex");
    return bytes;
}
tactile::TactileFrame frame_of_16() { return jacket_frame(16, {{0, 1.0F}, {6, 1e-5F}, {15, 0.5F}}); }

std::unique_ptr<input::TactileOutput> jacket_for(const UdpReceiver& receiver, std::size_t motors = 16) {
    return osc_jacket({"127.0.0.1", receiver.port()}, motors);
}

TEST(OscMessage, HasTheBytesOfTheTraces) {
    EXPECT_EQ(osc_message(frame_of_16(), 16), trace("osc_x16.hex"));
    EXPECT_EQ(osc_message(jacket_frame(40, {{20, 0.25F}, {39, 0.75F}}), 40), trace("osc_x40.hex"));
    EXPECT_EQ(osc_message({}, 16), silent_message());
    EXPECT_EQ(osc_ping(1500), trace("osc_ping.hex"));
}

TEST(OscMessage, AnyAmplitudesGiveALegalMessage) {
    auto frame = jacket_frame(16, {{0, std::nanf("")},
                                   {1, std::numeric_limits<float>::infinity()},
                                   {2, -std::numeric_limits<float>::infinity()},
                                   {3, -1e30F},
                                   {4, 1.5F}});
    const std::string head("/h\0\0,s\0\0", 8);
    const std::string words = "0000ffff00000000ffff" + std::string(44, '0');
    EXPECT_EQ(osc_message(frame, 16), head + words + std::string(4, '\0'));
    frame.count = ~0ULL;
    const auto size = head.size() + 4 * 40 + 4;
    EXPECT_EQ(osc_message(frame, 40).size(), size);
    frame.count = 2;
    EXPECT_EQ(osc_message(frame, 40).substr(8, 20), "0000ffff000000000000") << "motors without actuator";
}

TEST(OscMessage, EachSizeIsAMultipleOfFourAndEndsInNul) {
    for (std::size_t motors = 0; motors <= 64; ++motors) {
        const auto message = osc_message({}, motors);
        EXPECT_EQ(message.size() % 4, 0U);
        EXPECT_EQ(message.back(), '\0');
        EXPECT_EQ(message.size(), 8 + 4 * motors + 4);
    }
}

TEST(OscJacket, SendsAFrameWhenItChangedAndAfterHalfOfItsTime) {
    UdpReceiver receiver;
    const auto jacket = jacket_for(receiver);
    ASSERT_TRUE(jacket->open());
    const auto ping = receiver.next();
    EXPECT_EQ(ping, osc_ping(receiver.sender_port())) << "first it tells where heartbeats may go";
    EXPECT_EQ(receiver.next(), silent_message()) << "motors that were left on stop at once";
    const auto frame = frame_of_16();
    for (const double now_s : {1.0, 1.008, 1.016, 1.04, 1.0499}) jacket->write(frame, now_s);
    for (const double now_s : {1.051, 1.06, 1.1}) jacket->write(frame, now_s);
    jacket->write(jacket_frame(16, {{3, 1.0F}}), 1.1);
    const auto marker = osc_message(jacket_frame(16, {{3, 1.0F}}), 16);
    EXPECT_EQ(receiver.count_until(marker), 2);
    EXPECT_EQ(jacket->name(), "jacket at 127.0.0.1:" + std::to_string(receiver.port()));
}

TEST(OscJacket, AHostGetsTheMessagesAtEachOfItsAddresses) {
    UdpReceiver receiver;
    const auto jacket = osc_jacket({"two-addresses", receiver.port()}, 16);
    ASSERT_TRUE(jacket->open());
    EXPECT_EQ(receiver.next(), osc_ping(receiver.sender_port()));
    EXPECT_EQ(receiver.next(), silent_message());
    jacket->write(frame_of_16(), 1);
    EXPECT_EQ(receiver.next(), trace("osc_x16.hex"));
}

TEST(OscJacket, SilenceGoesOutSeveralTimesAndEndsWhenAFrameComes) {
    UdpReceiver receiver;
    const auto jacket = jacket_for(receiver);
    ASSERT_TRUE(jacket->open());
    jacket->write(frame_of_16(), 1);
    EXPECT_TRUE(receiver.gets(trace("osc_x16.hex")));
    jacket->silence();
    int silences = 0;
    while (silences < 8) {
        EXPECT_TRUE(jacket->is_connected());
        const auto message = receiver.next(1);
        if (!message) continue;
        ASSERT_EQ(*message, silent_message());
        ++silences;
    }
    for (int i = 0; i < 100; ++i) jacket->is_connected();
    jacket->silence();
    jacket->write(frame_of_16(), 2);
    jacket->is_connected();
    EXPECT_EQ(receiver.count_until(trace("osc_x16.hex")), 1)
        << "after eight messages the jacket is left alone";
    EXPECT_EQ(receiver.next(0), std::nullopt);
    jacket->close();
    EXPECT_EQ(receiver.next(), silent_message());
}

TEST(OscJacket, AFrameTooWeakForTheJacketIsSilence) {
    UdpReceiver receiver;
    const auto jacket = jacket_for(receiver);
    ASSERT_TRUE(jacket->open());
    jacket->write(frame_of_16(), 1);
    EXPECT_TRUE(receiver.gets(trace("osc_x16.hex")));
    for (int i = 0; i < 5; ++i) jacket->write(jacket_frame(16, {{3, 1e-7F}}), 1.01);
    EXPECT_EQ(receiver.next(), silent_message());
    EXPECT_EQ(receiver.next(0), std::nullopt);
}

TEST(OscJacket, ADeadJacketCostsNothingAndIsServedWhenItIsBack) {
    std::uint16_t port = 0;
    std::unique_ptr<input::TactileOutput> jacket;
    {
        const UdpReceiver receiver;
        port = receiver.port();
        jacket = jacket_for(receiver);
    }
    ASSERT_TRUE(jacket->open());
    for (int i = 0; i < 1000; ++i) {
        jacket->write(frame_of_16(), i);
        ASSERT_TRUE(jacket->is_connected());
    }
    UdpReceiver again(port);
    if (again.port() == 0) GTEST_SKIP() << "another program has taken the port";
    jacket->write(frame_of_16(), 2000);
    EXPECT_EQ(again.next(), trace("osc_x16.hex")) << "no error of an earlier message swallows this one";
}

TEST(OscJacket, AnAddressWithoutAMeaningIsAnErrorOfOneLine) {
    const auto jacket = osc_jacket({"no..host\n", 1027}, 16);
    const auto message = message_of(jacket->open());
    EXPECT_TRUE(message.starts_with("no address for 'no..host\\x0a': ")) << message;
    EXPECT_TRUE(message.ends_with("; correct the jacket in the settings file"));
    // A closed jacket ignores all calls.
    jacket->silence();
    jacket->close();
}

TEST(OscJacket, AnIpv6AddressIsWrittenInBrackets) {
    EXPECT_EQ(osc_jacket({"::1", 1027}, 16)->name(), "jacket at [::1]:1027");
    EXPECT_EQ(osc_jacket({"vest.local", 1}, 16)->name(), "jacket at vest.local:1");
}

TEST(TactilePlayerThreads, AnOscJacketIsSilentWhenFramesStop) {
    UdpReceiver receiver;
    input::TactilePlayer player;
    player.use(jacket_for(receiver));
    while (!player.is_open()) std::this_thread::yield();
    const auto wanted = trace("osc_x16.hex");
    bool felt = false;
    for (int i = 0; i < input::rig::patience_ms && !felt; ++i) {
        player.feel(frame_of_16());
        felt = receiver.next(1) == wanted;
    }
    ASSERT_TRUE(felt);
    EXPECT_TRUE(receiver.gets(silent_message()));
    EXPECT_GE(player.report().times_opened, 1U);
}

}  // namespace
}  // namespace thaum::game
