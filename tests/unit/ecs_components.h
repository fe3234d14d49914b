// tests/unit/ecs_components.h: components for the tests of the ECS.
#pragma once
#include "ecs/world.h"

namespace thaum::ecs::test {

struct Position {
    vec3 at{};
    static constexpr std::string_view name = "Position";
    static constexpr auto fields() { return std::tuple(field("at", &Position::at)); }
};

struct Velocity {
    vec3 linear{};
    static constexpr std::string_view name = "Velocity";
    static constexpr auto fields() { return std::tuple(field("linear", &Velocity::linear)); }
};

struct Health {
    std::int32_t points{};
    std::uint32_t shield{};
    static constexpr std::string_view name = "Health";
    static constexpr auto fields() {
        return std::tuple(field("points", &Health::points), field("shield", &Health::shield));
    }
};

struct Frozen {
    static constexpr std::string_view name = "Frozen";
};

struct Burning {
    static constexpr std::string_view name = "Burning";
};

/// A type with seven bytes of padding, which no compiler may take for a component.
struct Padded {
    std::uint8_t kind{};
    double value{};
    static constexpr std::string_view name = "Padded";
    static constexpr auto fields() {
        return std::tuple(field("kind", &Padded::kind), field("value", &Padded::value));
    }
};
static_assert(!Component<Padded>);

/// The same padding one level deeper.
struct HoldsPadded {
    std::array<Padded, 2> both{};
    static constexpr std::string_view name = "HoldsPadded";
    static constexpr auto fields() { return std::tuple(field("both", &HoldsPadded::both)); }
};
static_assert(!Component<HoldsPadded>);

inline void declare_all(World& world) {
    world.declare<Position>();
    world.declare<Velocity>();
    world.declare<Health>();
    world.declare<Frozen>();
    world.declare<Burning>();
}

}  // namespace thaum::ecs::test
