#include "game/live/live.h"

#include <algorithm>
#include <thread>

#include "core/random.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "core/threads.h"
#include "game/live/end_watch.h"
#include "game/live/replay.h"
#include "game/live/window.h"
#include "game/settings/own_pads.h"

namespace thaum::game::inline live {

// Shared ----------------------------------------------------------------------------------------------------

void Staller::pass(Stall::Thread thread) {
    if (stall.thread != thread) return;
    const auto now = monotonic_ns();
    if (next_ns == 0) next_ns = now + stall.every_ms * std::int64_t{1'000'000};
    if (now < next_ns) return;
    sleep_until_ns(now + stall.ms * std::int64_t{1'000'000});
    next_ns = monotonic_ns() + stall.every_ms * std::int64_t{1'000'000};
}

double Timings::at(double share) {
    if (values_.empty()) return 0;
    std::sort(values_.begin(), values_.end());
    return values_[static_cast<std::size_t>(share * static_cast<double>(values_.size() - 1))];
}

// Matches ---------------------------------------------------------------------------------------------------

namespace {

/// A live session with the window and the data that its threads share.
struct Live {
    const LivePlan& plan;
    LiveShared& shared;
    LiveSession& session;
    LiveWindow window;
};

/// Opens the log of the session's match `number`, if it is to be recorded. A match on the practice range is
/// not logged; the result is then the data files of the range.
Expected<Recording> open_recording(Live& live, std::uint64_t seed, std::uint64_t number) {
    auto& session = live.session;
    if (auto range = session.next().take_range()) return Recording(std::move(*range));
    if (live.plan.demo && number > 1) return Recording();
    return record_match({.named = live.plan.log,
                         .folder = live.plan.logs_folder,
                         .kept = session.menu().settings().logs_kept},
                        number, session.log_header(seed));
}

/// Time from now to the start of the next match (s): 0 on the practice range, in a replay, and in a session
/// that measures its own timing.
int countdown_of(const Live& live) {
    const bool none = live.plan.replay != nullptr || live.plan.probe || live.plan.practice ||
                      live.session.next().is_practice();
    return none ? 0 : live.session.menu().settings().countdown_s;
}

/// Text on a faulty settings file for the start of match `number`; empty if the start screen or an earlier
/// match has shown it already.
std::string fault_at_start(const LivePlan& plan, std::uint64_t number) {
    return number == 1 && !plan.start_screen ? plan.start_fault : std::string();
}

/// Plays one match. The error: the simulation thread could not be started.
Expected<void> play_match(Live& live, MatchStart start) {
    auto& shared = live.shared;
    shared.progress.ended = shared.requests.end = shared.requests.rematch = false;
    shared.progress.state = PlayState::playing;
    shared.requests.pause = shared.requests.go_on = no_player;
    for (auto& lost : shared.pad_lost) lost = false;
    auto& window = live.window.window;
    auto simulating = start_thread([&] {
        const auto wake = [&] { window.wake(); };
        if (live.plan.replay != nullptr)
            run_replay(live.plan, shared, wake);
        else
            run_simulation(live.plan, shared, std::move(start), wake);
    });
    if (!simulating) return simulating.error();
    run_match(live.session, shared, live.window);
    return {};
}

/// Plays one match after another until the players leave.
Expected<void> play_matches(Live& live) {
    auto& session = live.session;
    auto seed = live.plan.seed;
    bool again = false;
    if (live.plan.practice) {
        auto& next = session.next();
        if (auto opened = live.plan.apprentice ? next.open_apprentice() : next.open_range(); !opened)
            return opened;
    }
    for (std::uint64_t number = 1; !live.shared.stop; ++number) {
        if (live.plan.start_screen && !again && !run_start_screen(session, live.shared, live.window)) break;
        session.take_seats(live.window.pads.poll());
        const int countdown = countdown_of(live);
        auto recording = open_recording(live, seed, number);
        // A log that the user named must be opened. If the default folder fails, the match is played without
        // a log.
        if (!recording && number == 1 && !live.plan.log.empty()) return recording.error();
        if (!recording) tell_user(text("this match is not recorded: ", recording.error().message));
        auto played = play_match(
            live, {session.next().data(), seed, recording ? std::move(*recording) : Recording(), countdown,
                   fault_at_start(live.plan, number), session.next().take_lessons(), session.profile()});
        if (!played) return played;
        again = session.take_restart() || live.shared.requests.rematch;
        if (!again && !live.plan.start_screen) break;
        Random next = random_stream(seed, number);
        seed = next.next() >> 1U;
    }
    return {};
}

/// Opens the arms of the seats that ask for one. The arms give forces from the first match on.
Expected<LiveArms> open_arms_of(const LivePlan& plan) {
    if (plan.replay != nullptr) return LiveArms();
    return open_arms(plan.seats, plan.data->device);
}

/// Loads the layouts that players have written for their jackets. A fault is printed; the jacket then has its
/// usual layout.
void load_own_layouts(const LivePlan& plan, LiveShared& shared) {
    for (std::uint32_t p = 0; shared.body && p < players; ++p) {
        const auto& player = plan.settings.players.at(p);
        const auto jacket = parse_jacket(player.jacket);
        if (player.jacket_layout.empty() || !jacket || !*jacket) continue;
        auto layout = load_own_layout(player.jacket_layout, *jacket, plan.assets);
        if (!layout) {
            tell_user(text("player ", p + 1, ": the jacket has its usual layout: ", layout.error().message));
            continue;
        }
        shared.tactile.use_own_layout(p, layout->actuators.size());
        shared.body->own.at(p) = std::move(*layout);
    }
}

/// Loads effects and layouts for the body, and prints faults. A faulty file leaves out its own effect or
/// layout, a missing folder of effects all of them.
std::optional<LiveBody> load_body(const std::filesystem::path& assets) {
    auto body = LiveBody::load(assets);
    if (body) {
        for (const auto& fault : body->faults) tell_user(text("not felt on the body: ", fault));
        return std::move(*body);
    }
    tell_user(text("nothing is felt on the body: ", body.error().message));
    return std::nullopt;
}

// The report ------------------------------------------------------------------------------------------------

/// Prints the faults and the timing of an arm, with its name if there are several arms.
void tell_arm(const LiveArm& arm, bool name_it) {
    const auto faults = arm.servo.faults();
    tell_user(text("arm", name_it ? text(" ", input::name_of(arm.keeper->facts())) : "", ": ",
                   told(arm.keeper->times()), "; poses: ", faults.poses.repeated, " repeated, ",
                   faults.poses.backwards, " back in time, ", faults.poses.unusable, " no numbers; lost ",
                   arm.keeper->losses(), " times; ", faults.differing, " forces differ from the match's"));
}

void fill_report(LiveShared& shared, LiveReport& report) {
    report = shared.report;
    report.late_us_median = shared.late.at(0.5);
    report.late_us_p99 = shared.late.at(0.99);
    report.late_us_worst = shared.late.at(1);
    report.tick_us_median = shared.ticks.at(0.5);
    report.tick_us_p99 = shared.ticks.at(0.99);
}

/// Body of the thread that reads all data files and reports their faults. It waits for the first pictures, so
/// as not to delay them.
void look_at_data(const LivePlan& plan, LiveShared& shared, render::Window& window) {
    shared.started.wait(false);
    if (shared.stop || !plan.read_all_data) return;
    auto words = plan.read_all_data();
    if (words.empty()) return;
    tell_user(words);
    shared.data_fault.put(std::move(words));
    window.wake();
}

}  // namespace

std::string told(const input::TickReport& arm) {
    return text(arm.ticks, " ticks, ", arm.missed, " missed; uneven by ", fixed(arm.jitter_median, 0),
                " us in the middle, ", fixed(arm.jitter_p99, 0), " us at 99 %, ", fixed(arm.jitter_worst, 0),
                " us at worst; from pose to force ", fixed(arm.answer_median, 0), " us, ",
                fixed(arm.answer_p99, 0), " us, ", fixed(arm.answer_worst, 0), " us");
}

Expected<void> run_live(const LivePlan& plan) {
    // The search for pads begins first, since it runs in parallel with all that follows.
    auto own_pads = load_own_pads(own_pads_file(plan.settings_file));
    input::PadReader pads(std::move(own_pads.mappings));
    // The window is made before signals are watched. Nothing that must be closed is open yet, so a signal may
    // end the program at once, even if OpenGL's library hangs.
    auto window = render::Window::create({.fullscreen = plan.settings.fullscreen});
    if (!window) return window.error();
    const EndWatch watch;
    LiveShared shared;
    auto arms = open_arms_of(plan);
    if (!arms) return arms.error();
    shared.arms = std::move(*arms);
    audio::prepare_openal();
    shared.body = load_body(plan.assets);
    load_own_layouts(plan, shared);
    LiveSession session(shared, plan);
    auto drawing = start_thread([&] { run_render(plan, shared, *window); });
    if (!drawing) return drawing.error();
    auto reading = start_thread([&] { look_at_data(plan, shared, *window); });
    // While the render thread makes the arena's scene, this thread makes the sounds.
    shared.sound = LiveSound::start(plan.assets, plan.settings);
    Live live{plan, shared, session, {*window, pads, std::move(own_pads.faults), plan.settings.fullscreen}};
    const auto played = play_matches(live);
    shared.stop = true;
    shared.say_started();
    drawing->join();
    if (reading) reading->join();
    if (plan.report != nullptr) fill_report(shared, *plan.report);
    follow_arms(shared.arms);  // prints which arms were lost or came back during the last wait for events
    for (const auto& arm : shared.arms) tell_arm(*arm, shared.arms.size() > 1);
    if (!played) return played.error();
    if (shared.render_error) return *shared.render_error;
    if (shared.simulation_error) return *shared.simulation_error;
    tell_end_by_signal();
    return {};
}

}  // namespace thaum::game::inline live
