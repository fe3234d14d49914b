// Cases of the ECS benchmark that read and write components: iteration and random access.
#include <bit>
#include <numeric>

#include "core/random.h"
#include "tools/bench/ecs_contest.h"
#include "tools/bench/measure.h"

namespace thaum::bench::things {
namespace {

using ecs::Entity;
using ecs::World;

constexpr double dt = 0.001;

/// Adds b * s to a, which is the work done for each entity in all cases of iteration.
inline void add_scaled(Triple& a, const Triple& b, double s) {
    a.x += b.x * s;
    a.y += b.y * s;
    a.z += b.z * s;
}

inline void age(Prop& p) { ++p.moved_at; }

/// Work for each entity in the case iterate_2 of the benchmark, which reads and writes two components.
inline void move(Motion& m, Prop& p) {
    add_scaled(m.position, m.velocity, dt);
    p.moved_at += m.asleep;
}

/// Work for each entity in the case rare_view of the benchmark: slows it down and moves it.
inline void slow_down(Motion& m, const Body& b) {
    add_scaled(m.velocity, m.velocity, -dt * b.damping[0]);
    add_scaled(m.position, m.velocity, dt);
}

/// Work for each entity in the case iterate_3_half of the benchmark, which visits half of the entities.
inline void slow_down_and_age(Motion& m, Prop& p, const Body& b) {
    slow_down(m, b);
    p.moved_at += m.asleep;
}

}  // namespace

// ---- iteration --------------------------------------------------------------------------------------------

Contest iterate_1(std::uint32_t n) {
    auto a = std::make_shared<Arrays>(arrays(n));
    std::shared_ptr<World> world = world_of(n);
    Side raw{{},
             [a] {
                 auto* p = a->props.data();
                 for (std::size_t i = 0, count = a->size(); i < count; ++i) age(p[i]);
             },
             [a] { return hash_of(a->props); }};
    Side thaum{{},
               [world] { world->view<Prop>().each([](Prop& p) { age(p); }); },
               [world] { return hash_of(column<Prop>(*world)); }};
    const double bytes = sizeof(Prop) * n;
    return {"iterate_1", n, 1.0 * n, 2 * bytes, bytes, raw, thaum, calls_for(n)};
}

Contest iterate_2(std::uint32_t n) {
    auto a = std::make_shared<Arrays>(arrays(n));
    std::shared_ptr<World> world = world_of(n);
    Side raw{{},
             [a] {
                 auto* m = a->motions.data();
                 auto* p = a->props.data();
                 for (std::size_t i = 0, count = a->size(); i < count; ++i) move(m[i], p[i]);
             },
             [a] { return hash_of(a->motions, a->props); }};
    Side thaum{{},
               [world] { world->view<Motion, Prop>().each([](Motion& m, Prop& p) { move(m, p); }); },
               [world] { return hash_of(column<Motion>(*world), column<Prop>(*world)); }};
    const double bytes = 1.0 * (sizeof(Motion) + sizeof(Prop)) * n;
    return {"iterate_2", n, 1.0 * n, 2 * bytes, bytes, raw, thaum, calls_for(n)};
}

Contest iterate_3_half(std::uint32_t n) {
    auto a = std::make_shared<Arrays>(arrays(n, 2));
    auto b = std::make_shared<Array<Body>>(bodies(n, 2));
    std::shared_ptr<World> world = world_of(n, 2);
    Side raw{{},
             [a, b] {
                 auto* m = a->motions.data();
                 auto* p = a->props.data();
                 const auto* f = b->data();
                 for (std::size_t i = 0, count = a->size(); i < count; ++i)
                     slow_down_and_age(m[i], p[i], f[i]);
             },
             [a] { return hash_of(a->motions, a->props); }};
    Side thaum{{},
               [world] {
                   world->view<Motion, Prop, const Body>().each(
                       [](Motion& m, Prop& p, const Body& b) { slow_down_and_age(m, p, b); });
               },
               [world] { return hash_of(column<Motion, Body>(*world), column<Prop, Body>(*world)); }};
    const double written = 0.5 * (sizeof(Motion) + sizeof(Prop)) * n, read = 0.5 * sizeof(Body) * n;
    return {"iterate_3_half", n, 0.5 * n, 2 * written + read, written + read, raw, thaum, 2 * calls_for(n)};
}

namespace {

/// Large arrays, and a list of the few rows of these arrays whose entity has a Body.
struct Rare {
    Arrays all;
    std::vector<std::uint32_t> rows;
    Array<Body> bodies;  ///< one Body for each row in the list
};

std::shared_ptr<Rare> rare(std::uint32_t n, std::uint32_t step) {
    auto r = std::make_shared<Rare>();
    r->all = arrays(n);
    r->bodies = bodies(n, step);
    for (std::uint32_t i = 0; i < n; i += step) r->rows.push_back(i);
    return r;
}

std::uint64_t hash_rare(const Rare& r) {
    std::vector<Motion> motions;
    for (const auto row : r.rows) motions.push_back(r.all.motions[row]);
    return hash_of(motions);
}

}  // namespace

Contest rare_view(std::uint32_t n) {
    constexpr std::uint32_t few = 1000;
    auto r = rare(n, n / few);
    std::shared_ptr<World> world = world_of(n, n / few);
    Side raw{{},
             [r] {
                 auto* m = r->all.motions.data();
                 const auto* b = r->bodies.data();
                 const auto* rows = r->rows.data();
                 for (std::size_t i = 0, count = r->rows.size(); i < count; ++i) slow_down(m[rows[i]], b[i]);
             },
             [r] { return hash_rare(*r); }};
    Side thaum{{},
               [world] {
                   world->view<Motion, const Body>().each([](Motion& m, const Body& b) { slow_down(m, b); });
               },
               [world] { return hash_of(column<Motion, Body>(*world)); }};
    const double bytes = 1.0 * (sizeof(std::uint32_t) + sizeof(Motion) + sizeof(Body)) * few;
    return {"rare_view", n, 1.0 * few, bytes + sizeof(Motion) * few, bytes, raw, thaum, calls_for(few)};
}

Contest empty_view(std::uint32_t n) {
    constexpr std::uint32_t views = 1000;  // number of views in a run
    auto a = std::make_shared<Arrays>();
    std::shared_ptr<World> world = world_of(n);
    world->destroy(world->create(prop(0), Dead{}));
    Side raw{{},
             [a] {
                 for (std::uint32_t k = 0; k < views; ++k) {
                     do_not_optimise(a.get());
                     for (auto& p : a->props) age(p);
                 }
             },
             [a] { return a->size(); }};
    Side thaum{{},
               [world] {
                   for (std::uint32_t k = 0; k < views; ++k) {
                       do_not_optimise(world.get());
                       world->view<Prop, const Dead>().each([](Prop& p, const Dead&) { age(p); });
                   }
               },
               [world] { return world->view<const Prop, const Dead>().count(); }};
    return {"empty_view", n, 1.0 * views, 0, 8, raw, thaum, 20, "ns_per_view"};
}

// ---- random access ----------------------------------------------------------------------------------------

namespace {

std::vector<std::uint32_t> shuffled(std::uint32_t n) {
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0U);
    Random random = random_stream(1, 1);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
}

struct Lookup {
    Arrays arrays;
    std::unique_ptr<World> world;
    std::vector<std::uint32_t> indices;
    std::vector<Entity> handles;
    std::uint64_t raw_sum = 0, thaum_sum = 0;
};

std::shared_ptr<Lookup> lookup(std::uint32_t n) {
    auto l = std::make_shared<Lookup>();
    l->arrays = arrays(n);
    l->world = new_world();
    l->indices = shuffled(n);
    std::vector<Entity> in_order;
    for (std::uint32_t i = 0; i < n; ++i) in_order.push_back(l->world->create(motion(i), look(i), prop(i)));
    for (const auto i : l->indices) l->handles.push_back(in_order[i]);
    return l;
}

/// The value that random_get reads. It is an integer, because a sum of integers does not make an access wait
/// for the one before.
std::uint64_t value(const Motion& m) { return std::bit_cast<std::uint64_t>(m.position.x); }
std::uint64_t value(const Look& l) { return l.surface; }
std::uint64_t value(const Prop& p) { return p.moved_at; }

const Array<Motion>& cells_of(const Arrays& a, std::type_identity<Motion>) { return a.motions; }
const Array<Look>& cells_of(const Arrays& a, std::type_identity<Look>) { return a.looks; }
const Array<Prop>& cells_of(const Arrays& a, std::type_identity<Prop>) { return a.props; }

}  // namespace

template <class C>
Contest random_get(std::uint32_t n) {
    auto l = lookup(n);
    Side raw{{},
             [l] {
                 const auto* cells = cells_of(l->arrays, std::type_identity<C>{}).data();
                 std::uint64_t sum = 0;
                 for (const auto i : l->indices) sum += value(cells[i]);
                 l->raw_sum = sum;
             },
             [l] { return l->raw_sum; }};
    Side thaum{{},
               [l] {
                   const World& world = *l->world;
                   std::uint64_t sum = 0;
                   for (const auto e : l->handles) sum += value(world.get<C>(e));
                   l->thaum_sum = sum;
               },
               [l] { return l->thaum_sum; }};
    Contest contest{"random_get", n, 1.0 * n, 8.0 * n, (4.0 + sizeof(C)) * n, raw, thaum, calls_for(n)};
    contest.setting = {"component", std::string(C::name)};
    return contest;
}

template Contest random_get<Look>(std::uint32_t);
template Contest random_get<Prop>(std::uint32_t);
template Contest random_get<Motion>(std::uint32_t);

}  // namespace thaum::bench::things
