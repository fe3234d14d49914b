// game/settings/bindings.h: bindings of controls to actions in the settings, as sheets (one for each kind of
// device, and one for the session) with one row for each action. Functions here give the names of sheets,
// actions and controls, test which controls a hand can use, and move a control from one action to another.
#pragma once
#include <string>
#include <vector>

#include "game/settings/settings.h"

namespace thaum::game::inline settings {

/// One action on one sheet of bindings (the bindings of one kind of device, or of the session). Sheets 0 to 2
/// belong to the kinds of device in settings_hands. Sheet 3 has the keys of the session, such as the pause,
/// whatever devices the players use.
struct Slot {
    std::size_t sheet{}, action{};
    bool operator==(const Slot&) const = default;
};
inline constexpr std::size_t sheets = settings_hands.size() + 1;
inline constexpr std::size_t session_sheet = settings_hands.size();

std::size_t size_of_sheet(std::size_t sheet);
bool is_pad_sheet(std::size_t sheet);

/// Display names of the wands, such as "Bolt", by the number of the wand's slot, from 0. Empty: no wand has
/// the slot.
using WandNames = std::array<std::string, input::max_wands>;

/// Tests whether the page of controls lists the action. Other actions have no control by default and no
/// effect.
bool is_listed(Slot slot, const WandNames& wands);
/// Tests whether a key is one of the controls.
bool is_bound(const std::vector<input::Control>& controls, int key);
/// Tests whether the action opens the pause.
bool pauses(Slot slot);
/// Tests whether a control can be bound to the action: a control of the sheet's kind of device, or on the
/// session's sheet a key. Steps of the wheel always move a held thing nearer or farther, so they cannot be
/// bound to that action as well.
bool fits(Slot slot, const input::Control& control);

const std::vector<input::Control>& controls_of(const Settings& settings, Slot slot);

/// Makes `control` the only control of an action. Removes it from every action that works at the same time,
/// and returns those actions.
std::vector<Slot> assign(Settings& settings, Slot slot, const input::Control& control);

/// Label of a sheet of bindings: "Keypad and arrows", "Keys for everybody".
std::string label_of_sheet(std::size_t sheet);
/// Label of an action: "Use wand". An action that selects a wand has the wand's name.
std::string label_of(Slot slot, const WandNames& wands);
/// Returns a sentence that says what an action does.
std::string help_of(Slot slot, const WandNames& wands);
/// Label of a control: "Space", "Left mouse button", "RT", "Left stick up".
std::string label_of(const input::Control& control);

}  // namespace thaum::game::inline settings
