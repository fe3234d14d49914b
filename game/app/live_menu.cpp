// Keys, mouse and pads while a menu is open. The menu's keys cannot be bound: a menu must work whatever the
// bindings are.
#include <algorithm>
#include <cmath>

#include "core/config.h"
#include "core/file.h"
#include "core/text.h"
#include "game/app/live_session.h"
#include "game/bots/bot.h"

namespace thaum::app {

using input::Action;
using input::Control;
using input::DeviceKind;
using input::PadAxis;
using input::PadButton;
using Kind = MenuEvent::Kind;

namespace {

constexpr std::int64_t repeat_after_ns = 400'000'000, repeat_every_ns = 110'000'000;
constexpr double stick_press = 0.6;
constexpr std::size_t max_data_file = 1U << 20U;
constexpr int most_levels = 7;

constexpr Device keyboard{DeviceKind::keyboard_mouse, 0}, half{DeviceKind::keyboard_half, 0};

struct MenuKey {
    std::string_view name;
    Kind kind;
    Device device;
};
constexpr MenuKey menu_keys[] = {
    {"up", Kind::up, keyboard},           {"down", Kind::down, keyboard},
    {"left", Kind::left, keyboard},       {"right", Kind::right, keyboard},
    {"page_up", Kind::page_up, keyboard}, {"page_down", Kind::page_down, keyboard},
    {"enter", Kind::confirm, keyboard},   {"space", Kind::confirm, keyboard},
    {"escape", Kind::back, keyboard},     {"kp_8", Kind::up, half},
    {"kp_5", Kind::down, half},           {"kp_2", Kind::down, half},
    {"kp_4", Kind::left, half},           {"kp_6", Kind::right, half},
    {"kp_0", Kind::confirm, half},        {"kp_enter", Kind::confirm, half},
    {"kp_multiply", Kind::back, half},
};

/// Keys without a meaning in the menu: modifiers that people press to change windows, and the keypad, which
/// belongs to the other half of the keyboard.
bool means_nothing(const std::string& name) {
    for (const auto* start : {"kp_", "left_", "right_", "caps", "scroll", "num", "print", "menu", "pause"}) {
        if (name.starts_with(start)) return true;
    }
    return name.empty();
}

/// Event of a key; std::nullopt for a key without a meaning in a menu.
std::optional<MenuEvent> event_of(int key) {
    const auto name = key_name_of(key);
    for (const auto& one : menu_keys) {
        if (one.name == name) return MenuEvent{.kind = one.kind, .device = one.device};
    }
    if (means_nothing(name)) return {};
    return MenuEvent{.kind = Kind::other, .device = keyboard};
}

bool repeats(Kind kind) { return kind <= Kind::right; }

void start_repeat(LiveSession& session, const MenuEvent& event, int key, int pad) {
    session.repeat = {event, key, pad, monotonic_ns() + repeat_after_ns};
}

void control_event(LiveSession& session, const Device& device, const Control& control) {
    menu_event(session, {.kind = Kind::control, .device = device, .control = control});
}

void settings_changed(LiveSession& session, const Settings& before) {
    auto& now = session.menu.settings;
    if (now.fullscreen != before.fullscreen) session.shared.window.set_fullscreen(now.fullscreen);
    rebind_hands(session);
    if (session.plan.settings_file.empty()) return;
    if (const auto saved = save_changes(session.plan.settings_file, before, now); !saved)
        session.menu.note = text("for this run only: ", saved.error().message);
}

}  // namespace

void menu_event(LiveSession& session, const MenuEvent& event) {
    const auto before = session.menu.settings;
    session.menu = step(std::move(session.menu), event, session.menu_context);
    if (!(session.menu.settings == before)) settings_changed(session, before);
    session.shared.dummy = static_cast<game::DummyKind>(session.menu.dummy);
    session.stale = true;
}

// Keys and mouse --------------------------------------------------------------------------------------------

void menu_key(LiveSession& session, int key, bool pressed) {
    if (key == session.repeat.key) session.repeat = {};
    if (!pressed) return;
    const auto event = event_of(key);
    if (session.menu.waiting && !(event && event->kind == Kind::back && esc_ends_waiting(session.menu))) {
        if (!key_name_of(key).empty()) control_event(session, keyboard, {Control::Source::key, key, 0});
        return;
    }
    // In the pause the leave key acts at once, as it does after the round.
    const bool pause = session.menu.pages.back().page == Page::pause;
    if (pause && is_bound(session.menu.settings.of(SessionKey::leave), key)) return leave_match(session);
    if (!event) return;
    menu_event(session, *event);
    if (repeats(event->kind)) start_repeat(session, *event, key, -1);
}

namespace {

std::optional<game::MenuPlace> place_of_mouse(const LiveSession& session) {
    if (!session.mouse) return {};
    return game::place_at(picture_of(session.menu, session.menu_context), session.shared.window.size(),
                          session.menu.settings.text_scale, *session.mouse);
}

}  // namespace

void menu_cursor(LiveSession& session, double x, double y) {
    session.mouse = fvec2(x, y);
    const auto place = place_of_mouse(session);
    if (place && !session.menu.waiting && place->row != session.menu.pages.back().cursor)
        menu_event(session, {.kind = Kind::point, .device = keyboard, .row = place->row});
}

namespace {

Kind click_of(const game::MenuPlace& place) {
    switch (place.part) {
        case game::MenuPart::less: return Kind::left;
        case game::MenuPart::more: return Kind::right;
        default: return Kind::confirm;
    }
}

}  // namespace

void menu_mouse_button(LiveSession& session, int button, bool pressed) {
    constexpr int left = 0, buttons = 5;
    if (!pressed || button >= buttons) return;
    if (session.menu.waiting)
        return control_event(session, keyboard, {Control::Source::mouse_button, button, 0});
    const auto place = place_of_mouse(session);
    if (button == left && place)
        return menu_event(session, {.kind = click_of(*place), .device = keyboard, .row = place->row});
    const bool below = session.menu.pages.size() > 1;
    menu_event(session, {.kind = button != left && below ? Kind::back : Kind::other, .device = keyboard});
}

void menu_wheel(LiveSession& session, double steps) {
    if (steps == 0) return;
    const int way = steps > 0 ? 1 : -1;
    if (session.menu.waiting) return control_event(session, keyboard, {Control::Source::wheel, 0, way});
    menu_event(session, {.kind = way > 0 ? Kind::up : Kind::down, .device = keyboard});
}

// Pads ------------------------------------------------------------------------------------------------------

namespace {

double axis_of(const render::PadState& pad, PadAxis axis) {
    return static_cast<double>(pad.axes[static_cast<std::size_t>(axis)]);
}

/// Direction that a pad's cross or left stick points to in a menu.
std::optional<Kind> way_of(const render::PadState& pad) {
    const auto down = [&](PadButton b) { return (pad.buttons >> static_cast<unsigned>(b) & 1U) != 0; };
    const double x = axis_of(pad, PadAxis::left_x), y = axis_of(pad, PadAxis::left_y);
    const bool upright = std::abs(y) > std::abs(x);
    if (down(PadButton::up) || (upright && y < -stick_press)) return Kind::up;
    if (down(PadButton::down) || (upright && y > stick_press)) return Kind::down;
    if (down(PadButton::left) || (!upright && x < -stick_press)) return Kind::left;
    if (down(PadButton::right) || (!upright && x > stick_press)) return Kind::right;
    return {};
}

/// All controls of the pad that were pressed since `before`.
std::vector<Control> pressed_controls(const render::PadState& before, const render::PadState& now) {
    std::vector<Control> controls;
    for (unsigned b = 0; b <= static_cast<unsigned>(PadButton::left); ++b) {
        if ((now.buttons & ~before.buttons & 1U << b) != 0)
            controls.push_back({Control::Source::pad_button, static_cast<int>(b), 0});
    }
    for (std::size_t a = 0; a < input::pad_axes; ++a) {
        const double from = static_cast<double>(before.axes[a]), to = static_cast<double>(now.axes[a]);
        if (std::abs(from) >= stick_press || std::abs(to) < stick_press) continue;
        // Stick axes of the window are positive downwards.
        const bool upright =
            a == static_cast<std::size_t>(PadAxis::left_y) || a == static_cast<std::size_t>(PadAxis::right_y);
        controls.push_back({Control::Source::pad_axis, static_cast<int>(a), (to > 0) != upright ? 1 : -1});
    }
    return controls;
}

/// Event of a pad's control; std::nullopt for controls that move the choice, which way_of handles.
std::optional<Kind> kind_of(const Control& control, bool start_page) {
    if (control.source == Control::Source::pad_axis)
        return control.code >= static_cast<int>(PadAxis::left_trigger) ? std::optional(Kind::other)
                                                                       : std::nullopt;
    switch (static_cast<PadButton>(control.code)) {
        case PadButton::up:
        case PadButton::down:
        case PadButton::left:
        case PadButton::right: return {};
        case PadButton::a: return Kind::confirm;
        case PadButton::b: return Kind::back;
        case PadButton::start: return start_page ? Kind::other : Kind::back;
        case PadButton::left_bumper: return start_page ? Kind::other : Kind::page_up;
        case PadButton::right_bumper: return start_page ? Kind::other : Kind::page_down;
        default: return Kind::other;
    }
}

void point_by_pad(LiveSession& session, const Device& device, const render::PadState& before,
                  const render::PadState& now) {
    const auto way = way_of(now);
    if (way == way_of(before)) return;
    if (session.repeat.pad == device.pad) session.repeat = {};
    if (!way) return;
    const MenuEvent event{.kind = *way, .device = device};
    menu_event(session, event);
    start_repeat(session, event, -1, device.pad);
}

}  // namespace

void menu_pad(LiveSession& session, int place, const render::PadState& before) {
    const auto now = session.pads[static_cast<std::size_t>(place)];
    if (!now.present) {
        if (session.repeat.pad == place) session.repeat = {};
        return;
    }
    const Device device{DeviceKind::pad, place};
    for (const auto& control : pressed_controls(before, now)) {
        if (session.menu.pages.empty()) return;
        if (session.menu.waiting) {
            control_event(session, device, control);
            return;  // other controls pressed at the same time are ignored
        }
        const bool start_page = session.menu.pages.back().page == Page::start;
        if (const auto kind = kind_of(control, start_page))
            menu_event(session, {.kind = *kind, .device = device});
    }
    if (!session.menu.waiting && !session.menu.pages.empty()) point_by_pad(session, device, before, now);
}

void repeat_menu(LiveSession& session) {
    auto& repeat = session.repeat;
    if (session.menu.pages.empty() || session.menu.waiting) repeat = {};
    if (!repeat.event || monotonic_ns() < repeat.next_ns) return;
    repeat.next_ns = monotonic_ns() + repeat_every_ns;
    menu_event(session, *repeat.event);
}

// The pause -------------------------------------------------------------------------------------------------

void open_pause(LiveSession& session) {
    session.menu = opened(std::move(session.menu), Page::pause);
    session.mouse.reset();  // position unknown: the cursor was captured during play
    session.stale = true;
}

void tell_pause(LiveSession& session) {
    constexpr std::array<std::string_view, game::players> pad_lost_heads{"Player 1: pad lost",
                                                                         "Player 2: pad lost"};
    const auto& shared = session.shared;
    const auto by = shared.paused_by.load();
    auto head = text("Paused"), line = by < game::players ? text("by player ", by + 1) : std::string();
    for (std::uint32_t p = 0; p < game::players; ++p) {
        if (!shared.pad_lost[p]) continue;
        head = pad_lost_heads[p];
        line = text(how_to_rejoin, ", or keypad 0 for half of the keyboard");
    }
    if (session.menu.head == head && session.menu.line == line) return;
    session.menu.head = head;
    session.menu.line = line;
    session.stale = true;
}

// Menu context -------------------------------------------------------------------------------------------

namespace {

std::string clock_of(Tick length) {
    const auto whole = static_cast<int>(seconds(length));
    return text(whole / 60, whole % 60 < 10 ? ":0" : ":", whole % 60);
}

MenuContext::Named told(const std::string& name, const game::RoundRules& rules) {
    const auto rounds = rules.rounds > 1 ? text("best of ", rules.rounds, ", ") : std::string();
    return {name, text(name, ": ", rounds, "first to ", rules.kills, ", ", clock_of(rules.length))};
}

std::optional<MenuContext::Named> rules_of(const std::filesystem::path& file) {
    const auto source = read_text_file(file, max_data_file);
    if (!source) return {};
    const auto config = Config::parse(*source, file.string(), 1);
    if (!config) return {};
    const auto rules = game::read_round_rules(*config);
    if (!config->check()) return {};
    return told(file.stem().string(), rules);
}

/// Name and label of an arena; std::nullopt if the file has none. A match reports all other faults.
std::optional<MenuContext::Named> arena_of(const std::filesystem::path& file) {
    const auto source = read_text_file(file, max_data_file);
    if (!source) return {};
    const auto config = Config::parse(*source, file.string(), 1);
    if (!config) return {};
    auto label = config->root().string("name", "");
    if (label.empty()) return {};
    return MenuContext::Named{file.stem().string(), std::move(label)};
}

/// All files of a data folder that `read` accepts, sorted by name.
template <class Read>
std::vector<MenuContext::Named> all_in(const std::filesystem::path& folder, Read read) {
    std::vector<MenuContext::Named> all;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->path().extension() != ".toml") continue;
        if (auto one = read(it->path())) all.push_back(std::move(*one));
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return all;
}

std::vector<MenuContext::Named> all_arenas(const LivePlan& plan) {
    auto all = all_in(plan.assets / "arenas", arena_of);
    const auto& chosen = plan.data->choice.arena;
    const auto row = std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.name == chosen; });
    if (row == all.end()) all.push_back({chosen, plan.data->arena.name});
    return all;
}

std::vector<MenuContext::Named> all_rules(const LivePlan& plan) {
    auto all = all_in(plan.assets / "rules", rules_of);
    auto choice = plan.data->choice;
    const auto& chosen = length_of(choice);
    // Rules that were chosen on the command line, with the changes of --set.
    const auto row = std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == chosen; });
    (row == all.end() ? all.emplace_back() : *row) = told(chosen, plan.data->round);
    return all;
}

}  // namespace

MenuContext find_menu_context(const LivePlan& plan) {
    MenuContext context{
        .rules = all_rules(plan), .arenas = all_arenas(plan), .ends_match = plan.start_screen};
    for (int level = 1; level <= most_levels; ++level) {
        if (game::load_bot_skill(plan.assets, level)) context.levels.push_back(level);
    }
    // level 1 stands in; the match will report the missing file
    if (context.levels.empty()) context.levels.push_back(1);
    return context;
}

}  // namespace thaum::app
