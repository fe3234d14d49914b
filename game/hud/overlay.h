// game/hud/overlay.h: flat shapes that the HUD and the menus share.
#pragma once
#include <string>

#include "game/hud/layout.h"
#include "render/colour.h"
#include "render/scene.h"

namespace thaum::game {

/// Colours of the HUD.
struct HudPaints {
    fvec4 plate = render::colour(0x140E22, 0.8F);  ///< below words
    fvec4 panel = render::colour(0x140E22, 0.62F);
    fvec4 track = render::colour(0x140E22, 0.75F);  ///< the empty part of a bar
    fvec4 dark = render::colour(0x0A0614, 1.0F);
    fvec4 white = render::colour(0xF6F0FF, 1.0F);
    fvec4 soft = render::colour(0xD8CCE8, 0.85F);
    fvec4 chosen = render::colour(0xFFF4D0, 1.0F);        ///< words and shapes of what is in hand
    fvec4 chosen_plate = render::colour(0x6A4A9A, 0.7F);  ///< below it
    fvec4 red = render::colour(0xFF4A3A, 1.0F);
    fvec4 amber = render::colour(0xFFC04A, 1.0F);
    /// Colour for red words, since pure red is hard to read on brick and dusk.
    fvec4 light_red = render::colour(0xFFB0A0, 1.0F);
};
inline const HudPaints paints;

inline constexpr float whole_turn = 6.2831853F;  ///< angle of a full circle (rad)

/// Adds text with a dark copy below it, readable on any background.
void add_text(render::Overlay& out, std::string words, fvec2 position, float size, fvec4 paint,
              render::Align align);

/// Adds words that stay within a box: broken into lines and smaller if they must be. They begin at its top.
void add_text_in(render::Overlay& out, const Panel& box, std::string_view words, float size, fvec4 paint,
                 render::Align align);

/// Adds words like add_text_in, on a dark plate of their width, so that they are readable on a ground of their own
/// colour.
void add_text_on_plate(render::Overlay& out, const Panel& box, std::string_view words, float size,
                       fvec4 paint, render::Align align);

/// Adds fitted words on a dark plate of their width, in the middle of a box, with the top at `top`.
void add_plate(render::Overlay& out, const Panel& box, float top, const FittedWords& words, fvec4 paint);

/// Adds the mark of a team: a ring or a triangle.
void add_mark(render::Overlay& out, std::uint32_t team, fvec2 centre, float radius);

/// Darkens a rectangle.
void add_veil(render::Overlay& out, const render::Rect& r, fvec4 paint);

inline fvec4 opaque(fvec3 c, float alpha = 1) { return {c, alpha}; }

}  // namespace thaum::game
