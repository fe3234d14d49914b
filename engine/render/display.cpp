#include "render/display.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <string_view>

#include "core/environment.h"
#include "core/tell_user.h"
#include "core/text.h"

namespace thaum::render {
namespace {

constexpr const char* wayland = "WAYLAND_DISPLAY";

bool speaks(std::string_view system) {
    return std::string_view(glfwGetVersionString()).find(system) != std::string_view::npos;
}

std::string value_of(const char* variable) {
    const auto value = environment_value(variable);
    return value ? text(variable, "=", *value) : std::string();
}

int on_lost_display(void*) {
    static std::atomic<bool> told{false};
    // If another thread has reported the error, it is ending the program, and this thread waits. If this
    // function returned, Xlib would call exit().
    while (told.exchange(true)) ::pause();
    tell_user("the display is gone: the X server has ended");
    std::quick_exit(1);
}

}  // namespace

std::string display_for_windows() {
    auto display = speaks("Wayland") ? value_of(wayland) : std::string();
    return display.empty() && speaks("X11") ? value_of("DISPLAY") : display;
}

std::string display_not_spoken() { return speaks("Wayland") ? std::string() : value_of(wayland); }

void end_with_display() {
    // Xlib's function that sets what is called when the display is lost is looked up by name: GLFW loads Xlib
    // itself, and Xlib's headers may not be installed.
    using Handler = int (*)(void*);
    using SetHandler = Handler (*)(Handler);
    if (auto* set = reinterpret_cast<SetHandler>(::dlsym(RTLD_DEFAULT, "XSetIOErrorHandler")); set != nullptr)
        set(on_lost_display);
}

}  // namespace thaum::render
