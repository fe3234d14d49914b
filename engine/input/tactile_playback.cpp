#include "input/tactile_playback.h"

#include <algorithm>
#include <utility>

#include "core/text.h"

namespace thaum::input {
namespace {

/// Time between checks of the queue while an output is open (s).
constexpr double open_rest_s = 0.004;
/// Time between checks of the queue while no output is open (s): short enough that the queue does not fill
/// up.
constexpr double closed_rest_s = 0.1;
constexpr double s_per_tick = 1e-3;

/// Merges an older tactile frame into a newer one: each actuator gets the larger amplitude.
void merge(const tactile::TactileFrame& older, tactile::TactileFrame& newer) {
    for (std::size_t i = 0; i < newer.amplitude.size(); ++i) {
        if (!(older.amplitude[i] > newer.amplitude[i])) continue;
        // An actuator that is silent in the newer frame has no carrier there, so it takes the older one.
        if (newer.amplitude[i] == 0) newer.carrier_hz[i] = older.carrier_hz[i];
        newer.amplitude[i] = older.amplitude[i];
    }
}

double life_of(const tactile::TactileFrame& frame) {
    return std::min(static_cast<double>(frame.time_to_live) * s_per_tick, TactilePlayback::longest_life_s);
}

}  // namespace

bool TactilePlayback::feel(const tactile::TactileFrame& frame) {
    const bool queued = frames_.push(frame);
    if (!queued) refused_.fetch_add(1, std::memory_order_relaxed);
    return queued;
}

void TactilePlayback::try_out(const tactile::TactileFrame& frame) {
    const std::lock_guard lock(told_);
    next_trial_ = frame;
}

void TactilePlayback::use(std::unique_ptr<TactileOutput> output) {
    const std::lock_guard lock(told_);
    std::swap(next_output_, output);
    changes_output_ = true;
}

std::string TactilePlayback::status() const {
    const std::lock_guard lock(told_);
    return status_;
}

TactileReport TactilePlayback::report() const {
    const std::lock_guard lock(told_);
    auto report = published_;
    report.frames_lost += refused_.load(std::memory_order_relaxed);
    return report;
}

void TactilePlayback::say(std::string status) {
    publish_report();
    const std::lock_guard lock(told_);
    status_ = std::move(status);
}

void TactilePlayback::publish_report() {
    const std::lock_guard lock(told_);
    published_ = report_;
}

double TactilePlayback::step(double now_s) {
    const double age_s = now_s - std::exchange(last_step_s_, now_s);
    take_output(now_s);
    if (!abandoned_ && !open_ && output_ != nullptr && now_s >= next_try_s_) try_open(now_s);
    const bool lost = !abandoned_ && open_ && !output_->is_connected();
    if (abandoned_) return closed_rest_s;
    if (lost) lose(now_s);
    if (open_)
        play(now_s, age_s);
    else
        drop_waiting();
    publish_report();
    return open_ ? open_rest_s : closed_rest_s;
}

void TactilePlayback::close() {
    if (open_) output_->close();
    open_ = false;
    sounding_ = false;
    say({});
}

void TactilePlayback::take_output(double now_s) {
    std::unique_ptr<TactileOutput> former;
    {
        const std::lock_guard lock(told_);
        if (!std::exchange(changes_output_, false)) return;
        former = std::exchange(output_, std::move(next_output_));
        status_.clear();
    }
    if (open_) former->close();
    open_ = false;
    sounding_ = false;
    next_try_s_ = now_s;
}

void TactilePlayback::try_open(double now_s) {
    const auto opened = output_->open();
    if (abandoned_) return;
    if (!opened) {
        next_try_s_ = now_s + retry_s;
        return say(text(output_->name(), ": ", opened.error().message));
    }
    open_ = true;
    opened_at_s_ = now_s;
    ++report_.times_opened;
    drop_waiting();
    say(text(output_->name(), " plays"));
}

void TactilePlayback::lose(double now_s) {
    const auto fault = output_->fault();
    output_->close();
    open_ = false;
    sounding_ = false;
    ++report_.times_lost;
    // A device that is back is opened at once, but a device that fails at each opening must not keep a core
    // busy.
    next_try_s_ = std::max(now_s, opened_at_s_ + retry_s);
    say(text(output_->name(), ": ", fault));
}

/// Drops the tactile frames that wait, while no output can play them.
void TactilePlayback::drop_waiting() {
    for (; frames_.front() != nullptr; frames_.pop()) ++report_.frames_lost;
}

/// Takes the newest tactile frame that a second source, such as a menu, has passed by `try_out`. Returns
/// whether there is a new one.
bool TactilePlayback::take_trial(double now_s) {
    const std::lock_guard lock(told_);
    if (!next_trial_) return false;
    trial_ = *std::exchange(next_trial_, std::nullopt);
    trial_until_s_ = now_s + life_of(trial_);
    return true;
}

/// Merges all waiting tactile frames into one, `frame_`. Returns their number.
std::size_t TactilePlayback::take_frames() {
    const auto count = frames_.size();
    for (std::size_t i = 0; i < count; ++i, frames_.pop()) {
        const auto before = std::exchange(frame_, *frames_.front());
        if (i > 0) merge(before, frame_);
    }
    return count;
}

/// Passes each waiting tactile frame on unchanged, for an output that wants every frame, such as a recorder.
void TactilePlayback::pass_all(double now_s) {
    for (; frames_.front() != nullptr; frames_.pop()) {
        ++report_.frames_sent;
        if (!frames_.front()->is_silent()) output_->write(*frames_.front(), now_s);
    }
}

/// Plays the waiting tactile frames. `age_s` is the greatest age that they may have (s).
void TactilePlayback::play(double now_s, double age_s) {
    if (output_->wants_every_frame()) return pass_all(now_s);
    const bool tried = take_trial(now_s);
    const auto count = take_frames();
    if (count > 0 && now_s < trial_until_s_) {
        merge(trial_, frame_);
    } else if (count == 0 && tried) {
        frame_ = trial_;
        send(now_s, life_of(trial_));
    }
    if (count > 0) {
        const double life_s = life_of(frame_) - age_s;
        report_.frames_merged += count - 1;
        if (life_s > 0)
            send(now_s, life_s);
        else
            ++report_.frames_late;
    }
    if (!sounding_ || now_s < silent_at_s_) return;
    output_->silence();
    sounding_ = false;
    ++report_.times_silenced;
}

void TactilePlayback::send(double now_s, double life_s) {
    ++report_.frames_sent;
    silent_at_s_ = now_s + life_s;
    if (frame_.is_silent()) {
        if (std::exchange(sounding_, false)) output_->silence();
        return;
    }
    sounding_ = true;
    output_->write(frame_, now_s);
}

}  // namespace thaum::input
