// game/picture/gesture_wall_picture.h: the contents of the gesture wall, a display of all gestures on the
// practice range. The session fills them in.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "gesture/stroke.h"

namespace thaum::game::inline picture {

/// A gesture on the wall, with a pale example of its stroke (the ghost).
struct WallGesture {
    std::string name;   ///< name of the gesture as shown: "Circle"
    std::string spell;  ///< name of the spell that the gesture casts; empty: none
    std::vector<gesture::StrokePoint> ghost;
    bool own = false;  ///< true: the player has recorded this gesture; false: it is a shipped one
};

struct GestureWallPicture {
    bool on = false;
    std::shared_ptr<const std::vector<WallGesture>> gestures{};
    std::vector<int> scores{};  ///< score of the newest stroke of each gesture (%), -1: none yet
    int chosen = -1;            ///< index of the gesture that the newest stroke belongs to; -1: none
    std::vector<gesture::StrokePoint> stroke{};
    bool drawing = false;  ///< true: the stroke has not ended
    /// Lines below the gestures: the recognised gesture, and advice. Controls are in braces
    /// (game/data/control_words.h).
    std::vector<std::string> lines{};
};

}  // namespace thaum::game::inline picture
