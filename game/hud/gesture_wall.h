// game/hud/gesture_wall.h: the gesture wall of the range on the screen: each gesture with its ghost, the newest stroke
// in a panel of its own and over the gesture that it was read as, and what to do better.
//
//     Circle 97 %   S            Your stroke
//     Shield        Fog           the stroke, while it is drawn and afterwards
//      ghost         ghost
//     Star   42 %   V             a ghost in each cell; the chosen one is framed, and scores of older strokes are pale
//     Recall        Push
//      ghost         ghost
//     Shield, 97 % sure, gentle   what was read
//     end where you began         what to do better
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "game/hud/panel.h"
#include "gesture/stroke.h"
#include "render/scene.h"

namespace thaum::game {

/// A gesture of the wall.
struct WallGesture {
    std::string name;   ///< as the screen has it: "Circle"
    std::string spell;  ///< name of the spell that it casts; empty: none
    std::vector<gesture::StrokePoint> ghost;
    bool own = false;  ///< true: drawn by the player
};

struct GestureWallPicture {
    bool on = false;
    std::shared_ptr<const std::vector<WallGesture>> gestures{};
    std::vector<int> scores{};  ///< newest score of each gesture (%), -1: none yet
    int chosen = -1;            ///< gesture that the newest stroke belongs to; -1: none
    std::vector<gesture::StrokePoint> stroke{};
    bool drawing = false;  ///< true: the stroke has not ended
    /// Lines below the cells: what was read, and what to do better. Controls are in braces (game/data/control_words.h).
    std::vector<std::string> lines{};
};

/// Adds the wall in its box. `lines` are those of the wall with the names of controls. `unit` is the length of a HUD
/// unit (px).
void add_gesture_wall(render::Overlay& out, const GestureWallPicture& wall,
                      const std::vector<std::string>& lines, const Panel& box, float unit);

}  // namespace thaum::game
