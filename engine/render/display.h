// render/display.h: the display of a desktop, on which windows open.
#pragma once
#include <string>

namespace thaum::render {

/// The display on which windows would open, as VARIABLE=VALUE, such as "DISPLAY=:0". Empty if there is none
/// that the installed GLFW supports.
std::string display_for_windows();

/// Whether there is a desktop on which a window can open.
inline bool display_there() { return !display_for_windows().empty(); }

/// A Wayland display, as VARIABLE=VALUE, if the installed GLFW does not support Wayland; else empty. No
/// window can open on it.
std::string display_not_spoken();

/// Ends the program with one line and code 1 when the X server ends, as at a logout. Without this, Xlib
/// writes two lines and calls exit() on the thread that meets the error, and libraries are destroyed while
/// other threads use them. Functions of std::at_quick_exit are called. Call it when GLFW is initialised.
void end_with_display();

}  // namespace thaum::render
