#include "game/settings/bindings.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/text.h"
#include "game/components/orb.h"
#include "render/context.h"

namespace thaum::game::inline settings {

using input::Action;
using input::Control;
using input::DeviceKind;

namespace {

std::string capitalised_words(std::string_view name) {
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    if (!words.empty() && words[0] >= 'a' && words[0] <= 'z')
        words[0] = static_cast<char>(words[0] - 'a' + 'A');
    return words;
}

std::vector<Control>& controls_to_change(Settings& settings, Slot slot) {
    if (slot.sheet == session_sheet) return settings.session[slot.action];
    return settings.bindings_of(settings_hands[slot.sheet]).controls[slot.action];
}

bool is_pad_control(const Control& c) {
    return c.source == Control::Source::pad_button || c.source == Control::Source::pad_axis;
}

bool is(Slot slot, Action action) {
    return slot.sheet != session_sheet && slot.action == static_cast<std::size_t>(action);
}
bool is(Slot slot, SessionKey key) {
    return slot.sheet == session_sheet && slot.action == static_cast<std::size_t>(key);
}

/// Number of wand keys that choose something at orb and crystals, even if no wand has that key.
constexpr std::size_t station_keys = max_orb_modes;

/// Number of the wand (its slot, from 0) that the action selects; std::nullopt for other actions.
std::optional<std::size_t> wand_slot_of(Slot slot) {
    for (std::size_t wand = 0; wand < input::max_wands; ++wand) {
        if (is(slot, input::wand_action(wand + 1))) return wand;
    }
    return std::nullopt;
}

/// Whether an action only works after a round, when no other actions of players' devices do.
bool acts_after_round(Slot slot) {
    return is(slot, Action::confirm) || is(slot, SessionKey::again) || is(slot, SessionKey::leave);
}
bool acts_in_round(Slot slot) { return !acts_after_round(slot); }
bool acts_always(Slot slot) { return slot.sheet == session_sheet && acts_in_round(slot); }

/// Tests whether two actions may have the same control. Two players may share the emergency key (panic), the
/// pause or the confirmation. A session key, which works for both players, may also be a player's key for the
/// same purpose. Actions that never work at the same time may also share a control.
bool may_share(Slot a, Slot b) {
    const bool hands = a.sheet != session_sheet && b.sheet != session_sheet;
    if (hands && a.action == b.action)
        return is(a, Action::panic) || is(a, Action::pause) || is(a, Action::confirm);
    const auto either = [&](auto one, auto other) {
        return (is(a, one) && is(b, other)) || (is(b, one) && is(a, other));
    };
    if (either(Action::pause, SessionKey::pause) || either(Action::confirm, SessionKey::again)) return true;
    return acts_after_round(a) != acts_after_round(b) && !acts_always(a) && !acts_always(b);
}

/// Tests whether two actions must not have the same control. Two pads belong to two people, so a control on
/// the sheet of pads (their bindings) never conflicts with one on another sheet.
bool conflict(Slot a, Slot b) { return is_pad_sheet(a.sheet) == is_pad_sheet(b.sheet) && !may_share(a, b); }

constexpr std::array<std::string_view, 5> mouse_button_labels{
    "Left mouse button", "Right mouse button", "Middle mouse button", "Mouse button 4", "Mouse button 5"};

constexpr std::array<std::string_view, 15> pad_button_labels{"A",
                                                             "B",
                                                             "X",
                                                             "Y",
                                                             "LB",
                                                             "RB",
                                                             "Back",
                                                             "Start",
                                                             "Guide",
                                                             "Left stick in",
                                                             "Right stick in",
                                                             "Pad up",
                                                             "Pad right",
                                                             "Pad down",
                                                             "Pad left"};

/// Two labels for each axis of a pad: for its low end and its high end.
constexpr std::array<std::string_view, 12> pad_axis_labels{"Left stick left",
                                                           "Left stick right",
                                                           "Left stick down",
                                                           "Left stick up",
                                                           "Right stick left",
                                                           "Right stick right",
                                                           "Right stick down",
                                                           "Right stick up",
                                                           "LT",
                                                           "LT",
                                                           "RT",
                                                           "RT"};

/// Keys of the keypad that people know by the character printed on them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> keypad_signs{
    {{"add", "+"}, {"subtract", "-"}, {"multiply", "*"}, {"divide", "/"}, {"decimal", "."}, {"equal", "="}}};

std::string label_of_key(int code) {
    // Letters as printed on the user's keyboard; other keys by the names in the settings file, such as "Left
    // shift".
    if (auto label = render::key_label(code); label != render::key_name(code)) return label;
    auto words = capitalised_words(key_name_of(code));
    if (words == "Escape") return "Esc";
    if (!words.starts_with("Kp ")) return words;
    const auto key = std::string_view(words).substr(3);
    const auto sign =
        std::find_if(keypad_signs.begin(), keypad_signs.end(), [&](const auto& s) { return s.first == key; });
    return text("Keypad ", sign == keypad_signs.end() ? key : sign->second);
}

}  // namespace

