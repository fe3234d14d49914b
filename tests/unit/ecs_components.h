// tests/unit/ecs_components.h: components for the tests of the ECS.
#pragma once
#include "ecs/world.h"

namespace thaum::ecs::test {

struct Position {
    vec3 at{};
    THAUM_COMPONENT(Position, at);
};

struct Velocity {
    vec3 linear{};
    static constexpr bool stays_in_place = true;
    THAUM_COMPONENT(Velocity, linear);
};

struct Health {
    std::int32_t points{};
    std::uint32_t shield{};
    THAUM_COMPONENT(Health, points, shield);
};

struct Frozen {
    static constexpr std::string_view name = "Frozen";
};

struct Burning {
    static constexpr std::string_view name = "Burning";
};

inline void declare_all(World& world) {
    world.declare<Position>();
    world.declare<Velocity>();
    world.declare<Health>();
    world.declare<Frozen>();
    world.declare<Burning>();
}

}  // namespace thaum::ecs::test
