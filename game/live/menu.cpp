#include "game/live/menu.h"

#include <algorithm>

#include "core/one_line.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/menu/menu_input.h"

namespace thaum::game::inline live {

using input::Control;
using input::DeviceKind;
using Kind = MenuEvent::Kind;

namespace {

constexpr Device mouse_and_keys{DeviceKind::keyboard_mouse, 0};

bool repeats(Kind kind) { return kind <= Kind::right || kind == Kind::erase; }

}  // namespace

LiveMenu::LiveMenu(MenuState state, MenuContext context, std::filesystem::path settings_file)
    : state_(std::move(state)), context_(std::move(context)), settings_file_(std::move(settings_file)) {
    if (settings_file_.empty()) return;
    profiles_folder_ = settings_file_.parent_path() / "feel";
    std::vector<std::string> faults;
    context_.profiles = load_feel_profiles(profiles_folder_, faults);
    for (const auto& fault : faults) tell_user(text("a profile is left out: ", fault));
}

void LiveMenu::open(std::string_view page) {
    state_ = opened(std::move(state_), page);
    request_ = MenuRequest::none;
    // The mouse was captured during play, so where its cursor is shown is unknown until it moves.
    if (page == page_name::pause) mouse_.reset();
}

void LiveMenu::close() {
    state_.pages.clear();
    state_.waiting.reset();
    state_.typing.reset();
    context_.missing.clear();
}

namespace {

/// The chosen row of the page that is shown; std::nullopt: there is no page.
std::optional<std::size_t> chosen_row(const MenuState& state) {
    return state.pages.empty() ? std::nullopt : std::optional(state.pages.back().cursor);
}

}  // namespace

/// Applies an event to the menu. Presses are ignored while a request waits for the session. The request will
/// close the menu or end its match, so such presses are not meant for this menu any more.
void LiveMenu::step(const MenuEvent& event) {
    if (request_ != MenuRequest::none && event.kind != Kind::gone) return;
    const auto before = state_.settings;
    const auto row_before = chosen_row(state_);
    const auto depth_before = state_.pages.size();
    const auto seats_before = state_.seats;
    state_ = game::step(std::move(state_), event, context_);
    if (state_.request != MenuRequest::none) request_ = state_.request;
    if (state_.saves) save_profile(std::move(*state_.saves));
    if (state_.tries) trial_ = state_.tries;
    const bool chosen = state_.request != MenuRequest::none || state_.pages.size() > depth_before ||
                        state_.settings != before || state_.seats != seats_before;
    if (chosen)
        sound_ = event.kind == Kind::back ? MenuSound::back : MenuSound::choose;
    else if (state_.pages.size() < depth_before)
        sound_ = MenuSound::back;
    else if (chosen_row(state_) != row_before)
        sound_ = MenuSound::move;
    else if (!state_.note.empty())
        sound_ = MenuSound::refused;
    keep_changes(before);
}

/// Reports changed settings to the session, which applies them, and saves them.
void LiveMenu::keep_changes(const Settings& before) {
    if (state_.settings == before) return;
    settings_changed_ = true;
    if (settings_file_.empty()) return;
    if (const auto saved = save_changes(settings_file_, before, state_.settings); !saved)
        state_.note = text("for this run only: ", saved.error().message);
}

void LiveMenu::set_own_force(std::size_t player, std::uint32_t percent) {
    const auto before = state_.settings;
    auto& own = state_.settings.players.at(player);
    own.force = own_force;
    own.own_force_percent = static_cast<int>(percent);
    keep_changes(before);
}

/// Keeps a feel profile (a player's saved strengths of what is felt) in the menu's list, and in its file.
void LiveMenu::save_profile(FeelProfile profile) {
    auto& all = context_.profiles;
    const auto same =
        std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == profile.name; });
    state_.profile = static_cast<std::size_t>(same - all.begin());
    (same == all.end() ? all.emplace_back() : *same) = profile;
    state_.note = text("saved as ", profile.name);
    if (profiles_folder_.empty()) return;
    if (const auto saved = save_feel_profile(profiles_folder_, profile); !saved)
        state_.note = text("for this run only: ", saved.error().message);
}

