// game/hud/likely_spell.h: the spell that an unfinished stroke will probably cast, shown while the player
// draws. It is only shown: the spell is decided when Trace is released, and nothing here affects the match.
#pragma once
#include "game/data/presentation.h"
#include "game/picture/casting_picture.h"

namespace thaum::game::inline hud {

/// The probable spell of the unfinished stroke; null while it is not clear, or if the gesture casts none. The
/// answer depends only on the stroke, not on earlier calls. Uses memory of the calling thread, which is
/// allocated at the thread's first stroke.
const SpellPresentation* likely_spell(const CastingPicture& casting, const Presentation& shown);

}  // namespace thaum::game::inline hud
