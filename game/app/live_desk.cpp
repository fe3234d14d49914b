#include "game/app/live_desk.h"

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
/// The result must be seen before a key that was meant for the match leaves it.
constexpr std::int64_t leave_not_before_ns = 800'000'000;
constexpr double pad_poll_s = 0.004, menu_poll_s = 0.016, focus_poll_s = 0.05, idle_poll_s = 0.25;

/// Who plays with a person; a bot's view is shown only where nobody plays.
Watch watched(const LiveShared& shared) {
    const bool first = shared.seats[0].hands != nullptr, second = shared.seats[1].hands != nullptr;
    if (first == second) return Watch::both;
    return first ? Watch::first : Watch::second;
}

bool is_pad(const TakenSeat& seat) { return seat.hands && seat.seat.kind == SeatKind::pad; }

bool menu_open(const Desk& desk) { return !desk.menu.pages.empty(); }

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

/// What a player's hands are on now.
DeviceKind kind_in_hand(const Desk& desk, std::uint32_t player) {
    return desk.grips[player].half ? DeviceKind::keyboard_half : desk.shared.seats[player].spec.kind;
}

}  // namespace

Desk::Desk(LiveShared& s, const LivePlan& p)
    : shared(s), plan(p), data(p.data), facts(find_facts(p)), seated(p.settings) {
    menu.settings = p.settings;
    menu.dummy = static_cast<std::size_t>(p.practice.value_or(game::DummyKind::still));
    shared.dummy = p.practice.value_or(game::DummyKind::still);
    auto choice = p.data->choice;
    const auto chosen = [&](const MenuFacts::Rules& r) { return r.name == length_of(choice); };
    const auto found = std::find_if(facts.rules.begin(), facts.rules.end(), chosen);
    if (found != facts.rules.end()) menu.rules = static_cast<std::size_t>(found - facts.rules.begin());
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

void leave_match(Desk& desk) { (desk.plan.start_screen ? desk.shared.end_match : desk.shared.stop) = true; }

void publish_screen(Desk& desk) {
    if (!desk.stale) return;
    desk.stale = false;
    const auto& settings = desk.menu.settings;
    auto& screen = desk.shared.screen.to_fill();
    screen.hud = {.split = settings.split,
                  .watch = watched(desk.shared),
                  .fov = settings.fov,
                  .text_scale = settings.text_scale,
                  .bloom = settings.bloom,
                  .can_play_again = desk.plan.replay == nullptr,
                  .forces = desk.forces,
                  .menu = menu_open(desk)};
    if (desk.shared.arm_player < game::players)
        screen.hud.device_says[desk.shared.arm_player] = desk.arm_says;
    for (std::uint32_t player = 0; player < game::players; ++player)
        if (desk.shared.pad_lost[player]) screen.hud.device_says[player] = text("pad lost: ", how_to_rejoin);
    screen.quality = settings.quality;
    screen.menu = picture_of(desk.menu, desk.facts);
    screen.court = menu_open(desk) && desk.menu.pages.front().page == Page::start;
    screen.frames_per_second = settings.frames_per_second;
    desk.shared.screen.publish();
}

void rebind_hands(Desk& desk) {
    const auto& settings = desk.menu.settings;
    for (std::uint32_t p = 0; p < game::players; ++p) {
        auto& hands = desk.shared.seats[p].hands;
        if (!hands) continue;
        hands->rebind(settings.bindings_of(kind_in_hand(desk, p)));
        hands->set_look(settings.sensitivity / desk.seated.sensitivity,
                        settings.invert_y != desk.seated.invert_y);
    }
}

// Keys ---------------------------------------------------------------------------------------------------------------------

namespace {

void toggle_fullscreen(Desk& desk) {
    auto& fullscreen = desk.menu.settings.fullscreen;
    fullscreen = !fullscreen;
    desk.shared.window.set_fullscreen(fullscreen);
    desk.stale = true;
}

void turn_split(Desk& desk) {
    auto& split = desk.menu.settings.split;
    split = split == render::Split::top_bottom ? render::Split::side_by_side : render::Split::top_bottom;
    desk.stale = true;
}

/// Does a player's own key for it do the same?
bool somebody_pauses_with(const Desk& desk, int key) {
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (!desk.shared.seats[p].hands) continue;
        if (is_bound(desk.menu.settings.bindings_of(kind_in_hand(desk, p)).of(Action::pause), key))
            return true;
    }
    return false;
}

void key_after_round(Desk& desk, const Settings& settings, int key) {
    if (is_bound(settings.of(SessionKey::again), key)) desk.shared.rematch = true;
    const bool leaves =
        is_bound(settings.of(SessionKey::leave), key) || is_bound(settings.of(SessionKey::pause), key);
    if (leaves && monotonic_ns() > desk.over_since_ns + leave_not_before_ns) leave_match(desk);
}

/// Returns whether it was a key that means the same everywhere.
bool session_key(Desk& desk, int key) {
    const auto& settings = desk.menu.settings;
    const auto is = [&](SessionKey k) { return is_bound(settings.of(k), key); };
    if (desk.menu.waiting) return false;
    if (is(SessionKey::split)) turn_split(desk);
    if (is(SessionKey::fullscreen)) toggle_fullscreen(desk);
    if (is(SessionKey::mark)) ++desk.shared.marks;
    if (is(SessionKey::forces)) desk.forces = !desk.forces, desk.stale = true;
    return is(SessionKey::split) || is(SessionKey::fullscreen) || is(SessionKey::mark) ||
           is(SessionKey::forces);
}

void match_key(Desk& desk, int key) {
    auto& shared = desk.shared;
    const auto& settings = desk.menu.settings;
    const bool pause = is_bound(settings.of(SessionKey::pause), key);
    if (desk.plan.replay != nullptr) {
        if (pause || is_bound(settings.of(SessionKey::leave), key)) shared.stop = true;
        return;
    }
    const auto going = shared.going.load();
    if (going == Going::over) key_after_round(desk, settings, key);
    if (going == Going::playing && pause && !somebody_pauses_with(desk, key))
        shared.wants_pause = first_person(shared).value_or(0);
}

bool half_is_free(const Desk& desk) {
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (desk.shared.seats[p].hands && kind_in_hand(desk, p) == DeviceKind::keyboard_half) return false;
    }
    return true;
}

