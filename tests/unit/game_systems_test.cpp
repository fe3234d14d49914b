// Tests of the access to data that the systems (steps of a tick) of a match declare: shared data besides
// components are checked too, and all systems access only what they declare.
#include <set>

#include "game/components/fog.h"
#include "game/stations/cauldron/cauldron.h"
#include "tests/scenes/carving_hands.h"
#include "tests/scenes/searching_hands.h"
#include "tests/scenes/stirring_hands.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

using input::DeviceKind;

// Systems reach shared data through a context. It must give them no write access to data files and input.
template <class Context>
concept WritesData = requires(Context& context) {
    context.data.wizard.health = 1;
};
template <class Context>
concept WritesInput = requires(Context& context) {
    context.input.frame = {};
}
|| requires(Context& context) { context.input.devices.clear(); }
|| requires(Context& context) { context.input.haptic_setup.on[0] = false; };
static_assert(!WritesData<MatchContext> && !WritesInput<MatchContext>);

template <class R>
concept Writable = requires(R& resource) {
    resource.write();
};
// A function that gets a const context must not be able to write a resource (shared data besides components).
static_assert(Writable<decltype(MatchContext::physics)> && !Writable<const decltype(MatchContext::physics)>);

/// Tests that a system may read or write a resource (shared data besides components) only if it has declared
/// that access.
template <class R>
void expect_checked(ecs::World& world, ecs::Resource<R>& resource) {
    const auto declared = world.mask<R>();
    const auto tries = [&](std::string_view system, ecs::Mask reads, ecs::Mask writes, bool write) {
        ecs::Schedule schedule;
        schedule.add({.name = system, .reads = reads, .writes = writes, .run = [&](ecs::World&, Tick) {
                          write ? (void)resource.write() : (void)resource.read();
                      }});
        schedule.run(world, 0);
    };
    EXPECT_DEATH(tries("sneak", {}, {}, false), text("system sneak reads ", R::name, " without"));
    EXPECT_DEATH(tries("sneak", {}, {}, true), text("system sneak writes ", R::name, " without"));
    tries("reader", declared, {}, false);
    EXPECT_DEATH(tries("reader", declared, {}, true), text("system reader writes ", R::name, " without"));
    tries("writer", {}, declared, false);
    tries("writer", {}, declared, true);
}

struct GameSystems : testing::Test {
    Simulation match{duel_data(), {}};
    MatchContext& context = match.context_to_change();
};

TEST_F(GameSystems, AccessToThePhysicsIsChecked) { expect_checked(context.world, context.physics); }
TEST_F(GameSystems, AccessToTheHapticModelsIsChecked) {
    expect_checked(context.world, context.output.models);
}
TEST_F(GameSystems, AccessToTheEventJournalIsChecked) {
    expect_checked(context.world, context.output.journal);
}
TEST_F(GameSystems, AccessToTheForceTracesIsChecked) { expect_checked(context.world, context.output.forces); }
TEST_F(GameSystems, AccessToTheBrewSolverIsChecked) {
    ecs::World world;
    Jobs jobs(0);
    BrewResource brew(world, jobs);
    expect_checked(world, brew);
}

TEST_F(GameSystems, AnUndeclaredCallOfTheGameIsCaught) {
    const auto runs = [&](ecs::Mask reads, ecs::Mask writes, const std::function<void()>& run) {
        ecs::Schedule schedule;
        schedule.add(
            {.name = "sneak", .reads = reads, .writes = writes, .run = [&](ecs::World&, Tick) { run(); }});
        schedule.run(context.world, 0);
    };
    const auto& world = context.world;
    const auto add_event = [&] { record(context, {.kind = EventKind::dry}); };
    EXPECT_DEATH(runs({}, world.mask<EventLog>(), add_event), "system sneak writes event journal");
    EXPECT_DEATH(runs({}, world.mask<resource::Journal>(), add_event), "system sneak writes EventLog");
    // Removing a body from the World also removes it from the physics, so a system must declare both.
    const auto thing = world.view<const Prop, const Body>().first();
    ASSERT_TRUE(thing);
    const auto remove_body = [&] { context.world.remove<Body>(thing); };
    EXPECT_DEATH(runs({}, world.mask<Body>(), remove_body), "system sneak writes physics");
    runs({}, world.mask<EventLog, resource::Journal>(), add_event);
    runs({}, world.mask<Body, resource::Physics>(), remove_body);
}

/// Removes the systems that have run in the match from `names`.
void strike_out(Simulation& match, std::set<std::string_view>& names) {
    for (const auto* schedule : {&match.always(), &match.live()}) {
        for (std::size_t i = 0; i < schedule->size(); ++i) {
            if (schedule->counted(i).calls != 0) names.erase(schedule->system(i).name);
        }
    }
}

std::set<std::string_view> systems_of(Simulation& match) {
    std::set<std::string_view> names;
    for (const auto* schedule : {&match.always(), &match.live()}) {
        for (std::size_t i = 0; i < schedule->size(); ++i) names.insert(schedule->system(i).name);
    }
    return names;
}

// The schedule checks every access. Matches in which every system runs therefore show whether each
// declaration is wide enough.
TEST(GameSystemsOfBots, EverySystemRunsWithinItsDeclarations) {
    Simulation by_arm(duel_data(), {.devices = {{.player = 0, .kind = DeviceKind::arm, .name = "arm"}}});
    auto idle = systems_of(by_arm);
    for (int t = 0; t < 500; ++t) by_arm.tick({});
    strike_out(by_arm, idle);

    Simulation at_the_rim(duel_data(),
                          {.devices = {{.player = 0, .name = "one"}, {.player = 1, .name = "two"}}});
    bench::place_at_the_rim(at_the_rim);
    for (Tick t = 0; t < 500; ++t) at_the_rim.tick(bench::stirring(t));
    strike_out(at_the_rim, idle);

    Simulation at_the_crystal(duel_data(),
                              {.devices = {{.player = 0, .name = "one"}, {.player = 1, .name = "two"}}});
    bench::place_at_the_crystal(at_the_crystal);
    // A blow beside the crystal chips it. In a duel of bots this may not happen, so the test makes it.
    auto& crystals = at_the_crystal.world_to_change();
    const auto crystal = crystal_entity(crystals, 0);
    crystals.create(CrystalStrike{.crystal = crystal, .place = crystals.get<Crystal>(crystal).middle});
    for (Tick t = 0; t < 500; ++t) at_the_crystal.tick(bench::carving(t));
    strike_out(at_the_crystal, idle);

    Simulation at_the_orb(duel_data(),
                          {.devices = {{.player = 0, .name = "one"}, {.player = 1, .name = "two"}}});
    bench::place_at_the_orb(at_the_orb);
    for (Tick t = 0; t < 500; ++t) at_the_orb.tick(bench::searching(t));
    strike_out(at_the_orb, idle);

    auto duel = make_bot_duel(assets(), duel_data(), {"level_3", "level_3"}, 1).value();
    // Bots cast fog too seldom, so the test makes it.
    duel.match->world_to_change().create(Motion{}, Fog{.radius = 1, .sight = 1, .until = 5000});
    for (int s = 0; s < 245 && !idle.empty(); ++s) {
        duel.run(1000);
        strike_out(*duel.match, idle);
    }
    EXPECT_EQ(idle, std::set<std::string_view>{});
}

}  // namespace
}  // namespace thaum::game::test
