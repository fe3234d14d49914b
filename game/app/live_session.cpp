#include "game/app/live_session.h"

#include <algorithm>
#include <cstdio>

#include "core/text.h"
#include "game/app/end_watch.h"

namespace thaum::app {

using game::Watch;
using input::Action;
using input::Control;
using input::DeviceKind;

namespace {

constexpr std::int64_t focus_flicker_ns = 150'000'000;
/// Delay after the round's end before keys can leave the match (ns). The result must be seen before a key
/// meant for the match acts.
constexpr std::int64_t leave_not_before_ns = 800'000'000;
constexpr double pad_poll_s = 0.004, menu_poll_s = 0.016, focus_poll_s = 0.05, idle_poll_s = 0.25;

/// Views that are shown: those of all persons, and of the bots if no person plays.
Watch watched(const LiveShared& shared) {
    const bool first = shared.seats[0].hands != nullptr, second = shared.seats[1].hands != nullptr;
    if (first == second) return Watch::both;
    return first ? Watch::first : Watch::second;
}

bool is_pad(const TakenSeat& seat) { return seat.hands && seat.seat.kind == SeatKind::pad; }

bool menu_open(const LiveSession& session) { return !session.menu.pages.empty(); }

template <class F>
void each_hands(LiveShared& shared, F&& f) {
    for (auto& seat : shared.seats) {
        if (seat.hands) f(*seat.hands);
    }
}

/// Calls f with every event for the hands, then stamps the input. In this order the tick that takes the stamp
/// has the event.
template <class F>
void input(LiveShared& shared, F&& f) {
    const auto came = monotonic_ns();
    each_hands(shared, f);
    std::int64_t none = 0;
    shared.input_came_ns.compare_exchange_strong(none, came);
}

/// Device that a player uses now.
DeviceKind kind_in_hand(const LiveSession& session, std::uint32_t player) {
    return session.pad_holds[player].half ? DeviceKind::keyboard_half
                                          : session.shared.seats[player].spec.kind;
}

/// Index of a name in a list of the menu; 0 if it is missing.
std::size_t index_of(const std::vector<MenuContext::Named>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const auto& n) { return n.name == name; });
    return found == list.end() ? 0 : static_cast<std::size_t>(found - list.begin());
}

}  // namespace

LiveSession::LiveSession(LiveShared& s, const LivePlan& p)
    : shared(s), plan(p), data(p.data), menu_context(find_menu_context(p)), seated(p.settings) {
    menu.settings = p.settings;
    menu.dummy = static_cast<std::size_t>(p.practice.value_or(game::DummyKind::still));
    shared.dummy = p.practice.value_or(game::DummyKind::still);
    auto choice = p.data->choice;
    menu.rules = index_of(menu_context.rules, length_of(choice));
    menu.arena = index_of(menu_context.arenas, choice.arena);
    publish_screen(*this);
}

bool is_bound(const std::vector<Control>& controls, int key) {
    return std::any_of(controls.begin(), controls.end(),
                       [&](const Control& c) { return c.source == Control::Source::key && c.code == key; });
}

std::optional<std::uint32_t> first_person(const LiveShared& shared) {
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (shared.seats[p].hands) return p;
    }
    return {};
}

void leave_match(LiveSession& session) {
    (session.plan.start_screen ? session.shared.end_match : session.shared.stop) = true;
}

void publish_screen(LiveSession& session) {
    if (!session.stale) return;
    session.stale = false;
    const auto& settings = session.menu.settings;
    auto& screen = session.shared.screen.to_fill();
    screen.hud = {.split = settings.split,
                  .watch = watched(session.shared),
                  .fov = settings.fov,
                  .text_scale = settings.text_scale,
                  .bloom = settings.bloom,
                  .can_play_again = session.plan.replay == nullptr,
                  .forces = session.forces,
                  .menu = menu_open(session)};
    each_held_arm(session.shared, [&](const LiveArm& arm, std::size_t) {
        screen.hud.device_messages[arm.player] = arm.says;
    });
    for (std::uint32_t player = 0; player < game::players; ++player)
        if (session.shared.pad_lost[player])
            screen.hud.device_messages[player] = text("pad lost: ", how_to_rejoin);
    screen.quality = settings.quality;
    screen.menu = picture_of(session.menu, session.menu_context);
    screen.arena_scene = menu_open(session) && session.menu.pages.front().page == Page::start;
    screen.frames_per_second = settings.frames_per_second;
    session.shared.screen.publish();
}

