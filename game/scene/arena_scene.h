// game/scene/arena_scene.h: the arena as meshes and lights, created once per arena. Afterwards any thread can
// convert a Picture to instances of these meshes without OpenGL.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "game/picture/picture.h"
#include "game/scene/baked_light.h"
#include "game/scene/brew_look.h"
#include "game/scene/crystal_look.h"
#include "game/scene/orb_look.h"
#include "game/scene/powerups.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace thaum::game::inline scene {

struct ArenaScene {
    struct Meshes {
        std::optional<render::MeshId> lit, glowing;
        float glow = 1;  ///< brightness of the glowing mesh relative to its colours
    };
    struct Kind {
        ShapeKey key;
        Meshes meshes;
    };
    /// A thing that never moves. Its meshes contain the light baked at its position, so they are looked up by
    /// position, too. Masonry has no meshes here, because it is part of `stone`.
    struct Solid {
        ShapeKey key;
        vec3 position{};
        Meshes meshes;
    };
    struct Team {
        render::MeshId figure{}, fallen{}, arm{}, own_arm{}, spark{}, burst{}, shield{};
        std::vector<render::MeshId> missiles;  ///< meshes of missiles, indexed as Presentation::wands
        Meshes plate;
    };

    /// Ground to stand on: the top of a box or the slope of a ramp.
    struct Ground {
        vec3 low{}, high{};  ///< bounding box of the ground (m, world)
        double height{};     ///< height in the middle of the ground (m)
        double slope_x{}, slope_z{};
        double height_at(vec3 p) const;
    };

    std::vector<Solid> solids;
    std::vector<Kind> kinds;
    std::array<Team, players> teams{};
    Meshes neutral_plate;
    Meshes anchor;                      ///< mesh of a swing anchor (a point for a rope) with a radius of 1 m
    render::MeshId stone{}, lamps{};    ///< masonry with decoration, and lamps (world frame)
    std::vector<render::MeshId> wands;  ///< meshes of wands, indexed as Presentation::wands
    render::MeshId skyline{}, runes{}, ember{}, bubble{};
    /// White meshes: a beam 1 m long along -z with radius 1 m, and a ball of radius 1 m.
    render::MeshId beam{}, bead{};
    /// White meshes of ingredients, by IngredientShape.
    std::array<render::MeshId, ingredient_shapes> ingredients{};
    render::MeshId contact{};  ///< soft shade on the ground below things and wizards
    /// Meshes for things that are not in the arena's file, by physics::Shape.
    std::array<render::MeshId, 4> unit_shapes{};
    PowerUpMeshes power_ups;
    std::vector<Ground> grounds;
    std::vector<render::Block> blocks;       ///< masonry that hides things from viewers inside the arena
    Shade shade;                             ///< data for testing whether the sun reaches a moving thing
    std::vector<render::PointLight> lights;  ///< fixed lights; the cauldron's is the first
    std::optional<vec3> bowl;                ///< centre of the cauldron (m, world)
    double rim_radius{}, rim_height{};  ///< rim of the cauldron's bowl: radius, and height above `bowl` (m)
    /// Self-lit mesh of a painted brew, for a bowl without a simulated one.
    std::optional<render::MeshId> painted_brew;
    /// Look of the brew, used and refreshed by the drawing thread; null: no simulated brew.
    std::shared_ptr<BrewLook> brew;
    std::shared_ptr<OrbLook> orb;  ///< look of the orb, refreshed like `brew`; null: no orb with a flow
    /// Looks of the crystals that can be carved, refreshed like `brew`, in the order of Picture::crystals.
    std::vector<std::shared_ptr<CrystalLook>> crystals;
    render::Environment environment;
    MenuCameraLook menu_camera;
    double wizard_height{1.8};  ///< height of a wizard (m)
};

/// Uploads all meshes that the arena needs. The renderer's OpenGL context must be current.
ArenaScene make_arena_scene(render::Renderer& renderer, const MatchData& data);

/// Adds all instances that `viewer` sees: everything except the viewer's own figure, plus the viewer's own
/// arm with the wand. no_player: everything.
void add_instances(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                   std::vector<render::Instance>& out);

/// Refreshes the look of the brew if it has moved and a player is near enough to see it and may have it in
/// view.
void show_brew_near(const ArenaScene& arena_scene, const Picture& picture, const BrewOverlay& overlay);

/// Refreshes the looks of the orb and the crystals, as far as a player is near enough to see a difference.
void show_stations(const ArenaScene& arena_scene, const Picture& picture);
/// Adds the crystals that are near the eye to the volumes of a view (ViewScene::scans).
void add_crystals(const ArenaScene& arena_scene, const Picture& picture, vec3 eye,
                  std::vector<render::Scan>& out);
/// Adds the meshes of orb and crystals that may have changed, so that the renderer uploads them
/// (Frame::changes).
void add_mesh_changes(const ArenaScene& arena_scene, std::vector<render::MeshChange>& out);

/// Returns the volume of the simulated brew. Returns null if there is none, or if it is too far away to look
/// different from the painted brew.
const render::Volume* visible_brew(const ArenaScene& arena_scene, const Picture& picture, vec3 eye);

/// Returns the blocks that can hide things from `eye`. Empty from outside the arena, which is open above.
std::span<const render::Block> blocks_seen_from(const ArenaScene& arena_scene, vec3 eye);

/// Adds the steam over the brew to the translucent mists of a view (ViewScene::mists).
void add_steam(const ArenaScene& arena_scene, const Picture& picture, std::vector<render::Instance>& out);
/// Adds the visible traces of spells in the air, except the viewer's own shield, to the translucent mists of
/// a view (ViewScene::mists).
void add_spell_mists(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                     std::vector<render::Instance>& out);
/// Adds soft shades on the ground, also on ramps, below everything that blocks the light of the sky.
void add_contact_shades(const ArenaScene& arena_scene, const Picture& picture,
                        std::vector<render::Instance>& out);

/// Adds all objects that cast sun shadows: `fixed` ones never move; `moving` ones are the same for every
/// viewer.
void add_casters(const ArenaScene& arena_scene, const Picture& picture, std::vector<render::Instance>& fixed,
                 std::vector<render::Instance>& moving);

/// Chooses the most important lights for a view from `eye`, up to render::max_lights.
void choose_lights(const ArenaScene& arena_scene, const Picture& picture, vec3 eye,
                   std::vector<render::PointLight>& out);

}  // namespace thaum::game::inline scene
