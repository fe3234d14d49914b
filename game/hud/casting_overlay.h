// game/hud/casting_overlay.h: strokes and spells in the overlay of a player's view.
#pragma once
#include "game/hud/layout.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Adds the recent path of a hand that may cast without a button, faintly. The path ends at the crosshair and
/// fades towards its older end.
void add_free_trail(render::Overlay& out, const CastingPicture& casting, std::uint32_t player,
                    const ViewLayout& l);

/// Adds the stroke of a hand that draws in the air, around the crosshair. The line is wider and brighter
/// where the force is larger. Once it is clear which spell the stroke will cast, the line takes the spell's
/// colour, and the spell's gesture and name appear above it. A finished stroke fades: green if recognised,
/// grey and broken if not.
void add_stroke(render::Overlay& out, const CastingPicture& casting, const Presentation& shown,
                std::uint32_t player, const ViewLayout& l);

/// Adds the force scale above the crosshair: it shows the mean force of the stroke between gentle and harsh,
/// with a word for it.
void add_force_band(render::Overlay& out, const CastingPicture& casting, const ViewLayout& l);

/// Adds a veil over the view of a player who stands in fog.
void add_fog_veil(render::Overlay& out, const Picture& picture, std::uint32_t player, const ViewLayout& l);

/// Adds the remaining strength of the player's shield, as two arcs beside the crosshair.
void add_ward(render::Overlay& out, const CastingPicture& casting, const ViewLayout& l);

/// Adds an arc for the focus inside the arc for the health, and the focus as a number. `u`: length of a HUD
/// unit (px).
void add_focus(render::Overlay& out, const CastingPicture& casting, fvec2 centre, float u);

/// Adds the spells to the strip of wands, a cell for each: the gesture that casts it, the wand key that casts
/// it while the button Trace is held, and its cost in focus. A spell that costs more focus than the player
/// has is grey and struck through.
void add_spell_strip(render::Overlay& out, const Picture& picture, const ControlNames& controls,
                     std::uint32_t player, const ViewLayout& l);

}  // namespace thaum::game::inline hud
