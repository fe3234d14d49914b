// game/hud/casting_overlay.h: strokes and spells in the flat part of a player's view.
#pragma once
#include "game/hud/layout.h"
#include "render/scene.h"

namespace thaum::game {

/// Adds the way of a hand that may cast without a button, faintly. It ends at the crosshair, and its older part fades.
void add_free_trail(render::Overlay& out, const CastingPicture& casting, std::uint32_t player,
                    const ViewLayout& l);

/// Adds the stroke of a hand that draws in the air, round the crosshair. It is the wider and the brighter the more
/// force it has. As soon as its spell is clear, its glow takes the spell's colour, and the spell's gesture and name stand
/// above the ring. A finished stroke fades: green if it was read, grey and broken if not.
void add_stroke(render::Overlay& out, const CastingPicture& casting, const Presentation& shown,
                std::uint32_t player, const ViewLayout& l);

/// Adds the band of forces above the crosshair: the mean force of the stroke between gentle and harsh, with its word.
void add_force_band(render::Overlay& out, const CastingPicture& casting, const ViewLayout& l);

/// Veils the view of a player who stands in fog.
void add_fog_veil(render::Overlay& out, const Picture& picture, std::uint32_t player, const ViewLayout& l);

/// Adds what is left of the player's shield, in two arcs beside the crosshair.
void add_ward(render::Overlay& out, const CastingPicture& casting, const ViewLayout& l);

/// Adds the arc of the focus within that of the health, and its number. `u`: length of a unit (px).
void add_focus(render::Overlay& out, const CastingPicture& casting, fvec2 centre, float u);

/// Adds the spells in the cells of the strip of wands: the gesture of each, the key of its chord, and its cost. A spell
/// for which the focus does not suffice is grey and struck through.
void add_spell_strip(render::Overlay& out, const Picture& picture, const ControlNames& controls,
                     std::uint32_t player, const ViewLayout& l);

}  // namespace thaum::game
