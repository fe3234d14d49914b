// The World against the simplest model that can be right: a map from entity to values. Long random histories, each step compared.
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "core/random.h"
#include "ecs/snapshot.h"
#include "unit/ecs_components.h"

namespace thaum::ecs::test {
namespace {

struct Model {
    std::optional<double> position, velocity;
    std::optional<std::int32_t> health;
    bool frozen = false, burning = false;
};

struct Key {
    bool operator()(Entity a, Entity b) const {
        return a.index != b.index ? a.index < b.index : a.generation < b.generation;
    }
};
using Models = std::map<Entity, Model, Key>;

void step(World& world, Models& models, Random& random) {
    const auto value = static_cast<double>(random.below(1000));
    if (models.empty() || random.below(4) == 0) {
        Model m;
        Entity e;
        switch (random.below(3)) {
            case 0:
                e = world.create(Position{{value, 0, 0}});
                m.position = value;
                break;
            case 1:
                e = world.create(Position{{value, 0, 0}}, Burning{}, Health{3, 0});
                m.position = value;
                m.burning = true;
                m.health = 3;
                break;
            default: e = world.create(); break;
        }
        ASSERT_FALSE(models.contains(e));
        models[e] = m;
        return;
    }
    auto it = models.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(random.below(models.size())));
    const Entity e = it->first;
    auto& m = it->second;
    const auto toggle = [&]<class C>(auto& slot, const C& c, auto v) {
        if (slot) {
            world.remove<C>(e);
            slot = {};
        } else {
            world.add(e, c);
            slot = v;
        }
    };
    switch (random.below(6)) {
        case 0: toggle(m.position, Position{{value, 0, 0}}, value); break;
        case 1: toggle(m.velocity, Velocity{{value, 0, 0}}, value); break;
        case 2:
            toggle(m.health, Health{static_cast<std::int32_t>(value), 0}, static_cast<std::int32_t>(value));
            break;
        case 3: toggle(m.frozen, Frozen{}, true); break;
        case 4: toggle(m.burning, Burning{}, true); break;
        default: world.destroy(e); models.erase(it);
    }
}

void compare(const World& world, const Models& models) {
    ASSERT_EQ(world.size(), models.size());
    std::uint32_t frozen = 0;
    for (const auto& [e, m] : models) {
        ASSERT_TRUE(world.alive(e));
        const auto* p = world.find<Position>(e);
        const auto* v = world.find<Velocity>(e);
        const auto* h = world.find<Health>(e);
        ASSERT_EQ(p != nullptr, m.position.has_value());
        ASSERT_EQ(v != nullptr, m.velocity.has_value());
        ASSERT_EQ(h != nullptr, m.health.has_value());
        if (p != nullptr) {
            ASSERT_EQ(p->at.x, *m.position);
        }
        if (v != nullptr) {
            ASSERT_EQ(v->linear.x, *m.velocity);
        }
        if (h != nullptr) {
            ASSERT_EQ(h->points, *m.health);
        }
        ASSERT_EQ(world.has<Frozen>(e), m.frozen);
        ASSERT_EQ(world.has<Burning>(e), m.burning);
        frozen += m.frozen ? 1U : 0U;
    }
    ASSERT_EQ(world.count<Frozen>(), frozen);
    std::size_t matches = 0;
    world.view<const Position, Without<Velocity>, Frozen, Without<Burning>>().each(
        [&](Entity e, const Position&) {
            const auto& m = models.at(e);
            EXPECT_TRUE(m.position && !m.velocity && m.frozen && !m.burning);
            ++matches;
        });
    std::size_t expected = 0;
    for (const auto& [e, m] : models) {
        expected += m.position && !m.velocity && m.frozen && !m.burning ? 1U : 0U;
    }
    ASSERT_EQ(matches, expected);
}

TEST(EcsModel, LongRandomHistoriesAgreeWithAMapAndSurviveRestore) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        World world;
        declare_all(world);
        Models models;
        Random random{seed};
        Bytes bytes;
        for (int i = 0; i < 4000 && !HasFatalFailure(); ++i) {
            step(world, models, random);
            if (i % 50 == 0) compare(world, models);
            if (random.below(500) == 0) {
                const auto hash = state_hash(world);
                save(world, bytes);
                ASSERT_TRUE(restore(world, bytes).has_value());
                ASSERT_EQ(state_hash(world), hash);
            }
        }
        compare(world, models);
    }
}

}  // namespace
}  // namespace thaum::ecs::test
