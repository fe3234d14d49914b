// game/scene/figures.h: the meshes of wizards and their wands.
#pragma once
#include <cstdint>

#include "core/maths.h"
#include "game/data/wand_look.h"
#include "render/mesh.h"

namespace thaum::game::inline scene {

/// Robe, head and hat. The feet are at the origin, the face looks along -z, and the hat's brim is at 1.8 m.
render::MeshData wizard_figure(std::uint32_t team);
/// A dead wizard: robe on the ground, hat on top.
render::MeshData fallen_wizard(std::uint32_t team);
/// Sleeve and hand, with the shoulder at the origin, so that they can be rotated with the wizard's view.
render::MeshData wizard_arm(std::uint32_t team);
/// Position of the shoulder (m, eye frame).
inline constexpr fvec3 shoulder{0.24F, -0.27F, 0.0F};
/// The hand in the wizard's own view (eye frame). It is close to the middle, so that a wide, flat view shows
/// it as well.
inline constexpr fvec3 own_hand{0.37F, -0.25F, -0.57F};
/// Sleeve and hand in the wizard's own view (eye frame).
render::MeshData own_arm(std::uint32_t team);

/// A wand with its handle at the origin and its tip at `wand_length` along -z.
render::MeshData wand_mesh(const WandLook& look);
/// A wand's missile, flying along -z. If the look has no missile, a small ball of light.
render::MeshData missile_mesh(const WandLook& look, std::uint32_t team);
inline constexpr float wand_length = 0.5F;
/// Transforms a wand to reach from the hand to wand_tip (eye frame): in the other player's view, and in the
/// player's own.
fmat4 wand_in_hand();
fmat4 wand_in_own_hand();

/// The glowing tip of a wand, centred at the origin.
render::MeshData wand_spark(std::uint32_t team);
/// The shell of a burst, radius 1 m: three rings or triangles (by the team) with one centre, one
/// perpendicular to each axis.
render::MeshData burst_shell(std::uint32_t team);
/// A white beam to be tinted, from the origin 1 m along -z, radius 1 m.
render::MeshData beam_of_light();

/// The shield of a protected wizard: rings or triangles around the body's middle.
render::MeshData shield_rings(std::uint32_t team);

}  // namespace thaum::game::inline scene
