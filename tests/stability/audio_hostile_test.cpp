// Gives the mixer frames of random, often impossible values: its output must stay within -1 to 1, and the
// mixer must recover.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "audio/detail/limiter.h"
#include "core/random.h"
#include "unit/audio_rig.h"

namespace thaum::audio {
namespace {

using namespace rig;

class Attacker {
public:
    explicit Attacker(std::uint64_t seed) : random_{seed} {}

    double number() {
        constexpr std::array odd{0.0,
                                 -0.0,
                                 1.0,
                                 -1.0,
                                 1e-320,
                                 1e300,
                                 -1e300,
                                 40.0,
                                 std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()};
        const auto kind = below(16);
        return kind < odd.size() ? odd[kind] : 20 * random_.uniform() - 10;
    }
    vec3 vector() { return {number(), number(), number()}; }
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_.uniform() * count); }
    Voice voice() {
        Voice made;
        made.sound = below(sound_count + 2);
        made.key = below(12);
        made.heard_by = below(5);
        made.at_ear = below(4) == 0;
        made.position = vector();
        made.gain = number();
        made.pitch = number();
        made.muffled = {number(), number()};
        return made;
    }
    AudioFrame frame() {
        AudioFrame made;
        made.listener_count = below(4);
        for (auto& listener : made.listeners) listener = {vector(), vector(), vector()};
        for (auto count = below(40); count > 0; --count) made.lasts.add(voice());
        for (auto count = below(40); count > 0; --count) made.begins.add(voice());
        if (below(50) == 0) made.lasts.count = below(4'000'000'000U);
        return made;
    }
    MixSettings settings() {
        return {.master = number(),
                .effects = number(),
                .music = number(),
                .interface = number(),
                .headphones = below(2) == 0,
                .ears = static_cast<Ears>(below(3))};
    }

private:
    Random random_;
};

TEST(MixerHostile, RandomFramesNeverClipAndNeverBreakTheMixer) {
    auto mixing = mixer();
    Attacker attacker(22);
    std::array<float, block_values> block{};
    double loudest = 0;
    for (int i = 0; i < 3000; ++i) {
        if (attacker.below(40) == 0) mixing.set(attacker.settings());
        if (attacker.below(200) == 0) mixing.silence();
        for (auto count = attacker.below(30); count > 0; --count) mixing.begin(attacker.voice());
        if (attacker.below(5) == 0)
            mixing.run_on(block);
        else
            mixing.play(attacker.frame(), block);
        for (const float sample : block) {
            ASSERT_TRUE(std::abs(sample) <= 1) << sample << " in block " << i;
            loudest = std::max(loudest, static_cast<double>(std::abs(sample)));
        }
        ASSERT_LE(mixing.report().voices, 2 * max_heard);
    }
    EXPECT_GT(loudest, 0.9);
    EXPECT_GT(mixing.report().bad_values, 10'000U);
    // After all that input, a tone must sound as in a new mixer.
    mixing.set({});
    Recorder recorder(mixing);
    recorder.play(frame_with({voice(hum, {1, 0, 0})}), 100);
    EXPECT_NEAR(recorder.levels(20).right, 0.5, 2e-3);
    EXPECT_EQ(mixing.report().voices, 1U);
}

/// The limiter's gain, measured with a constant signal in one channel while peaks occur in the other, must
/// change only a little from sample to sample.
TEST(Limiter, ItsGainMovesEvenlyAndKeepsEveryPeakBelowOne) {
    detail::Limiter limiter;
    Attacker attacker(5);
    float before = 0;
    std::size_t reduced = 0;
    for (int i = 0; i < 500; ++i) {
        std::array<float, block_values> block{};
        for (std::size_t k = 0; k < block.size(); k += 2) {
            block[k] = 0.01F;  // a constant signal, in which the gain can be seen
            const bool peak = attacker.below(1000) == 0;
            block[k + 1] = peak ? 1.0F + 10.0F * static_cast<float>(attacker.below(3)) : 0.3F;
        }
        reduced += limiter.process(block) ? 1 : 0;
        for (std::size_t k = 0; k < block.size(); k += 2) {
            ASSERT_LE(std::abs(block[k + 1]), 1);
            const float gain = block[k] / 0.01F;
            if (i > 0) {
                // The gain may fall completely in the 96 samples of the delay, and rises in 0.25 s.
                ASSERT_GT(gain - before, -1.01 / 96) << i;
                ASSERT_LT(gain - before, 1e-3) << i;
            }
            before = gain;
        }
    }
    EXPECT_GT(reduced, 400U);
}

TEST(Limiter, AQuietSignalPassesUnchangedAlsoAfterALoudOne) {
    detail::Limiter limiter;
    std::array<float, block_values> block{};
    block.fill(50);
    EXPECT_TRUE(limiter.process(block));
    block.fill(std::numeric_limits<float>::quiet_NaN());
    limiter.process(block);
    for (int i = 0; i < 60; ++i) {
        block.fill(0.123F);
        limiter.process(block);
    }
    for (const float sample : block) ASSERT_EQ(sample, 0.123F);
    block.fill(0.9F);
    EXPECT_FALSE(limiter.process(block));
}

}  // namespace
}  // namespace thaum::audio
