#include "game/app/watch.h"

#include "core/file.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "core/threads.h"
#include "game/app/command.h"
#include "game/hud/still.h"
#include "game/live/live.h"
#include "game/settings/recorded_names.h"
#include "render/display.h"
#include "render/priority.h"

namespace thaum::game::inline app {

namespace {

/// Exit code of a watched replay: does_not_hold, with a message, if the replay diverged from the record.
int verdict(const std::optional<Divergence>& divergence) {
    if (!divergence) return done;
    print_line(described(*divergence));
    return does_not_hold;
}

/// Starts a thread that fills the index, the stored states from which jumps in the replay are quick. The
/// thread has lower priority than the replay itself.
Expected<std::jthread> fill_beside(const Playback& playback, ReplayIndex& index,
                                   const std::atomic<bool>& stop) {
    auto again = playback.open_again();
    if (!again) return again.error();
    return start_thread([&index, &stop, again = std::move(*again)]() mutable {
        render::work_behind_others();
        index.fill(std::move(again), stop);
    });
}

/// Shows the replay while its index of stored states is filled. Without these states, a jump ahead must
/// compute every tick on the way.
int run_with_index(const LivePlan& plan, const Playback& playback, ReplayIndex& index) {
    std::atomic<bool> stop{false};
    const auto filling = fill_beside(playback, index, stop);
    if (!filling) {
        tell_user(text("thaum: jumps ahead will be slow: ", filling.error().message));
        index.give_up();
    }
    const int result = exit_code_of(run_live(plan));
    stop = true;
    return result;
}

int watch_in_window(Playback playback, const WatchPlan& watched) {
    const auto assets = find_assets();
    ReplayIndex index(playback);
    const ShownReplay replay{playback, index, watched.start, watched.speed};
    LivePlan plan;
    plan.data = std::make_shared<const MatchData>(playback.match().data());
    plan.replay = &replay;
    plan.assets = assets;
    plan.settings = settings_to_play_with(settings_file(), assets).settings;
    const int result = run_with_index(plan, playback, index);
    return result == done ? verdict(earlier(playback.divergence(), index.divergence())) : result;
}

int leave_picture(Playback& playback, const WatchPlan& plan) {
    const auto stem = plan.out / text("replay_", plan.start);
    if (const auto made = make_folder(plan.out); !made) return refuse(made.error());
    for (const auto* ending : {".png", ".dump"}) {
        if (const auto free = check_output(stem.string() + ending); !free) return refuse(free.error());
    }
    playback.play_to(plan.start);
    const auto& match = playback.match();
    auto still = Still::create(match.data(), find_assets(), {1280, 720});
    if (!still) return refuse(still.error());
    if (const auto saved =
            still->save(match, {.names = recorded_names(playback.log().header())}, stem.string() + ".png");
        !saved)
        return refuse(saved.error());
    Bytes state;
    match.save(state);
    if (const auto saved = write_file(stem.string() + ".dump", state); !saved) return refuse(saved.error());
    print_line(text("no display: tick ", match.now(), ", state ", hex(match.state_hash()), ", in ",
                    stem.string(), ".png and .dump"));
    return verdict(playback.divergence());
}

}  // namespace

int watch(Playback playback, const WatchPlan& plan) {
    if (!render::display_there()) return leave_picture(playback, plan);
    return watch_in_window(std::move(playback), plan);
}

}  // namespace thaum::game::inline app
