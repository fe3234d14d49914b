#include "game/app/command.h"

#include "render/display.h"

namespace thaum::app {

bool display_there() { return !render::display_for_windows().empty(); }

}  // namespace thaum::app
