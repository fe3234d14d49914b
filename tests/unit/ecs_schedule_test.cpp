#include <gtest/gtest.h>

#include "ecs/resource.h"
#include "ecs/schedule.h"
#include "ecs/snapshot.h"
#include "unit/ecs_components.h"

namespace thaum::ecs::test {
namespace {

struct Weather {
    using Value = std::array<int, 2>;
    static constexpr std::string_view name = "weather";
};
static_assert(ResourceType<Weather> && !Component<Weather>);

struct EcsSchedule : testing::Test {
    EcsSchedule() { declare_all(world); }
    World world;
    Schedule schedule;
};

TEST_F(EcsSchedule, RunsAtPeriodAndPhaseInTheOrderAdded) {
    std::string ran;
    schedule.add(
        {.name = "a", .period = 4, .phase = 1, .run = [&](World&, Tick t) { ran += text("a", t, " "); }});
    schedule.add({.name = "b", .period = 2, .run = [&](World&, Tick t) { ran += text("b", t, " "); }});
    for (Tick t = 0; t < 6; ++t) schedule.run(world, t);
    EXPECT_EQ(ran, "b0 a1 b2 b4 a5 ");
}

TEST_F(EcsSchedule, SkipsASystemWithoutItsComponentsAndWakesItAtOnce) {
    schedule.add({.name = "heal",
                  .writes = world.mask<Health>(),
                  .needs = world.mask<Health, Frozen>(),
                  .run = [](World& w, Tick) { w.view<Health>().each([](Health& h) { ++h.points; }); }});
    const Entity e = world.create(Health{});
    schedule.run(world, 0);
    EXPECT_EQ(schedule.counted(0).calls, 0U);
    EXPECT_EQ(schedule.counted(0).skipped, 1U);
    world.add<Frozen>(e);
    schedule.run(world, 1);
    EXPECT_EQ(schedule.counted(0).calls, 1U);
    EXPECT_EQ(world.get<Health>(e).points, 1);
}

TEST_F(EcsSchedule, CommandsOfOneSystemAreDoneBeforeTheNext) {
    world.create(Position{});
    std::size_t seen = 0;
    schedule.add({.name = "freeze", .reads = world.mask<Position>(), .run = [](World& w, Tick) {
                      w.view<const Position>().each(
                          [&](Entity e, const Position&) { w.commands().add<Frozen>(e); });
                  }});
    schedule.add({.name = "count", .reads = world.mask<Position, Frozen>(), .run = [&](World& w, Tick) {
                      seen = w.view<const Position, Frozen>().count();
                  }});
    schedule.run(world, 0);
    EXPECT_EQ(seen, 1U);
}

TEST_F(EcsSchedule, UndeclaredAccessStopsAndNamesSystemAndComponent) {
    const Entity e = world.create(Position{}, Health{});
    schedule.add({.name = "sneak", .reads = world.mask<Position>(), .run = [&](World& w, Tick t) {
                      if (t == 0) std::as_const(w).get<Position>(e);
                      if (t == 1) w.get<Position>(e);
                      if (t == 2) w.view<const Health>();
                  }});
    schedule.run(world, 0);
    EXPECT_DEATH(schedule.run(world, 1), "system sneak writes Position without having declared it");
    EXPECT_DEATH(schedule.run(world, 2), "system sneak reads Health without having declared it");
}

TEST_F(EcsSchedule, AccessToAResourceIsCheckedLikeAccessToAComponent) {
    Resource<Weather> weather(world, 1, 2);
    schedule.add(
        {.name = "sneak", .run = [&](World&, Tick t) { t == 0 ? weather.read() : weather.write(); }});
    EXPECT_DEATH(schedule.run(world, 0), "system sneak reads weather without having declared it");
    EXPECT_DEATH(schedule.run(world, 1), "system sneak writes weather without having declared it");
    Schedule readers;
    readers.add({.name = "reader", .reads = world.mask<Weather>(), .run = [&](World&, Tick t) {
                     t == 0 ? weather.read() : weather.write();
                 }});
    readers.run(world, 0);
    EXPECT_DEATH(readers.run(world, 1), "system reader writes weather without having declared it");
    Schedule writers;
    writers.add({.name = "writer", .writes = world.mask<Weather>(), .run = [&](World&, Tick) {
                     weather.write()[0] = weather.read()[1];
                 }});
    writers.run(world, 0);
    EXPECT_EQ(weather.read(), (std::array{2, 2}));  // outside of systems every access is allowed
}

TEST_F(EcsSchedule, AResourceMustBeDeclaredOnce) {
    EXPECT_DEATH((void)world.mask<Weather>(), "weather was not declared in this World");
    const Resource<Weather> weather(world);
    EXPECT_DEATH(Resource<Weather>{world}, "resource weather is declared twice");
}

TEST_F(EcsSchedule, AResourceIsNoPartOfTheState) {
    World other;
    Resource<Weather> weather(other);
    declare_all(other);
    world.create(Position{{1, 2, 3}});
    other.create(Position{{1, 2, 3}});
    EXPECT_EQ(state_hash(other), state_hash(world));
    weather.write()[0] = 7;
    EXPECT_EQ(state_hash(other), state_hash(world));
    Bytes bytes;
    save(world, bytes);
    ASSERT_TRUE(restore(other, bytes).has_value());
    EXPECT_EQ(weather.read()[0], 7);
    EXPECT_EQ(other.count(other.id<Weather>()), 1U) << "a system that needs the resource would be skipped";
}

}  // namespace
}  // namespace thaum::ecs::test
