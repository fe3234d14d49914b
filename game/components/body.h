// game/components/body.h: what Bullet moves. Adding a Body puts the entity into the physics, removing it takes it out.
#pragma once
#include "core/units.h"
#include "ecs/component.h"
#include "game/components/match.h"
#include "physics/physics.h"

namespace thaum::game {

using ecs::field;

/// What the body is. Changed only by removing and adding it.
struct Body : physics::BodyDesc {
    bool operator==(const Body&) const = default;
    static constexpr std::string_view name = "Body";
    static constexpr auto fields() {
        return std::tuple(
            field("shape", &Body::shape), field("mesh", &Body::mesh), field("size", &Body::size),
            field("mass", &Body::mass), field("friction", &Body::friction),
            field("restitution", &Body::restitution), field("rolling_friction", &Body::rolling_friction),
            field("linear_damping", &Body::linear_damping), field("angular_damping", &Body::angular_damping),
            field("layer", &Body::layer), field("collides_with", &Body::collides_with),
            field("upright", &Body::upright), field("swept", &Body::swept));
    }
};

/// Where it is and how it moves: what Bullet had after the last step. Entities without a Body keep their last one.
struct Motion : physics::BodyState {
    static constexpr std::string_view name = "Motion";
    static constexpr auto fields() {
        return std::tuple(field("position", &Motion::position), field("orientation", &Motion::orientation),
                          field("velocity", &Motion::velocity), field("spin", &Motion::spin),
                          field("idle_s", &Motion::idle_s), field("drowsy", &Motion::drowsy),
                          field("asleep", &Motion::asleep));
    }
};

/// Collision layers.
namespace layer {
inline constexpr physics::Layers ground = 1U << 0U;
inline constexpr physics::Layers prop = 1U << 1U;
inline constexpr physics::Layers wizard = 1U << 2U;
}  // namespace layer

/// What a thing is made to look like; the picture finds mesh and colour by it.
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
    static constexpr std::string_view name = "Look";
    static constexpr auto fields() { return std::tuple(field("surface", &Look::surface)); }
};

/// A loose thing: may be pushed, and hurts when it hits. What it does is for a while the deed of who set it going.
struct Prop {
    Tick moved_at{};                    ///< ticks of play
    std::uint32_t moved_by{no_player};  ///< the player who last shot or threw it
    std::uint32_t spare{};
    static constexpr std::string_view name = "Prop";
    static constexpr auto fields() {
        return std::tuple(field("moved_at", &Prop::moved_at), field("moved_by", &Prop::moved_by),
                          field("spare", &Prop::spare));
    }
};

/// A point that the Swing wand can latch on.
struct Anchor {
    static constexpr std::string_view name = "Anchor";
};

/// Where wizards come (back) to life.
struct Pad {
    vec3 feet{};             ///< m
    double yaw{};            ///< rad, facing
    std::uint32_t player{};  ///< who starts here: 0, 1, or 2 for nobody
    std::uint32_t number{};
    bool operator==(const Pad&) const = default;
    static constexpr std::string_view name = "Pad";
    static constexpr auto fields() {
        return std::tuple(field("feet", &Pad::feet), field("yaw", &Pad::yaw), field("player", &Pad::player),
                          field("number", &Pad::number));
    }
};

}  // namespace thaum::game
