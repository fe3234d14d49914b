// game/hud/likely_spell.h: finds the spell that an unfinished stroke will probably cast, to show it while the
// player draws. It is only shown: the match decides on the spell when the button Trace is released.
#pragma once
#include "game/data/presentation.h"
#include "game/picture/casting_picture.h"

namespace thaum::game::inline hud {

/// The spell that the unfinished stroke will probably cast; null while that is not clear, or if the gesture
/// casts none. The answer depends only on the stroke, not on earlier calls. Uses memory of the calling
/// thread, which is allocated at the thread's first stroke.
const SpellPresentation* likely_spell(const CastingPicture& casting, const Presentation& shown);

}  // namespace thaum::game::inline hud
