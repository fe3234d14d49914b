// Cases of the ECS benchmark that create, destroy and change entities, and that save or hash them all.
#include <cstring>

#include "ecs/snapshot.h"
#include "tools/bench/ecs_contest.h"
#include "tools/bench/measure.h"

namespace thaum::bench::things {
namespace {

using ecs::Entity;
using ecs::World;

}  // namespace

// ---- structural changes -----------------------------------------------------------------------------------

Contest create_3(std::uint32_t n, bool reserved) {
    const Motion made = motion(1);
    auto a = std::make_shared<Arrays>();
    auto world = std::make_shared<std::unique_ptr<World>>(new_world());
    Side raw{[=] {
                 if (!reserved) *a = {};
                 a->clear();
             },
             [=] {
                 for (std::uint32_t i = 0; i < n; ++i) a->push_back(made, look(i), prop(i));
             },
             [=] { return hash_first(*a, a->size()); }};
    Side thaum{[=] {
                   if (reserved) {
                       (*world)->clear();
                   } else {
                       *world = new_world();
                   }
               },
               [=] {
                   World& w = **world;
                   for (std::uint32_t i = 0; i < n; ++i) w.create(made, look(i), prop(i));
               },
               [=] { return hash_things<>(**world); }};
    Contest contest{"create_3", n, 1.0 * n, thing_bytes * n, thing_bytes * n, raw, thaum};
    contest.setting = {"memory", reserved ? "reserved" : "growing"};
    return contest;
}

namespace {

/// Two groups of plain arrays, one without and one with a Body, between which rows move.
struct Groups {
    Arrays plain, solid;
    Array<Body> bodies;  ///< bodies of the rows of `solid`
    std::size_t plain_count = 0, solid_count = 0;
};

std::shared_ptr<Groups> groups(std::uint32_t n) {
    auto g = std::make_shared<Groups>();
    g->plain = arrays(n);
    g->solid = arrays(n);
    g->bodies = bodies(n);
    return g;
}

/// Row of entity k in the arrays after entities 0 to k - 1 were removed, each hole being filled with the last
/// row.
std::size_t row_of_next(std::size_t k, std::size_t count) { return std::min(k, count - 1); }

/// A World whose entities are created again before each run, in memory that is already allocated.
struct Crowd {
    std::unique_ptr<World> world = new_world();
    std::vector<Entity> entities;
};

std::shared_ptr<Crowd> crowd(std::uint32_t n) {
    auto c = std::make_shared<Crowd>();
    c->world->reserve_entities(n);
    c->world->reserve<Motion, Look, Prop>(n);
    c->world->reserve<Motion, Look, Prop, Body>(n);
    return c;
}

template <class... More>
void refill(Crowd& c, std::uint32_t n) {
    c.world->clear();
    c.entities.clear();
    for (std::uint32_t i = 0; i < n; ++i) {
        c.entities.push_back(c.world->create(motion(i), look(i), prop(i), More{}...));
    }
}

void refill(Arrays& a, std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) a.set(i);
}

}  // namespace

Contest destroy_all(std::uint32_t n) {
    auto g = groups(n);
    auto c = crowd(n);
    Side raw{[=] {
                 refill(g->plain, n);
                 g->plain_count = n;
             },
             [=] {
                 Arrays& a = g->plain;
                 std::size_t count = g->plain_count;
                 for (std::size_t k = 0; k < n; ++k) {
                     const auto row = row_of_next(k, count);
                     a.copy(a, --count, row);
                     do_not_optimise(count);
                 }
                 g->plain_count = count;
             },
             [=] { return g->plain_count; }};
    Side thaum{[=] { refill<>(*c, n); },
               [=] {
                   for (const auto e : c->entities) c->world->destroy(e);
               },
               [=] { return c->world->size(); }};
    return {"destroy_all", n, 1.0 * n, thing_bytes * n, thing_bytes * n, raw, thaum};
}

namespace {

/// Number of bytes that the raw arrays read and write when an object moves to the other group: the object,
/// and the one that fills its hole.
constexpr double moved_bytes = 4 * thing_bytes;

}  // namespace

Contest add_1(std::uint32_t n) {
    const Body made = body(1);
    auto g = groups(n);
    auto c = crowd(n);
    Side raw{[=] {
                 refill(g->plain, n);
                 g->plain_count = n;
                 g->solid_count = 0;
             },
             [=] {
                 std::size_t count = g->plain_count;
                 for (std::size_t k = 0; k < n; ++k) {
                     const auto row = row_of_next(k, count);
                     g->solid.copy(g->plain, row, k);
                     g->bodies[k] = made;
                     g->plain.copy(g->plain, --count, row);
                 }
                 g->plain_count = count;
                 g->solid_count = n;
             },
             [=] { return hash_first(g->solid, g->solid_count); }};
    Side thaum{[=] { refill<>(*c, n); },
               [=] {
                   for (const auto e : c->entities) c->world->add(e, made);
               },
               [=] { return hash_things<Body>(*c->world); }};
    const double bytes = (moved_bytes + sizeof(Body)) * n;
    return {"add_1", n, 1.0 * n, bytes, (2 * thing_bytes + sizeof(Body)) * n, raw, thaum};
}