/// Goes on for a player who has something in hand again.
void rejoin(Desk& desk, std::uint32_t player) {
    auto& shared = desk.shared;
    shared.pad_lost[player] = false;
    desk.stale = true;
    rebind_hands(desk);
    const bool all = std::none_of(shared.pad_lost.begin(), shared.pad_lost.end(),
                                  [](const auto& lost) { return lost.load(); });
    if (all) shared.wants_to_go_on = player;
}

/// Who has no pad (any more) may take half of the keyboard, if nobody has it: with the key that uses the wand.
bool take_half(Desk& desk, int key) {
    if (!half_is_free(desk)) return false;
    const auto& half = desk.menu.settings.bindings_of(DeviceKind::keyboard_half);
    if (!is_bound(half.of(Action::fire), key)) return false;
    for (std::uint32_t p = 0; p < game::players; ++p) {
        auto& grip = desk.grips[p];
        if (!is_pad(desk.shared.seats[p]) || grip.seen || grip.half) continue;
        grip.half = true;
        rejoin(desk, p);
        return true;
    }
    return false;
}

void on_key(Desk& desk, int key, bool pressed) {
    if (pressed && session_key(desk, key)) return;
    if (pressed && !desk.menu.waiting && take_half(desk, key)) return;
    if (menu_open(desk)) {
        menu_key(desk, key, pressed);
        return;
    }
    if (pressed) match_key(desk, key);
    input(desk.shared, [&](auto& hands) { hands.key(key, pressed); });
}

