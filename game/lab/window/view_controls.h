// game/lab/window/view_controls.h: how the mouse moves the view in the lab's windows.
#pragma once

namespace thaum::game::inline lab {

inline constexpr double turn_per_px = 0.008;    // rotation of the view per mouse motion (rad/px)
inline constexpr double nearer_per_step = 0.9;  // factor on the camera's distance per step of the wheel

}  // namespace thaum::game::inline lab
