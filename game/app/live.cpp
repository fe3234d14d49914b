#include "game/app/live.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <thread>

#include "core/text.h"
#include "game/app/command.h"
#include "game/app/live_shared.h"
#include "game/bots/bot.h"

namespace thaum::app {

using game::Watch;
using input::Action;
using input::Control;
using input::DeviceKind;

// Shared -------------------------------------------------------------------------------------------------------------------

std::int64_t monotonic_ns() {
    timespec t{};
    ::clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
}

void sleep_until_ns(std::int64_t when) {
    const timespec t{when / 1'000'000'000, when % 1'000'000'000};
    while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {}
}

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

// Seats --------------------------------------------------------------------------------------------------------------------

namespace {

DeviceKind device_kind(SeatKind kind) {
    switch (kind) {
        case SeatKind::keyboard_mouse: return DeviceKind::keyboard_mouse;
        case SeatKind::keyboard_half: return DeviceKind::keyboard_half;
        case SeatKind::bot: return DeviceKind::bot;
        default: return DeviceKind::pad;
    }
}

std::string device_name(const Seat& seat) {
    switch (seat.kind) {
        case SeatKind::keyboard_mouse: return "mouse and keyboard";
        case SeatKind::keyboard_half: return "half of the keyboard";
        default: return text("pad ", seat.pad + 1);
    }
}

TakenSeat take_seat(const Settings& settings, Seat seat, std::uint32_t player) {
    if (seat.kind == SeatKind::bot) return {seat, game::bot_device(player, seat.level), nullptr};
    input::DeviceSpec spec;
    spec.player = player;
    spec.kind = device_kind(seat.kind);
    spec.name = device_name(seat);
    spec.look_rad_per_count *= settings.sensitivity;
    spec.turn_rad_per_s = settings.turn_deg_per_s * radians_per_degree;
    if (settings.invert_y) spec.flags |= input::DeviceSpec::invert_y;
    return {seat, spec, std::make_unique<input::HandsCollector>(settings.bindings_of(spec.kind))};
}

bool is_pad(const TakenSeat& seat) { return seat.seat.kind == SeatKind::pad; }

/// Who plays with a person; a bot's view is shown only where nobody plays.
Watch watched(const LiveShared& shared) {
    const bool first = shared.seats[0].hands != nullptr, second = shared.seats[1].hands != nullptr;
    if (first == second) return Watch::both;
    return first ? Watch::first : Watch::second;
}

std::optional<std::uint32_t> first_person(const LiveShared& shared) {
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (shared.seats[p].hands) return p;
    }
    return {};
}

// The main thread ----------------------------------------------------------------------------------------------------------

constexpr std::int64_t focus_flicker_ns = 150'000'000;

struct Keys {
    int escape, enter, kp_enter, q, f6, f11;
};

Keys session_keys() {
    const auto code = [](std::string_view name) { return key_code_of(name).value_or(-2); };
    return {code("escape"), code("enter"), code("kp_enter"), code("q"), code("f6"), code("f11")};
}

struct Desk {
    LiveShared& shared;
    const LivePlan& plan;
    Keys keys = session_keys();
    bool fullscreen = false;
    std::int64_t unfocused_since_ns = 0;  ///< 0: has the focus, or its loss was dealt with
    std::array<bool, game::players> pad_seen{}, rejoining{};
    bool keyboard_pauses = false;  ///< somebody's bindings have Esc already
};

bool binds_escape(const Settings& settings, const TakenSeat& seat, int escape) {
    if (!seat.hands) return false;
    const auto& controls =
        settings.bindings_of(seat.spec.kind).controls[static_cast<std::size_t>(Action::pause)];
    return std::any_of(controls.begin(), controls.end(), [&](const Control& c) {
        return c.source == Control::Source::key && c.code == escape;
    });
}

void ask_for_pause(Desk& desk, std::uint32_t player) { desk.shared.wants_pause = player; }

void session_key(Desk& desk, int key) {
    auto& shared = desk.shared;
    const auto going = shared.going.load();
    if (key == desk.keys.escape && desk.plan.replay != nullptr) shared.stop = true;
    if (key == desk.keys.f6) {
        shared.split = shared.split.load() == render::Split::top_bottom ? render::Split::side_by_side
                                                                        : render::Split::top_bottom;
    }
    if (key == desk.keys.f11) shared.window.set_fullscreen(desk.fullscreen = !desk.fullscreen);
    if (key == desk.keys.q && going == Going::paused) shared.stop = true;
    if (key == desk.keys.escape && going == Going::over) shared.stop = true;
    if (key == desk.keys.escape && !desk.keyboard_pauses && desk.plan.replay == nullptr) {
        const auto player = first_person(shared).value_or(0);
        if (going == Going::playing) shared.wants_pause = player;
        if (going == Going::paused) shared.wants_to_go_on = player;
    }
    if ((key == desk.keys.enter || key == desk.keys.kp_enter) && going == Going::over) shared.rematch = true;
}

template <class F>
void each_hands(LiveShared& shared, F&& f) {
    for (auto& seat : shared.seats) {
        if (seat.hands) f(*seat.hands);
    }
}

/// Events for the hands; stamped after they were told, so that the tick which takes the stamp has the event.
template <class F>
void input(LiveShared& shared, F&& f) {
    const auto came = monotonic_ns();
    each_hands(shared, f);
    std::int64_t none = 0;
    shared.input_came_ns.compare_exchange_strong(none, came);
}

void focus_changed(Desk& desk, bool focused) {
    desk.unfocused_since_ns = focused ? 0 : monotonic_ns();
    if (!focused) each_hands(desk.shared, [](auto& hands) { hands.focus_lost(); });
}

/// The focus goes and comes while a window opens or fills the screen; only a loss that lasts is one.
void pause_without_focus(Desk& desk) {
    const auto person = first_person(desk.shared);
    const bool lost =
        desk.unfocused_since_ns != 0 && monotonic_ns() > desk.unfocused_since_ns + focus_flicker_ns;
    if (!lost || !person || !desk.shared.ready) return;
    desk.unfocused_since_ns = 0;
    ask_for_pause(desk, *person);
}

render::WindowEvents desk_events(Desk& desk) {
    auto& shared = desk.shared;
    render::WindowEvents events;
    events.key = [&](int key, int, bool pressed) {
        if (pressed) session_key(desk, key);
        input(shared, [&](auto& hands) { hands.key(key, pressed); });
    };
    events.mouse_button = [&](int button, bool pressed) {
        input(shared, [&](auto& hands) { hands.mouse_button(button, pressed); });
    };
    events.mouse_move = [&](double dx, double dy) {
        input(shared, [&](auto& hands) { hands.mouse_move(dx, dy); });
    };
    events.wheel = [&](double steps) { input(shared, [&](auto& hands) { hands.wheel(steps); }); };
    events.focus = [&](bool focused) { focus_changed(desk, focused); };
    return events;
}

/// The window's sticks are positive downwards, the collector's upwards.
input::PadState pad_state(const render::PadState& from) {
    input::PadState to;
    for (std::size_t i = 0; i < to.axes.size(); ++i) to.axes[i] = static_cast<double>(from.axes[i]);
    to.axes[static_cast<std::size_t>(input::PadAxis::left_y)] *= -1;
    to.axes[static_cast<std::size_t>(input::PadAxis::right_y)] *= -1;
    to.buttons = from.buttons;
    return to;
}

void pad_went(Desk& desk, std::uint32_t player) {
    desk.shared.seats[player].hands->focus_lost();
    desk.shared.pad_lost[player] = true;
    ask_for_pause(desk, player);
}

void follow_pad(Desk& desk, std::uint32_t player, const render::PadState& pad) {
    auto& shared = desk.shared;
    if (!pad.present) {
        if (desk.pad_seen[player]) pad_went(desk, player);
        desk.pad_seen[player] = false;
        return;
    }
    desk.pad_seen[player] = true;
    if (shared.pad_lost[player]) {
        if (pad.buttons == 0) return;
        shared.pad_lost[player] = false;
        shared.wants_to_go_on = player;
        desk.rejoining[player] = true;
    }
    // The press that rejoins is not also one in the match.
    if (desk.rejoining[player] && pad.buttons != 0) return;
    desk.rejoining[player] = false;
    shared.seats[player].hands->pad(pad_state(pad));
}

void follow_pads(Desk& desk) {
    const auto pads = desk.shared.window.pads();
    for (std::uint32_t p = 0; p < game::players; ++p) {
        const auto& seat = desk.shared.seats[p];
        if (!is_pad(seat)) continue;
        const auto place = static_cast<std::size_t>(seat.seat.pad);
        follow_pad(desk, p, place < pads.size() ? pads[place] : render::PadState{});
    }
}

/// A movement now and then, at no beat of the pictures'.
void probe(const render::WindowEvents& events, std::int64_t& next_ns) {
    constexpr std::int64_t period_ns = 23'700'000;
    if (monotonic_ns() < next_ns) return;
    next_ns = monotonic_ns() + period_ns;
    events.mouse_move(1, 0);
}

void run_desk(Desk& desk) {
    auto& shared = desk.shared;
    const auto events = desk_events(desk);
    const bool pads = is_pad(shared.seats[0]) || is_pad(shared.seats[1]);
    const bool mouse = std::any_of(shared.seats.begin(), shared.seats.end(), [](const TakenSeat& s) {
        return s.seat.kind == SeatKind::keyboard_mouse;
    });
    Staller staller{desk.plan.stall};
    // A pad that was never there is missed as well: its player cannot begin.
    for (std::uint32_t p = 0; p < game::players; ++p) desk.pad_seen[p] = is_pad(shared.seats[p]);
    std::int64_t next_probe_ns = 0;
    while (!shared.stop) {
        staller.pass(Stall::Thread::main);
        // Pads send no events; all else does.
        const double patience = desk.unfocused_since_ns != 0 ? 0.05 : 0.25;
        shared.window.poll(events, pads || desk.plan.probe ? 0.004 : patience);
        if (desk.plan.probe)
            probe(events, next_probe_ns);
        else
            pause_without_focus(desk);
        if (shared.window.should_close()) shared.stop = true;
        if (pads) follow_pads(desk);
        shared.window.capture_cursor(mouse && !desk.plan.probe && shared.going.load() == Going::playing);
    }
    shared.window.capture_cursor(false);
}

void choose_seats(const LivePlan& plan, LiveShared& shared) {
    if (plan.replay != nullptr) return;  // nobody sits there
    int free_pad = 0;
    for (std::uint32_t p = 0; p < game::players; ++p) {
        auto seat = plan.seats[p];
        if (seat.kind == SeatKind::pad_or_half) {
            const auto pads = shared.window.pads();
            const bool there = pads[static_cast<std::size_t>(free_pad)].present;
            seat.kind = there ? SeatKind::pad : SeatKind::keyboard_half;
            seat.pad = free_pad;
        }
        if (seat.kind == SeatKind::pad) free_pad = seat.pad + 1;
        shared.seats[p] = take_seat(plan.settings, seat, p);
    }
}

}  // namespace

int run_live(const LivePlan& plan) {
    auto window = render::Window::create({.fullscreen = plan.settings.fullscreen});
    if (!window) return refuse(window.error());
    LiveShared shared(*window);
    shared.split = plan.settings.split;
    choose_seats(plan, shared);
    std::optional<input::LogWriter> log;
    if (!plan.log.empty()) {
        auto opened = open_log(plan, shared, plan.seed, 1);
        if (!opened) return refuse(opened.error());
        log.emplace(std::move(*opened));
    }
    Desk desk{.shared = shared, .plan = plan, .fullscreen = plan.settings.fullscreen};
    for (const auto& seat : shared.seats)
        desk.keyboard_pauses = desk.keyboard_pauses || binds_escape(plan.settings, seat, desk.keys.escape);

    std::thread drawing([&] { run_render(plan, shared, watched(shared)); });
    std::thread simulating([&] { run_simulation(plan, shared, std::move(log)); });
    run_desk(desk);
    simulating.join();
    drawing.join();
    if (plan.report != nullptr) *plan.report = shared.report;
    if (shared.render_error) return refuse(*shared.render_error);
    if (shared.simulation_error) return refuse(*shared.simulation_error);
    return done;
}

}  // namespace thaum::app