std::size_t size_of_sheet(std::size_t sheet) {
    return sheet == session_sheet ? session_keys : input::actions;
}

bool is_pad_sheet(std::size_t sheet) {
    return sheet < settings_hands.size() && settings_hands[sheet] == DeviceKind::pad;
}

bool is_listed(Slot slot, const WandNames& wands) {
    if (const auto wand = wand_slot_of(slot)) return !wands[*wand].empty() || *wand < station_keys;
    return !is(slot, Action::rejoin) && !is(slot, Action::quit) && !is(slot, Action::mark);
}

bool is_bound(const std::vector<Control>& controls, int key) {
    return std::any_of(controls.begin(), controls.end(),
                       [&](const Control& c) { return c.source == Control::Source::key && c.code == key; });
}

bool pauses(Slot slot) { return is(slot, Action::pause) || is(slot, SessionKey::pause); }

bool fits(Slot slot, const Control& control) {
    // The steps of the mouse wheel always move a held thing farther or nearer, without a binding.
    const bool wheel = control.source == Control::Source::wheel;
    if (wheel && (is(slot, Action::farther) || is(slot, Action::nearer))) return false;
    if (is_pad_sheet(slot.sheet)) return is_pad_control(control);
    if (slot.sheet == 0) return !is_pad_control(control);
    return control.source == Control::Source::key;
}

const std::vector<Control>& controls_of(const Settings& settings, Slot slot) {
    if (slot.sheet == session_sheet) return settings.session[slot.action];
    return settings.bindings_of(settings_hands[slot.sheet]).controls[slot.action];
}

std::vector<Slot> assign(Settings& settings, Slot slot, const Control& control) {
    std::vector<Slot> losers;
    for (std::size_t sheet = 0; sheet < sheets; ++sheet) {
        for (std::size_t action = 0; action < size_of_sheet(sheet); ++action) {
            const Slot other{sheet, action};
            if (other == slot || !conflict(slot, other)) continue;
            if (std::erase(controls_to_change(settings, other), control) > 0) losers.push_back(other);
        }
    }
    controls_to_change(settings, slot) = {control};
    return losers;
}

std::string label_of_sheet(std::size_t sheet) {
    constexpr std::array<std::string_view, sheets> labels{"Mouse and keyboard", "Keypad and arrows", "Pad",
                                                          "Keys for everybody"};
    return std::string(labels[sheet]);
}

std::string label_of(Slot slot, const WandNames& wands) {
    if (slot.sheet == session_sheet) {
        const auto key = static_cast<SessionKey>(slot.action);
        switch (key) {
            case SessionKey::again: return "Rematch";
            case SessionKey::leave: return "Quit to menu";
            case SessionKey::mark: return "Bookmark";
            default: return capitalised_words(name_of(key));
        }
    }
    if (is(slot, Action::panic)) return "Forces off (emergency)";
    const auto wand = wand_slot_of(slot);
    if (wand && !wands[*wand].empty()) return wands[*wand];
    if (wand) return text("Mode ", *wand + 1);
    return capitalised_words(input::name_of(static_cast<Action>(slot.action)));
}

