// game/hud/figures.h: the meshes of wizards and their wands. A team is told by colour, by mark (ring or triangle) and by
// the pattern of the robe, so that colour is never needed.
#pragma once
#include <string_view>

#include "core/maths.h"
#include "game/wands/wand.h"
#include "render/mesh.h"

namespace thaum::game {

/// The colours of a team: 0 ember, 1 tide.
struct TeamColours {
    fvec3 cloth, dark, light;  ///< linear
    fvec3 glow;                ///< of bolts and of the light they give
};
const TeamColours& team_colours(std::uint32_t team);
/// Of a force, by its share of the most that can be felt: from green over yellow to red.
fvec3 force_colour(double share);
/// "Ember", "Tide".
std::string_view team_name(std::uint32_t team);

/// Robe, head and hat; feet at the origin, looks along -z, 1.8 m up to the brim.
render::MeshData wizard_figure(std::uint32_t team);
/// What is left of a wizard who died: robe on the ground, hat on top.
render::MeshData fallen_wizard(std::uint32_t team);
/// Sleeve and hand about the shoulder, so that it can be turned to where the wizard looks.
render::MeshData wizard_arm(std::uint32_t team);
/// Where the shoulder is: from the eye, m.
inline constexpr fvec3 shoulder{0.24F, -0.27F, 0.0F};
/// Sleeve and hand as the wizard sees them; in the frame of the eye.
render::MeshData own_arm(std::uint32_t team);

/// The grip at the origin, the tip at -z, `wand_length` off; all five can be told apart as shadows.
render::MeshData wand_mesh(Silhouette silhouette);
inline constexpr float wand_length = 0.5F;
/// Puts a wand from the hand to wand_tip, in the frame of the eye: as the other sees it, or as one sees one's own.
fmat4 wand_in_hand();
fmat4 wand_in_own_hand();

/// The glowing tip of a wand, centred.
render::MeshData wand_spark(std::uint32_t team);
/// A needle of light along -z with the team's mark around its tail.
render::MeshData bolt_needle(std::uint32_t team);
/// A ball of light of radius 1 m with a tail along +z and the team's mark around it.
render::MeshData fireball(std::uint32_t team);
/// A dark ball of radius 1 m in a cage of the team's marks.
render::MeshData lob_stone(std::uint32_t team);
/// The team's mark three times about the same middle, of radius 1 m: what flies off from a burst.
render::MeshData burst_shell(std::uint32_t team);
/// White, to be tinted: from the origin 1 m along -z, of radius 1 m.
render::MeshData beam_of_light();

/// Around a wizard whom nothing can hurt: rings or triangles, centred at the body.
render::MeshData shield_rings(std::uint32_t team);

}  // namespace thaum::game
