#include "game/app/watch.h"

#include <cstdio>

#include "core/file.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/live.h"
#include "game/app/still.h"

namespace thaum::app {

namespace {

/// Exit code of a shown replay: does_not_hold, with a message, if the replay diverged from the record.
int verdict(const game::Playback& playback) {
    if (!playback.divergence()) return done;
    std::printf("%s\n", game::described(*playback.divergence()).c_str());
    return does_not_hold;
}

int watch_in_window(game::Playback playback, double speed) {
    const auto assets = game::find_assets();
    LivePlan plan;
    plan.data = std::make_shared<const game::MatchData>(playback.match().data());
    plan.replay = &playback;
    plan.speed = speed;
    plan.assets = assets;
    plan.settings = settings_to_play_with(settings_file(), assets);
    const int result = run_live(plan);
    return result == done ? verdict(playback) : result;
}

int leave_picture(game::Playback& playback, const WatchPlan& plan) {
    const auto stem = plan.out / text("replay_", plan.start);
    if (const auto made = make_folder(plan.out); !made) return refuse(made.error());
    for (const auto* ending : {".png", ".dump"}) {
        if (const auto free = check_output(stem.string() + ending); !free) return refuse(free.error());
    }
    playback.play_to(plan.start);
    const auto& match = playback.match();
    auto still = Still::create(match.data(), game::find_assets(), {1280, 720});
    if (!still) return refuse(still.error());
    if (const auto saved = still->save(match, {}, stem.string() + ".png"); !saved)
        return refuse(saved.error());
    Bytes state;
    match.save(state);
    if (const auto saved = write_file(stem.string() + ".dump", state); !saved) return refuse(saved.error());
    std::printf("no display: tick %llu, state %s, in %s.png and .dump\n",
                static_cast<unsigned long long>(match.now()), hex(match.state_hash()).c_str(), stem.c_str());
    return verdict(playback);
}

}  // namespace

int watch(game::Playback playback, const WatchPlan& plan) {
    if (!display_there()) return leave_picture(playback, plan);
    playback.play_to(plan.start);
    return watch_in_window(std::move(playback), plan.speed);
}

}  // namespace thaum::app