void rebind_hands(LiveSession& session) {
    const auto& settings = session.menu.settings;
    for (std::uint32_t p = 0; p < game::players; ++p) {
        auto& hands = session.shared.seats[p].hands;
        if (!hands) continue;
        hands->rebind(settings.bindings_of(kind_in_hand(session, p)));
        hands->set_look(settings.sensitivity / session.seated.sensitivity,
                        settings.invert_y != session.seated.invert_y);
    }
}

// Keys ------------------------------------------------------------------------------------------------------

namespace {

void toggle_fullscreen(LiveSession& session) {
    auto& fullscreen = session.menu.settings.fullscreen;
    fullscreen = !fullscreen;
    session.shared.window.set_fullscreen(fullscreen);
    session.stale = true;
}

void turn_split(LiveSession& session) {
    auto& split = session.menu.settings.split;
    split = split == render::Split::top_bottom ? render::Split::side_by_side : render::Split::top_bottom;
    session.stale = true;
}

/// Tests whether a player's own binding of the key pauses as well.
bool a_player_pauses_with(const LiveSession& session, int key) {
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (!session.shared.seats[p].hands) continue;
        if (is_bound(session.menu.settings.bindings_of(kind_in_hand(session, p)).of(Action::pause), key))
            return true;
    }
    return false;
}

void key_after_round(LiveSession& session, const Settings& settings, int key) {
    if (is_bound(settings.of(SessionKey::again), key)) session.shared.rematch = true;
    const bool leaves =
        is_bound(settings.of(SessionKey::leave), key) || is_bound(settings.of(SessionKey::pause), key);
    if (leaves && monotonic_ns() > session.over_since_ns + leave_not_before_ns) leave_match(session);
}

/// Handles keys that act at any time. Returns whether the key was one of them.
bool session_key(LiveSession& session, int key) {
    const auto& settings = session.menu.settings;
    const auto is = [&](SessionKey k) { return is_bound(settings.of(k), key); };
    if (session.menu.waiting) return false;
    if (is(SessionKey::split)) turn_split(session);
    if (is(SessionKey::fullscreen)) toggle_fullscreen(session);
    if (is(SessionKey::mark)) ++session.shared.marks;
    if (is(SessionKey::forces)) session.forces = !session.forces, session.stale = true;
    return is(SessionKey::split) || is(SessionKey::fullscreen) || is(SessionKey::mark) ||
           is(SessionKey::forces);
}

void match_key(LiveSession& session, int key) {
    auto& shared = session.shared;
    const auto& settings = session.menu.settings;
    const bool pause = is_bound(settings.of(SessionKey::pause), key);
    if (session.plan.replay != nullptr) {
        if (pause || is_bound(settings.of(SessionKey::leave), key)) shared.stop = true;
        return;
    }
    const auto going = shared.going.load();
    if (going == PlayState::over) key_after_round(session, settings, key);
    if (going == PlayState::playing && pause && !a_player_pauses_with(session, key))
        shared.wants_pause = first_person(shared).value_or(0);
}

bool half_is_free(const LiveSession& session) {
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (session.shared.seats[p].hands && kind_in_hand(session, p) == DeviceKind::keyboard_half)
            return false;
    }
    return true;
}

/// Ends the pause for a player who has a working device again.
void rejoin(LiveSession& session, std::uint32_t player) {
    auto& shared = session.shared;
    shared.pad_lost[player] = false;
    session.stale = true;
    rebind_hands(session);
    const bool all = std::none_of(shared.pad_lost.begin(), shared.pad_lost.end(),
                                  [](const auto& lost) { return lost.load(); });
    if (all) shared.wants_to_go_on = player;
}

/// Gives half of the keyboard to a player without a pad, if no other player has it. The player asks with that
/// half's key for the wand.
bool take_half(LiveSession& session, int key) {
    if (!half_is_free(session)) return false;
    const auto& half = session.menu.settings.bindings_of(DeviceKind::keyboard_half);
    if (!is_bound(half.of(Action::fire), key)) return false;
    for (std::uint32_t p = 0; p < game::players; ++p) {
        auto& hold = session.pad_holds[p];
        if (!is_pad(session.shared.seats[p]) || hold.seen || hold.half) continue;
        hold.half = true;
        rejoin(session, p);
        return true;
    }
    return false;
}

