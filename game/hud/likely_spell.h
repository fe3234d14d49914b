// game/hud/likely_spell.h: the spell that a stroke will likely cast, told while the player draws. It is for the eye alone:
// the release of Trace decides, and nothing of this is part of a match.
#pragma once
#include "game/data/presentation.h"
#include "game/picture/casting_picture.h"

namespace thaum::game {

/// The likely spell of the stroke that is being drawn; null as long as it is not clear, or if no spell is meant. It depends
/// on the stroke alone, not on when it was asked for before. Uses memory of the calling thread, and allocates only at the
/// thread's first stroke.
const SpellPresentation* likely_spell(const CastingPicture& casting, const Presentation& shown);

}  // namespace thaum::game