Contest remove_1(std::uint32_t n) {
    auto g = groups(n);
    auto c = crowd(n);
    Side raw{[=] {
                 refill(g->solid, n);
                 g->solid_count = n;
                 g->plain_count = 0;
             },
             [=] {
                 std::size_t count = g->solid_count;
                 for (std::size_t k = 0; k < n; ++k) {
                     const auto row = row_of_next(k, count);
                     g->plain.copy(g->solid, row, k);
                     --count;
                     g->solid.copy(g->solid, count, row);
                     g->bodies[row] = g->bodies[count];
                 }
                 g->solid_count = count;
                 g->plain_count = n;
             },
             [=] { return hash_first(g->plain, g->plain_count); }};
    Side thaum{[=] { refill<Body>(*c, n); },
               [=] {
                   for (const auto e : c->entities) c->world->remove<Body>(e);
               },
               [=] { return hash_things<>(*c->world); }};
    const double bytes = (moved_bytes + 2 * sizeof(Body)) * n;
    return {"remove_1", n, 1.0 * n, bytes, (2 * thing_bytes + sizeof(Body)) * n, raw, thaum};
}

namespace {

struct Bits {
    std::vector<std::uint64_t> words;
    explicit Bits(std::uint32_t n) : words((n + 63) / 64) {}
    void set(std::size_t i) { words[i / 64] |= std::uint64_t{1} << (i % 64); }
    void clear(std::size_t i) { words[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
};

}  // namespace

Contest tag_churn(std::uint32_t n) {
    auto bits = std::make_shared<Bits>(n);
    auto c = crowd(n);
    refill<>(*c, n);
    Side raw{{},
             [=] {
                 for (std::uint32_t i = 0; i < n; ++i) bits->set(i);
                 do_not_optimise(bits->words.data());
                 for (std::uint32_t i = 0; i < n; ++i) bits->clear(i);
             },
             [=] {
                 std::vector<Prop> marked;
                 for (std::uint32_t i = 0; i < n; i += 3) bits->set(i);
                 for (std::uint32_t i = 0; i < n; ++i) {
                     if (((bits->words[i / 64] >> (i % 64)) & 1U) != 0) marked.push_back(prop(i));
                 }
                 return hash_of(marked);
             }};
    Side thaum{{},
               [=] {
                   for (const auto e : c->entities) c->world->add<Marked>(e);
                   for (const auto e : c->entities) c->world->remove<Marked>(e);
               },
               [=] {
                   for (std::uint32_t i = 0; i < n; i += 3) c->world->add<Marked>(c->entities[i]);
                   return hash_of(column<Prop, Marked>(*c->world));
               }};
    return {"tag_churn", n, 1.0 * n, n / 2.0, n / 8.0, raw, thaum, calls_for(n)};
}

// ---- saving and hashing the whole state -------------------------------------------------------------------

namespace {

struct State {
    std::unique_ptr<World> world;
    Bytes saved, raw_copy, thaum_copy;
    std::uint64_t hash = 0;
};

std::shared_ptr<State> state(std::uint32_t n) {
    auto s = std::make_shared<State>();
    s->world = world_of(n);
    ecs::save(*s->world, s->saved);
    s->raw_copy = s->saved;
    return s;
}

Side copy_saved(const std::shared_ptr<State>& s) {
    return {{},
            [s] {
                std::memcpy(s->raw_copy.data(), s->saved.data(), s->saved.size());
                do_not_optimise(s->raw_copy.data());
            },
            [s] { return hash_of(s->raw_copy); }};
}

}  // namespace

Contest snapshot(std::uint32_t n) {
    auto s = state(n);
    Side thaum{{}, [s] { ecs::save(*s->world, s->thaum_copy); }, [s] { return hash_of(s->thaum_copy); }};
    const auto bytes = 2.0 * static_cast<double>(s->saved.size());
    return {"snapshot", n, 1.0 * n, bytes, bytes, copy_saved(s), thaum, calls_for(n)};
}

Contest state_hash(std::uint32_t n) {
    auto s = state(n);
    Side thaum{{}, [s] { s->hash = ecs::state_hash(*s->world); }, [s] { return s->hash; }};
    const auto bytes = 2.0 * static_cast<double>(s->saved.size());
    return {"state_hash", n, 1.0 * n, bytes, bytes, copy_saved(s), thaum, calls_for(n)};
}

}  // namespace thaum::bench::things
