// game/app/bindings.h: the settings' bindings as sheets of actions: what a control is called, which hand can reach it, and what loses
// it when something else gets it.
#pragma once
#include <string>
#include <vector>

#include "game/app/settings.h"

namespace thaum::app {

/// One action of one sheet of bindings: sheet 0 to 2 is settings_hands, 3 the session's keys.
struct Slot {
    std::size_t sheet{}, action{};
    bool operator==(const Slot&) const = default;
};
inline constexpr std::size_t sheets = settings_hands.size() + 1;
inline constexpr std::size_t session_sheet = settings_hands.size();

std::size_t size_of_sheet(std::size_t sheet);
bool is_pad_sheet(std::size_t sheet);

/// Is it shown to be changed? The other actions have no control by default, and nothing listens to them.
bool is_listed(Slot slot);
/// Is it what opens the pause?
bool pauses(Slot slot);
/// Can a hand of this sheet reach the control?
bool fits(std::size_t sheet, const input::Control& control);

const std::vector<input::Control>& controls_of(const Settings& settings, Slot slot);

/// Gives the slot this control and nothing else; it is taken from whatever else it would do at the same time. Returns
/// what lost it.
std::vector<Slot> assign(Settings& settings, Slot slot, const input::Control& control);

/// "Half of the keyboard", "Keys for everybody".
std::string label_of_sheet(std::size_t sheet);
/// "Use wand".
std::string label_of(Slot slot);
/// "Space", "Left mouse button", "RT", "Left stick up".
std::string label_of(const input::Control& control);

}  // namespace thaum::app
