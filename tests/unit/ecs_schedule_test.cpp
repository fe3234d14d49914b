#include <gtest/gtest.h>

#include "ecs/schedule.h"
#include "unit/ecs_components.h"

namespace thaum::ecs::test {
namespace {

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

}  // namespace
}  // namespace thaum::ecs::test
