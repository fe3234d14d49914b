// game/components/body.h: rigid bodies moved by Bullet, and other things with a place in the arena. Adding a
// Body component puts the entity into the physics. Removing it takes the entity out.
#pragma once
#include "core/units.h"
#include "ecs/component.h"
#include "game/components/match.h"
#include "physics/physics.h"

namespace thaum::game::inline components {

/// Description of a rigid body. To change it, remove the component and add a new one.
struct Body : physics::BodyDesc {
    bool operator==(const Body&) const = default;
    THAUM_COMPONENT(Body, shape, mesh, size, mass, friction, restitution, rolling_friction, linear_damping,
                    angular_damping, layer, collides_with, upright, swept);
};

/// Position and motion after Bullet's last step. An entity whose Body was removed keeps its last Motion.
struct Motion : physics::BodyState {
    static constexpr bool stays_in_place = true;  // large, and things gain and lose a Body
    THAUM_COMPONENT(Motion, position, orientation, velocity, spin, idle_s, drowsy, asleep);
};

/// Collision layers: one bit for each kind of body.
namespace layer {
inline constexpr physics::Layers ground = 1U << 0U;
inline constexpr physics::Layers prop = 1U << 1U;
inline constexpr physics::Layers wizard = 1U << 2U;
}  // namespace layer

/// Kind of a surface. The renderer chooses mesh and colour by it.
enum class Surface : std::uint32_t {
    floor,
    wall,
    pit,
    kerb,
    plinth,
    bowl,
    orb,
    crystal,
    anchor,
    pad,
    crate,
    barrel,
    ball,
    table,
    stone,
    wizard
};
inline constexpr std::array<std::string_view, 16> surface_names{
    "floor",  "wall", "pit",   "kerb",   "plinth", "bowl",  "orb",   "crystal",
    "anchor", "pad",  "crate", "barrel", "ball",   "table", "stone", "wizard"};

struct Look {
    Surface surface{};
    THAUM_COMPONENT(Look, surface);
};

/// A loose thing: it can be pushed, and it hurts a wizard whom it hits. For a while after a player has moved
/// it, its hits are credited to that player.
struct Prop {
    Tick moved_at{};                    ///< when a player last moved the thing (ticks of play)
    std::uint32_t moved_by{no_player};  ///< player who last shot, threw or pushed the thing
    std::uint32_t spare{};
    THAUM_COMPONENT(Prop, moved_at, moved_by, spare);
};

/// Point to which the rope of the Swing wand can attach.
struct Anchor {
    static constexpr std::string_view name = "Anchor";
};

/// Place where a wizard starts a round or returns to life.
struct Pad {
    vec3 feet{};             ///< position of the wizard's feet (m, world)
    double yaw{};            ///< direction in which a wizard who appears here looks: yaw to the left from -z
                             ///< (rad)
    std::uint32_t player{};  ///< player who starts here: 0 or 1; 2: none
    std::uint32_t number{};
    bool operator==(const Pad&) const = default;
    THAUM_COMPONENT(Pad, feet, yaw, player, number);
};

}  // namespace thaum::game::inline components
