// Fake sound devices, driven by a clock that the test sets.
#pragma once
#include <deque>
#include <vector>

#include "audio/sound_device.h"
#include "unit/audio_rig.h"

namespace thaum::audio::rig {

/// State and settings of a fake sound card, shared with the test. Must outlive the device.
struct FakeCard {
    double now_s{};        ///< time of the card's clock (s)
    double speed{1};       ///< speed of the card's clock relative to the test's
    std::size_t queue{2};  ///< number of blocks that the card queues
    std::size_t lie{};     ///< if not 0: number of blocks that the card claims to want, true or not
    bool present{true};    ///< false: the card cannot be opened
    bool connected{true};  ///< false: the card has been unplugged
    bool deaf{};           ///< true: the card never wants a block
    int opened{}, closed{};
    std::size_t gaps{};
    std::vector<float> played;        ///< all samples that have been heard
    std::vector<double> played_at_s;  ///< the time at which each block began to sound
    std::deque<std::vector<float>> waiting;
    bool playing{};
    double block_ends_s{};

    /// Plays until the time is `until_s`, on the test's clock.
    void play_until(double until_s) {
        now_s = until_s;
        while (playing && block_ends_s <= now_s) {
            waiting.pop_front();
            playing = !waiting.empty();
            if (playing)
                start_block(block_ends_s);
            else
                ++gaps;
        }
    }
    void start_block(double at_s) {
        playing = true;
        played.insert(played.end(), waiting.front().begin(), waiting.front().end());
        played_at_s.push_back(at_s);
        block_ends_s = at_s + 0.008 / speed;
    }
};

class FakeDevice final : public SoundDevice {
public:
    explicit FakeDevice(FakeCard& card) : card_(card) {}
    Expected<void> open() override {
        ++card_.opened;
        if (!card_.present) return fail("no sound device was found");
        card_.connected = true;
        card_.waiting.clear();
        card_.playing = false;
        return {};
    }
    std::size_t wanted() override {
        if (card_.deaf) return 0;
        if (card_.lie != 0) return card_.lie;
        return card_.queue - std::min(card_.queue, card_.waiting.size());
    }
    void write(std::span<const float> block) override {
        card_.waiting.emplace_back(block.begin(), block.end());
        if (!card_.playing && card_.waiting.size() >= card_.queue) card_.start_block(card_.now_s);
    }
    bool is_connected() override { return card_.connected; }
    void close() override { ++card_.closed; }

private:
    FakeCard& card_;
};

}  // namespace thaum::audio::rig
