// game/hud/stroke_words.h: the caption after a stroke. It says what was read, how sure that is, and what came of it:
// "Circle 97 %: Shield, gentle", "not read; nearest: S", "Circle 97 %: Shield needs 12 more focus". A key
// chord draws nothing, so its caption has the key: "[1] Shield, gentle". A stroke that is too small or too quick is not
// read, and says so. A hand without a button has a caption where it nearly cast something.
#pragma once
#include <string>

#include "game/data/control_names.h"
#include "game/data/presentation.h"
#include "game/picture/casting_picture.h"

namespace thaum::game {

/// Word for the force of a stroke: "gentle", "normal" or "harsh".
std::string_view force_word(const CastingRules& rules, double force);

/// A probability in whole per cent, as captions and the gesture wall show it. Only a certain reading has 100.
int whole_percent(double probability);

struct StrokeCaption {
    std::string words;  ///< empty: no stroke was read just now
    bool failed{};      ///< the stroke did not do what was wanted
};
StrokeCaption stroke_caption(const CastingPicture& casting, const Presentation& shown,
                             const ControlNames& controls = {});

}  // namespace thaum::game
