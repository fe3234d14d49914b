// game/scene/arena_parts.h: converts the parts of an arena's picture to instances of its meshes. Only the
// sources of ArenaScene include this file.
#pragma once
#include "game/scene/arena_scene.h"

namespace thaum::game::inline scene {

/// Share of its own light that a surface emits if it both shines and is lit by other lights.
inline constexpr float glow_share = 0.85F;

/// Model matrix of a thing at a position.
fmat4 placed(vec3 position, quat orientation);
/// Rotation matrix of a figure that looks in a direction (rad).
fmat4 looking(double yaw, double pitch);

/// A ball of light with this radius (m). `tint` is its colour (linear light), `glow` its brightness.
render::Instance bead_at(const ArenaScene& arena_scene, vec3 place, float radius, fvec3 tint, float glow);

/// Sets whether the sun reaches each instance, for pictures without a shadow map. Fixed things have baked
/// light instead.
void set_sun(const ArenaScene& arena_scene, vec3 at, std::span<render::Instance> of);

// Functions that add wizards (arena_figures.cpp). `number`: number of the player.

/// Adds body, arm and wand, as the other player sees them and as they cast shadows.
void add_figure(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                std::vector<render::Instance>& out);
/// Adds the glowing parts of a wizard: the wand's tip and the shield.
void add_glow(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p, double time,
              std::vector<render::Instance>& out);
/// Adds arm and wand as their player sees them in the player's own view.
void add_own_arm(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                 std::vector<render::Instance>& out);
/// Adds the path of the shot that the player is drawing, and the spring of the drawn wand.
void add_drawn_shot(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                    std::vector<render::Instance>& out);
/// Adds a straight beam of light of this thickness (m). `tint` is its colour (linear light).
void add_beam(const ArenaScene& arena_scene, vec3 from, vec3 to, double thick, fvec3 tint,
              std::vector<render::Instance>& out);
/// Adds the spring from the wand to a held object. In a player's own view it also adds the force on the hand,
/// at the wand's tip.
void add_forces(const ArenaScene& arena_scene, const PlayerPicture& p, bool own,
                std::vector<render::Instance>& out);

// Functions that add strokes and spells (arena_spells.cpp).

/// Adds the trail of a stroke: at the wand, in the other player's view; on the brew, in every view.
void add_stroke_of(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p, bool own,
                   std::vector<render::Instance>& out);
/// Adds a chain of lights from a recalled thing to its wizard.
void add_recall(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                std::vector<render::Instance>& out);
/// Adds the bars of a shield's shell. They are lower the less harm the shield can still absorb.
void add_shell(const ArenaScene& arena_scene, const PlayerPicture& p, double time,
               std::vector<render::Instance>& out);
/// Adds the shimmer of a shield's shell to the translucent mists of a view (ViewScene::mists).
void add_shell_mist(const ArenaScene& arena_scene, const PlayerPicture& p,
                    std::vector<render::Instance>& out);
/// Adds the clouds of fog, and the dust of pushes, to the translucent mists of a view (ViewScene::mists).
void add_fog(const ArenaScene& arena_scene, const Picture& picture, std::vector<render::Instance>& out);
void add_dust(const ArenaScene& arena_scene, const Picture& picture, std::vector<render::Instance>& out);

// Functions that add effects: missiles, bursts, steam and glow (arena_effects.cpp).

void add_missile(const ArenaScene& arena_scene, const Picture& picture, const MissilePicture& missile,
                 std::uint32_t viewer, std::vector<render::Instance>& out);
void add_burst(const ArenaScene& arena_scene, const Picture& picture, const BurstPicture& burst,
               std::uint32_t viewer, std::vector<render::Instance>& out);
/// Adds an ingredient around its position (ingredient_shapes.h). `scale` is 1 in a niche, `paint` its colour
/// (linear light).
void add_ingredient(const ArenaScene& arena_scene, const fmat4& place, float scale, IngredientShape shape,
                    fvec3 paint, std::vector<render::Instance>& out);
/// Height of an ingredient above the ground of its niche (m).
inline constexpr float niche_height = 0.5F;
/// Adds the ingredients that lie ready at their niches.
void add_niches(const ArenaScene& arena_scene, const Picture& picture, std::vector<render::Instance>& out);
/// Adds the shape of the next stroke on the brew, for a wizard who stirs (ghost_stroke.cpp).
void add_ghost_stroke(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t player,
                      std::vector<render::Instance>& out);
/// Adds the cauldron, the orb and the crystals, with the probes and tools of wizards who work there
/// (stations_scene.cpp).
void add_stations(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                  std::vector<render::Instance>& out);
/// Adds the space in which tools act on crystals to the translucent mists of a view (ViewScene::mists).
void add_tool_mists(const ArenaScene& arena_scene, const Picture& picture,
                    std::vector<render::Instance>& out);
/// Adds the brew with ladles, embers and bubbles.
void add_cauldron(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                  std::vector<render::Instance>& out);

}  // namespace thaum::game::inline scene
