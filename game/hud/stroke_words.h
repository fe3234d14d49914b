// game/hud/stroke_words.h: the caption after a stroke. It gives the recognised gesture, its probability and
// the result: "Circle 97 %: Shield, gentle", "not read; nearest: S", "Circle 97 %: Shield needs 12 more
// focus". A key chord draws nothing, so its caption has the key: "[1] Shield, gentle". For a stroke that is
// too small or too quick to be read, the caption says so. Free casting (without a button) has a caption if a
// spell was almost cast.
#pragma once
#include <string>

#include "game/data/control_names.h"
#include "game/data/presentation.h"
#include "game/picture/casting_picture.h"

namespace thaum::game::inline hud {

/// Word for the force of a stroke: "gentle", "normal" or "harsh".
std::string_view force_word(const CastingRules& rules, double force);

/// A probability as a whole percentage, as captions and the gesture wall show it. Only a probability of 1
/// gives 100.
int whole_percent(double probability);

struct StrokeCaption {
    std::string words;  ///< text of the caption; empty: no stroke was read just now
    bool failed{};      ///< true: the stroke did not have the result that the player wanted
};
StrokeCaption stroke_caption(const CastingPicture& casting, const Presentation& shown,
                             const ControlNames& controls = {});

}  // namespace thaum::game::inline hud
