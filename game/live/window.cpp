#include "game/live/window.h"

#include "core/clock.h"
#include "game/live/end_watch.h"

namespace thaum::game::inline live {
namespace {

render::WindowEvents events_of(LiveSession& session, const render::Window& window) {
    render::WindowEvents events;
    events.key = [&](int key, int, bool pressed) { session.key(key, pressed, monotonic_ns()); };
    events.character = [&](char32_t character) { session.character(character); };
    events.mouse_button = [&](int button, bool pressed) {
        session.mouse_button(button, pressed, window.size(), monotonic_ns());
    };
    events.mouse_move = [&](double dx, double dy) { session.mouse_move(dx, dy, monotonic_ns()); };
    events.cursor = [&](double x, double y) { session.cursor({x, y}, window.size()); };
    events.wheel = [&](double steps) { session.wheel(steps, monotonic_ns()); };
    events.focus = [&](bool focused) { session.focus(focused, monotonic_ns()); };
    return events;
}

void follow_fullscreen(const LiveSession& session, LiveWindow& window) {
    const bool wanted = session.menu().settings().fullscreen;
    if (wanted != window.fullscreen) window.window.set_fullscreen(window.fullscreen = wanted);
}

/// Shows in the window's title what the menu shows, and whether the match waits.
void tell_menu(LiveWindow& window, const LiveMenu& menu) {
    auto title = window_title(menu.state(), menu.context());
    if (title == window.title) return;
    window.title = std::move(title);
    window.window.set_title(window.title);
}

bool closes(const render::Window& window) { return window.should_close() || EndWatch::asked(); }

/// Moves player 1's mouse every 23.7 ms, for a session that measures its own timing. The period is no
/// multiple of the period of pictures, so that events come at all times between two pictures.
void probe(LiveSession& session, std::int64_t& next_ns) {
    constexpr std::int64_t period_ns = 23'700'000;
    const auto now = monotonic_ns();
    if (now < next_ns) return;
    next_ns = now + period_ns;
    session.mouse_move(1, 0, now);
}

/// Prints a changed state of loudspeakers and motors.
void tell_outputs(LiveShared& shared) {
    if (shared.sound != nullptr) shared.sound->tell_status();
    shared.tactile.tell_status();
}

/// Tells the menu about joysticks that are plugged in but cannot be used.
void look_at_sticks(LiveSession& session, LiveWindow& window) {
    constexpr std::int64_t period_ns = 2'000'000'000;
    if (!session.menu().is_open()) return;
    if (const auto now = monotonic_ns(); now >= window.look_for_locked_ns) {
        window.look_for_locked_ns = now + period_ns;
        window.locked = input::locked_sticks();
    }
    IdleSticks sticks{.unknown = window.pads.sticks(),
                      .own = window.pads.own(),
                      .locked = window.locked,
                      .left_over = window.pads.left_over(),
                      .without_right_stick = window.pads.without_right_stick(),
                      .faults = window.pad_faults};
    if (!window.pads.fault().empty()) sticks.faults.push_back(window.pads.fault());
    const auto change = session.look_at_sticks(std::move(sticks));
    if (!change) return;
    if (change->mapping.empty()) window.pads.forget(change->model);
    const auto taken = change->mapping.empty() ? Expected<void>() : window.pads.add(change->mapping);
    session.end_pad_setup(*change, taken);
}

}  // namespace

bool run_start_screen(LiveSession& session, LiveShared& shared, LiveWindow& window) {
    session.open_start_screen(monotonic_ns());
    const auto events = events_of(session, window.window);
    // Pads and joysticks are looked at before the first key, which may open the page about them.
    for (bool first = true; !shared.stop; first = false) {
        session.publish_screen();
        if (!first) window.window.poll(events, session.patience_s());
        const bool starts = session.step_start_screen(window.pads.poll(), monotonic_ns());
        look_at_sticks(session, window);
        tell_menu(window, session.menu());
        follow_fullscreen(session, window);
        tell_outputs(shared);
        if (starts) return true;
        if (closes(window.window)) shared.stop = true;
    }
    return false;
}

void run_match(LiveSession& session, LiveShared& shared, LiveWindow& window) {
    auto& view = window.window;
    session.begin_match(window.pads.poll());
    const auto events = events_of(session, view);
    Staller staller{session.plan().stall};
    std::int64_t next_probe_ns = 0;
    while (!shared.stop && !shared.progress.ended) {
        staller.pass(Stall::Thread::main);
        session.publish_screen();
        view.poll(events, session.patience_s());
        if (session.plan().probe) probe(session, next_probe_ns);
        if (closes(view)) shared.stop = true;
        session.step_match(session.needs_pads() ? std::optional(window.pads.poll()) : std::nullopt,
                           monotonic_ns());
        look_at_sticks(session, window);
        follow_fullscreen(session, window);
        tell_outputs(shared);
        view.capture_cursor(session.captures_cursor());
        tell_menu(window, session.menu());
    }
    view.capture_cursor(false);
}

}  // namespace thaum::game::inline live
