// game/hud/stroke_words.h: the caption after a stroke. It says what was read, how sure that is, and what came of it:
// "Circle 97 %: Shield, gentle", "not read; nearest: S 31 %", "Circle 97 %: Shield needs 12 more focus".
#pragma once
#include <string>

#include "game/data/presentation.h"
#include "game/hud/casting_picture.h"

namespace thaum::game {

/// Word for the force of a stroke: "gentle", "normal" or "harsh".
std::string_view force_word(const CastingRules& rules, double force);

struct StrokeCaption {
    std::string words;  ///< empty: no stroke was read just now
    bool failed{};      ///< the stroke did not do what was wanted
};
StrokeCaption stroke_caption(const CastingPicture& casting, const Presentation& shown);

}  // namespace thaum::game
