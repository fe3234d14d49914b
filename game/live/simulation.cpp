#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/tell_user.h"
#include "core/text.h"
#include "core/threads.h"
#include "game/bots/bot_file.h"
#include "game/casting/free_casting.h"
#include "game/live/arm_pace.h"
#include "game/live/shared.h"
#include "game/match/hand/arm_system.h"
#include "game/match/own_gestures.h"
#include "game/match/record.h"
#include "game/range/practice.h"

namespace thaum::game::inline live {

using input::Button;

namespace {

constexpr Tick max_behind = 250;
constexpr Tick publish_period = 4;  ///< period of published pictures in real time (ticks)
// Periods for a pause and the time after the end, when little moves:
/// ticks computed at each wake-up of the thread in a pause and after the end of a match
constexpr Tick idle_wake = 8;
/// period of published pictures in a pause and after the end, when the render thread draws even fewer (ticks)
constexpr Tick idle_publish_period = 32;
/// time after the end of a match in which a wish for a rematch is ignored, because players may still be
/// shooting (ticks)
constexpr Tick rematch_not_before = 800;
constexpr Tick demo_result_shown = ticks(8.0);  ///< time for which a demo shows a result (ticks)
constexpr std::int64_t notice_ns = 3'000'000'000;
/// Difference between the seeds of a match's bots. It may be constant: a person in the match makes the bots'
/// random numbers unpredictable anyway.
constexpr std::uint64_t bot_seed_step = 0x9e3779b97f4a7c15ULL;

/// One match with its bots, and its log or the practice range's data.
struct Round {
    std::unique_ptr<Simulation> own;
    Simulation* match = nullptr;  ///< `own`, or the match of the practice range
    Bots bots;
    /// record of the match: none, its log, or a Practice, which is the practice range with its data
    std::variant<std::monostate, input::LogWriter, Practice> kept;
    std::string told_step{};               ///< text of the lesson's step that was printed last
    std::unique_ptr<DataWatcher> watcher;  ///< the practice range's files; null outside of practice
    std::optional<Tick> over_at;
    std::uint32_t buttons_before = 0;
    std::uint32_t marks = 0;
    Tick marked_at = 0;
};

struct SimulationThread {
    const LivePlan& plan;
    LiveShared& shared;
    const std::function<void()>& wake;  ///< called when shared.progress has changed
    Round round{};
    MatchSound sound;
    MatchBody body;
    std::int64_t start_ns = 0;  ///< deadline of the match's tick 0 (ns)
    Tick skips_to_log = 0;
    std::int64_t skipped_at_ns = 0;
    int countdown = 0;    ///< time to the start of the match (s); 0: it has begun
    std::string fault{};  ///< words on a fault for the first seconds of the match
    /// buttons that the main thread's requests press in the next input frame (bits of input::Button)
    std::uint32_t next_press = 0;
};

/// Log of the match; null if the match is not logged, as on the practice range.
input::LogWriter* log_of(Round& round) { return std::get_if<input::LogWriter>(&round.kept); }
/// Tests whether the match is paused or over.
bool is_idle(const SimulationThread& s) { return s.shared.progress.state.load() != PlayState::playing; }
Practice* practice_of(Round& round) { return std::get_if<Practice>(&round.kept); }

bool finds_force(Round& round) {
    const auto* practice = practice_of(round);
    return practice != nullptr && practice->finds_force();
}

void show_scene(LiveShared& shared, std::shared_ptr<const MatchData> data) {
    shared.scene.to_fill() = std::move(data);
    shared.scene.publish();
}

/// Makes the recognisers of gestures that the players need before the first tick, so that the first stroke
/// need not wait.
void make_readers(const MatchContext& context) {
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto* gestures = gestures_of(context, player);
        if (gestures == nullptr) continue;
        (void)gestures->recogniser();
        if (casts_freely(context, player)) (void)gestures->motion_recogniser();
    }
}

void start_practice(SimulationThread& s, RangeFiles files, MatchStart& start) {
    show_scene(s.shared, files.data().match);
    auto devices = arms_of(s.shared.arms);
    devices.insert(devices.begin(), s.shared.seats[practising].spec);
    auto& practice =
        s.round.kept.emplace<Practice>(files.data(), devices, s.shared.requests.dummy, start.seed,
                                       std::move(start.lessons), std::move(start.profile));
    s.round.match = &practice.match();
    s.round.watcher = std::make_unique<DataWatcher>(std::move(files));
}

bool add_bots(SimulationThread& s, std::uint64_t seed) {
    for (std::uint32_t p = 0; p < players; ++p) {
        const auto& seat = s.shared.seats[p].seat;
        if (seat.kind != SeatKind::bot) continue;
        const auto skill = load_bot_skill(s.plan.assets, seat.bot);
        if (!skill) {
            s.shared.simulation_error = skill.error();
            return false;
        }
        s.round.bots.add(*s.round.match, p, p, *skill, seed + (p + 1) * bot_seed_step);
    }
    return true;
}

/// Number of job threads of a match in real time. A second one shares the steps of the brew where the threads
/// of simulation, arms, picture and sound leave it a processor.
unsigned brew_threads() { return processors() >= 6 ? 2 : 1; }

bool start_round(SimulationThread& s, MatchStart start) {
    s.shared.requests.forget();
    s.shared.progress.drawn_number = 0;
    s.countdown = start.countdown;
    s.fault = std::move(start.fault);
    for (auto& seat : s.shared.seats)
        if (seat.faders) seat.faders->begin_match(seat.spec.faders());
    if (auto* files = std::get_if<RangeFiles>(&start.recording)) {
        start_practice(s, std::move(*files), start);
    } else {
        show_scene(s.shared, start.data);
        MatchSetup setup{.seed = start.seed,
                         .devices = devices_of(s.shared.seats, s.shared.arms),
                         .workers = brew_threads()};
        // Gestures that do not suit the data were left out when they were loaded, so this does not fail.
        (void)use_profile(*start.data, std::move(start.profile), setup);
        s.round.own = std::make_unique<Simulation>(std::move(start.data), std::move(setup));
        s.round.match = s.round.own.get();
    }
    make_readers(s.round.match->context());
    if (auto* log = std::get_if<input::LogWriter>(&start.recording)) s.round.kept = std::move(*log);
    return add_bots(s, start.seed);
}

void close_log(Round& round) {
    auto* log = log_of(round);
    if (log == nullptr) return;
    if (const auto closed = game::close_log(*log, *round.match); !closed) tell_user(closed.error().message);
    round.kept = std::monostate{};
}

void tell_score(Round& round) {
    if (auto* practice = practice_of(round)) print_line(practice->last_words());
}

/// Tests the tasks of the Apprentice (the lessons on the practice range) after a tick. Prints each new step
/// in the terminal too.
void follow_lessons(Round& round) {
    auto* practice = practice_of(round);
    if (practice == nullptr || practice->apprentice() == nullptr) return;
    practice->follow_lessons();
    auto step = practice->step_words();
    if (step == round.told_step) return;
    print_line(text("apprentice: ", step));
    std::fflush(stdout);
    round.told_step = std::move(step);
}

/// Number plus 1 of the gesture that the player records anew; 0: none.
std::uint32_t number_of_drawn(const GestureWall& wall, const GestureSet* gestures) {
    if (!wall.records() || gestures == nullptr) return 0;
    const auto number = gestures->number(wall.recorded_name());
    return number ? *number + 1 : 0;
}

/// Shows the strokes of this tick on the gesture wall, the practice range's display of gestures. Hands a
/// gesture that the player has recorded there to the main thread.
void follow_gestures(SimulationThread& s) {
    auto* practice = practice_of(s.round);
    if (practice == nullptr) return;
    practice->follow_gestures();
    s.shared.progress.drawn_number =
        number_of_drawn(practice->wall(), practice->match().data().gestures.get());
    auto drawn = practice->wall().take_recorded();
    if (!drawn) return;
    s.shared.progress.drawn_gesture.put(std::move(*drawn));
    s.wake();
}

/// Applies the menu's choices and reloaded data files to the practice range, between two ticks.
void follow_practice(SimulationThread& s) {
    auto* practice = practice_of(s.round);
    if (practice == nullptr) return;
    if (practice->apprentice() == nullptr) {
        practice->set_dummy(s.shared.requests.dummy);
        if (practice->set_changes(s.shared.requests.range)) s.round.match = &practice->match();
    }
    if (auto own = s.shared.requests.own_gestures.take()) {
        practice->use_gestures(std::move(*own));
        s.round.match = &practice->match();
    }
    const auto* reload = s.round.watcher->take();
    if (reload == nullptr) return;
    reload->data ? print_line(reload->line) : tell_user(reload->line);
    std::fflush(stdout);
    practice->adopt(*reload);
    if (!reload->data) return;
    s.round.match = &practice->match();
    show_scene(s.shared, reload->data->match);
}

PlayState play_state_of(const Match& match) {
    if (match.phase != Phase::playing) return PlayState::over;
    return match.paused != 0 ? PlayState::paused : PlayState::playing;
}

/// Presses the pause button for the main thread, which has asked for a pause or for its end. The button is
/// pressed in every second input frame until the pause has begun or ended. A release between two presses is
/// needed because only then does a press count, and the main thread may ask again within a tick.
void press_for_main(MatchRequests& requests, PlayState state, input::InputFrame& frame) {
    const auto press = [&](std::atomic<std::uint32_t>& request, PlayState unless) {
        const auto player = request.load();
        if (player >= players) return;
        if (state == PlayState::over || state == unless)
            request = no_player;
        else
            frame.devices[player].press(Button::pause);
    };
    press(requests.pause, PlayState::paused);
    press(requests.go_on, PlayState::playing);
}

/// Notes the time of the newest input event together with the tick that takes it, to measure its delay. Must
/// run before the hands are sampled: then that tick has all of the noted input.
void stamp_input(SimulationThread& s) {
    const auto came = s.shared.input_came_ns.exchange(0);
    const auto tick = static_cast<std::int64_t>(s.round.match->now() + 1);
    if (came != 0 && play_state_of(s.round.match->match()) == PlayState::playing)
        s.shared.stamps.push({came, s.start_ns + tick * ns_per_tick});
}

/// Lets the player of the practice range find the largest force by feel.
void try_force(SimulationThread& s, Practice& practice, input::InputFrame& frame) {
    const auto found = practice.try_force(frame);
    s.shared.seats[practising].faders->note(frame.devices[practising].change);
    if (!found) return;
    s.shared.progress.found_force = *found;
    s.wake();
}

input::InputFrame take_frame(SimulationThread& s) {
    stamp_input(s);
    input::InputFrame frame;
    s.round.bots.sample(*s.round.match, frame);
    if (auto* practice = practice_of(s.round)) frame.devices[dummys] = practice->dummy_sample();
    for (std::size_t i = 0; i < s.shared.seats.size(); ++i) {
        if (auto& hands = s.shared.seats[i].hands) frame.devices[i] = hands->take();
        auto& faders = s.shared.seats[i].faders;
        if (faders && !finds_force(s.round)) frame.devices[i].change = faders->take();
        frame.devices[i].away = s.shared.pad_lost[i];
    }
    each_held_arm(s.shared.arms, [&](LiveArm& arm, std::size_t device) {
        frame.devices[device] = arm.servo.take();
        frame.devices[device].away = arm.keeper->is_lost();
    });
    if (auto* practice = practice_of(s.round)) {
        practice->hold_fire_back(frame);
        try_force(s, *practice, frame);
    }
    if (s.round.match->now() % 2 == 0)
        press_for_main(s.shared.requests, play_state_of(s.round.match->match()), frame);
    frame.devices[0].buttons |= std::exchange(s.next_press, 0);
    // Between two rounds of a match the rematch key starts the next round.
    if (s.shared.requests.rematch && s.round.match->match().phase == Phase::between)
        frame.devices[0].press(Button::confirm);
    // All devices lose the same samples, so only the first device's column of the log records their number.
    const auto skips = std::min<Tick>(s.skips_to_log, 0xffff);
    frame.devices[0].skips = static_cast<std::uint16_t>(skips);
    s.skips_to_log -= skips;
    return frame;
}

/// Adjusts the match's clock to the arms' clocks. `behind` is the number of ticks that are due, this one
/// included. The arm with the most waiting samples decides: otherwise its samples would pile up. A slower arm
/// repeats a sample now and then.
void keep_pace_with_arms(SimulationThread& s, Tick behind) {
    if (play_state_of(s.round.match->match()) != PlayState::playing) return;
    std::size_t waiting = 0;
    each_held_arm(s.shared.arms,
                  [&](const LiveArm& arm, std::size_t) { waiting = std::max(waiting, arm.servo.waiting()); });
    s.start_ns += arm_pace_correction(static_cast<std::int64_t>(waiting), behind);
}

/// Hands the newest haptic models to the arms. From such a model an arm's thread computes its forces by
/// itself.
void give_orders(SimulationThread& s) {
    const auto& match = *s.round.match;
    each_held_arm(s.shared.arms, [&](LiveArm& arm, std::size_t) {
        if (fill_order(match.world(), match.haptic_setup(), arm.player, arm.servo.order()))
            arm.servo.publish();
    });
}

/// Handles buttons of any device that act on the session and not on the match.
void watch_buttons(SimulationThread& s, const input::InputFrame& frame) {
    auto& round = s.round;
    std::uint32_t buttons = 0;
    for (const auto& device : frame.devices) buttons |= device.buttons;
    const auto pressed = [&](Button b) {
        return (buttons & ~round.buttons_before & static_cast<std::uint32_t>(b)) != 0;
    };
    if (auto* log = log_of(round); pressed(Button::mark) && log != nullptr) {
        log->mark(++round.marks);
        round.marked_at = round.match->now();
    }
    const bool may = round.over_at && round.match->now() >= *round.over_at + rematch_not_before;
    if (may && pressed(Button::confirm)) s.shared.requests.rematch = true;
    if (s.plan.demo && round.over_at && round.match->now() >= *round.over_at + demo_result_shown)
        s.shared.requests.rematch = true;
    if (!round.over_at) s.shared.requests.rematch = false;
    round.buttons_before = buttons;
}

void tell_progress(SimulationThread& s) {
    const auto& match = s.round.match->match();
    const auto state = play_state_of(match);
    s.shared.progress.paused_by = match.paused_by;
    if (s.shared.progress.state.exchange(state) != state) s.wake();
}

/// Number of a bookmark that was set in the log within the last mark_shown ticks; 0: none.
std::uint32_t recent_mark(const Round& round) {
    return round.marks > 0 && round.match->now() < round.marked_at + mark_shown ? round.marks : 0;
}

void publish(SimulationThread& s) {
    auto& picture = s.shared.pictures.to_fill();
    take_picture(*s.round.match, picture);
    picture.due_ns = s.start_ns + static_cast<std::int64_t>(picture.tick) * ns_per_tick;
    picture.mark = recent_mark(s.round);
    picture.countdown = s.countdown;
    picture.practice = {};
    picture.caption = {};
    if (auto* practice = practice_of(s.round)) practice->show(picture);
    s.sound.show(picture);
    s.body.show(picture);
    if (shows_fault(s.fault, s.round.match->match().played))
        picture.caption = {.words = s.fault, .fault = true};
    picture.overloaded = s.skipped_at_ns != 0 && monotonic_ns() < s.skipped_at_ns + notice_ns;
    s.shared.pictures.publish();
}

void run_tick(SimulationThread& s) {
    auto& round = s.round;
    s.shared.requests.carry_out({practice_of(round), s.next_press});
    follow_practice(s);
    const auto frame = take_frame(s);
    tick_and_record(*round.match, frame, log_of(round));
    follow_lessons(round);
    follow_gestures(s);
    give_orders(s);
    const auto now = round.match->now();
    s.sound.follow(*round.match);
    s.body.follow(*round.match, s.sound);
    if (round.match->match().phase == Phase::over && !round.over_at) round.over_at = now;
    if (round.over_at && now == *round.over_at + log_after_end) close_log(round);
    watch_buttons(s, frame);
    tell_progress(s);
    if (now % (is_idle(s) ? idle_publish_period : publish_period) == 0) publish(s);
}

/// Number of ticks whose deadline has passed and that have not been computed.
Tick backlog(const SimulationThread& s) {
    const auto due = (monotonic_ns() - s.start_ns) / ns_per_tick;
    const auto done = static_cast<std::int64_t>(s.round.match->now());
    return due > done ? static_cast<Tick>(due - done) : 0;
}

/// Skips a backlog (ticks that are due but not computed): they are never computed. Their input goes into one
/// sample, and the clock continues from now.
void skip(SimulationThread& s, Tick behind) {
    const auto skipped = behind - 1;
    s.start_ns += static_cast<std::int64_t>(skipped) * ns_per_tick;
    s.skips_to_log += skipped;
    s.shared.report.skipped += skipped;
    s.skipped_at_ns = monotonic_ns();
}

void wait_for_next(SimulationThread& s) {
    const bool idle = is_idle(s);
    const auto tick = s.round.match->now() + (idle ? idle_wake : 1);
    const auto deadline = s.start_ns + static_cast<std::int64_t>(tick) * ns_per_tick;
    sleep_until_ns(deadline);
    if (!idle) s.shared.late.add(static_cast<double>(monotonic_ns() - deadline) * 1e-3);
}

/// Tests whether the plan's time is up. Time is counted in computed ticks. So a session on a busy machine,
/// which skips ticks, plays as much of a match as any other.
bool is_time_up(const SimulationThread& s) {
    return s.plan.seconds && s.shared.report.ticks >= ticks(*s.plan.seconds);
}

/// Drops input that came before the match. A press of the pause button is kept as a request.
void drop_input(SimulationThread& s) {
    for (std::uint32_t p = 0; p < players; ++p) {
        const auto& hands = s.shared.seats[p].hands;
        if (hands && hands->take().down(Button::pause)) s.shared.requests.pause = p;
    }
}

/// Shows the start of the match while its seconds are counted down. The match itself begins afterwards.
void count_down(SimulationThread& s) {
    constexpr std::int64_t ns_per_second = 1'000'000'000;
    const auto end = monotonic_ns() + s.countdown * ns_per_second;
    s.sound.count_down();
    for (auto now = monotonic_ns(); now < end; now = monotonic_ns()) {
        if (s.shared.stop || s.shared.requests.end) break;
        const auto left = static_cast<int>((end - now + ns_per_second - 1) / ns_per_second);
        if (left != s.countdown) s.sound.count_down();
        s.countdown = left;
        drop_input(s);
        publish(s);
        sleep_until_ns(now + static_cast<std::int64_t>(idle_publish_period) * ns_per_tick);
    }
    s.countdown = 0;
    drop_input(s);
}

/// Begins the match that start_round has made, after its countdown.
void begin_match(SimulationThread& s) {
    s.sound.listen(s.shared.seats[0].hands != nullptr, s.shared.seats[1].hands != nullptr);
    if (s.countdown > 0) count_down(s);
    for (auto& arm : s.shared.arms) arm->servo.begin_match();
    s.start_ns = monotonic_ns() - static_cast<std::int64_t>(s.round.match->now()) * ns_per_tick;
}

void run_session(SimulationThread& s) {
    Staller staller{s.plan.stall};
    publish(s);
    while (!s.shared.stop && !s.shared.requests.end && !is_time_up(s)) {
        staller.pass(Stall::Thread::simulation);
        const auto behind = backlog(s);
        if (behind == 0) {
            wait_for_next(s);
            continue;
        }
        if (behind > max_behind) skip(s, behind);
        const auto before = monotonic_ns();
        keep_pace_with_arms(s, behind);
        run_tick(s);
        s.shared.ticks.add(static_cast<double>(monotonic_ns() - before) * 1e-3);
        ++s.shared.report.ticks;
        if (s.shared.requests.rematch && s.round.over_at) break;
    }
    if (is_time_up(s)) s.shared.stop = true;
    close_log(s.round);
    tell_score(s.round);
}

}  // namespace

void run_simulation(const LivePlan& plan, LiveShared& shared, MatchStart start,
                    const std::function<void()>& wake) {
    while (!shared.ready && !shared.stop) sleep_until_ns(monotonic_ns() + ns_per_tick);
    SimulationThread session{.plan = plan,
                             .shared = shared,
                             .wake = wake,
                             .sound = MatchSound(shared.sound.get()),
                             .body = MatchBody(shared.body, shared.tactile, shared.sound.get())};
    if (start_round(session, std::move(start))) {
        begin_match(session);
        run_session(session);
    } else {
        shared.stop = true;
    }
    ++shared.report.matches;
    shared.progress.ended = true;
    wake();
}

}  // namespace thaum::game::inline live
