// Fake outputs for tactile frames.
#pragma once
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "input/tactile_output.h"

namespace thaum::input::rig {

/// State and settings of a fake output. The output and the test share it, since an abandoned thread may
/// outlive the test.
struct Felt {
    mutable std::mutex mutex;
    std::condition_variable changed;
    bool present{true};    ///< false: the output cannot be opened
    bool connected{true};  ///< false: the output has been unplugged
    bool hangs{};          ///< true: calls of `write` and `open` do not return until it is false
    bool wants_every{};    ///< true: the output asks for every frame that is not silent
    bool in_hang{};        ///< true: a call hangs at the moment
    int opened{}, closed{}, silenced{};
    bool on{};  ///< true: some actuator is on
    std::vector<tactile::TactileFrame> frames;

    template <class Condition>
    void wait(Condition condition) {
        std::unique_lock lock(mutex);
        changed.wait(lock, condition);
    }
    template <class Change>
    auto with(Change change) {
        const std::lock_guard lock(mutex);
        changed.notify_all();
        return change();
    }
    /// Waits while `hangs` is true. Must be called with the mutex locked.
    void hang(std::unique_lock<std::mutex>& lock) {
        in_hang = hangs;
        changed.notify_all();
        changed.wait(lock, [this] { return !hangs; });
        in_hang = false;
    }
};

class FakeOutput : public TactileOutput {
public:
    explicit FakeOutput(std::shared_ptr<Felt> felt) : felt_(std::move(felt)) {}

    Expected<void> open() override {
        std::unique_lock lock(felt_->mutex);
        felt_->hang(lock);
        ++felt_->opened;
        felt_->changed.notify_all();
        if (!felt_->present) return fail("it is not there");
        felt_->connected = true;
        return {};
    }
    void write(const tactile::TactileFrame& frame, double) override {
        std::unique_lock lock(felt_->mutex);
        felt_->hang(lock);
        felt_->frames.push_back(frame);
        felt_->on = true;
        felt_->changed.notify_all();
    }
    void silence() override {
        felt_->with([this] { ++felt_->silenced, felt_->on = false; });
    }
    bool is_connected() override {
        return felt_->with([this] { return felt_->connected; });
    }
    void close() override {
        felt_->with([this] { ++felt_->closed, felt_->on = false; });
    }
    bool wants_every_frame() const override {
        return felt_->with([this] { return felt_->wants_every; });
    }
    std::string name() const override { return "fake"; }

private:
    std::shared_ptr<Felt> felt_;
};

/// A tactile frame for the two motors of a pad.
inline tactile::TactileFrame frame_of(float left, float right, Tick time_to_live = 48) {
    tactile::TactileFrame frame{.time_to_live = time_to_live, .count = 2};
    frame.amplitude[0] = left;
    frame.amplitude[1] = right;
    frame.carrier_hz[0] = frame.carrier_hz[1] = 100;
    return frame;
}

}  // namespace thaum::input::rig
