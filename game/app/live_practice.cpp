#include "game/app/live_practice.h"

#include <chrono>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "core/threads.h"

namespace thaum::app {
namespace {

constexpr auto look_period = std::chrono::milliseconds(200);
constexpr Tick welcome_shown = ticks(8.0), reading_shown = ticks(4.0);
constexpr Tick until_next_reading = std::numeric_limits<Tick>::max() / 2;

}  // namespace

DataWatcher::DataWatcher(game::RangeFiles files) : files_(std::move(files)) {
    // Without this thread data files are read only once, and practice goes on.
    if (auto started = start_thread([this] { watch(); })) thread_ = std::move(*started);
}

DataWatcher::~DataWatcher() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    stopped_.notify_one();
}

void DataWatcher::watch() {
    std::unique_lock lock(mutex_);
    while (!stopped_.wait_for(lock, look_period, [this] { return stop_; })) {
        auto reload = files_.look();
        if (!reload) continue;
        reloads_.to_fill() = std::move(*reload);
        reloads_.publish();
    }
}

const game::Reload* DataWatcher::take() { return reloads_.take() ? &reloads_.newest() : nullptr; }

Practice::Practice(const game::RangeData& data, const std::vector<input::DeviceSpec>& devices,
                   game::DummyKind kind, std::uint64_t seed)
    : data_(data),
      range_(game::make_range(data, devices.front(), kind, seed, {devices.begin() + 1, devices.end()})) {
    say("The range: nothing is recorded, and data files that change are read at once", welcome_shown);
}

void Practice::say(std::string words, Tick how_long) {
    caption_ = {.words = std::move(words), .fault = how_long == until_next_reading};
    caption_until_ = match().match().played + how_long;
}

void Practice::set_dummy(game::DummyKind kind) {
    if (kind == range_.dummy.kind()) return;
    range_.dummy.become(kind);
    scorer_.reset(match());
}

bool Practice::set_changes(const game::RangeChanges& changes) {
    if (changes == changes_) return false;
    changes_ = changes;
    range_.adopt(changed(data_, changes_));
    return true;
}

void Practice::adopt(const game::Reload& reload) {
    say(reload.line, reload.data ? reading_shown : until_next_reading);
    if (!reload.data) return;
    data_ = *reload.data;
    range_.adopt(changed(data_, changes_));
    scorer_.reset(match());
}

void Practice::show(game::Picture& picture) {
    const auto& dummy = picture.wizards[game::dummys];
    const auto health =
        dummy.dead ? std::string("comes back") : text(std::lround(std::ceil(dummy.health)), " HP");
    picture.practice.on = true;
    picture.practice.score = score();
    picture.practice.dummy =
        text(game::dummy_names[static_cast<std::size_t>(range_.dummy.kind())], " dummy: ", health);
    if (match().match().played < caption_until_)
        picture.caption = caption_;
    else
        picture.caption = {};
}

}  // namespace thaum::app
