#include "audio/playback.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/text.h"

namespace thaum::audio {
namespace {

constexpr double block_s = static_cast<double>(frame_samples) / sample_rate;
/// Time between two checks of a device that plays (s).
constexpr double playing_rest_s = 0.002;
/// Time between two checks of the queues while nothing plays (s): short enough that they do not fill up.
constexpr double silent_rest_s = 0.1;
/// Largest rate at which a device may take blocks, relative to real time. A device that claims to take more
/// could keep a core busy.
constexpr double max_speed = 1.25;
/// Longest time between two steps that is counted as waiting for the device (s).
constexpr double longest_wait_s = 0.05;

}  // namespace

Playback::Playback(Mixer mixer, std::unique_ptr<SoundDevice> device)
    : mixer_(std::move(mixer)), device_(std::move(device)) {}

void Playback::set(const MixSettings& settings) {
    settings_.to_fill() = settings;
    settings_.publish();
}

std::string Playback::status() const {
    const std::lock_guard lock(told_);
    return status_;
}

PlaybackReport Playback::report() const {
    const std::lock_guard lock(told_);
    return published_;
}

void Playback::say(std::string status) {
    publish_report();
    const std::lock_guard lock(told_);
    status_ = std::move(status);
}

void Playback::publish_report() {
    report_.mix = mixer_.report();
    const std::lock_guard lock(told_);
    published_ = report_;
}

double Playback::step(double now_s) {
    if (settings_.take()) mixer_.set(settings_.newest());
    if (!open_ && now_s >= next_try_s_) try_open(now_s);
    if (open_ && !device_->is_connected()) lose(now_s, "the sound device is gone");
    if (!open_) {
        drop_waiting();
        return silent_rest_s;
    }
    // If this thread itself was held up, the device is not to blame for all of the time since the last step,
    // so only a part of it counts.
    waited_s_ += std::clamp(now_s - last_step_s_, 0.0, longest_wait_s);
    const auto blocks = allowed(device_->wanted(), now_s);
    feed(blocks);
    if (blocks > 0)
        waited_s_ = 0;
    else if (waited_s_ > patience_s)
        lose(now_s, "the sound device takes no sound");
    return playing_rest_s;
}

void Playback::close() {
    if (open_) device_->close();
    open_ = plays_ = false;
    say("no sound: ended");
}

void Playback::try_open(double now_s) {
    const auto opened = device_->open();
    if (abandoned_) return;
    if (!opened) {
        next_try_s_ = now_s + retry_s;
        return say(text("no sound: ", opened.error().message, "; a new try every ", retry_s, " s"));
    }
    open_ = plays_ = true;
    ++report_.times_opened;
    last_step_s_ = now_s;
    waited_s_ = 0;
    credit_ = max_at_once;
    // Nobody has heard what was played or queued before this moment, so it is dropped.
    mixer_.silence();
    drop_waiting();
    say("sound plays");
}

void Playback::lose(double now_s, std::string_view why) {
    device_->close();
    open_ = plays_ = false;
    if (abandoned_) return;
    ++report_.times_lost;
    // Another device may already be available, such as the speakers after headphones were pulled out, so the
    // next try comes at once.
    next_try_s_ = now_s;
    say(text("no sound: ", why, "; trying to open it again"));
}

void Playback::drop_waiting() {
    while (frames_.front() != nullptr) frames_.pop();
    while (voices_.front() != nullptr) voices_.pop();
}

/// Number of audio blocks to write: as many as the device asks for, but no more than real time allows.
std::size_t Playback::allowed(std::size_t wanted, double now_s) {
    const double passed = std::max(0.0, now_s - last_step_s_);
    last_step_s_ = now_s;
    credit_ = std::min<double>(max_at_once, credit_ + passed / block_s * max_speed);
    const auto blocks = std::min(wanted, static_cast<std::size_t>(credit_));
    credit_ -= static_cast<double>(blocks);
    return blocks;
}

void Playback::feed(std::size_t blocks) {
    std::array<float, block_values> block{};
    for (std::size_t i = 0; i < blocks; ++i) {
        mix_block(blocks - i, block);
        device_->write(block);
        ++report_.blocks_written;
    }
    if (blocks > 0) publish_report();
}

void Playback::mix_block(std::size_t blocks_left, std::span<float> block) {
    for (; voices_.front() != nullptr; voices_.pop()) mixer_.begin(*voices_.front());
    // Each block takes one frame. If more frames are waiting than blocks are left, the oldest ones are
    // merged.
    for (; frames_.size() > blocks_left; frames_.pop()) {
        const auto& begins = frames_.front()->begins;
        const auto count = std::min<std::size_t>(begins.count, begins.voices.size());
        for (std::size_t i = 0; i < count; ++i) mixer_.begin(begins.voices[i]);
        ++report_.frames_merged;
    }
    if (const auto* frame = frames_.front()) {
        mixer_.play(*frame, block);
        quiet_.listener_count = frame->listener_count;
        quiet_.listeners = frame->listeners;
        frames_.pop();
        blocks_without_frame_ = 0;
        return;
    }
    ++blocks_without_frame_;
    if (static_cast<double>(blocks_without_frame_) * block_s > late_after_s)
        mixer_.play(quiet_, block);
    else
        mixer_.run_on(block);
}

}  // namespace thaum::audio
