// Tests of the mixer: place, distance, damping, faders, two listeners, and no clicks.
#include "audio/mixer.h"

#include <gtest/gtest.h>

#include "unit/audio_rig.h"

namespace thaum::audio {
namespace {

using namespace rig;

constexpr double near_zero = 1e-6;

class MixerTest : public testing::Test {
protected:
    Mixer mixing = mixer();
    Recorder recorder{mixing};
};

// ---- place of a sound -------------------------------------------------------------------------------------

TEST_F(MixerTest, ASoundAtOneSideIsLouderThere) {
    recorder.play(frame_with({voice(hum, {3, 0, 0})}), second);
    const auto right = recorder.levels(100);
    EXPECT_GT(right.right, 10 * right.left);
    recorder.play(frame_with({voice(hum, {-3, 0, 0})}), second);
    const auto left = recorder.levels(100);
    EXPECT_GT(left.left, 10 * left.right);
    recorder.play(frame_with({voice(hum, {0, 0, -3})}), second);
    EXPECT_NEAR(recorder.levels(100).left, recorder.levels(100).right, near_zero);
}

TEST_F(MixerTest, TheSideFollowsWhereTheListenerLooks) {
    auto frame = frame_with({voice(hum, {10, 5, -7})});
    frame.listeners[0] = {.position = {10, 5, -10}, .forward = {1, 0, 0}};
    recorder.play(frame, second);  // the listener looks east, so the sound is to the south
    EXPECT_GT(recorder.levels(100).right, 10 * recorder.levels(100).left);
    frame.listeners[0].up = {0, -1, 0};  // the listener is upside down, so right and left are exchanged
    recorder.play(frame, second);
    EXPECT_GT(recorder.levels(100).left, 10 * recorder.levels(100).right);
}

TEST(Mixer, LoudnessFollowsTheDistanceLawAndEndsAtTheReach) {
    for (const double distance : {0.5, 2.0, 4.0, 10.0, 30.0, 39.9}) {
        auto mixing = mixer();
        Recorder recorder(mixing);
        recorder.play(frame_with({voice(hum, {distance, 0, 0})}), 2 * second);
        EXPECT_NEAR(recorder.levels(second).right, 0.5 * distance_gain(distance, 2, 40), 0.5 * 1e-3)
            << distance;
    }
    EXPECT_DOUBLE_EQ(distance_gain(1, 2, 40), 1);
    EXPECT_DOUBLE_EQ(distance_gain(2, 2, 40), 1);
    EXPECT_NEAR(distance_gain(20, 2, 40), (0.1 - 0.05) / 0.95, 1e-12);
    EXPECT_EQ(distance_gain(40, 2, 40), 0);
}

TEST_F(MixerTest, AVoiceBeyondItsReachUsesNoSource) {
    recorder.play(frame_with({voice(hum, {41, 0, 0})}, {voice(bell, {0, 0, 1000})}), 10);
    EXPECT_EQ(mixing.report().voices, 0U);
    EXPECT_EQ(mixing.report().begun, 0U);
    EXPECT_EQ(recorder.largest(), 0);
}

TEST_F(MixerTest, AVoiceAtTheEarIsEquallyLoudOnBothSidesWhereverTheListenerIs) {
    auto frame = frame_with({at_ear(hum)});
    frame.listeners[0].position = {500, 0, 0};
    recorder.play(frame, second);
    EXPECT_NEAR(recorder.levels(100).left, 0.5 * std::sqrt(0.5), 1e-3);
    EXPECT_NEAR(recorder.levels(100).right, recorder.levels(100).left, near_zero);
}

TEST(Mixer, WallsTakeHighTonesAway) {
    const auto energies = [](double muffled) {
        auto mixing = mixer();
        Recorder recorder(mixing);
        auto hissing = voice(hiss, {0, 0, -1});
        hissing.muffled = {muffled, 0};
        recorder.play(frame_with({hissing}), 60);
        return std::pair{recorder.band(100, 1000), recorder.band(2000, 20'000)};
    };
    const auto open = energies(0), half = energies(0.5), walled = energies(1);
    EXPECT_LT(half.second, 0.5 * open.second);
    EXPECT_LT(walled.second, 0.1 * open.second);
    EXPECT_LT(walled.second, half.second);
    // Walls let low tones through better than high ones.
    EXPECT_GT(walled.first / open.first, 4 * walled.second / open.second);
}

TEST(Mixer, HrtfGivesTheTwoEarsDifferentSounds) {
    auto mixing = mixer({.headphones = true});
    if (!mixing.report().hrtf) {
        std::array<float, block_values> block{};
        mixing.run_on(block);
    }
    ASSERT_TRUE(mixing.report().hrtf) << "libopenal-data holds the data for HRTF";
    Recorder recorder(mixing);
    recorder.play(frame_with({voice(hiss, {3, 0, 0})}), second);
    const auto levels = recorder.levels(100);
    EXPECT_GT(levels.right, 1.3 * levels.left);
    EXPECT_GT(levels.left, 0.01) << "the far ear hears the sound too, unlike with panning";
}

TEST_F(MixerTest, HrtfTurnsOnAndOffWithoutAClickAndOnlyForOneListener) {
    auto frame = frame_with({voice(hum, {0, 0, -1})});
    recorder.play(frame, 20);
    EXPECT_FALSE(mixing.report().hrtf);
    mixing.set({.headphones = true});
    recorder.play(frame, 20);
    EXPECT_TRUE(mixing.report().hrtf);
    EXPECT_GT(recorder.levels(5).left, 0.2);
    frame.listener_count = 2;
    recorder.play(frame, 20);
    EXPECT_FALSE(mixing.report().hrtf);
    frame.listener_count = 1;
    recorder.play(frame, 20);
    EXPECT_TRUE(mixing.report().hrtf);
    EXPECT_LT(recorder.max_step(), smooth_step(0.75));
}

// ---- beginning, lasting and ending voices ----------------------------------------------------------------

TEST_F(MixerTest, ASoundThatBeginsPlaysOnceToItsEnd) {
    recorder.play(frame_with({}, {voice(bell, {2, 0, 0})}));
    EXPECT_GT(recorder.largest(), 0.1);
    EXPECT_EQ(mixing.report().begun, 1U);
    recorder.play({}, second);
    EXPECT_EQ(mixing.report().voices, 0U);
    double sum = 0;
    for (std::size_t i = 1; i < recorder.samples.size(); i += 2) sum += std::pow(recorder.samples[i], 2);
    double wanted = 0;
    const auto original = bank().sounds[bell].samples;
    for (const float s : original) wanted += std::pow(s, 2);
    EXPECT_NEAR(sum, wanted, 0.01 * wanted);
}

TEST_F(MixerTest, ALastingVoiceEndsWithinTheFrameThatLacksIt) {
    recorder.play(frame_with({voice(loud, {1, 0, 0})}), 20);
    // Plays more than one block, because the limiter's delay shifts samples into the second one.
    recorder.play({}, 3);
    EXPECT_EQ(mixing.report().voices, 0U);
    recorder.clear();
    recorder.play({}, 5);
    EXPECT_EQ(recorder.largest(), 0);
}

TEST(Mixer, ABlockWithoutAFrameGoesOn) {
    auto with_frames = mixer(), without = mixer();
    Recorder a(with_frames), b(without);
    auto frame = frame_with({voice(hum, {1, 0, 0})});
    a.play(frame, 20);
    b.play(frame);
    b.run_on(19);
    EXPECT_EQ(a.samples, b.samples);
    EXPECT_EQ(without.report().blocks_without_frame, 19U);
}

TEST_F(MixerTest, ALoopedSoundGoesOnWithoutAStep) {
    recorder.play(frame_with({voice(hum, {1, 0, 0})}), 3 * second);
    EXPECT_LT(recorder.max_step(), smooth_step(0.5));
    EXPECT_NEAR(recorder.levels(20).right, 0.5, 2e-3);
}

TEST_F(MixerTest, StartsStopsAndChangesDoNotClick) {
    for (int round = 0; round < 12; ++round) {
        auto humming = voice(hum, {round % 2 == 0 ? 1.0 : -1.0, 0, 0.3 * round});
        humming.gain = round % 3 == 0 ? 1 : 0.4;
        humming.muffled = {round % 4 == 0 ? 1.0 : 0.0, 0};
        recorder.play(frame_with({humming}), 5 + static_cast<std::size_t>(round));
        if (round % 4 == 3) recorder.play({}, 2);
    }
    EXPECT_LT(recorder.max_step(), smooth_step(0.75));
}

TEST_F(MixerTest, LayersOfMusicThatComeAndGoStayInStep) {
    recorder.play(frame_with({at_ear(song, 1)}), 77);
    const double alone = recorder.levels(20).left;
    recorder.play(frame_with({at_ear(song, 1), at_ear(verse, 2)}), 63);
    EXPECT_NEAR(recorder.levels(20).left, 2 * alone, 0.02 * alone);
    recorder.play(frame_with({at_ear(verse, 2)}), 41);
    recorder.play(frame_with({at_ear(song, 1), at_ear(verse, 2)}), 41);
    EXPECT_NEAR(recorder.levels(20).left, 2 * alone, 0.02 * alone);
}

TEST_F(MixerTest, AVoicePlayedFasterSoundsHigher) {
    auto high = voice(hum, {0, 0, -1});
    high.pitch = 2;
    recorder.play(frame_with({high}), 60);
    EXPECT_GT(recorder.band(375, 470), 50 * recorder.band(187, 282));
}

// ---- more voices than the mixer plays ---------------------------------------------------------------------

TEST_F(MixerTest, TheQuietestVoicesAreLeftOutAndCounted) {
    for (std::uint32_t i = 0; i < 200; ++i) {
        auto ringing = voice(bell, {1, 0, 0});
        ringing.gain = i % 2 == 0 ? 0.001 : 0.002;
        mixing.begin(ringing);
    }
    recorder.play({});
    EXPECT_EQ(mixing.report().voices, 64U);
    EXPECT_EQ(mixing.report().left_out, 136U);
    recorder.play({}, 10);
    // Only the 64 loudest voices play, each with the level 0.002.
    EXPECT_NEAR(recorder.levels(5).right, 64 * 0.002 * 0.5, 0.002);
}

TEST_F(MixerTest, ALouderVoiceTakesASourceAndTheOtherFades) {
    AudioFrame frame;
    for (std::uint32_t key = 0; key < 32; ++key) {
        auto humming = voice(hum, {1, 0, 0}, key);
        humming.gain = 0.01;
        frame.lasts.add(humming);
    }
    for (int i = 0; i < 32; ++i) {
        auto ringing = voice(bell, {1, 0, 0});
        ringing.gain = 0.005;
        frame.begins.add(ringing);
    }
    recorder.play(frame);
    frame.begins.count = 0;
    recorder.play(frame, 4);
    EXPECT_EQ(mixing.report().voices, 64U);
    EXPECT_EQ(mixing.report().stolen, 0U);
    auto louder = voice(bell, {1, 0, 0});
    louder.gain = 0.05;
    for (int i = 0; i < 10; ++i) mixing.begin(louder);
    recorder.play(frame, 10);
    EXPECT_EQ(mixing.report().stolen, 10U);
    EXPECT_EQ(mixing.report().begun, 74U);
    // A lasting voice that the frame no longer contains ends. It does not count as stolen, because no louder
    // voice has taken its place.
    frame.lasts.count = 20;
    recorder.play(frame, 5);
    EXPECT_EQ(mixing.report().stolen, 10U);
    EXPECT_LT(recorder.max_step(), smooth_step(0.5));
}

// ---- two listeners ----------------------------------------------------------------------------------------

AudioFrame two_listeners(std::initializer_list<Voice> lasts = {}) {
    auto frame = frame_with(lasts);
    frame.listener_count = 2;
    frame.listeners[1].position = {0, 0, 1000};
    return frame;
}

TEST(Mixer, EachOfTwoPlayersHasASpeaker) {
    auto mixing = mixer({.ears = Ears::left_right});
    Recorder recorder(mixing);
    recorder.play(two_listeners());
    recorder.clear();
    recorder.play(two_listeners({voice(hum, {3, 0, 0})}), 50);
    EXPECT_EQ(recorder.levels(50).right, 0) << "the second player hears nothing";
    EXPECT_GT(recorder.levels(20).left, 0.2);
    recorder.play(two_listeners({voice(hum, {-1, 0, 1000})}), 50);
    recorder.clear();
    recorder.play(two_listeners({voice(hum, {-1, 0, 1000})}), 50);
    EXPECT_EQ(recorder.levels(50).left, 0) << "the first player hears nothing";
    EXPECT_GT(recorder.levels(20).right, 0.2);
}

TEST_F(MixerTest, TwoPlayersWhoShareSpeakersAreHeardOnBoth) {
    recorder.play(two_listeners({voice(hum, {2, 0, 1000})}), 50);
    EXPECT_NEAR(recorder.levels(20).right, 0.5 * std::sqrt(0.5), 2e-3) << "3 dB quieter, at its own side";
    EXPECT_LT(recorder.levels(20).left, 0.05);
}

TEST(Mixer, OnlyItsListenersHearAVoice) {
    auto mixing = mixer({.ears = Ears::left_right});
    Recorder recorder(mixing);
    auto heard = at_ear(hum);
    heard.heard_by = 2;
    recorder.play(two_listeners());
    recorder.clear();
    recorder.play(two_listeners({heard}), 50);
    EXPECT_EQ(recorder.levels(50).left, 0);
    EXPECT_GT(recorder.levels(20).right, 0.2);
    recorder.play(two_listeners(), 10);
    recorder.clear();
    auto rung = at_ear(bell);
    rung.heard_by = 1;
    mixing.begin(rung);
    recorder.play(two_listeners(), 20);
    EXPECT_EQ(recorder.levels(20).right, 0);
    EXPECT_GT(recorder.levels(20).left, 0.2);
}

TEST_F(MixerTest, PlayersComeAndSpeakersChangeWithoutAClick) {
    auto frame = frame_with({voice(hum, {0, 0, -1})});
    for (const auto count : {1U, 2U, 1U, 2U}) {
        frame.listener_count = count;
        recorder.play(frame, 7);
        mixing.set({.ears = Ears::left_right});
        recorder.play(frame, 7);
        mixing.set({.ears = Ears::shared});
        recorder.play(frame, 7);
    }
    EXPECT_LT(recorder.max_step(), smooth_step(0.75));
}

// ---- faders and limits ------------------------------------------------------------------------------------

TEST(Mixer, EachGroupHasItsFader) {
    const auto level = [](const MixSettings& settings, std::uint32_t sound) {
        auto mixing = mixer(settings);
        Recorder recorder(mixing);
        recorder.play(sound == wood ? frame_with({}, {at_ear(sound)}) : frame_with({at_ear(sound)}), 20);
        return recorder.levels(20).left;
    };
    for (const auto sound : {hum, song, wood}) {
        const double full = level({}, sound);
        EXPECT_GT(full, 0.05);
        EXPECT_NEAR(level({.master = 0.5}, sound), 0.25 * full, 1e-4) << sound;
        EXPECT_EQ(level({.master = 0}, sound), 0) << sound;
        EXPECT_EQ(level({.effects = 0}, sound), sound == hum ? 0 : full) << sound;
        EXPECT_EQ(level({.music = 0}, sound), sound == song ? 0 : full) << sound;
        EXPECT_EQ(level({.interface = 0}, sound), sound == wood ? 0 : full) << sound;
    }
}

TEST_F(MixerTest, AFaderMovesWithoutAClick) {
    const auto frame = frame_with({voice(hum, {1, 0, 0})});
    for (const double master : {1.0, 0.0, 1.0, 0.3, 0.9, 0.0, 0.5}) {
        mixing.set({.master = master});
        recorder.play(frame, 9);
    }
    EXPECT_LT(recorder.max_step(), smooth_step(0.5));
}

TEST_F(MixerTest, OneQuietVoiceIsNotTouchedByTheLimiter) {
    recorder.play(frame_with({}, {voice(bell, {1, 0, 0})}));
    recorder.play({}, 40);
    EXPECT_EQ(mixing.report().limited_blocks, 0U);
    const auto original = bank().sounds[bell].samples;
    constexpr std::size_t late = 95;  // delay of the limiter (samples)
    double error = 0;
    for (std::size_t i = 0; i < original.size(); ++i)
        error = std::max(error,
                         std::abs(static_cast<double>(recorder.samples[2 * (i + late) + 1] - original[i])));
    EXPECT_EQ(error, 0);
}

TEST_F(MixerTest, ManyFullVoicesNeverClip) {
    AudioFrame frame;
    for (std::uint32_t key = 0; key < 32; ++key)
        frame.lasts.add(voice(loud, {key % 2 == 0 ? 1.0 : -1.0, 0, 0}, key));
    for (int i = 0; i < 32; ++i) frame.begins.add(at_ear(bell));
    recorder.play(frame, 100);
    frame.begins.count = 0;
    recorder.play(frame, 100);
    recorder.play({}, 10);
    EXPECT_LE(recorder.largest(), 1);
    EXPECT_GT(recorder.largest(), 0.5);
    EXPECT_GT(mixing.report().limited_blocks, 150U);
    // The limiter has made everything quieter during the noise. A voice that follows has its full loudness
    // again after 0.3 s.
    recorder.play({}, 40);
    recorder.play(frame_with({voice(hum, {1, 0, 0})}), 20);
    EXPECT_NEAR(recorder.levels(10).right, 0.5, 2e-3);
}

// ---- invalid input ---------------------------------------------------------------------------------------

TEST(Mixer, BadValuesAreClippedAndCounted) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    auto mixing = mixer();
    Recorder recorder(mixing);
    auto frame = frame_with({voice(hum, {nan, 0, 0}, 1), voice(hum, {infinite, 0, 0}, 2), voice(99, {}, 3),
                             voice(bell, {}, 4), voice(hum, {1, 0, 0}, 5), voice(hum, {1, 0, 0}, 5)},
                            {voice(hum, {}), voice(0xffffffff, {})});
    auto wild = voice(hum, {1, 0, 0}, 6);
    wild.gain = 1e30;
    wild.pitch = nan;
    wild.muffled = {-infinite, nan};
    frame.lasts.add(wild);
    frame.listener_count = 77;
    frame.listeners[0] = {.position = {nan, 0, 0}, .forward = {0, 0, 0}};
    frame.listeners[1] = {.forward = {0, 1, 0}, .up = {0, 2, 0}};
    recorder.play(frame, 20);
    EXPECT_LE(recorder.largest(), 1);
    EXPECT_GT(recorder.largest(), 0.1);
    EXPECT_EQ(mixing.report().bad_values, 20U * 13U);
    EXPECT_TRUE(std::isfinite(recorder.levels(10).left));
}

TEST_F(MixerTest, ListsWithImpossibleCountsAreReadToTheirEnd) {
    AudioFrame frame;
    frame.lasts.count = 0xffffffff;
    frame.begins.count = 33;
    recorder.play(frame, 3);
    EXPECT_GT(mixing.report().bad_values, 0U);
    EXPECT_LE(recorder.largest(), 1);
}

TEST(Mixer, SoundsThatAreNotNumbersAreSilent) {
    SoundBank odd;
    odd.sounds.resize(2);
    odd.sounds[0] = {
        .name = "a", .description = "", .loops = true, .near_m = -3, .reach_m = 1e300, .samples = {}};
    odd.sounds[1] = {.name = "b",
                     .description = "",
                     .loops = true,
                     .near_m = std::nan(""),
                     .samples = std::vector<float>(1000, std::numeric_limits<float>::infinity())};
    auto made = Mixer::create(odd, {.master = std::nan(""), .music = 7}).value();
    Recorder recorder(made);
    made.set({.master = 4});
    recorder.play(frame_with({voice(0, {1, 0, 0}, 1), voice(1, {1, 0, 0}, 2)}), 10);
    EXPECT_EQ(recorder.largest(), 0);
    EXPECT_GT(made.report().bad_values, 5U);
    auto none = Mixer::create({}, {}).value();
    Recorder empty(none);
    empty.play(frame_with({voice(0, {})}), 3);
    EXPECT_EQ(empty.largest(), 0);
}

// ---- repeatability ---------------------------------------------------------------------------------------

/// A busy second: voices begin, move and end, and two listeners turn.
std::vector<float> lively_second(const MixSettings& settings) {
    auto mixing = mixer(settings);
    Recorder recorder(mixing);
    for (std::uint32_t i = 0; i < second; ++i) {
        AudioFrame frame;
        frame.listener_count = i < 60 ? 1 : 2;
        const double angle = 0.05 * i;
        frame.listeners[0].forward = {std::sin(angle), 0, -std::cos(angle)};
        for (std::uint32_t key = i / 10; key < i / 10 + 20; ++key) {
            auto last = voice(key % 3 == 0 ? hiss : hum, {0.5 * key - 5, 1, std::sin(angle + key)}, key);
            last.pitch = 0.5 + 0.05 * (key % 20);
            last.muffled = {0.1 * (key % 11), 0.1 * (i % 11)};
            frame.lasts.add(last);
        }
        for (std::uint32_t n = 0; n < i % 5; ++n) frame.begins.add(voice(bell, {1.0 * n, 0, -2}));
        recorder.play(frame);
    }
    return recorder.samples;
}

TEST(Mixer, EqualFramesGiveEqualSamples) {
    for (const auto& settings : {MixSettings{}, MixSettings{.headphones = true, .ears = Ears::left_right}}) {
        const auto first = lively_second(settings);
        EXPECT_EQ(first, lively_second(settings));
        // Another mixer in the same process must not change what this one plays.
        auto other = mixer();
        Recorder recorder(other);
        recorder.play(frame_with({voice(hiss, {1, 0, 0})}), 30);
        EXPECT_EQ(first, lively_second(settings));
    }
}

}  // namespace
}  // namespace thaum::audio
