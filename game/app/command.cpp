#include "game/app/command.h"

#include <cstdlib>

namespace thaum::app {

bool display_there() {
    for (const auto* name : {"WAYLAND_DISPLAY", "DISPLAY"}) {
        const char* value = std::getenv(name);
        if (value != nullptr && *value != '\0') return true;
    }
    return false;
}

}  // namespace thaum::app