namespace {

std::string_view help_of(SessionKey key) {
    switch (key) {
        case SessionKey::pause: return "Pauses the match; after the round it leaves.";
        case SessionKey::again: return "Plays another match after the result.";
        case SessionKey::leave: return "Leaves a match that is paused or over.";
        case SessionKey::split: return "Turns the split between the two views.";
        case SessionKey::fullscreen: return "Fills the whole screen, or plays in a window.";
        case SessionKey::mark: return "Puts a numbered bookmark into the recording.";
        case SessionKey::forces:
            return "Draws the forces on the hands as curves; again: times of the picture.";
    }
    return {};
}

std::string_view help_of(Action action) {
    switch (action) {
        case Action::fire: return "Uses the wand or carving tool, and drops what is carried.";
        case Action::jump: return "Jumps.";
        case Action::next_wand: return "Takes the next wand, mode or tool.";
        case Action::previous_wand: return "Takes the wand, mode or tool before.";
        case Action::trace: return "Draws a gesture while held; with a wand's key it casts that key's spell.";
        case Action::stir: return "Stirs the brew, scries the orb, carves the crystal.";
        case Action::throw_: return "Throws the thing that the wand Lift holds, or puts an ingredient away.";
        case Action::clutch: return "Moves the hand and not the view, while held.";
        case Action::panic: return "Ends all forces at once, for everybody.";
        case Action::pause: return "Pauses the match, or goes on.";
        case Action::confirm: return "Begins the next round, or another match after the result.";
        case Action::move_left: return "Walks to the left, or turns the crystal.";
        case Action::move_right: return "Walks to the right, or turns the crystal.";
        case Action::move_forward: return "Walks forward.";
        case Action::move_back: return "Walks back.";
        case Action::turn_left: return "Turns the view to the left.";
        case Action::turn_right: return "Turns the view to the right.";
        case Action::turn_up: return "Turns the view up.";
        case Action::turn_down: return "Turns the view down.";
        case Action::farther: return "Moves the thing that Lift holds away, as the wheel of a mouse does.";
        case Action::nearer: return "Moves the thing that Lift holds closer, as the wheel of a mouse does.";
        default: return {};
    }
}

/// Help on the key of a wand, which also chooses a mode at the orb or a tool at a crystal.
std::string help_of_wand(std::size_t wand, std::string_view name) {
    if (wand >= station_keys) return text("Takes the wand ", name, ".");
    const auto other = text("mode or tool ", wand + 1, " at orb and crystal.");
    return name.empty() ? text("Takes ", other) : text("Takes the wand ", name, "; takes ", other);
}

}  // namespace

std::string help_of(Slot slot, const WandNames& wands) {
    if (slot.sheet == session_sheet) return std::string(help_of(static_cast<SessionKey>(slot.action)));
    if (const auto wand = wand_slot_of(slot)) return help_of_wand(*wand, wands[*wand]);
    return std::string(help_of(static_cast<Action>(slot.action)));
}

std::string label_of(const Control& control) {
    const auto code = static_cast<std::size_t>(control.code);
    switch (control.source) {
        case Control::Source::key: return label_of_key(control.code);
        case Control::Source::mouse_button: return std::string(mouse_button_labels.at(code));
        case Control::Source::wheel: return control.direction > 0 ? "Wheel up" : "Wheel down";
        case Control::Source::pad_button: return std::string(pad_button_labels.at(code));
        case Control::Source::pad_axis:
            return std::string(pad_axis_labels.at(2 * code + (control.direction > 0 ? 1 : 0)));
    }
    return {};
}

}  // namespace thaum::game::inline settings
