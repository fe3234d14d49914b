// game/hud/panel.h: a rectangle on the screen.
#pragma once
#include "core/maths.h"

namespace thaum::game::inline hud {

/// A rectangle given by its top left and bottom right corners (px).
struct Panel {
    fvec2 low{}, high{};
    bool operator==(const Panel&) const = default;
};

}  // namespace thaum::game::inline hud
