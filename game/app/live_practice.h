// game/app/live_practice.h: the range in a live session: its match and dummy, the scores, and data files that are read again
// when they change.
#pragma once
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/latest.h"
#include "game/bots/range_files.h"
#include "game/hud/picture.h"

namespace thaum::app {

/// Looks after the files in a thread of its own, so that neither the match nor the window waits for the disk.
class DataWatcher {
public:
    explicit DataWatcher(game::RangeFiles files);
    ~DataWatcher();
    DataWatcher(const DataWatcher&) = delete;
    DataWatcher& operator=(const DataWatcher&) = delete;

    /// The newest that was read since the last call, or null; it stays until the next call. Does not wait.
    const game::Reload* take();

private:
    void watch();

    game::RangeFiles files_;
    Latest<game::Reload> reloads_{game::Reload{}};
    std::mutex mutex_;
    std::condition_variable stopped_;
    bool stop_ = false;
    std::thread thread_;
};

class Practice {
public:
    /// devices: of who practises: hands, and an arm if they hold one.
    Practice(game::RangeFiles files, const std::vector<input::DeviceSpec>& devices, game::DummyKind kind,
             std::uint64_t seed);

    game::Simulation& match() { return *range_.match; }
    input::DeviceSample dummy_sample() { return range_.dummy.sample(*range_.match); }
    void set_dummy(game::DummyKind kind);
    /// Goes on by data that was read since the last call, and returns it; match() is then another.
    std::shared_ptr<const game::RangeData> adopt_reload();
    void show(game::Picture& picture);
    std::string score() { return words_of(scorer_.score(*range_.match)); }

private:
    void say(std::string words, Tick how_long);

    game::RangeMatch range_;
    game::RangeScorer scorer_{};
    game::Caption caption_{};
    Tick caption_until_{};                  ///< of play, so that a pause does not hide it
    std::unique_ptr<DataWatcher> watcher_;  ///< last: begins when the rest is there
};

}  // namespace thaum::app
