// game/hud/panel.h: a place on the screen.
#pragma once
#include "core/maths.h"

namespace thaum::game {

/// A rectangle: its top left and its bottom right (px).
struct Panel {
    fvec2 low{}, high{};
    bool operator==(const Panel&) const = default;
};

}  // namespace thaum::game
