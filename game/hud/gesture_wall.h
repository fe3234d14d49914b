// game/hud/gesture_wall.h: the gesture wall of the practice range on the screen. It shows each gesture with
// its ghost (a faint picture of its recorded strokes), the newest stroke in a panel of its own and over the
// gesture as which it was recognised, and advice.
//
//     Circle 97 %   S            Your stroke
//     Shield        Fog           the stroke, while it is drawn and afterwards
//      ghost         ghost
//     Star   42 %   V             a ghost in each cell; the newest stroke's is lit, older scores are pale
//     Recall        Push
//      ghost         ghost
//     Shield, 97 % sure, gentle   what was read
//     end where you began         what to do better
#pragma once
#include <string>
#include <vector>

#include "game/hud/panel.h"
#include "game/picture/gesture_wall_picture.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Adds the gesture wall in its box. `lines`: its text, with the player's control names filled in. `unit`:
/// length of a HUD unit (px).
void add_gesture_wall(render::Overlay& out, const GestureWallPicture& wall,
                      const std::vector<std::string>& lines, const Panel& box, float unit);

}  // namespace thaum::game::inline hud
