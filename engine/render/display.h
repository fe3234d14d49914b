// render/display.h: the display of a desktop, on which windows open.
#pragma once
#include <string>

namespace thaum::render {

/// The display that windows would open on, as VARIABLE=VALUE, such as "DISPLAY=:0". Empty if there is none for the
/// window system that the installed GLFW speaks.
std::string display_for_windows();

/// Whether a desktop is there to open a window on.
inline bool display_there() { return !display_for_windows().empty(); }

/// A Wayland display if GLFW does not speak Wayland, as VARIABLE=VALUE; else empty. No window opens on it.
std::string display_not_spoken();

/// Ends the program with one line and code 1 when the X server ends, as at a logout. Without this, Xlib writes two
/// lines and calls exit() on whatever thread meets the fault, and libraries are torn down while other threads use them.
/// Functions of std::at_quick_exit are called. Call it when GLFW is initialised.
void end_with_display();

}  // namespace thaum::render