// Focus --------------------------------------------------------------------------------------------------------------------

void focus_changed(Desk& desk, bool focused) {
    desk.unfocused_since_ns = focused ? 0 : monotonic_ns();
    desk.repeat = {};
    if (!focused) each_hands(desk.shared, [](auto& hands) { hands.focus_lost(); });
}

/// The focus goes and comes while a window opens or fills the screen; only a loss that lasts is one.
void pause_without_focus(Desk& desk) {
    const auto person = first_person(desk.shared);
    const bool lost =
        desk.unfocused_since_ns != 0 && monotonic_ns() > desk.unfocused_since_ns + focus_flicker_ns;
    if (!lost || !person || !desk.shared.ready) return;
    desk.unfocused_since_ns = 0;
    desk.shared.wants_pause = *person;
}

render::WindowEvents desk_events(Desk& desk) {
    render::WindowEvents events;
    auto& shared = desk.shared;
    events.key = [&](int key, int, bool pressed) { on_key(desk, key, pressed); };
    events.mouse_button = [&](int button, bool pressed) {
        if (menu_open(desk))
            menu_mouse_button(desk, button, pressed);
        else
            input(shared, [&](auto& hands) { hands.mouse_button(button, pressed); });
    };
    events.mouse_move = [&](double dx, double dy) {
        if (!menu_open(desk)) input(shared, [&](auto& hands) { hands.mouse_move(dx, dy); });
    };
    events.cursor = [&](double x, double y) {
        if (menu_open(desk)) menu_cursor(desk, x, y);
    };
    events.wheel = [&](double steps) {
        if (menu_open(desk))
            menu_wheel(desk, steps);
        else
            input(shared, [&](auto& hands) { hands.wheel(steps); });
    };
    events.focus = [&](bool focused) { focus_changed(desk, focused); };
    return events;
}

// Pads ---------------------------------------------------------------------------------------------------------------------

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
    desk.shared.wants_pause = player;
    desk.stale = true;
}

/// Returns whether the pad brought its player back: then what it does is for nothing else.
bool follow_pad(Desk& desk, std::uint32_t player, const render::PadState& pad) {
    auto& grip = desk.grips[player];
    if (!pad.present) {
        if (grip.seen && !grip.half) pad_went(desk, player);
        grip.seen = false;
        return false;
    }
    grip.seen = true;
    bool back = false;
    if (desk.shared.pad_lost[player] || grip.half) {
        if (pad.buttons == 0) return false;
        grip.half = false;
        back = grip.let_go_first = true;
        rejoin(desk, player);
    }
    if (menu_open(desk)) grip.let_go_first = true;
    if (grip.let_go_first && (pad.buttons != 0 || menu_open(desk))) return back;
    grip.let_go_first = false;
    desk.shared.seats[player].hands->pad(pad_state(pad));
    return back;
}

/// B, when the round is over: as Esc.
void leave_by_pad(Desk& desk, const render::PadState& before, const render::PadState& now) {
    constexpr auto b = 1U << static_cast<unsigned>(input::PadButton::b);
    const bool pressed = (now.buttons & ~before.buttons & b) != 0;
    if (desk.over_since_ns != 0 && pressed && monotonic_ns() > desk.over_since_ns + leave_not_before_ns)
        leave_match(desk);
}

void follow_pads(Desk& desk) {
    const auto before = desk.pads;
    desk.pads = desk.shared.window.pads();
    std::array<bool, 4> used{};
    for (std::uint32_t p = 0; p < game::players; ++p) {
        const auto& seat = desk.shared.seats[p];
        if (!is_pad(seat)) continue;
        const auto place = static_cast<std::size_t>(seat.seat.pad);
        if (place >= used.size()) continue;
        used[place] = follow_pad(desk, p, desk.pads[place]);
        leave_by_pad(desk, before[place], desk.pads[place]);
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i] && menu_open(desk)) menu_pad(desk, static_cast<int>(i), before[i]);
    }
}

