// Compares the World (the store of entities and components) with the simplest correct model, a map from
// entity to values, after each step of long random histories.
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

void create(World& world, Models& models, Random& random, double value) {
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
}

/// Adds a component to an entity or removes it, or destroys the entity, in the World and in the models alike.
void change(World& world, Models& models, Random& random, double value) {
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

void step(World& world, Models& models, Random& random) {
    const auto value = static_cast<double>(random.below(1000));
    if (models.empty() || random.below(4) == 0) {
        create(world, models, random, value);
    } else {
        change(world, models, random, value);
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

/// Component of N bytes. Small sizes are moved in registers, large ones are not.
template <std::size_t N, bool in_place = false>
struct Sized {
    std::array<std::uint8_t, N> bytes{};
    static constexpr bool stays_in_place = in_place;
    static constexpr std::array<char, 3> letters{'S', 'A' + N / 26, 'A' + N % 26};
    static constexpr std::string_view name{letters.data(), letters.size()};
    THAUM_FIELDS(Sized, bytes);
};

template <std::size_t N>
Sized<N> sized(std::uint64_t value) {
    Sized<N> s;
    for (std::size_t i = 0; i < N; ++i) s.bytes[i] = static_cast<std::uint8_t>(value * 31 + i * 7);
    return s;
}

/// The component of N bytes as one of two Worlds stores it. Other sizes stay in place in the first World than
/// in the second, which must not show in their states.
template <std::size_t N, bool second>
using SizedIn = Sized<N, N == 100 || (second ? N == 4 || N == 24 : N == 1 || N == 12)>;

template <bool second, std::size_t N>
SizedIn<N, second> stored(const Sized<N>& component) {
    return {component.bytes};
}
template <bool second, Tag C>
C stored(const C& component) {
    return component;
}

template <std::size_t... Ns>
struct Sizes {
    static constexpr std::size_t count = sizeof...(Ns);
    /// Calls f.operator()<N>(), where N is the size at index `number`.
    template <class F>
    static void with(std::size_t number, F&& f) {
        std::size_t i = 0;
        ((i++ == number ? f.template operator()<Ns>() : void()), ...);
    }
    template <bool second>
    static void declare(World& world) {
        (world.declare<SizedIn<Ns, second>>(), ...);
    }
};
using AllSizes = Sizes<1, 4, 8, 12, 16, 20, 24, 32, 40, 100>;

struct Churned {
    Entity entity;
    std::array<std::optional<std::uint64_t>, AllSizes::count> values{};
    bool frozen = false, burning = false;
};

/// Two Worlds that must stay equal, byte for byte. One of them is restored sometimes, so that it loses its
/// cached edges between tables. One gets changes as commands, the other directly. Other components stay in
/// place.
struct Twins {
    World lasting, restored;
    std::vector<Churned> all;
    Random random;

    explicit Twins(std::uint64_t seed) : random{seed} {
        AllSizes::declare<false>(lasting);
        AllSizes::declare<true>(restored);
        for (auto* world : {&lasting, &restored}) {
            world->declare<Frozen>();
            world->declare<Burning>();
        }
    }

    void create() {
        const auto value = random.below(1000);
        Churned c;
        const auto both = [&](const auto&... components) {
            c.entity = lasting.create(stored<false>(components)...);
            ASSERT_EQ(restored.create(stored<true>(components)...), c.entity);
        };
        switch (random.below(4)) {
            case 0: both(); break;
            case 1:
                both(sized<12>(value), sized<24>(value));
                c.values[3] = c.values[6] = value;
                break;
            case 2:
                both(sized<100>(value), Burning{}, sized<1>(value));
                c.values[9] = c.values[0] = value;
                c.burning = true;
                break;
            default:
                both(sized<32>(value), sized<20>(value), sized<4>(value));
                c.values[7] = c.values[5] = c.values[1] = value;
        }
        all.push_back(c);
    }

    template <class C>
    void change(Entity e, bool add, const C& c) {
        const auto first = stored<false>(c);
        const auto second = stored<true>(c);
        if (add) {
            lasting.add(e, first);
            restored.commands().add(e, second);
        } else {
            lasting.remove<std::remove_const_t<decltype(first)>>(e);
            restored.commands().remove<std::remove_const_t<decltype(second)>>(e);
        }
        if (random.below(3) == 0) restored.apply_commands();
    }

    void toggle_one(Churned& c) {
        const auto which = random.below(AllSizes::count + 2);
        if (which == AllSizes::count) {
            change(c.entity, c.frozen = !c.frozen, Frozen{});
        } else if (which > AllSizes::count) {
            change(c.entity, c.burning = !c.burning, Burning{});
        } else {
            auto& slot = c.values[which];
            slot = slot ? std::nullopt : std::optional(random.below(1000));
            AllSizes::with(which, [&]<std::size_t N>() {
                change(c.entity, slot.has_value(), sized<N>(slot.value_or(0)));
            });
        }
    }

    void step() {
        const auto what = random.below(16);
        if (all.empty() || what == 0) {
            restored.apply_commands();
            create();
            return;
        }
        const auto at = random.below(all.size());
        if (what == 1 && all.size() > 40) {
            lasting.destroy(all[at].entity);
            restored.commands().destroy(all[at].entity);
            all[at] = all.back();
            all.pop_back();
        } else {
            toggle_one(all[at]);
        }
    }

    void compare() {
        restored.apply_commands();
        Bytes a, b;
        save(lasting, a);
        save(restored, b);
        ASSERT_EQ(a, b);
        ASSERT_EQ(state_hash(lasting), state_hash(restored));
        for (const auto& c : all) {
            ASSERT_EQ(lasting.has<Frozen>(c.entity), c.frozen);
            ASSERT_EQ(lasting.has<Burning>(c.entity), c.burning);
            for (std::size_t i = 0; i < AllSizes::count; ++i) {
                AllSizes::with(i, [&]<std::size_t N>() {
                    const auto* found = lasting.find<SizedIn<N, false>>(c.entity);
                    ASSERT_EQ(found != nullptr, c.values[i].has_value());
                    if (found != nullptr) {
                        ASSERT_EQ(found->bytes, sized<N>(*c.values[i]).bytes);
                    }
                });
            }
        }
    }

    /// Restores the second World, so that its tables are kept but everything outside its state is lost.
    void forget() {
        Bytes bytes;
        save(restored, bytes);
        ASSERT_TRUE(restore(restored, bytes).has_value());
    }
};

TEST(EcsModel, ChurnOverManySetsIsTheSameDirectlyByCommandsAndAfterForgettingNeighbours) {
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
        Twins twins(seed);
        for (int i = 0; i < 3000 && !testing::Test::HasFatalFailure(); ++i) {
            twins.step();
            if (i % 100 != 0) continue;
            twins.compare();
            if (twins.random.below(4) == 0) twins.forget();
        }
        twins.compare();
        EXPECT_GT(twins.lasting.tables().size(), 200U);
    }
}

}  // namespace
}  // namespace thaum::ecs::test
