// game/menu/menu_input.h: meaning of keys and pads in a menu. These controls cannot be bound: a menu
// must work whatever the bindings are.
#pragma once
#include <optional>
#include <vector>

#include "game/menu/menu.h"
#include "input/pad_state.h"

namespace thaum::game::inline menu {

/// Deflection from which a stick or trigger of a pad counts as pressed in a menu (share of the full
/// deflection).
inline constexpr double menu_stick_press = 0.6;

/// Event of a key; std::nullopt for a key without a meaning in a menu.
std::optional<MenuEvent> menu_event_of(int key);

/// Event of a key while a name is typed; std::nullopt for keys that only type.
std::optional<MenuEvent::Kind> name_event_of(int key);

/// Direction that a pad's d-pad or left stick points to; std::nullopt: none.
std::optional<MenuEvent::Kind> menu_direction_of(const input::PadState& pad);

/// All controls of the pad that were pressed since `before`.
std::vector<input::Control> pressed_controls(const input::PadState& before, const input::PadState& current);

/// Event of a pad's control; std::nullopt for controls that point in a direction (menu_direction_of).
std::optional<MenuEvent::Kind> menu_event_of(const input::Control& control, bool start_page);

}  // namespace thaum::game::inline menu
