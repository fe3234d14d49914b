#include "game/live/replay.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace thaum::game::inline live {
namespace {

/// time for which the thread sleeps before it looks for requests of the viewer again (ns)
constexpr std::int64_t idle_ns = 8'000'000;
constexpr double publish_period_ns = 4e6;  ///< period of published pictures, at any speed (ns of real time)
/// delay behind the clock above which the replay does not hurry to make up for it (ns); no tick is lost,
/// since all are shown later
constexpr std::int64_t max_behind_ns = 250'000'000;

struct ReplayThread {
    const ShownReplay& replay;
    LiveShared& shared;
    MatchSound sound;
    MatchBody body;
    std::int64_t start_ns = 0;  ///< deadline of tick 0 at the present speed (ns)
    double speed = 1;
    bool at_end = false;

    Playback& playback() { return replay.playback; }
    Tick now() const { return replay.playback.match().now(); }
    double tick_ns() const { return static_cast<double>(ns_per_tick) / speed; }
    std::int64_t due_ns(Tick tick) const {
        return start_ns + std::llround(static_cast<double>(tick) * tick_ns());
    }
};

/// Sets the clock so that the present tick is due now and nothing before it has to be made up for. Called
/// after a pause, a jump or a change of speed.
void begin_clock(ReplayThread& r) {
    r.start_ns = 0;
    r.start_ns = monotonic_ns() - r.due_ns(r.now());
}

/// Number of a bookmark of the log within the last mark_shown ticks, which the screen shows; 0: there is
/// none.
std::uint32_t recent_mark(const Playback& playback) {
    const auto now = playback.match().now();
    const auto& marks = playback.log().marks();
    auto mark = std::upper_bound(marks.begin(), marks.end(), now,
                                 [](Tick tick, const input::Mark& m) { return tick < m.tick; });
    while (mark != marks.begin() && now < (--mark)->tick + mark_shown) {
        if (mark->kind == input::MarkKind::user) return mark->number;
    }
    return 0;
}

/// Words on a replay that differs from the recorded match, or that has come to its end.
Caption caption_of(const ReplayThread& r) {
    const auto& playback = r.replay.playback;
    const auto differs = earlier(playback.divergence(), r.replay.index.divergence());
    if (differs && r.now() >= differs->recorded.tick)
        return {text("From ", clock_text(differs->recorded.tick / ticks_per_second),
                     " on this replay differs from the recorded match."),
                true};
    if (!r.at_end) return {};
    switch (playback.log().ending()) {
        case input::LogEnding::clean: return {"The recording ends here.", false};
        case input::LogEnding::cut_off: return {"The recording was cut off here.", true};
        case input::LogEnding::damaged: return {"The recording is damaged from here on.", true};
    }
    return {};
}

void publish(ReplayThread& r) {
    auto& picture = r.shared.pictures.to_fill();
    take_picture(r.playback().match(), picture);
    picture.due_ns = r.due_ns(picture.tick);
    picture.mark = recent_mark(r.playback());
    picture.practice = {};
    picture.caption = caption_of(r);
    r.sound.show(picture);
    r.body.show(picture);
    r.shared.pictures.publish();
    r.shared.replay.now = picture.tick;
}

/// Jumps to a tick once the index of saved states has been filled that far. Until then only sleeps for a
/// moment, and must be called again.
void go_to(ReplayThread& r, Tick target) {
    const auto& index = r.replay.index;
    if (!index.covers(target) && !index.complete()) return sleep_until_ns(monotonic_ns() + idle_ns);
    if (const auto there = seek(r.playback(), index, target, r.shared.stop); !there) {
        r.shared.simulation_error = there.error();
        r.shared.stop = true;
        return;
    }
    r.at_end = r.now() < target || target == r.playback().log().ticks();
    begin_clock(r);
    r.sound.forget();
    r.body.forget();
    publish(r);
    // Another jump may have been asked for meanwhile. That request must not be lost.
    r.shared.replay.target.compare_exchange_strong(target, ReplayRequests::nowhere);
}

/// Plays the ticks that are due, until the next picture.
void play(ReplayThread& r) {
    const auto late_ns = monotonic_ns() - r.due_ns(r.now() + 1);
    if (late_ns < 0) return sleep_until_ns(r.due_ns(r.now() + 1));
    if (late_ns > max_behind_ns) begin_clock(r);
    const auto every = static_cast<Tick>(std::max(1.0, std::round(publish_period_ns / r.tick_ns())));
    do {
        r.at_end = !r.playback().step();
        r.sound.follow(r.playback().match());
        r.body.follow(r.playback().match(), r.sound);
    } while (!r.at_end && r.now() % every != 0 && monotonic_ns() >= r.due_ns(r.now() + 1));
    if (r.at_end || r.now() % every == 0) publish(r);
}

}  // namespace

void run_replay(const LivePlan& plan, LiveShared& shared, const std::function<void()>& wake) {
    while (!shared.ready && !shared.stop) sleep_until_ns(monotonic_ns() + idle_ns);
    ReplayThread r{.replay = *plan.replay,
                   .shared = shared,
                   .sound = MatchSound(shared.sound.get()),
                   .body = MatchBody(shared.body, shared.tactile, shared.sound.get()),
                   .speed = plan.replay->speed};
    begin_clock(r);
    publish(r);
    while (!shared.stop) {
        if (const double speed = shared.replay.speed; speed != r.speed) {
            r.speed = speed;
            begin_clock(r);
        }
        if (const auto target = shared.replay.target.load(); target != ReplayRequests::nowhere) {
            go_to(r, target);
            wake();
        } else if (shared.replay.paused || r.at_end) {
            if (r.now() != shared.replay.now) publish(r);
            sleep_until_ns(monotonic_ns() + idle_ns);
            begin_clock(r);
        } else {
            play(r);
        }
    }
    shared.progress.ended = true;
    wake();
}

}  // namespace thaum::game::inline live
