// Tests of feeding a sound device: frames that come early, late or not at all, and devices that fail.
#include "audio/playback.h"

#include <gtest/gtest.h>

#include "unit/audio_device_rig.h"

namespace thaum::audio {
namespace {

using namespace rig;

/// A playback, its sound card, and the test's clock. Steps of the playback run when it asks for them.
struct Room {
    FakeCard card;
    Playback playback{mixer(), std::make_unique<FakeDevice>(card)};
    double now_s{};
    double next_step_s{};
    bool heard_all = true;  ///< false after a frame was lost because the queue was full

    void run_until(double until_s) {
        while (next_step_s <= until_s) {
            now_s = next_step_s;
            card.play_until(now_s);
            next_step_s = now_s + playback.step(now_s);
        }
        now_s = until_s;
        card.play_until(now_s);
    }
    /// Sends a frame every 8 ms for a while.
    void play(const AudioFrame& frame, double seconds) {
        for (const double end = now_s + seconds; now_s < end - 1e-9;) {
            heard_all = playback.hear(frame) && heard_all;
            run_until(now_s + 0.008);
        }
    }
    /// Time at which the first audible sample was heard (s); -1: none was.
    double first_sound_s(std::size_t from_value = 0) const {
        for (std::size_t i = from_value; i < card.played.size(); ++i) {
            if (std::abs(card.played[i]) <= 1e-5F) continue;
            const std::size_t sample = i % block_values / 2;
            return card.played_at_s[i / block_values] + static_cast<double>(sample) / sample_rate;
        }
        return -1;
    }
};

TEST(Playback, AnEventIsHeardWithin30MsWhateverTheClocksDo) {
    double worst = 0;
    for (int phase = 0; phase < 16; ++phase) {
        Room room;
        room.play({}, 0.4);
        room.run_until(room.now_s + 0.0005 * phase);
        room.play({}, 0.2);
        const auto before = room.card.played.size();
        // The event is in the first tick of the frame that the match is filling now, so it waits for 8 ms.
        const double event_s = room.now_s;
        room.run_until(room.now_s + 0.008);
        ASSERT_TRUE(room.playback.hear(frame_with({}, {at_ear(bell)})));
        room.run_until(room.now_s + 0.1);
        const double heard_s = room.first_sound_s(before);
        ASSERT_GT(heard_s, event_s);
        worst = std::max(worst, heard_s - event_s);
        EXPECT_EQ(room.card.gaps, 0U);
    }
    EXPECT_LT(worst, 0.030);
    EXPECT_GT(worst, 0.020) << "two blocks and a frame lie between";
}

TEST(Playback, FramesThatWaitLoseNoBeginning) {
    Room room;
    room.play({}, 0.1);
    // The simulation is behind, then sends seven frames at once.
    room.run_until(room.now_s + 0.06);
    for (int i = 0; i < 7; ++i) {
        auto ringing = voice(bell, {1, 0, 0});
        ringing.gain = 0.1;
        room.playback.hear(frame_with({voice(hum, {1, 0, 0}, 1)}, {ringing}));
    }
    room.play(frame_with({voice(hum, {1, 0, 0}, 1)}), 0.1);
    EXPECT_EQ(room.playback.report().mix.begun, 8U);
    EXPECT_GE(room.playback.report().frames_merged, 6U);
    EXPECT_EQ(room.playback.report().mix.voices, 8U);
}

TEST(Playback, ACardThatRunsFastOrSlowMakesNoGapAndLosesNoBeginning) {
    for (const double speed : {0.98, 1.02}) {
        Room room;
        room.card.speed = speed;
        auto knocking = at_ear(wood);
        knocking.gain = 0.1;
        room.play({}, 0.1);
        room.play(frame_with({at_ear(hum)}, {knocking}), 5);
        EXPECT_EQ(room.card.gaps, 0U) << speed;
        room.play({}, 0.1);
        EXPECT_EQ(room.playback.report().mix.begun, 625U + 1) << speed;
    }
}

TEST(Playback, LateFramesLetVoicesGoOnAndThenFade) {
    Room room;
    room.play(frame_with({voice(hum, {1, 0, 0})}), 0.2);
    room.run_until(room.now_s + 0.1);
    EXPECT_EQ(room.playback.report().mix.voices, 1U);
    EXPECT_GT(room.playback.report().mix.blocks_without_frame, 8U);
    room.run_until(room.now_s + 0.3);
    EXPECT_EQ(room.playback.report().mix.voices, 0U) << "a game that stands still does not drone on";
    room.play(frame_with({voice(hum, {1, 0, 0})}), 0.05);
    EXPECT_EQ(room.playback.report().mix.voices, 1U);
    double step = 0;
    for (std::size_t i = 2; i < room.card.played.size(); ++i)
        step = std::max(step, static_cast<double>(std::abs(room.card.played[i] - room.card.played[i - 2])));
    EXPECT_LT(step, smooth_step(0.5));
}

TEST(Playback, AMenuSoundsWithoutASimulation) {
    Room room;
    room.run_until(0.5);
    EXPECT_TRUE(room.playback.hear(at_ear(wood)));
    room.run_until(0.6);
    EXPECT_GT(room.first_sound_s(), 0.5);
    EXPECT_LT(room.first_sound_s(), 0.53);
}

TEST(Playback, SettingsReachTheMixer) {
    Room room;
    room.play(frame_with({at_ear(hum)}), 0.1);
    room.playback.set({.master = 0});
    room.play(frame_with({at_ear(hum)}), 0.1);
    room.card.played.clear();
    room.play(frame_with({at_ear(hum)}), 0.1);
    for (const float sample : room.card.played) ASSERT_EQ(sample, 0);
}

TEST(Playback, WithoutADeviceItIsSilentAndTriesEveryTwoSeconds) {
    Room room;
    room.card.present = false;
    room.play(frame_with({at_ear(hum)}, {at_ear(bell)}), 7);
    EXPECT_TRUE(room.heard_all) << "frames are taken and forgotten";
    EXPECT_EQ(room.card.opened, 4);
    EXPECT_EQ(room.playback.report().mix.blocks, 0U);
    EXPECT_EQ(room.playback.status(), "no sound: no sound device was found; a new try every 2 s");
    room.card.present = true;
    room.play(frame_with({at_ear(hum)}), 2);
    EXPECT_EQ(room.playback.status(), "sound plays");
    EXPECT_EQ(room.playback.report().mix.begun, 1U) << "what happened before is not heard later";
}

TEST(Playback, ADeviceThatIsPulledOutAndPutBackPlaysOn) {
    Room room;
    room.play(frame_with({at_ear(hum)}), 1);
    room.card.present = room.card.connected = false;
    room.play(frame_with({at_ear(hum)}, {at_ear(bell)}), 3);
    EXPECT_EQ(room.card.closed, 1);
    EXPECT_NE(room.playback.status().find("no sound"), std::string::npos);
    room.card.present = true;
    room.card.played.clear();
    room.play(frame_with({at_ear(hum)}), 2.5);
    EXPECT_EQ(room.playback.status(), "sound plays");
    EXPECT_EQ(room.playback.report().times_lost, 1U);
    EXPECT_EQ(room.playback.report().times_opened, 2U);
    float most = 0;
    for (const float sample : room.card.played) most = std::max(most, std::abs(sample));
    EXPECT_NEAR(most, 0.5 * std::sqrt(0.5), 0.01);
}

TEST(Playback, AStateIsNotToldBeforeItsCounts) {
    Room room;
    room.card.deaf = true;  // the opened card takes no blocks
    room.playback.step(0);
    EXPECT_EQ(room.playback.status(), "sound plays");
    EXPECT_EQ(room.playback.report().times_opened, 1U);
}

TEST(Playback, WhatWasPlayedBeforeALossIsNotHeardAfterIt) {
    Room room;
    room.play({}, 0.1);
    room.playback.hear(at_ear(bell));
    room.play({}, 0.05);
    room.card.present = room.card.connected = false;
    room.play({}, 0.5);
    room.card.present = true;
    room.card.played.clear();
    room.card.played_at_s.clear();
    room.play({}, 3);
    EXPECT_EQ(room.playback.status(), "sound plays");
    EXPECT_EQ(room.first_sound_s(), -1);
}

TEST(Playback, ADeviceThatChangesIsOpenedAgainAtOnce) {
    Room room;
    room.play({}, 1);
    room.card.connected = false;  // headphones are pulled out; the loudspeakers are available
    room.play({}, 0.3);
    EXPECT_EQ(room.playback.status(), "sound plays");
    EXPECT_EQ(room.playback.report().times_opened, 2U);
}

TEST(Playback, ADeviceThatTakesNothingIsGivenUpAfterASecond) {
    Room room;
    room.play({}, 0.5);
    room.card.deaf = true;
    room.play({}, 0.9);
    EXPECT_EQ(room.playback.report().times_lost, 0U);
    room.play({}, 0.3);
    EXPECT_EQ(room.playback.report().times_lost, 1U);
    room.card.deaf = false;
    room.play({}, 0.5);
    EXPECT_EQ(room.playback.status(), "sound plays");
}

TEST(Playback, ADeviceThatLiesAboutItsTimeGetsNoMoreThanAQuarterTooMuch) {
    Room room;
    room.card.lie = std::numeric_limits<std::size_t>::max();
    room.play({}, 4);
    EXPECT_LT(room.playback.report().blocks_written, 4 * 125 * 1.25 + 30);
    EXPECT_GT(room.playback.report().blocks_written, 4 * 125U);
}

TEST(Playback, AClockThatJumpsDoesNoHarm) {
    Room room;
    room.play({}, 0.1);
    for (const double now : {-5.0, 1e9, 0.0, 3.0}) {
        EXPECT_GT(room.playback.step(now), 0);
        EXPECT_LT(room.playback.step(now), 1);
    }
    EXPECT_LT(room.playback.report().blocks_written, 200U);
}

TEST(Playback, EqualFramesAtEqualTimesGiveEqualSamples) {
    const auto played = [] {
        Room room;
        for (int i = 0; i < 60; ++i)
            room.play(frame_with({voice(hum, {0.1 * i, 0, -1})}, {voice(bell, {-1, 0, 0})}),
                      0.008 * (1 + i % 3));
        return room.card.played;
    };
    EXPECT_EQ(played(), played());
}

}  // namespace
}  // namespace thaum::audio