// The match ----------------------------------------------------------------------------------------------------------------

/// The menu is open while the match is paused.
void follow_going(Desk& desk) {
    const auto going = desk.shared.going.load();
    if (going == Going::over && desk.over_since_ns == 0) desk.over_since_ns = monotonic_ns();
    if (going != Going::over) desk.over_since_ns = 0;
    if (desk.plan.replay != nullptr) return;
    if (going == Going::paused && !menu_open(desk)) {
        each_hands(desk.shared, [](auto& hands) { hands.focus_lost(); });
        open_pause(desk);
    }
    if (going == Going::paused) tell_pause(desk);
    if (going != Going::paused && menu_open(desk)) {
        desk.menu.pages.clear();
        desk.menu.waiting.reset();
        desk.stale = true;
    }
}

void follow_wish(Desk& desk) {
    const auto wish = std::exchange(desk.menu.wish, MenuWish::none);
    if (wish == MenuWish::go_on) desk.shared.wants_to_go_on = first_person(desk.shared).value_or(0);
    if (wish == MenuWish::leave || wish == MenuWish::quit) leave_match(desk);
}

/// The match goes on without the arm, by mouse; whoever keeps it looks for it.
void follow_arm(Desk& desk) {
    if (!desk.shared.arm) return;
    const auto status = desk.shared.arm->status();
    const bool lost = status.state != input::ArmPresence::present;
    const auto shown = text(input::name_of(desk.shared.arm->facts()), lost ? " (gone)" : "");
    auto says = input::caption_of(status);
    if (says != desk.arm_says) {
        desk.arm_says = std::move(says);
        desk.stale = true;
    }
    if (shown == desk.facts.arm) return;
    const bool first = desk.facts.arm.empty();
    desk.facts.arm = shown;
    desk.stale = true;
    if (first && !lost) return;
    std::fprintf(stderr, "%s\n", lost ? status.text.c_str() : "the arm is back");
}

/// A movement now and then, at no beat of the pictures'.
void probe(const render::WindowEvents& events, std::int64_t& next_ns) {
    constexpr std::int64_t period_ns = 23'700'000;
    if (monotonic_ns() < next_ns) return;
    next_ns = monotonic_ns() + period_ns;
    events.mouse_move(1, 0);
}

/// s that the window may wait for events: pads send none.
double patience(const Desk& desk, bool pads) {
    if (pads || desk.plan.probe) return pad_poll_s;
    if (menu_open(desk)) return menu_poll_s;
    return desk.unfocused_since_ns != 0 ? focus_poll_s : idle_poll_s;
}

}  // namespace

void run_desk(Desk& desk) {
    auto& shared = desk.shared;
    desk.seated = desk.menu.settings;
    desk.menu.pages.clear();
    desk.stale = true;
    desk.pads = shared.window.pads();
    const auto events = desk_events(desk);
    const bool pads = is_pad(shared.seats[0]) || is_pad(shared.seats[1]);
    const bool mouse = std::any_of(shared.seats.begin(), shared.seats.end(), [](const TakenSeat& s) {
        return s.hands && s.seat.kind == SeatKind::keyboard_mouse;
    });
    // What started the match is not also a shot in it.
    for (std::uint32_t p = 0; p < game::players; ++p) {
        const auto place = static_cast<std::size_t>(shared.seats[p].seat.pad);
        const bool seen = place < desk.pads.size() && desk.pads[place].present;
        desk.grips[p] = {.seen = seen, .let_go_first = true, .half = desk.grips[p].half};
    }
    rebind_hands(desk);
    Staller staller{desk.plan.stall};
    std::int64_t next_probe_ns = 0;
    while (!shared.stop && !shared.ended) {
        staller.pass(Stall::Thread::main);
        publish_screen(desk);
        shared.window.poll(events, patience(desk, pads));
        if (desk.plan.probe)
            probe(events, next_probe_ns);
        else
            pause_without_focus(desk);
        if (shared.window.should_close() || EndWatch::asked()) shared.stop = true;
        if (pads || menu_open(desk)) follow_pads(desk);
        follow_arm(desk);
        follow_going(desk);
        repeat_menu(desk);
        follow_wish(desk);
        shared.window.capture_cursor(mouse && !desk.plan.probe && shared.going.load() == Going::playing);
    }
    shared.window.capture_cursor(false);
}

