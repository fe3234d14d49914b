// game/hud/court.h: the court as meshes and lights. Made once for an arena; after that a Picture becomes instances of
// these meshes, without OpenGL, on whatever thread builds the frame.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "game/hud/brew_look.h"
#include "game/hud/masonry.h"
#include "game/hud/picture.h"
#include "game/hud/powerups.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace thaum::game {

struct Court {
    struct Meshes {
        std::optional<render::MeshId> lit, glowing;
        float glow = 1;  ///< how much brighter than its colours it shines
    };
    struct Kind {
        ShapeKey key;
        Meshes meshes;
    };
    /// What never moves has the light of its own place in it, so it is known by its place as well. The meshes of masonry are
    /// empty: it is in `stone`.
    struct Solid {
        ShapeKey key;
        vec3 position{};
        Meshes meshes;
    };
    struct Team {
        render::MeshId figure{}, fallen{}, arm{}, own_arm{}, spark{}, bolt{}, fireball{}, stone{}, burst{},
            shield{};
        Meshes plate;
    };

    /// What one stands on: the top of a box, or the slope of a ramp.
    struct Ground {
        vec3 low{}, high{};  ///< m, of the box that holds it
        double height{};     ///< m, in the middle
        double slope_x{}, slope_z{};
        double height_at(vec3 p) const;
    };

    std::vector<Solid> solids;
    std::vector<Kind> kinds;
    std::array<Team, players> teams{};
    Meshes neutral_plate;
    Meshes anchor;                                                ///< of radius 1 m
    render::MeshId stone{}, lamps{};                              ///< masonry and decoration; world frame
    std::array<render::MeshId, silhouette_names.size()> wands{};  ///< by Silhouette
    render::MeshId skyline{}, runes{}, ember{}, bubble{};
    render::MeshId beam{}, bead{};  ///< white: 1 m along -z and of radius 1 m; a ball of radius 1 m
    render::MeshId contact{};       ///< shade below whatever stands or lies
    std::array<render::MeshId, 4> unit_shapes{};  ///< for what no arena has: by physics::Shape
    PowerUpMeshes power_ups;
    std::vector<Ground> grounds;
    std::vector<render::Block> blocks;           ///< of masonry: what hides things from who is in the court
    Shade shade;                                 ///< to ask whether the sun reaches a thing that moves
    std::vector<render::PointLight> lights;      ///< that stay; the first is the cauldron's
    std::optional<vec3> bowl;                    ///< the cauldron's centre
    std::optional<render::MeshId> painted_brew;  ///< for a bowl in which none flows; shines by itself
    std::shared_ptr<BrewLook> brew;              ///< of who draws, made anew as it moves; null: none flows
    render::Environment environment;
    double wizard_height{1.8};  ///< m
};

/// Uploads all meshes that the arena needs. The renderer's context must be current.
Court make_court(render::Renderer& renderer, const MatchData& data);

/// What `viewer` sees: everything but the own figure, and the own arm with the wand (no_player: everything).
void add_instances(const Court& court, const Picture& picture, std::uint32_t viewer,
                   std::vector<render::Instance>& out);

/// Makes the brew's picture anew where it has moved and somebody is near enough to see it.
void show_brew_near(const Court& court, const Picture& picture, const BrewOverlay& overlay);

/// The flowing brew as it is to be drawn; null where there is none, or it is too far away to be told from the painted one.
const render::Volume* visible_brew(const Court& court, const Picture& picture, vec3 eye);

/// What hides things from there; nothing from outside the court, which is open above.
std::span<const render::Block> blocks_seen_from(const Court& court, vec3 eye);

/// Wisps that rise from the brew, for ViewScene::mists.
void add_steam(const Court& court, const Picture& picture, std::vector<render::Instance>& out);
/// Whatever stands in the light of the sky darkens the ground below it a little, on ramps as well.
void add_contact_shades(const Court& court, const Picture& picture, std::vector<render::Instance>& out);

/// What casts the sun's shadows: what never moves, and the rest, whoever looks.
void add_casters(const Court& court, const Picture& picture, std::vector<render::Instance>& fixed,
                 std::vector<render::Instance>& moving);

/// The lights that matter most there, up to render::max_lights.
void choose_lights(const Court& court, const Picture& picture, vec3 eye,
                   std::vector<render::PointLight>& out);

}  // namespace thaum::game
