// game/hud/stroke_words.h: the caption after a stroke. It gives the recognised gesture, its probability and
// the result: "Circle 97 %: Shield, gentle", "not read; nearest: S", "Circle 97 %: Shield needs 12 more
// focus". A spell that a wand key casts while Trace is held has no stroke, so its caption has the key: "[1]
// Shield, gentle". For a stroke that is too small or too quick to be read, the caption says so. Free casting
// (without a button) has a caption if a spell was almost cast.
#pragma once
#include <string>

#include "game/data/control_names.h"
#include "game/data/presentation.h"
#include "game/picture/casting_picture.h"

namespace thaum::game::inline hud {

struct StrokeCaption {
    std::string words;  ///< text of the caption; empty: no stroke was read just now
    bool failed{};      ///< true: the stroke did not have the result that the player wanted
};
StrokeCaption stroke_caption(const CastingPicture& casting, const Presentation& shown,
                             const ControlNames& controls = {});

}  // namespace thaum::game::inline hud