void on_key(LiveSession& session, int key, bool pressed) {
    if (pressed && session_key(session, key)) return;
    if (pressed && !session.menu.waiting && take_half(session, key)) return;
    if (menu_open(session)) {
        menu_key(session, key, pressed);
        return;
    }
    if (pressed) match_key(session, key);
    input(session.shared, [&](auto& hands) { hands.key(key, pressed); });
}

// Focus -----------------------------------------------------------------------------------------------------

void focus_changed(LiveSession& session, bool focused) {
    session.unfocused_since_ns = focused ? 0 : monotonic_ns();
    session.repeat = {};
    if (!focused) each_hands(session.shared, [](auto& hands) { hands.focus_lost(); });
}

/// Pauses when the focus is lost for long. The focus also comes and goes while a window opens or fills the
/// screen.
void pause_without_focus(LiveSession& session) {
    const auto person = first_person(session.shared);
    const bool lost =
        session.unfocused_since_ns != 0 && monotonic_ns() > session.unfocused_since_ns + focus_flicker_ns;
    if (!lost || !person || !session.shared.ready) return;
    session.unfocused_since_ns = 0;
    session.shared.wants_pause = *person;
}

render::WindowEvents session_events(LiveSession& session) {
    render::WindowEvents events;
    auto& shared = session.shared;
    events.key = [&](int key, int, bool pressed) { on_key(session, key, pressed); };
    events.mouse_button = [&](int button, bool pressed) {
        if (menu_open(session))
            menu_mouse_button(session, button, pressed);
        else
            input(shared, [&](auto& hands) { hands.mouse_button(button, pressed); });
    };
    events.mouse_move = [&](double dx, double dy) {
        if (!menu_open(session)) input(shared, [&](auto& hands) { hands.mouse_move(dx, dy); });
    };
    events.cursor = [&](double x, double y) {
        if (menu_open(session)) menu_cursor(session, x, y);
    };
    events.wheel = [&](double steps) {
        if (menu_open(session))
            menu_wheel(session, steps);
        else
            input(shared, [&](auto& hands) { hands.wheel(steps); });
    };
    events.focus = [&](bool focused) { focus_changed(session, focused); };
    return events;
}

// Pads ------------------------------------------------------------------------------------------------------

/// Pad state for the collector, whose stick axes are positive upwards; the window's are positive downwards.
input::PadState pad_state(const render::PadState& from) {
    input::PadState to;
    for (std::size_t i = 0; i < to.axes.size(); ++i) to.axes[i] = static_cast<double>(from.axes[i]);
    to.axes[static_cast<std::size_t>(input::PadAxis::left_y)] *= -1;
    to.axes[static_cast<std::size_t>(input::PadAxis::right_y)] *= -1;
    to.buttons = from.buttons;
    return to;
}

void pad_went(LiveSession& session, std::uint32_t player) {
    session.shared.seats[player].hands->focus_lost();
    session.shared.pad_lost[player] = true;
    session.shared.wants_pause = player;
    session.stale = true;
}

/// Handles a player's pad. Returns true if the pad has just brought its player back; then its buttons have no
/// other effect.
bool follow_pad(LiveSession& session, std::uint32_t player, const render::PadState& pad) {
    auto& hold = session.pad_holds[player];
    if (!pad.present) {
        if (hold.seen && !hold.half) pad_went(session, player);
        hold.seen = false;
        return false;
    }
    hold.seen = true;
    bool back = false;
    if (session.shared.pad_lost[player] || hold.half) {
        if (pad.buttons == 0) return false;
        hold.half = false;
        back = hold.let_go_first = true;
        rejoin(session, player);
    }
    if (menu_open(session)) hold.let_go_first = true;
    if (hold.let_go_first && (pad.buttons != 0 || menu_open(session))) return back;
    hold.let_go_first = false;
    session.shared.seats[player].hands->pad(pad_state(pad));
    return back;
}

/// Leaves the match by button B after the round, as Esc does.
void leave_by_pad(LiveSession& session, const render::PadState& before, const render::PadState& now) {
    constexpr auto b = 1U << static_cast<unsigned>(input::PadButton::b);
    const bool pressed = (now.buttons & ~before.buttons & b) != 0;
    if (session.over_since_ns != 0 && pressed && monotonic_ns() > session.over_since_ns + leave_not_before_ns)
        leave_match(session);
}