void LiveMenu::give_control(const Device& device, const Control& control) {
    step({.kind = Kind::control, .device = device, .control = control});
}

// Keys and mouse --------------------------------------------------------------------------------------------

void LiveMenu::key(int key, bool pressed, std::int64_t now_ns) {
    if (key == held_.key) release();
    if (!pressed) return;
    const auto event = menu_event_of(key);
    if (waits_for_control() && !(event && event->kind == Kind::back && esc_ends_waiting(state_))) {
        if (!key_name_of(key).empty()) give_control(mouse_and_keys, {Control::Source::key, key, 0});
        return;
    }
    if (takes_text()) return name_key(key, now_ns);
    // In the pause the session's key `leave` acts at once, as it does after the round.
    const bool pause = state_.pages.back().page == page_name::pause;
    if (pause && is_bound(settings().of(SessionKey::leave), key)) {
        request_ = MenuRequest::leave;
        return;
    }
    if (!event) return;
    step(*event);
    if (repeats(event->kind)) held_ = {*event, key, -1, now_ns + repeat_after_ns};
}

/// Handles a key while a name is typed. Letters arrive by character() instead.
void LiveMenu::name_key(int key, std::int64_t now_ns) {
    const auto kind = name_event_of(key);
    if (!kind) return;
    const MenuEvent event{.kind = *kind, .device = mouse_and_keys};
    step(event);
    if (repeats(*kind)) held_ = {event, key, -1, now_ns + repeat_after_ns};
}

void LiveMenu::character(char32_t character) {
    if (takes_text()) step({.kind = Kind::character, .device = mouse_and_keys, .typed = character});
}

std::optional<MenuPlace> LiveMenu::place_of_mouse(render::Size window) const {
    if (!mouse_) return {};
    return place_at(picture(), window, settings().text_scale, *mouse_);
}

void LiveMenu::cursor(fvec2 position, render::Size window) {
    mouse_ = position;
    const auto place = place_of_mouse(window);
    if (place && !takes_all_keys() && place->row != state_.pages.back().cursor)
        step({.kind = Kind::point, .device = mouse_and_keys, .row = place->row});
}

namespace {

Kind click_of(const MenuPlace& place) {
    switch (place.part) {
        case MenuPart::less: return Kind::left;
        case MenuPart::more: return Kind::right;
        default: return Kind::confirm;
    }
}

}  // namespace

void LiveMenu::mouse_button(int button, bool pressed, render::Size window) {
    constexpr int left = 0, buttons = 5;
    if (!pressed || button >= buttons) return;
    if (waits_for_control()) return give_control(mouse_and_keys, {Control::Source::mouse_button, button, 0});
    const auto place = place_of_mouse(window);
    if (button == left && place)
        return step({.kind = click_of(*place), .device = mouse_and_keys, .row = place->row});
    const bool below = state_.pages.size() > 1;
    step({.kind = button != left && below ? Kind::back : Kind::other, .device = mouse_and_keys});
}

void LiveMenu::wheel(double steps) {
    if (steps == 0) return;
    const int way = steps > 0 ? 1 : -1;
    if (waits_for_control()) return give_control(mouse_and_keys, {Control::Source::wheel, 0, way});
    step({.kind = way > 0 ? Kind::up : Kind::down, .device = mouse_and_keys});
}

// Pads ------------------------------------------------------------------------------------------------------

bool LiveMenu::has_seat(int place) const {
    const auto& seats = state_.seats;
    return std::find(seats.begin(), seats.end(), Device{DeviceKind::pad, place}) != seats.end();
}

/// Whether a button of the pad has been held down since the press with which the pad joined. Further presses
/// then count as part of that one. Otherwise somebody who presses several buttons at once would join and
/// start the match before the other player has a seat.
bool LiveMenu::joined_just_now(const Device& device, const input::PadState& before) {
    bool& joining = joining_.at(static_cast<std::size_t>(device.pad));
    if (joining && pressed_controls({}, before).empty()) joining = false;
    return joining;
}

