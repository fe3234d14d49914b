// Tests of jackets whose motors (shakers) are connected to the channels of a sound device: the wave is on the
// motor's own channel, nothing clicks, and the wave ends after its time to live. One fake device lets OpenAL
// render into memory, another keeps the blocks of samples that it gets.
#include "game/jackets/makers/audio.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>

#include "audio/channels.h"
#include "audio/detail/block_stream.h"
#include "game/jackets/jacket.h"
#include "tactile/layout.h"
#include "unit/jacket_rig.h"
#include "unit/loopback_card.h"

namespace thaum::game {
namespace {

using audio::frame_samples;
using audio::sample_rate;
using input::rig::jacket_frame;

/// Samples of one channel, taken from interleaved samples.
std::vector<double> channel_of(const std::vector<float>& heard, std::size_t channels, std::size_t channel) {
    std::vector<double> samples;
    for (std::size_t i = channel; i < heard.size(); i += channels)
        samples.push_back(static_cast<double>(heard[i]));
    return samples;
}

/// Amplitude of the component of a signal at one frequency.
double amplitude_at(const std::vector<double>& samples, double hz) {
    std::complex<double> sum{};
    for (std::size_t i = 0; i < samples.size(); ++i)
        sum +=
            samples[i] * std::polar(1.0, -2 * std::numbers::pi * hz * static_cast<double>(i) / sample_rate);
    return 2 * std::abs(sum) / static_cast<double>(samples.size());
}

double peak_of(const std::vector<double>& samples) {
    double peak = 0;
    for (const double sample : samples) peak = std::max(peak, std::abs(sample));
    return peak;
}

TEST(ChannelTones, ABlockHoldsTheTonesAlone) {
    audio::ChannelTones tones(2);
    tones.set(1, {.amplitude = 0.5, .hz = 250});
    tones.set(1, {.amplitude = 0.5, .hz = 0});  // 0 Hz: the tone keeps its frequency of 250 Hz
    std::vector<float> block(2 * frame_samples), heard;
    for (int i = 0; i < 20; ++i) {
        std::fill(block.begin(), block.end(), 9.0F);
        tones.mix(block);
        if (i >= 10) heard.insert(heard.end(), block.begin(), block.end());
    }
    EXPECT_EQ(peak_of(channel_of(heard, 2, 0)), 0);
    EXPECT_NEAR(amplitude_at(channel_of(heard, 2, 1), 250), 0.5, 0.01);
}

/// A sound card with some channels, whose time advances when the test says so.
class CardDevice final : public audio::SoundDevice {
public:
    explicit CardDevice(std::size_t channels) : channels_(channels), card_(sample_rate, channels) {}
    ~CardDevice() override { close(); }
    Expected<void> open() override {
        const auto scope = card_.enter();
        stream_.emplace(2, channels_);
        return {};
    }
    std::size_t wanted() override {
        const auto scope = card_.enter();
        return stream_->wanted();
    }
    void write(std::span<const float> block) override {
        const auto scope = card_.enter();
        stream_->write(block);
    }
    bool is_connected() override { return true; }
    void close() override {
        const auto scope = card_.enter();
        if (stream_) stream_->destroy();
        stream_.reset();
    }
    /// Plays the card's output for eight milliseconds.
    void play(std::vector<float>& heard) { card_.render(heard, frame_samples); }

private:
    std::size_t channels_;
    audio::rig::Card card_;
    std::optional<audio::detail::BlockStream> stream_;
};

TEST(AudioJacket, EachOfEightActuatorsHasItsChannelAndFrequencyOnTheCard) {
    for (std::size_t actuator = 0; actuator < 8; ++actuator) {
        auto device = std::make_unique<CardDevice>(8);
        auto& card = *device;
        const auto jacket = audio_jacket("shakers", 8, std::move(device));
        ASSERT_TRUE(jacket->open());
        std::vector<float> heard;
        auto frame = jacket_frame(8, {{actuator, 0.5F}});
        frame.carrier_hz.fill(80);
        for (int i = 0; i < 125; ++i) {
            jacket->write(frame, 8e-3 * i);
            jacket->is_connected();
            card.play(heard);
        }
        // Leaves out the first 32 ms, in which the wave was still waiting in the queue.
        heard.erase(heard.begin(), heard.begin() + 8 * 4 * static_cast<std::ptrdiff_t>(frame_samples));
        for (std::size_t channel = 0; channel < 8; ++channel) {
            const auto samples = channel_of(heard, 8, channel);
            if (channel != actuator) {
                EXPECT_EQ(peak_of(samples), 0) << channel << " of " << actuator;
                continue;
            }
            EXPECT_NEAR(amplitude_at(samples, 80), 0.5, 0.02) << actuator;
            EXPECT_LT(amplitude_at(samples, 160), 0.005) << actuator;
            EXPECT_LT(amplitude_at(samples, 40), 0.02) << actuator;
        }
    }
}

TEST(AudioJacket, AfterItsTimeToLiveTheCardIsSilent) {
    auto device = std::make_unique<CardDevice>(2);
    auto& card = *device;
    const auto jacket = audio_jacket("shakers", 2, std::move(device));
    ASSERT_TRUE(jacket->open());
    jacket->write(jacket_frame(2, {{1, 1.0F}}, 80), 0);
    std::vector<float> heard;
    for (int i = 0; i < 40; ++i) {
        jacket->is_connected();
        card.play(heard);
    }
    const auto right = channel_of(heard, 2, 1);
    const auto last = std::find_if(right.rbegin(), right.rend(), [](double s) { return s != 0; });
    const auto sounding = static_cast<std::size_t>(right.rend() - last);
    // Expected length of the sound: 80 ms, plus the block in which the wave ends, plus the two blocks that
    // wait in the queue.
    EXPECT_GE(sounding, 10 * frame_samples);
    EXPECT_LE(sounding, 13 * frame_samples);
    EXPECT_NEAR(peak_of(right), 1, 0.01);
    EXPECT_EQ(peak_of(channel_of(heard, 2, 0)), 0);
}

/// A device that stores the blocks that it gets.
struct Kept {
    std::vector<float> samples{};
    std::size_t wanted{1};
    bool connected{true}, opens{true};
    int closed{};
};
class KeepingDevice final : public audio::SoundDevice {
public:
    explicit KeepingDevice(Kept& kept) : kept_(kept) {}
    Expected<void> open() override {
        if (!kept_.opens) return fail("there is no sound device of this name");
        return {};
    }
    std::size_t wanted() override { return kept_.wanted; }
    void write(std::span<const float> block) override {
        kept_.samples.insert(kept_.samples.end(), block.begin(), block.end());
    }
    bool is_connected() override { return kept_.connected; }
    void close() override { ++kept_.closed; }

private:
    Kept& kept_;
};

TEST(AudioJacket, NothingClicksWhenFramesJumpStopAndChangeTheirFrequency) {
    Kept kept;
    auto jacket = audio_jacket("shakers", 2, std::make_unique<KeepingDevice>(kept));
    ASSERT_TRUE(jacket->open());
    for (int i = 0; i < 60; ++i) {
        auto frame = jacket_frame(2, {{0, i % 3 == 0 ? 1.0F : 0.0F}, {1, 0.25F * static_cast<float>(i % 5)}});
        frame.carrier_hz[0] = i % 2 == 0 ? 60.0F : 200.0F;
        frame.carrier_hz[1] = 20.0F * static_cast<float>(1 + i % 10);
        jacket->write(frame, 0);
    }
    jacket.reset();  // closing ends the wave, too
    // A wave of 200 Hz and full amplitude changes by at most 2 pi 200 / 48000 between two samples, and a rise
    // over 8 ms adds 1 / 384.
    const double steepest = 2 * std::numbers::pi * 200 / sample_rate + 1.0 / frame_samples;
    for (const std::size_t channel : {0U, 1U}) {
        const auto samples = channel_of(kept.samples, 2, channel);
        double step = std::abs(samples[0]);
        for (std::size_t i = 1; i < samples.size(); ++i)
            step = std::max(step, std::abs(samples[i] - samples[i - 1]));
        EXPECT_LE(step, steepest * 1.001);
        EXPECT_GT(peak_of(samples), 0.9);
        EXPECT_EQ(samples.back(), 0);
    }
    EXPECT_EQ(kept.closed, 1);
}

TEST(AudioJacket, AnyFrameGivesLegalSamples) {
    Kept kept;
    const auto jacket = audio_jacket("shakers", 8, std::make_unique<KeepingDevice>(kept));
    ASSERT_TRUE(jacket->open());
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    for (const float amplitude : {nan, inf, -inf, -1.0F, 1e30F}) {
        for (const float hz : {nan, inf, -inf, 0.0F, 1e30F}) {
            tactile::TactileFrame frame{.time_to_live = ~Tick{}, .count = ~0ULL};
            frame.amplitude.fill(amplitude);
            frame.carrier_hz.fill(hz);
            jacket->write(frame, 0);
        }
    }
    for (const float sample : kept.samples) ASSERT_LE(std::abs(sample), 1);
    for (int i = 0; i < 100; ++i) jacket->is_connected();
    EXPECT_EQ(kept.samples.back(), 0) << "half a second is the longest time to live";
}

TEST(AudioJacket, ADeviceThatIsGoneOrTakesNothingIsToldAndClosed) {
    Kept kept;
    const auto jacket = audio_jacket("2 shakers on 'box'", 2, std::make_unique<KeepingDevice>(kept));
    EXPECT_EQ(jacket->name(), "2 shakers on 'box'");
    kept.opens = false;
    EXPECT_EQ(jacket->open().error().message, "there is no sound device of this name");
    EXPECT_FALSE(jacket->is_connected());
    kept.opens = true;
    ASSERT_TRUE(jacket->open());
    kept.connected = false;
    EXPECT_FALSE(jacket->is_connected());
    EXPECT_EQ(jacket->fault(), "the sound device is gone");
    jacket->close();
    jacket->write(jacket_frame(2, {{0, 1.0F}}), 1);  // a closed jacket ignores calls
    jacket->silence();
    kept = {.wanted = 0};
    ASSERT_TRUE(jacket->open());
    int looks = 0;
    while (jacket->is_connected() && looks < 10'000) ++looks;
    EXPECT_EQ(looks, 499);
    EXPECT_EQ(jacket->fault(), "the sound device takes no sound");
}

TEST(AudioJacket, ADeviceThatWantsEverMoreGetsFourBlocksAtOnce) {
    Kept kept{.wanted = 1'000'000};
    const auto jacket = audio_jacket("shakers", 8, std::make_unique<KeepingDevice>(kept));
    ASSERT_TRUE(jacket->open());
    jacket->is_connected();
    EXPECT_EQ(kept.samples.size(), 4 * 8 * frame_samples);
}

TEST(AudioJacket, TheLayoutOfEightNamesTheChannelsInTheirOrder) {
    const auto file = std::filesystem::path(THAUM_SOURCE_DIR) / "assets/tactile/layouts/shakers8.toml";
    const auto layout = tactile::load_layout(file).value();
    ASSERT_EQ(layout.actuators.size(), audio::max_channels);
    for (std::size_t i = 0; i < audio::max_channels; ++i)
        EXPECT_EQ(layout.actuators[i].name, audio::surround_channels[i]);
}

}  // namespace
}  // namespace thaum::game