void follow_pads(LiveSession& session) {
    const auto before = session.pads;
    session.pads = session.shared.window.pads();
    std::array<bool, 4> used{};
    for (std::uint32_t p = 0; p < game::players; ++p) {
        const auto& seat = session.shared.seats[p];
        if (!is_pad(seat)) continue;
        const auto place = static_cast<std::size_t>(seat.seat.pad);
        if (place >= used.size()) continue;
        used[place] = follow_pad(session, p, session.pads[place]);
        leave_by_pad(session, before[place], session.pads[place]);
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i] && menu_open(session)) menu_pad(session, static_cast<int>(i), before[i]);
    }
}

// The match -------------------------------------------------------------------------------------------------

/// Opens the menu while the match is paused, and closes it when the match goes on.
void follow_going(LiveSession& session) {
    const auto going = session.shared.going.load();
    if (going == PlayState::over && session.over_since_ns == 0) session.over_since_ns = monotonic_ns();
    if (going != PlayState::over) session.over_since_ns = 0;
    if (session.plan.replay != nullptr) return;
    if (going == PlayState::paused && !menu_open(session)) {
        each_hands(session.shared, [](auto& hands) { hands.focus_lost(); });
        open_pause(session);
    }
    if (going == PlayState::paused) tell_pause(session);
    if (going != PlayState::paused && menu_open(session)) {
        session.menu.pages.clear();
        session.menu.waiting.reset();
        session.stale = true;
    }
}

void follow_wish(LiveSession& session) {
    const auto request = std::exchange(session.menu.request, MenuRequest::none);
    if (request == MenuRequest::go_on)
        session.shared.wants_to_go_on = first_person(session.shared).value_or(0);
    if (request == MenuRequest::leave || request == MenuRequest::quit) leave_match(session);
}

/// Shows the state of an arm. Returns whether what the screen shows has changed.
bool follow_arm(LiveArm& arm, bool name_it) {
    const auto status = arm.keeper->status();
    const auto name = input::name_of(arm.keeper->facts());
    const bool lost = status.state != input::ArmPresence::present, first = arm.shown.empty();
    const auto shown = text(name, lost ? " (gone)" : "");
    const auto says = input::caption_of(status);
    const bool changes = shown != arm.shown;
    if (changes && (lost || !first))
        std::fprintf(stderr, "%s%s\n", name_it ? text(name, ": ").c_str() : "",
                     lost ? status.text.c_str() : "the arm is back");
    const bool stale = changes || says != arm.says;
    arm.shown = shown;
    arm.says = says;
    return stale;
}

/// Shows the states of the arms. Without its arm a hand goes on by mouse or pad, and the ArmKeeper looks for
/// the arm.
void follow_arms(LiveSession& session) {
    auto& arms = session.shared.arms;
    for (std::size_t i = 0; i < arms.size(); ++i) {
        if (!follow_arm(*arms[i], arms.size() > 1)) continue;
        session.menu_context.arms.at(i) = arms[i]->shown;
        session.stale = true;
    }
}

/// Moves the mouse now and then, with a period that is no multiple of the pictures'.
void probe(const render::WindowEvents& events, std::int64_t& next_ns) {
    constexpr std::int64_t period_ns = 23'700'000;
    if (monotonic_ns() < next_ns) return;
    next_ns = monotonic_ns() + period_ns;
    events.mouse_move(1, 0);
}

/// Time that the window may wait for events (s). Pads send no events, so they must be polled.
double patience(const LiveSession& session, bool pads) {
    if (pads || session.plan.probe) return pad_poll_s;
    if (menu_open(session)) return menu_poll_s;
    return session.unfocused_since_ns != 0 ? focus_poll_s : idle_poll_s;
}

}  // namespace

void run_session(LiveSession& session) {
    auto& shared = session.shared;
    session.seated = session.menu.settings;
    session.menu.pages.clear();
    session.stale = true;
    session.pads = shared.window.pads();
    const auto events = session_events(session);
    const bool pads = is_pad(shared.seats[0]) || is_pad(shared.seats[1]);
    const bool mouse = std::any_of(shared.seats.begin(), shared.seats.end(), [](const TakenSeat& s) {
        return s.hands && s.seat.kind == SeatKind::keyboard_mouse;
    });
    // Buttons that started the match must be released before they act in it.
    for (std::uint32_t p = 0; p < game::players; ++p) {
        const auto place = static_cast<std::size_t>(shared.seats[p].seat.pad);
        const bool seen = place < session.pads.size() && session.pads[place].present;
        session.pad_holds[p] = {.seen = seen, .let_go_first = true, .half = session.pad_holds[p].half};
    }
    rebind_hands(session);
    Staller staller{session.plan.stall};
    std::int64_t next_probe_ns = 0;
    while (!shared.stop && !shared.ended) {
        staller.pass(Stall::Thread::main);
        publish_screen(session);
        shared.window.poll(events, patience(session, pads));
        if (session.plan.probe)
            probe(events, next_probe_ns);
        else
            pause_without_focus(session);
        if (shared.window.should_close() || EndWatch::asked()) shared.stop = true;
        if (pads || menu_open(session)) follow_pads(session);
        follow_arms(session);
        follow_going(session);
        repeat_menu(session);
        follow_wish(session);
        shared.window.capture_cursor(mouse && !session.plan.probe &&
                                     shared.going.load() == PlayState::playing);
    }
    shared.window.capture_cursor(false);
}

