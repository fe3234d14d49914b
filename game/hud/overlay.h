// game/hud/overlay.h: flat shapes that the HUD and the menus share.
#pragma once
#include <string>

#include "game/hud/layout.h"
#include "render/colour.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Colours of the HUD.
struct HudPaints {
    fvec4 plate = render::colour(0x140E22, 0.8F);  ///< dark background of text
    fvec4 panel = render::colour(0x140E22, 0.62F);
    fvec4 track = render::colour(0x140E22, 0.75F);  ///< the empty part of a bar
    fvec4 dark = render::colour(0x0A0614, 1.0F);
    fvec4 white = render::colour(0xF6F0FF, 1.0F);
    fvec4 soft = render::colour(0xD8CCE8, 0.85F);
    fvec4 chosen = render::colour(0xFFF4D0, 1.0F);        ///< text and shapes of the chosen item
    fvec4 chosen_plate = render::colour(0x6A4A9A, 0.7F);  ///< background of the chosen item
    fvec4 red = render::colour(0xFF4A3A, 1.0F);
    fvec4 amber = render::colour(0xFFC04A, 1.0F);
    /// Colour of red text: light, because pure red is hard to read on brick and dusk.
    fvec4 light_red = render::colour(0xFFB0A0, 1.0F);
};
inline const HudPaints paints;

inline constexpr float whole_turn = 6.2831853F;  ///< angle of a full circle (rad)

/// Adds text with a dark copy below it, which is readable on any background.
void add_text(render::Overlay& out, std::string words, fvec2 position, float size, fvec4 paint,
              render::Align align);

/// Adds text inside a box, starting at its top: broken into lines and made smaller where necessary.
void add_text_in(render::Overlay& out, const Panel& box, std::string_view words, float size, fvec4 paint,
                 render::Align align);

/// Adds text like add_text_in, but on a dark plate of the text's width, which is readable on a coloured
/// background.
void add_text_on_plate(render::Overlay& out, const Panel& box, std::string_view words, float size,
                       fvec4 paint, render::Align align);

/// Adds fitted text, centred in a box on a dark plate of the text's width, with the top at `top`.
void add_plate(render::Overlay& out, const Panel& box, float top, const FittedWords& words, fvec4 paint);

/// Adds the mark of a team: a ring or a triangle.
void add_mark(render::Overlay& out, std::uint32_t team, fvec2 centre, float radius);

/// Darkens a rectangle of the screen.
void add_veil(render::Overlay& out, const render::Rect& r, fvec4 paint);

inline fvec4 opaque(fvec3 c, float alpha = 1) { return {c, alpha}; }

}  // namespace thaum::game::inline hud