void LiveMenu::pad(int place, const input::PadState& before, const input::PadState& current,
                   std::int64_t now_ns) {
    if (!current.present) {
        if (held_.pad == place) release();
        return;
    }
    const Device device{DeviceKind::pad, place};
    for (const auto& control : pressed_controls(before, current)) {
        // While the menu waits for a control, only the first one that was pressed counts.
        if (waits_for_control()) return give_control(device, control);
        const bool start_page = on_start_page();
        const auto kind = menu_event_of(control, start_page);
        if (!kind || (start_page && joined_just_now(device, before))) continue;
        const bool seated = has_seat(place);
        step({.kind = *kind, .device = device});
        joining_.at(static_cast<std::size_t>(place)) = !seated && has_seat(place);
    }
    if (!waits_for_control()) point_by_pad(device, before, current, now_ns);
}

void LiveMenu::point_by_pad(const Device& device, const input::PadState& before,
                            const input::PadState& current, std::int64_t now_ns) {
    if (!before.present) return;  // a stick that is pushed when the pad is plugged in may be stuck
    const auto way = menu_direction_of(current);
    if (way == menu_direction_of(before) || (on_start_page() && joined_just_now(device, before))) return;
    if (held_.pad == device.pad) release();
    if (!way) return;
    const MenuEvent event{.kind = *way, .device = device};
    step(event);
    held_ = {event, -1, device.pad, now_ns + repeat_after_ns};
}

void LiveMenu::repeat(std::int64_t now_ns) {
    if (!is_open() || waits_for_control()) release();
    if (!held_.event || now_ns < held_.next_ns) return;
    held_.next_ns = now_ns + repeat_every_ns;
    step(*held_.event);
}

// News ------------------------------------------------------------------------------------------------------

void LiveMenu::name_pads(const Pads& pads) {
    for (std::size_t i = 0; i < pads.size(); ++i) {
        constexpr std::size_t max_of_name = 40;
        const auto name = pads[i].present ? printable(pads[i].name, max_of_name) : std::string();
        if (name == context_.pads[i]) continue;
        context_.pads[i] = name;
        if (!pads[i].present) step({.kind = Kind::gone, .device = {DeviceKind::pad, static_cast<int>(i)}});
    }
}

void LiveMenu::tell_sticks(std::vector<std::string> unknown, std::vector<std::string> own,
                           std::vector<std::string> faults) {
    context_.pad_faults = std::move(faults);
    if (unknown == context_.sticks && own == context_.own_pads) return;
    const auto before = context_;
    context_.sticks = std::move(unknown);
    context_.own_pads = std::move(own);
    state_ = on_same_rows(std::move(state_), before, context_);
}

void LiveMenu::end_pad_setup(std::string note) {
    if (sets_up_pad()) state_.pages.pop_back();
    state_.note = std::move(note);
}

void LiveMenu::set_gestures(const GestureSet* gestures) {
    context_.gestures.clear();
    if (gestures == nullptr) return;
    for (const auto& gesture : gestures->gestures()) context_.gestures.push_back(gesture.name);
}

void LiveMenu::set_pause(PauseWords words) {
    state_.head = std::move(words.head);
    state_.line = std::move(words.line);
    if (words.missing != context_.missing && state_.note == words_of_refusal(context_)) state_.note.clear();
    context_.missing = std::move(words.missing);
    if (words.half_for == context_.half_for) return;
    const auto before = context_;
    context_.half_for = std::move(words.half_for);
    state_ = on_same_rows(std::move(state_), before, context_);
}

void LiveMenu::turn_split() {
    auto& split = state_.settings.split;
    split = split == render::Split::top_bottom ? render::Split::side_by_side : render::Split::top_bottom;
}

}  // namespace thaum::game::inline live
