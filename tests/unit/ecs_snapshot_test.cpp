#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ecs/diff.h"
#include "ecs/snapshot.h"
#include "unit/ecs_components.h"

namespace thaum::ecs::test {
namespace {

/// Gives the World a history: entities that were destroyed, whose numbers are free again, entities that moved
/// between tables, and tags (components without data).
void fill(World& world, std::size_t n) {
    std::vector<Entity> all;
    for (std::size_t i = 0; i < n; ++i) all.push_back(world.create(Position{{static_cast<double>(i), 0, 0}}));
    for (std::size_t i = 0; i < n; i += 2) world.add(all[i], Velocity{{0, static_cast<double>(i), 0}});
    for (std::size_t i = 0; i < n; i += 3) world.add<Burning>(all[i]);
    for (std::size_t i = 0; i < n; i += 5) world.destroy(all[i]);
}

/// A blob: samples of a liquid that belong to the World as a whole.
struct Levels {
    using Element = float;
    static constexpr std::string_view name = "Levels";
};

struct EcsSnapshot : testing::Test {
    EcsSnapshot() {
        for (World* w : {&world, &copy}) {
            declare_all(*w);
            w->declare<Levels>();
        }
    }
    /// Gives the World a blob (an array of its own, without entities) of ten elements, 0 to 9.
    void fill_levels() {
        world.resize<Levels>(10);
        std::iota(world.blob<Levels>().begin(), world.blob<Levels>().end(), 0.0F);
    }
    void expect_spoilt_are_refused_or_consistent(std::size_t step);
    World world, copy;
    Bytes bytes;
};

TEST_F(EcsSnapshot, ARestoredWorldGoesOnTheSameWay) {
    fill(world, 1000);
    save(world, bytes);
    copy.create(Health{});  // this entity must be gone after the restore
    ASSERT_TRUE(restore(copy, bytes).has_value());
    EXPECT_EQ(state_hash(copy), state_hash(world));
    EXPECT_EQ(copy.size(), world.size());
    EXPECT_EQ(copy.count<Burning>(), world.count<Burning>());
    for (auto* w : {&world, &copy}) {
        for (int i = 0; i < 20; ++i) w->create(Position{}, Health{i, 0});
        w->view<Position, const Velocity>().each([&](Entity e, Position& p, const Velocity& v) {
            p.at += v.linear;
            if (v.linear.y > 900) w->commands().destroy(e);
        });
        w->apply_commands();
    }
    EXPECT_EQ(state_hash(copy), state_hash(world));
    Bytes a, b;
    save(world, a);
    save(copy, b);
    EXPECT_EQ(a, b);
}

// So many values that stay in place need memory of the system, which grows twice here.
TEST_F(EcsSnapshot, ManyValuesThatStayInPlaceAreKeptAndRestored) {
    const auto velocity_of = [](std::uint32_t i) { return Velocity{{0.5 * i, 1, i}}; };
    std::vector<Entity> entities;
    for (std::uint32_t i = 0; i < 9000; ++i) entities.push_back(world.create(velocity_of(i)));
    for (std::uint32_t i = 0; i < 9000; i += 3) world.add(entities[i], Position{});
    for (std::uint32_t i = 0; i < 9000; i += 7) world.destroy(entities[i]);
    save(world, bytes);
    ASSERT_TRUE(restore(copy, bytes).has_value());
    EXPECT_EQ(state_hash(copy), state_hash(world));
    for (std::uint32_t i = 0; i < 9000; ++i) {
        if (i % 7 == 0) continue;
        ASSERT_EQ(world.get<Velocity>(entities[i]).linear, velocity_of(i).linear) << i;
        ASSERT_EQ(copy.get<Velocity>(entities[i]).linear, velocity_of(i).linear) << i;
    }
}

TEST_F(EcsSnapshot, TheHashSeesOneBitAndTheOrder) {
    fill(world, 100);
    const auto before = state_hash(world);
    const Entity e = world.view<const Velocity>().first();
    auto& y = world.get<Velocity>(e).linear.y;
    const double was = y;
    y = std::nextafter(was, 1e9);
    EXPECT_NE(state_hash(world), before);
    y = was;
    EXPECT_EQ(state_hash(world), before);
    world.add<Frozen>(e);
    EXPECT_NE(state_hash(world), before);
}

TEST_F(EcsSnapshot, DiffNamesComponentEntityFieldAndBothValues) {
    fill(world, 50);
    save(world, bytes);
    ASSERT_TRUE(restore(copy, bytes).has_value());
    const Entity e = copy.view<const Velocity>().first();
    copy.get<Velocity>(e).linear.z = 2.5;
    copy.add<Frozen>(e);
    Bytes other;
    save(copy, other);
    const auto differences = diff(bytes, other);
    ASSERT_TRUE(differences.has_value());
    ASSERT_EQ(differences->size(), 2U);
    EXPECT_EQ((*differences)[0].component, "Velocity");
    EXPECT_EQ((*differences)[0].entity, e.index);
    EXPECT_EQ((*differences)[0].field, "linear.z");
    EXPECT_EQ((*differences)[0].a, "0");
    EXPECT_EQ((*differences)[0].b, "2.5");
    EXPECT_EQ((*differences)[1].component, "Frozen");
    EXPECT_TRUE(diff(bytes, bytes)->empty());
}

TEST_F(EcsSnapshot, ABlobIsSavedHashedAndEmptiedWithTheWorld) {
    fill(world, 20);
    const auto without = state_hash(world);
    EXPECT_EQ(world.count<Levels>(), 0U);
    fill_levels();
    EXPECT_EQ(world.count<Levels>(), 1U);
    const auto with = state_hash(world);
    EXPECT_NE(with, without);
    save(world, bytes);
    copy.resize<Levels>(3);  // this size must be gone after the restore
    ASSERT_TRUE(restore(copy, bytes).has_value());
    EXPECT_EQ(state_hash(copy), with);
    EXPECT_TRUE(std::ranges::equal(copy.blob<Levels>(), world.blob<Levels>()));
    copy.blob<Levels>()[9] = std::nextafter(9.0F, 10.0F);
    EXPECT_NE(state_hash(copy), with);
    world.clear();
    EXPECT_TRUE(world.blob<Levels>().empty());
    EXPECT_EQ(world.count<Levels>(), 0U);
    world.resize<Levels>(2);
    EXPECT_EQ(world.blob<Levels>()[1], 0.0F);
}

TEST_F(EcsSnapshot, DiffNamesTheElementsOfABlob) {
    fill_levels();
    save(world, bytes);
    world.blob<Levels>()[7] = 0.5F;
    Bytes other;
    save(world, other);
    const auto differences = diff(bytes, other);
    ASSERT_TRUE(differences.has_value());
    ASSERT_EQ(differences->size(), 1U);
    EXPECT_EQ((*differences)[0].component, "Levels");
    EXPECT_EQ((*differences)[0].entity, none);
    EXPECT_EQ((*differences)[0].field, "[7]");
    EXPECT_EQ((*differences)[0].a, "7");
    EXPECT_EQ((*differences)[0].b, "0.5");
    world.resize<Levels>(4);
    save(world, other);
    const auto sizes = diff(bytes, other);
    ASSERT_TRUE(sizes.has_value());
    ASSERT_EQ(sizes->size(), 1U);
    EXPECT_EQ((*sizes)[0].a, "10 elements");
    EXPECT_EQ((*sizes)[0].b, "4 elements");
}

/// `Velocity` and `Levels` as another build has them: Velocity with one field more, Levels of whole numbers.
namespace other_build {
struct Velocity {
    vec3 linear{};
    double spin{};
    THAUM_COMPONENT(Velocity, linear, spin);
};
struct Levels {
    using Element = std::int32_t;
    static constexpr std::string_view name = "Levels";
};
}  // namespace other_build

TEST(EcsDiff, SnapshotsOfOtherBuildsAreReadByTheirOwnTypes) {
    World ours, theirs;
    ours.declare<Velocity>();
    ours.declare<Levels>();
    theirs.declare<other_build::Velocity>();
    theirs.declare<other_build::Levels>();
    ours.create(Velocity{{1, 2, 3}});
    theirs.create(other_build::Velocity{{1, 2, 3}, 4.5});
    ours.resize<Levels>(1);
    theirs.resize<other_build::Levels>(1);
    ours.blob<Levels>()[0] = 1.5F;
    theirs.blob<other_build::Levels>()[0] = 7;
    Bytes a, b;
    save(ours, a);
    save(theirs, b);
    const auto forth = diff(a, b);
    ASSERT_TRUE(forth.has_value());
    ASSERT_EQ(forth->size(), 2U);
    EXPECT_EQ((*forth)[0].field, "spin");
    EXPECT_EQ((*forth)[0].a, "-");
    EXPECT_EQ((*forth)[0].b, "4.5");
    EXPECT_EQ((*forth)[1].field, "[0]");
    EXPECT_EQ((*forth)[1].a, "1.5");
    EXPECT_EQ((*forth)[1].b, "7");
    const auto back = diff(b, a);
    ASSERT_TRUE(back.has_value());
    ASSERT_EQ(back->size(), 2U);
    EXPECT_EQ((*back)[0].a, "4.5");
    EXPECT_EQ((*back)[0].b, "-");
}

TEST_F(EcsSnapshot, ASystemMayUseOnlyTheBlobsItDeclared) {
    fill_levels();
    const Access reads{world.mask<Levels>(), {}, "reader"};
    world.set_access(&reads);
    EXPECT_EQ(std::as_const(world).blob<Levels>()[3], 3.0F);
    EXPECT_DEATH(world.blob<Levels>(), "reader writes Levels without having declared it");
    const Access nothing{{}, {}, "stranger"};
    world.set_access(&nothing);
    EXPECT_DEATH((void)std::as_const(world).blob<Levels>(), "stranger reads Levels");
    world.set_access(nullptr);
}

/// Cuts off a snapshot at every `step`th byte, and flips bits of that byte.
void EcsSnapshot::expect_spoilt_are_refused_or_consistent(std::size_t step) {
    fill(world, 40);
    fill_levels();
    save(world, bytes);
    for (std::size_t n = 0; n < bytes.size(); n += step) {
        ASSERT_FALSE(restore(copy, std::span(bytes).first(n)).has_value()) << n;
        ASSERT_FALSE(diff(std::span(bytes).first(n), bytes).has_value()) << n;
        ASSERT_EQ(copy.size(), 0U);
    }
    for (std::size_t n = 0; n < bytes.size(); n += step) {
        Bytes spoilt = bytes;
        spoilt[n] ^= std::byte{0x41};
        // A snapshot with a changed value may be restored, one with a damaged structure may not.
        if (restore(copy, spoilt)) {
            copy.view<Position>().each([](Position& p) { p.at.x += 1; });
            copy.clear();
        }
        (void)diff(spoilt, bytes);
    }
    ASSERT_TRUE(restore(copy, bytes).has_value());
    EXPECT_EQ(state_hash(copy), state_hash(world));
}

// Among every eight consecutive bytes, one has an index that is a multiple of seven, so every number of eight
// bytes is changed. Under sanitizers this test replaces the slower EveryTruncationAndEveryFlippedByte test.
TEST_F(EcsSnapshot, EverySeventhTruncationAndFlippedByteIsRefusedOrConsistent) {
    expect_spoilt_are_refused_or_consistent(7);
}

TEST_F(EcsSnapshot, EveryTruncationAndEveryFlippedByteIsRefusedOrConsistent) {
    expect_spoilt_are_refused_or_consistent(1);
}

}  // namespace
}  // namespace thaum::ecs::test
