// game/hud/wand_icon.h: flat pictures of wands, drawn from the same parts as their meshes.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "game/data/presentation.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Adds the outline of a wand, from its handle at the lower left to its tip at the upper right. `size` is the
/// edge of the square that holds it (px).
void add_wand_icon(render::Overlay& out, const WandLook& look, fvec2 middle, float size, fvec4 paint);

/// A control's name in at most three characters: "PgU" for "Page up", "LSh" for "Left shift", "5" for "Keypad
/// 5".
std::string brief_label(std::string_view label);

struct WandStrip {
    const std::vector<WandPresentation>& wands;
    std::span<const double> charges;        ///< energy of each wand, as a share of the full energy
    std::span<const std::string> controls;  ///< names of the controls that select a wand, by slot
    std::string_view next_control{};        ///< name of the control that selects the next wand
    std::uint32_t in_hand{};                ///< index of the wand in hand
    std::size_t columns{};                  ///< number of wands in one row
    bool refilled{};                        ///< true: stirring refills all wands now
    fvec4 full{};                           ///< colour of a wand's energy
};

/// Adds the icons of all wands in the order of their slots, with the names of their keys and their energy. If
/// wands have no keys of their own, as on a pad, the wand that comes next shows the control for the next
/// wand. The bar of a wand with less than a fifth of its energy is amber, and that of an empty wand is a red
/// line.
void add_wand_strip(render::Overlay& out, const WandStrip& strip, fvec2 upper_left, float unit);

}  // namespace thaum::game::inline hud