// The start screen ------------------------------------------------------------------------------------------

namespace {

/// Publishes the arena and a picture of it as it is before a match.
void show_arena(LiveSession& session) {
    session.shared.scene.to_fill() = session.data;
    session.shared.scene.publish();
    input::DeviceSpec no_device;
    std::vector<input::DeviceSpec> devices(game::players, no_device);
    for (std::uint32_t p = 0; p < game::players; ++p) devices[p].player = p;
    const game::Simulation match(session.data, {1, std::move(devices)});
    game::take_picture(match, session.shared.pictures.to_fill());
    session.shared.pictures.publish();
}

void follow_plugs(LiveSession& session) {
    for (std::size_t i = 0; i < session.pads.size(); ++i) {
        const std::string name = session.pads[i].present ? session.pads[i].name : std::string();
        if (name == session.menu_context.pads[i]) continue;
        session.menu_context.pads[i] = name;
        session.stale = true;
        if (!session.pads[i].present)
            menu_event(session,
                       {.kind = MenuEvent::Kind::gone, .device = {DeviceKind::pad, static_cast<int>(i)}});
    }
}

/// Shows an error on the screen. Returns whether there was none.
bool note_fault(LiveSession& session, const Expected<void>& result) {
    if (result) return true;
    session.menu.note = result.error().message;
    session.stale = true;
    return false;
}

/// Reloads the chosen match's data from the files, which may have been changed on the range.
Expected<void> load_chosen(LiveSession& session) {
    auto choice = session.data->choice;
    length_of(choice) = session.menu_context.rules[session.menu.rules].name;
    choice.arena = session.menu_context.arenas[session.menu.arena].name;
    auto data = game::load_match_data(session.plan.assets, choice);
    if (!data) return tl::unexpected(data.error());
    session.data = std::make_shared<const game::MatchData>(std::move(*data));
    return {};
}

/// Loads and shows the arena that the menu has chosen. If its file is faulty, the menu returns to the shown arena.
void follow_arena(LiveSession& session) {
    const auto& arenas = session.menu_context.arenas;
    if (arenas[session.menu.arena].name == session.data->choice.arena) return;
    if (note_fault(session, load_chosen(session))) return show_arena(session);
    session.menu.arena = index_of(arenas, session.data->choice.arena);
}

bool out_of_time(const LiveSession& session) {
    return session.plan.seconds &&
           monotonic_ns() > session.shared.began_ns + static_cast<std::int64_t>(*session.plan.seconds * 1e9);
}

}  // namespace

Expected<void> open_range(LiveSession& session) {
    auto files = game::RangeFiles::open(session.plan.assets, session.data->choice);
    if (!files) return tl::unexpected(files.error());
    session.range = std::move(*files);
    return {};
}

bool run_start_screen(LiveSession& session) {
    auto& shared = session.shared;
    for (auto& seat : shared.seats) seat = {};
    session.pad_holds = {};
    if (shared.began_ns == 0) shared.began_ns = monotonic_ns();
    show_arena(session);
    session.menu = opened(std::move(session.menu), Page::start);
    session.stale = true;
    const auto events = session_events(session);
    while (!shared.stop) {
        publish_screen(session);
        shared.window.poll(events, menu_poll_s);
        follow_pads(session);
        follow_plugs(session);
        follow_arms(session);
        repeat_menu(session);
        follow_arena(session);
        const auto request = std::exchange(session.menu.request, MenuRequest::none);
        if (request == MenuRequest::start && note_fault(session, load_chosen(session))) return true;
        if (request == MenuRequest::range && note_fault(session, open_range(session))) return true;
        const bool closes = shared.window.should_close() || EndWatch::asked() || out_of_time(session);
        if (request == MenuRequest::quit || closes) shared.stop = true;
    }
    return false;
}

}  // namespace thaum::app
