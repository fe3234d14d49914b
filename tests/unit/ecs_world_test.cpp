#include <gtest/gtest.h>

#include "unit/ecs_components.h"

namespace thaum::ecs::test {
namespace {

struct EcsWorld : testing::Test {
    EcsWorld() { declare_all(world); }
    World world;
};

TEST_F(EcsWorld, ComponentsAreKeptThroughAddAndRemove) {
    const Entity e = world.create(Position{{1, 2, 3}});
    world.add(e, Velocity{{4, 5, 6}});
    world.add(e, Health{7, 8});
    world.remove<Velocity>(e);
    EXPECT_EQ(world.get<Position>(e).at, vec3(1, 2, 3));
    EXPECT_EQ(world.get<Health>(e).points, 7);
    EXPECT_FALSE(world.has<Velocity>(e));
    EXPECT_EQ(world.find<Velocity>(e), nullptr);
    EXPECT_EQ(world.count<Health>(), 1U);
    EXPECT_EQ(world.count<Velocity>(), 0U);
}

TEST_F(EcsWorld, AHandleOfADestroyedEntityIsStaleEvenWhenItsNumberIsUsedAgain) {
    const Entity a = world.create(Position{});
    world.destroy(a);
    const Entity b = world.create(Position{});
    EXPECT_EQ(a.index, b.index);
    EXPECT_FALSE(world.alive(a));
    EXPECT_TRUE(world.alive(b));
    EXPECT_FALSE(world.alive(no_entity));
    EXPECT_EQ(world.find<Position>(a), nullptr);
}

TEST_F(EcsWorld, RemovingARowKeepsEveryOtherEntitysValues) {
    std::vector<Entity> all;
    for (int i = 0; i < 200; ++i) all.push_back(world.create(Position{{i, 0, 0}}, Health{i, 0}));
    for (int i = 0; i < 200; i += 3) world.destroy(all[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 200; ++i) {
        const Entity e = all[static_cast<std::size_t>(i)];
        ASSERT_EQ(world.alive(e), i % 3 != 0);
        if (i % 3 != 0) {
            ASSERT_EQ(world.get<Health>(e).points, i);
            ASSERT_EQ(world.get<Position>(e).at.x, i);
        }
    }
}

TEST_F(EcsWorld, TagsFollowTheirEntityWhenRowsMove) {
    std::vector<Entity> all;
    for (int i = 0; i < 300; ++i) all.push_back(world.create(Position{{i, 0, 0}}));
    for (int i = 0; i < 300; i += 2) world.add<Frozen>(all[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 300; i += 5) world.add(all[static_cast<std::size_t>(i)], Velocity{});
    for (int i = 1; i < 300; i += 7) world.destroy(all[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 300; ++i) {
        const Entity e = all[static_cast<std::size_t>(i)];
        if (!world.alive(e)) continue;
        ASSERT_EQ(world.has<Frozen>(e), i % 2 == 0) << i;
    }
    world.remove<Frozen>(all[0]);
    EXPECT_FALSE(world.has<Frozen>(all[0]));
}

TEST_F(EcsWorld, ViewsRequireExcludeAndOffer) {
    const Entity plain = world.create(Position{{1, 0, 0}});
    const Entity moving = world.create(Position{{2, 0, 0}}, Velocity{{1, 0, 0}});
    const Entity frozen = world.create(Position{{3, 0, 0}}, Velocity{{1, 0, 0}}, Frozen{});
    const Entity wounded = world.create(Position{{4, 0, 0}}, Velocity{{1, 0, 0}}, Health{5, 0});

    std::vector<Entity> seen;
    world.view<Position, const Velocity, Without<Frozen>>().each(
        [&](Entity e, Position& p, const Velocity& v) {
            p.at += v.linear;
            seen.push_back(e);
        });
    EXPECT_EQ(seen, (std::vector{moving, wounded}));
    EXPECT_EQ(world.get<Position>(moving).at.x, 3);
    EXPECT_EQ(world.get<Position>(frozen).at.x, 3);
    EXPECT_EQ(world.get<Position>(plain).at.x, 1);

    int with_health = 0;
    world.view<const Position, Maybe<const Health>>().each(
        [&](const Position&, const Health* h) { with_health += h != nullptr ? 1 : 0; });
    EXPECT_EQ(with_health, 1);
    const auto frozen_view = world.view<const Position, Frozen>();
    const auto unhurt_view = world.view<const Position, Without<Health>>();
    EXPECT_EQ(frozen_view.count(), 1U);
    EXPECT_EQ(frozen_view.first(), frozen);
    EXPECT_EQ(unhurt_view.count(), 3U);
}

TEST_F(EcsWorld, OrderDependsOnTheHistoryOfThisWorldAlone) {
    const auto history = [](World& w) {
        std::vector<Entity> all;
        for (int i = 0; i < 50; ++i) all.push_back(w.create(Position{}));
        for (std::size_t i = 0; i < 50; i += 3) w.add(all[i], Velocity{});
        for (std::size_t i = 0; i < 50; i += 4) w.destroy(all[i]);
        for (int i = 0; i < 10; ++i) w.create(Position{}, Velocity{});
    };
    World other;
    declare_all(other);
    // Work in another World, with other views and tables, happens in between. It must not change what these
    // two Worlds do.
    World stranger;
    declare_all(stranger);
    stranger.create(Health{}, Burning{});
    history(other);
    stranger.create(Velocity{}, Health{});
    history(world);
    const auto order = [](World& w) {
        std::vector<Entity> seen;
        w.view<const Position>().each([&](Entity e, const Position&) { seen.push_back(e); });
        return seen;
    };
    EXPECT_EQ(order(world), order(other));
    EXPECT_GT(order(world).size(), 40U);
}

TEST_F(EcsWorld, CommandsApplyInTheOrderTheyWereGiven) {
    const Entity a = world.create(Position{{1, 0, 0}});
    const Entity b = world.create(Position{{2, 0, 0}});
    world.view<const Position>().each([&](Entity e, const Position& p) {
        world.commands().add<Frozen>(e);
        if (p.at.x == 2) world.commands().destroy(e);
        const auto twin = world.commands().create(Position{p.at + vec3(10, 0, 0)});
        world.commands().add(twin, Health{9, 0});
    });
    world.apply_commands();
    EXPECT_TRUE(world.has<Frozen>(a));
    EXPECT_FALSE(world.alive(b));
    EXPECT_EQ(world.count<Health>(), 2U);
    std::vector<double> xs;
    world.view<const Position, const Health>().each(
        [&](const Position& p, const Health&) { xs.push_back(p.at.x); });
    EXPECT_EQ(xs, (std::vector<double>{11, 12}));
}

TEST_F(EcsWorld, HooksSeeTheComponentWhenItComesAndGoes) {
    struct Heard {
        std::vector<int> came, went;
    } heard;
    world.on_add<Health>({[](void* c, Entity, const void* h) {
                              static_cast<Heard*>(c)->came.push_back(static_cast<const Health*>(h)->points);
                          },
                          &heard});
    world.on_remove<Health>({[](void* c, Entity, const void* h) {
                                 static_cast<Heard*>(c)->went.push_back(
                                     static_cast<const Health*>(h)->points);
                             },
                             &heard});
    const Entity a = world.create(Health{1, 0});
    const Entity b = world.create();
    world.add(b, Health{2, 0});
    world.get<Health>(b).points = 3;
    world.remove<Health>(b);
    world.destroy(a);
    EXPECT_EQ(heard.came, (std::vector{1, 2}));
    EXPECT_EQ(heard.went, (std::vector{3, 1}));
}

TEST_F(EcsWorld, AViewStaysGoodWhileViewsThatWereNeverUsedBeforeStartInsideIt) {
    for (int i = 0; i < 3; ++i) world.create(Position{{i, 0, 0}}, Velocity{}, Health{}, Burning{});
    std::size_t inner = 0;
    int outer = 0;
    world.view<Position, Velocity, Burning>().each([&](Position&, Velocity&) {
        ++outer;
        inner += world.view<const Health, Burning>().count() +
                 world.view<const Health, const Velocity>().count() +
                 world.view<const Health, Maybe<const Position>, Burning>().count() +
                 world.view<const Velocity, Without<Frozen>>().count();
    });
    EXPECT_EQ(outer, 3);
    EXPECT_EQ(inner, 36U);
}

TEST_F(EcsWorld, AComponentMayBeCopiedFromTheTableThatGrowsForIt) {
    const Entity first = world.create(Position{{1, 2, 3}}, Health{4, 0}, Velocity{{6, 7, 8}});
    for (int i = 0; i < 200; ++i) {
        const Entity e = world.create(world.get<Position>(first), world.get<Health>(first));
        ASSERT_EQ(world.get<Position>(e).at, vec3(1, 2, 3));
        const Entity other = world.create(Position{{5, 5, 5}});
        world.add(other, world.get<Health>(first));
        ASSERT_EQ(world.get<Health>(other).points, 4);
        world.add(other, world.get<Velocity>(first));
        ASSERT_EQ(world.get<Velocity>(other).linear, vec3(6, 7, 8));
    }
}

using EcsWorldDeath = EcsWorld;

/// A component of `size` bytes, in which neighbouring bytes differ, so that a wrong copy shows.
template <std::size_t size>
struct Cell {
    std::array<std::uint8_t, size> value{};
    THAUM_COMPONENT(Cell, value);
};

template <std::size_t size>
Cell<size> cell(std::uint32_t entity) {
    Cell<size> out;
    for (std::size_t i = 0; i < size; ++i) out.value[i] = static_cast<std::uint8_t>(entity * 37 + i * 11);
    return out;
}

/// Sizes of components (bytes): just below and above each size of a word with which tables copy them, and the
/// game's own sizes up to 128.
constexpr std::array<std::size_t, 24> cell_sizes{1,  2,  3,  4,  5,  7,  8,  9,  12, 15, 16,  17,
                                                 24, 31, 32, 33, 40, 44, 63, 64, 65, 96, 120, 128};

/// A component whose size has the index n in `cell_sizes`.
template <std::size_t n>
using CellOf = Cell<cell_sizes[n]>;

template <class C>
void toggle_cell(World& world, Entity e) {
    if (world.has<C>(e)) {
        world.remove<C>(e);
    } else {
        world.add(e, cell<sizeof(C)>(e.index));
    }
}

template <class C>
void expect_cell(const World& world, Entity e, bool has) {
    const auto* found = world.find<C>(e);
    ASSERT_EQ(found != nullptr, has);
    if (!has) return;
    EXPECT_EQ(found->value, cell<sizeof(C)>(e.index).value) << sizeof(C) << " bytes";
}

/// Moves entities at random between tables with eight components: every third of `cell_sizes`, from index
/// `first` on.
template <std::size_t first>
void move_cells_at_random() {
    World world;
    [&]<std::size_t... k>(std::index_sequence<k...>) {
        (world.declare<CellOf<first + 3 * k>>(), ...);
        // Components of each entity, as bits.
        std::vector<std::pair<Entity, std::uint32_t>> all;
        std::uint32_t state = 1;
        const auto any = [&state](std::uint32_t below) {
            state = state * 1664525U + 1013904223U;
            return (state >> 8U) % below;
        };
        for (int step = 0; step < 10'000; ++step) {
            if (all.size() < 60) all.emplace_back(world.create(), 0U);
            const auto i = any(static_cast<std::uint32_t>(all.size()));
            auto& [entity, has] = all[i];
            const auto number = any(sizeof...(k));
            ((k == number ? toggle_cell<CellOf<first + 3 * k>>(world, entity) : void()), ...);
            has ^= 1U << number;
            if (any(200) == 0) {
                world.destroy(entity);
                all.erase(all.begin() + i);
            }
        }
        for (const auto& [entity, has] : all) {
            (expect_cell<CellOf<first + 3 * k>>(world, entity, ((has >> k) & 1U) != 0), ...);
        }
    }
    (std::make_index_sequence<cell_sizes.size() / 3>{});
}

TEST(EcsCells, StayWithTheirEntityWhenItMovesBetweenTables) {
    move_cells_at_random<0>();
    move_cells_at_random<1>();
    move_cells_at_random<2>();
}

TEST_F(EcsWorldDeath, WrongUseStopsAndNamesTheComponent) {
    const Entity e = world.create(Position{});
    const Entity gone = world.create(Position{});
    world.destroy(gone);
    EXPECT_DEATH(world.get<Position>(gone), "is stale, asked for component Position");
    EXPECT_DEATH(world.add(gone, Velocity{}), "is stale, asked for component Velocity");
    EXPECT_DEATH(world.add(e, Position{}), "already has Position");
    EXPECT_DEATH(world.get<Velocity>(e), "has no component Velocity");
    EXPECT_DEATH(world.remove<Frozen>(e), "has no Frozen");
    EXPECT_DEATH(world.destroy(gone), "is stale");
    EXPECT_DEATH(world.view<Position>().each([&](Entity x, Position&) { world.add(x, Velocity{}); }),
                 "structural change inside a view or hook, component Velocity");
    EXPECT_DEATH(world.view<Position>().each([&](Entity, Position&) { world.create(Health{}); }),
                 "structural change inside a view or hook, component Health");
    EXPECT_DEATH(world.single<Health>(), "there are 0 of Health, not one");
    World empty;
    EXPECT_DEATH(empty.create(Position{}), "Position was not declared in this World");
    EXPECT_DEATH(world.declare<Position>(), "component Position is declared");
    EXPECT_DEATH(detail::next_type_number(), "a World was made before main");
}

}  // namespace
}  // namespace thaum::ecs::test
