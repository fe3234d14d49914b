// Tests of the speakers' thread. The fake devices let a test wait until they have done something, so no test
// waits for a fixed time.
#include "audio/speakers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "unit/audio_rig.h"

namespace thaum::audio {
namespace {

using namespace rig;

/// What a test sees and sets of the fake devices that it has given to the speakers.
struct Watched {
    std::mutex mutex;
    std::condition_variable changed;
    std::size_t written = 0;
    float loudest = 0;
    bool blocks_open = false, blocks_close = false;
    bool in_open = false, in_close = false, destroyed = false;
    bool connected = true;
    int opened = 0;

    template <class Condition>
    void wait(Condition condition) {
        std::unique_lock lock(mutex);
        changed.wait(lock, condition);
    }
    template <class Value>
    Value get(Value Watched::*value) {
        const std::lock_guard lock(mutex);
        return this->*value;
    }
    template <class Change>
    void change(Change change) {
        const std::lock_guard lock(mutex);
        change();
        changed.notify_all();
    }
};

class WatchedDevice final : public SoundDevice {
public:
    explicit WatchedDevice(std::shared_ptr<Watched> watched) : watched_(std::move(watched)) {}
    ~WatchedDevice() override {
        watched_->change([&] { watched_->destroyed = true; });
    }
    Expected<void> open() override {
        watched_->change([&] { watched_->in_open = true; });
        watched_->wait([&] { return !watched_->blocks_open; });
        watched_->change([&] { ++watched_->opened, watched_->connected = true; });
        return {};
    }
    std::size_t wanted() override { return 1; }
    void write(std::span<const float> block) override {
        watched_->change([&] {
            ++watched_->written;
            for (const float sample : block)
                watched_->loudest = std::max(watched_->loudest, std::abs(sample));
        });
    }
    bool is_connected() override {
        const std::lock_guard lock(watched_->mutex);
        return watched_->connected;
    }
    void close() override {
        watched_->change([&] { watched_->in_close = true; });
        watched_->wait([&] { return !watched_->blocks_close; });
    }

private:
    std::shared_ptr<Watched> watched_;
};

TEST(Speakers, PlayWhatOtherThreadsSend) {
    const auto watched = std::make_shared<Watched>();
    Speakers speakers(mixer(), std::make_unique<WatchedDevice>(watched));
    std::atomic<bool> stop = false;
    std::jthread simulation([&] {
        while (!stop) {
            speakers.hear(frame_with({voice(hum, {1, 0, 0})}, {voice(bell, {1, 0, 0})}));
            std::this_thread::yield();
        }
    });
    for (int i = 0; i < 20; ++i) {
        speakers.hear(at_ear(wood));
        speakers.set({.master = 0.5 + 0.02 * i});
        const auto before = watched->get(&Watched::written);
        watched->wait([&] { return watched->written > before + 5; });
        EXPECT_EQ(speakers.status(), "sound plays");
    }
    stop = true;
    watched->wait([&] { return watched->loudest > 0.1F; });
    EXPECT_GT(speakers.report().blocks_written, 100U);
    EXPECT_LE(watched->get(&Watched::loudest), 1);
}

TEST(Speakers, ALostDeviceIsOpenedAgain) {
    const auto watched = std::make_shared<Watched>();
    Speakers speakers(mixer(), std::make_unique<WatchedDevice>(watched));
    for (int round = 1; round <= 3; ++round) {
        watched->wait([&] { return watched->opened == round && watched->written > 0; });
        watched->change([&] { watched->connected = false, watched->written = 0; });
    }
    watched->wait([&] { return watched->opened == 4; });
    EXPECT_GE(speakers.report().times_lost, 3U);
}

TEST(Speakers, ADeviceThatBlocksInItsOpeningHoldsNobodyUp) {
    const auto watched = std::make_shared<Watched>();
    watched->blocks_open = true;
    {
        Speakers speakers(mixer(), std::make_unique<WatchedDevice>(watched), 0);
        watched->wait([&] { return watched->in_open; });
        int taken = 0;
        for (int i = 0; i < 1000; ++i) taken += speakers.hear(frame_with({at_ear(hum)})) ? 1 : 0;
        EXPECT_EQ(taken, 64) << "a full queue drops frames";
        EXPECT_EQ(speakers.status(), "");
        EXPECT_EQ(speakers.report().blocks_written, 0U);
    }  // the call that opens the device still blocks, so its thread is abandoned
    watched->change([&] { watched->blocks_open = false; });
    watched->wait([&] { return watched->opened == 1; });
    EXPECT_EQ(watched->get(&Watched::written), 0U) << "the device is not used any more";
    EXPECT_FALSE(watched->get(&Watched::destroyed));
}

TEST(Speakers, ADeviceThatBlocksInItsClosingHoldsNobodyUp) {
    const auto watched = std::make_shared<Watched>();
    watched->blocks_close = true;
    {
        Speakers speakers(mixer(), std::make_unique<WatchedDevice>(watched), 0);
        watched->wait([&] { return watched->written > 3; });
        watched->change([&] { watched->connected = false; });  // a device that is unplugged is closed
        watched->wait([&] { return watched->in_close; });
    }
    EXPECT_FALSE(watched->get(&Watched::destroyed));
    watched->change([&] { watched->blocks_close = false; });
}

TEST(Speakers, AtItsEndTheDeviceIsClosed) {
    const auto watched = std::make_shared<Watched>();
    {
        constexpr double long_enough = 3600;
        Speakers speakers(mixer(), std::make_unique<WatchedDevice>(watched), long_enough);
        watched->wait([&] { return watched->opened == 1; });
    }
    EXPECT_TRUE(watched->get(&Watched::in_close));
    EXPECT_TRUE(watched->get(&Watched::destroyed));
}

TEST(Speakers, WaitLessThanTwoSecondsForADevice) { EXPECT_LT(Speakers::max_wait_s, 2); }

}  // namespace
}  // namespace thaum::audio