// The start screen ---------------------------------------------------------------------------------------------------------

namespace {

/// The court as a match would find it.
void show_court(Desk& desk) {
    input::DeviceSpec nobody;
    std::vector<input::DeviceSpec> devices(game::players, nobody);
    for (std::uint32_t p = 0; p < game::players; ++p) devices[p].player = p;
    const game::Simulation match(desk.data, {1, std::move(devices)});
    game::take_picture(match, desk.shared.pictures.to_fill());
    desk.shared.pictures.publish();
}

void follow_plugs(Desk& desk) {
    for (std::size_t i = 0; i < desk.pads.size(); ++i) {
        const std::string name = desk.pads[i].present ? desk.pads[i].name : std::string();
        if (name == desk.facts.pads[i]) continue;
        desk.facts.pads[i] = name;
        desk.stale = true;
        if (!desk.pads[i].present)
            menu_event(desk,
                       {.kind = MenuEvent::Kind::gone, .device = {DeviceKind::pad, static_cast<int>(i)}});
    }
}

/// A fault shows on the screen.
bool note_fault(Desk& desk, const Expected<void>& result) {
    if (result) return true;
    desk.menu.note = result.error().message;
    desk.stale = true;
    return false;
}

/// The data of the match that was chosen, as the files are now: they may have been changed on the range.
Expected<void> load_chosen(Desk& desk) {
    auto choice = desk.data->choice;
    length_of(choice) = desk.facts.rules[desk.menu.rules].name;
    auto data = game::load_match_data(desk.plan.assets, choice);
    if (!data) return tl::unexpected(data.error());
    desk.data = std::make_shared<const game::MatchData>(std::move(*data));
    return {};
}

bool out_of_time(const Desk& desk) {
    return desk.plan.seconds &&
           monotonic_ns() > desk.shared.began_ns + static_cast<std::int64_t>(*desk.plan.seconds * 1e9);
}

}  // namespace

Expected<void> open_range(Desk& desk) {
    auto files = game::RangeFiles::open(desk.plan.assets, desk.data->choice);
    if (!files) return tl::unexpected(files.error());
    desk.range = std::move(*files);
    return {};
}

bool run_start_screen(Desk& desk) {
    auto& shared = desk.shared;
    for (auto& seat : shared.seats) seat = {};
    desk.grips = {};
    if (shared.began_ns == 0) shared.began_ns = monotonic_ns();
    show_court(desk);
    desk.menu = opened(std::move(desk.menu), Page::start);
    desk.stale = true;
    const auto events = desk_events(desk);
    while (!shared.stop) {
        publish_screen(desk);
        shared.window.poll(events, menu_poll_s);
        follow_pads(desk);
        follow_plugs(desk);
        follow_arm(desk);
        repeat_menu(desk);
        const auto wish = std::exchange(desk.menu.wish, MenuWish::none);
        if (wish == MenuWish::start && note_fault(desk, load_chosen(desk))) return true;
        if (wish == MenuWish::range && note_fault(desk, open_range(desk))) return true;
        const bool closes = shared.window.should_close() || EndWatch::asked() || out_of_time(desk);
        if (wish == MenuWish::quit || closes) shared.stop = true;
    }
    return false;
}

}  // namespace thaum::app
