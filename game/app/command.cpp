#include "game/app/command.h"

#include <cstdio>
#include <cstdlib>

#include "core/one_line.h"

namespace thaum::app {

bool display_there() {
    for (const auto* name : {"WAYLAND_DISPLAY", "DISPLAY"}) {
        const char* value = std::getenv(name);
        if (value != nullptr && *value != '\0') return true;
    }
    return false;
}

int refuse(const Error& error) {
    std::fprintf(stderr, "thaum: %s\n", in_one_line(error.message).c_str());
    return wrong_use;
}

}  // namespace thaum::app
