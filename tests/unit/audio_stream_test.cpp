// Tests of OpenAL's queue of blocks, with devices of many rates that render into memory.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "audio/detail/block_stream.h"
#include "unit/audio_rig.h"
#include "unit/loopback_card.h"

namespace thaum::audio {
namespace {

using namespace rig;

/// A sine on the left and silence on the right, in blocks.
class Tone {
public:
    explicit Tone(double frequency) : frequency_(frequency) {}
    std::span<const float> next() {
        for (std::size_t i = 0; i < frame_samples; ++i, ++at_)
            block_[2 * i] = static_cast<float>(
                0.5 * std::sin(2 * pi * frequency_ * static_cast<double>(at_) / sample_rate));
        return block_;
    }

private:
    double frequency_;
    std::size_t at_{};
    std::array<float, block_values> block_{};
};

TEST(BlockStream, DevicesFrom8To192KhzPlayTheToneAtItsPitch) {
    constexpr double frequency = 500;
    for (const int rate : {8000, 11'025, 22'050, 44'100, 48'000, 96'000, 192'000}) {
        Card card(rate);
        const auto scope = card.enter();
        detail::BlockStream stream(4);
        Tone tone(frequency);
        std::vector<float> heard;
        for (int i = 0; i < 250; ++i) {
            for (auto wanted = stream.wanted(); wanted > 0; --wanted) stream.write(tone.next());
            card.render(heard, static_cast<std::size_t>(rate) / 125);
        }
        EXPECT_EQ(stream.queued(), 4U) << "no gap at " << rate;
        int crossings = 0;
        float right = 0;
        double energy = 0;
        for (std::size_t i = 2; i < heard.size(); i += 2) {
            crossings += heard[i - 2] < 0 && heard[i] >= 0 ? 1 : 0;
            right = std::max(right, std::abs(heard[i + 1]));
            energy += heard[i] * heard[i];
        }
        const double seconds = static_cast<double>(heard.size()) / 2 / rate;
        EXPECT_NEAR(crossings / seconds, frequency, 3) << rate;
        EXPECT_NEAR(std::sqrt(2 * energy / (static_cast<double>(heard.size()) / 2)), 0.5, 0.01) << rate;
        EXPECT_EQ(right, 0) << rate;
        stream.destroy();
    }
}

TEST(BlockStream, AGapStartsAgainWithOneBlockMore) {
    Card card(48'000);
    const auto scope = card.enter();
    detail::BlockStream stream(2);
    Tone tone(500);
    std::vector<float> heard;
    const auto play = [&](int rounds) {
        for (int i = 0; i < rounds; ++i) {
            for (auto wanted = stream.wanted(); wanted > 0; --wanted) stream.write(tone.next());
            card.render(heard, frame_samples);
        }
    };
    play(10);
    EXPECT_EQ(stream.queued(), 2U);
    card.render(heard, 10 * frame_samples);  // the card plays on while nothing is written
    EXPECT_EQ(stream.wanted(), 3U);
    stream.write(tone.next());
    EXPECT_EQ(stream.wanted(), 2U) << "a block that waits has not been played";
    heard.clear();
    play(20);
    EXPECT_EQ(stream.queued(), 3U);
    float most = 0;
    for (const float sample : std::span(heard).last(block_values)) most = std::max(most, sample);
    EXPECT_NEAR(most, 0.5, 1e-3);
    stream.destroy();
}

TEST(BlockStream, TheQueueIsLongEnoughForTheDevicesPeriod) {
    EXPECT_EQ(detail::blocks_to_queue(384), 2U);
    EXPECT_EQ(detail::blocks_to_queue(385), 3U);
    EXPECT_EQ(detail::blocks_to_queue(1024), 4U);
    EXPECT_EQ(detail::blocks_to_queue(10), 2U);
    for (const double odd : {0.0, -1.0, std::nan("")}) EXPECT_EQ(detail::blocks_to_queue(odd), 2U);
    EXPECT_EQ(detail::blocks_to_queue(std::numeric_limits<double>::infinity()),
              detail::BlockStream::max_queued);
    // A device that takes periods of other lengths finds enough samples in the queue each time.
    for (const std::size_t period : {100U, 441U, 1024U, 1500U, 2048U}) {
        Card card(48'000);
        const auto scope = card.enter();
        detail::BlockStream stream(detail::blocks_to_queue(static_cast<double>(period)));
        Tone tone(500);
        std::vector<float> heard;
        for (int i = 0; i < 100; ++i) {
            for (auto wanted = stream.wanted(); wanted > 0; --wanted) stream.write(tone.next());
            card.render(heard, period);
        }
        EXPECT_EQ(stream.queued(), detail::blocks_to_queue(static_cast<double>(period))) << period;
        stream.destroy();
    }
}

}  // namespace
}  // namespace thaum::audio
