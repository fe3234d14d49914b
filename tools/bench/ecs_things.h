// tools/bench/ecs_things.h: components, plain arrays and Worlds of the ECS benchmark.
//
// The entities are loose objects ("things"), the most numerous entities of an arena. game/match/spawn.cpp
// creates them from a Motion (120 bytes), a Look (4) and a Prop (16), and then adds a Body (96) to put them
// into the physics. A wizard's death removes the Body. The benchmark makes the same calls. Other components
// that the game's systems often use have sizes in between: Dead 8 bytes, Health and Pad 40, Controls 44,
// Stance 72, WandBelt 80.
#pragma once
#include <memory>
#include <tuple>
#include <vector>

#include "core/hash.h"
#include "core/memory.h"
#include "ecs/world.h"
#include "game/components/body.h"
#include "game/components/wizard.h"

namespace thaum::bench::things {

/// Three numbers as separate members instead of a vec3. GLM declares x, y and z inside unions, and GCC 12
/// vectorises nothing with those. The raw arrays would be slower than possible and make the World look
/// better than it is.
struct Triple {
    double x{}, y{}, z{};
    THAUM_FIELDS(Triple, x, y, z);
};

/// Stands for game::Motion, the component of position and velocity, whose memory layout it has.
struct Motion {
    Triple position{};
    std::array<double, 4> orientation{1, 0, 0, 0};
    Triple velocity{};
    Triple spin{};
    double idle_s{};
    std::uint32_t drowsy{};
    std::uint32_t asleep{};
    static constexpr bool stays_in_place = game::Motion::stays_in_place;
    THAUM_COMPONENT(Motion, position, orientation, velocity, spin, idle_s, drowsy, asleep);
};
static_assert(sizeof(Motion) == sizeof(game::Motion));

/// Stands for game::Look, the component of appearance, whose memory layout it has.
struct Look {
    std::uint32_t surface{};
    THAUM_COMPONENT(Look, surface);
};
static_assert(sizeof(Look) == sizeof(game::Look));

/// Stands for game::Prop, the component of loose things, whose memory layout it has.
struct Prop {
    std::uint64_t moved_at{};
    std::uint32_t moved_by{};
    std::uint32_t spare{};
    THAUM_COMPONENT(Prop, moved_at, moved_by, spare);
};
static_assert(sizeof(Prop) == sizeof(game::Prop));

/// Stands for game::Body, the component of rigid bodies, whose memory layout it has.
struct Body {
    std::array<std::uint32_t, 2> shape{};
    Triple size{0.5, 0.5, 0.5};
    double mass{1};
    std::array<double, 3> surface{0.7, 0, 0};
    std::array<double, 2> damping{0.1, 0.1};
    std::array<std::uint32_t, 4> flags{};
    THAUM_COMPONENT(Body, shape, size, mass, surface, damping, flags);
};
static_assert(sizeof(Body) == sizeof(game::Body));

/// Stands for game::Dead, whose layout it has: a component that no entity has in most ticks.
struct Dead {
    std::uint64_t returns_at{};
    THAUM_COMPONENT(Dead, returns_at);
};
static_assert(sizeof(Dead) == sizeof(game::Dead));

struct Marked {
    static constexpr std::string_view name = "Marked";
};

inline Motion motion(std::uint32_t i) {
    Motion m;
    m.position = {1.0 * i, 1, 2};
    m.velocity = {1, 2.0 * i, 3};
    m.asleep = i % 2;
    return m;
}
inline Look look(std::uint32_t i) { return {i % 16}; }
inline Prop prop(std::uint32_t i) { return {i, i % 3, 0}; }
inline Body body(std::uint32_t i) {
    Body b;
    b.shape[1] = i;
    return b;
}

/// A plain array in the same kind of memory as the World's tables.
template <class T>
using Array = std::vector<T, ArrayAllocator<T>>;

/// Plain arrays of loose things, of equal length.
struct Arrays {
    Array<Motion> motions;
    Array<Look> looks;
    Array<Prop> props;

    std::size_t size() const { return motions.size(); }
    void push_back(const Motion& m, Look l, Prop p) {
        motions.push_back(m);
        looks.push_back(l);
        props.push_back(p);
    }
    void set(std::uint32_t i) {
        motions[i] = motion(i);
        looks[i] = look(i);
        props[i] = prop(i);
    }
    void copy(const Arrays& from, std::size_t row, std::size_t to_row) {
        motions[to_row] = from.motions[row];
        looks[to_row] = from.looks[row];
        props[to_row] = from.props[row];
    }
    void clear() {
        motions.clear();
        looks.clear();
        props.clear();
    }
};
/// Size of one loose thing without a Body (bytes).
inline constexpr double thing_bytes = sizeof(Motion) + sizeof(Look) + sizeof(Prop);

inline Arrays arrays(std::uint32_t n, std::uint32_t step = 1) {
    Arrays a;
    for (std::uint32_t i = 0; i < n; i += step) a.push_back(motion(i), look(i), prop(i));
    return a;
}

inline Array<Body> bodies(std::uint32_t n, std::uint32_t step = 1) {
    Array<Body> b;
    for (std::uint32_t i = 0; i < n; i += step) b.push_back(body(i));
    return b;
}

inline std::unique_ptr<ecs::World> new_world() {
    auto world = std::make_unique<ecs::World>();
    world->declare<Motion>();
    world->declare<Look>();
    world->declare<Prop>();
    world->declare<Body>();
    world->declare<Dead>();
    world->declare<Marked>();
    return world;
}

/// A World of n loose objects. Every `step`th one has a Body as well (0: none).
inline std::unique_ptr<ecs::World> world_of(std::uint32_t n, std::uint32_t step = 0) {
    auto world = new_world();
    for (std::uint32_t i = 0; i < n; ++i) {
        if (step != 0 && i % step == 0) {
            world->create(motion(i), look(i), prop(i), body(i));
        } else {
            world->create(motion(i), look(i), prop(i));
        }
    }
    return world;
}

template <class... Ts>
std::uint64_t hash_of(const Ts&... columns) {
    std::uint64_t h = 0;
    ((h = hash_combine(h, hash_bytes(std::as_bytes(std::span(columns))))), ...);
    return h;
}

/// Hash of the first `count` things.
inline std::uint64_t hash_first(const Arrays& a, std::size_t count) {
    return hash_of(std::span(a.motions.data(), count), std::span(a.looks.data(), count),
                   std::span(a.props.data(), count));
}

/// Components C of all entities that have every component in With, in the order of iteration.
template <class C, class... With>
std::vector<C> column(ecs::World& world) {
    std::vector<C> out;
    world.view<const C, const With...>().each([&](const C& c, const auto&...) { out.push_back(c); });
    return out;
}

/// The same hash as `hash_first`, over all objects that have every component in With.
template <class... With>
std::uint64_t hash_things(ecs::World& world) {
    return hash_of(column<Motion, With...>(world), column<Look, With...>(world),
                   column<Prop, With...>(world));
}

}  // namespace thaum::bench::things
