// tools/bench/ecs_bench.cpp: compares the World with plain arrays, case by case.
//
// The entities are loose things of the game, with its sizes of components (ecs_things.h). `raw` is a lower
// limit, not a design: 64-byte aligned arrays, one per component, without handles and checks. If only some
// entities match, the matching ones lie together. It is never made slower than necessary:
//
//     iterate_3_half   the matching half in arrays of its own
//     rare_view        a list of indices into the big arrays; arrays of their own for the few would be
//                      the layout of the World
//     random_get       a shuffled list of indices
//     create_3         appends to three vectors, because creating one entity at a time must test for room
//     add_1, remove_1  moves rows between two groups of arrays; the last row fills the hole, so that
//                      both groups stay contiguous, as iterate_3_half needs; rows are known without
//                      a look-up
//     destroy_all      fills holes in the same way and order
//     tag_churn        one bit per entity
//     snapshot         memcpy of the same number of bytes; state_hash likewise
//
// gb_per_s of a raw row counts the bytes of the cells it reads and writes. memcpy_gb_per_s is memcpy between
// the halves of a buffer as large as the row's data, counted in the same way. ratio_to_raw is the median over
// the rounds, min_ratio_to_raw that of the fastest samples. If the two differ much, the machine was too busy.
//
// Most cases have a target: a ratio to raw, or a time if raw is so fast that a ratio means nothing. Reaching
// one of the two is enough. target_met is 1 or 0, by the medians.
#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

#include "core/random.h"
#include "core/text.h"
#include "ecs/snapshot.h"
#include "tools/bench/areas.h"
#include "tools/bench/ecs_things.h"
#include "tools/bench/measure.h"

namespace thaum::bench::things {
namespace {

using ecs::Entity;
using ecs::World;

constexpr double dt = 0.001;

/// a += b * s, the work of all iterations.
inline void add_scaled(Triple& a, const Triple& b, double s) {
    a.x += b.x * s;
    a.y += b.y * s;
    a.z += b.z * s;
}

inline void age(Prop& p) { ++p.moved_at; }

/// Work of iterate_2.
inline void move(Motion& m, Prop& p) {
    add_scaled(m.position, m.velocity, dt);
    p.moved_at += m.asleep;
}

/// Work of rare_view.
inline void slow_down(Motion& m, const Body& b) {
    add_scaled(m.velocity, m.velocity, -dt * b.damping[0]);
    add_scaled(m.position, m.velocity, dt);
}

/// Work of iterate_3_half.
inline void slow_down_and_age(Motion& m, Prop& p, const Body& b) {
    slow_down(m, b);
    p.moved_at += m.asleep;
}

// ---- one contest ------------------------------------------------------------------------------------------

struct Side {
    std::function<void()> setup;  ///< empty if runs can follow each other without it
    std::function<void()> run;
    std::function<std::uint64_t()> result;  ///< hash of the data after the runs
};

struct Contest {
    std::string_view name;
    std::uint32_t n{};
    double matches{};      ///< entities that one run touches; times are divided by this number
    double bytes{};        ///< bytes that raw reads and writes in one run
    double working_set{};  ///< size of raw's data (bytes)
    Side raw, thaum;
    std::size_t calls = 1;
    std::string unit = "ns_per_entity";
    std::optional<std::pair<std::string, Value>> setting{};  ///< further setting of the row
};

/// Number of runs per sample. Short runs are repeated, because the clock is too coarse for them.
std::size_t calls_for(std::uint32_t n) { return std::max<std::size_t>(1, 100'000 / n); }

/// Copies between the halves of a buffer of `size` bytes, often enough for the clock.
class Copy {
public:
    explicit Copy(double size)
        : half_(std::max<std::size_t>(1, static_cast<std::size_t>(size) / 2)),
          bytes_(2 * half_),
          times_(1 + (std::size_t{1} << 20U) / bytes_.size()) {}
    void run() {
        for (std::size_t i = 0; i < times_; ++i) {
            std::memcpy(bytes_.data(), bytes_.data() + half_, half_);
            do_not_optimise(bytes_.data());
        }
    }
    double bytes_moved() const { return static_cast<double>(times_) * static_cast<double>(bytes_.size()); }

private:
    std::size_t half_;
    Array<std::byte> bytes_;
    std::size_t times_;
};

Row row_of(const Contest& contest, std::string_view store, const std::vector<double>& samples) {
    Row row;
    row.area = "ecs";
    row.name = contest.name;
    row.setting = {{"store", std::string(store)}, {"n", std::int64_t{contest.n}}};
    if (contest.setting) row.setting.push_back(*contest.setting);
    row.time_us = times(samples);
    row.is_default = store == "thaum";
    row.metrics.emplace_back(contest.unit, row.time_us->median * 1000 / contest.matches);
    return row;
}

struct Target {
    std::string_view name;
    double ratio;           ///< largest ratio to raw; 0: no such target
    double ns;              ///< largest time in the unit of the case; 0: no such target
    std::uint32_t n_least;  ///< smallest number of entities for which the target holds
};

constexpr std::array targets{
    Target{"iterate_1", 1.1, 0, 0}, Target{"iterate_2", 1.1, 0, 0},  Target{"iterate_3_half", 1.1, 0, 0},
    Target{"rare_view", 1.1, 0, 0}, Target{"empty_view", 0, 10, 0},  Target{"random_get", 6, 0, 1'000'000},
    Target{"create_3", 2, 30, 0},   Target{"destroy_all", 0, 25, 0}, Target{"add_1", 0, 25, 0},
    Target{"remove_1", 0, 25, 0},   Target{"tag_churn", 0, 20, 0},
};

void judge(const Contest& contest, double ns, double ratio_to_raw, Row& row) {
    const auto* target =
        std::find_if(targets.begin(), targets.end(), [&](const Target& t) { return t.name == contest.name; });
    if (target == targets.end() || contest.n < target->n_least) return;
    if (target->ratio > 0) row.metrics.emplace_back("target_ratio", target->ratio);
    if (target->ns > 0) row.metrics.emplace_back("target_ns", target->ns);
    row.metrics.emplace_back("target_met", ratio_to_raw <= target->ratio || ns <= target->ns ? 1 : 0);
}

void hold(const Contest& contest, const Options& options, Report& report) {
    Copy copy(contest.working_set);
    const std::array<Contestant, 3> contestants{Contestant{contest.raw.setup, contest.raw.run},
                                                Contestant{contest.thaum.setup, contest.thaum.run},
                                                Contestant{{}, [&] { copy.run(); }}};
    const auto samples = measure(contestants, {options.quick ? 0.25 : 1.0, 15, 1000, contest.calls});

    auto raw = row_of(contest, "raw", samples[0]);
    if (contest.bytes > 0) {
        raw.metrics.emplace_back("gb_per_s", contest.bytes / median(samples[0]) / 1000);
        raw.metrics.emplace_back("memcpy_gb_per_s", copy.bytes_moved() / median(samples[2]) / 1000);
    }
    raw.hash = hex(contest.raw.result());
    auto thaum = row_of(contest, "thaum", samples[1]);
    const double ns = thaum.metrics.back().second;
    const double ratio_to_raw = ratio(samples[1], samples[0]);
    thaum.metrics.emplace_back("ratio_to_raw", ratio_to_raw);
    thaum.metrics.emplace_back("min_ratio_to_raw", thaum.time_us->min / raw.time_us->min);
    judge(contest, ns, ratio_to_raw, thaum);
    thaum.hash = hex(contest.thaum.result());
    report.rows.push_back(std::move(raw));
    report.rows.push_back(std::move(thaum));
}

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

/// Big arrays, and a list of the rows that have a Body.
struct Rare {
    Arrays all;
    std::vector<std::uint32_t> rows;
    Array<Body> bodies;  ///< one Body for each of the rows
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

/// Views over a component that one entity had once and none has now.
Contest empty_view(std::uint32_t n) {
    constexpr std::uint32_t views = 1000;  // views per run
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

// ---- access -----------------------------------------------------------------------------------------------

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

/// The value that random_get reads. It is an integer: an integer sum does not make an access wait for the one
/// before.
std::uint64_t value(const Motion& m) { return std::bit_cast<std::uint64_t>(m.position.x); }
std::uint64_t value(const Look& l) { return l.surface; }
std::uint64_t value(const Prop& p) { return p.moved_at; }

const Array<Motion>& cells_of(const Arrays& a, std::type_identity<Motion>) { return a.motions; }
const Array<Look>& cells_of(const Arrays& a, std::type_identity<Look>) { return a.looks; }
const Array<Prop>& cells_of(const Arrays& a, std::type_identity<Prop>) { return a.props; }

/// Reads one component of all entities in random order: the smallest, the middle one or the largest.
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

// ---- structure --------------------------------------------------------------------------------------------

/// Creates entities in reserved memory whose pages have been touched, or in a store that grows from
/// nothing. All have the same Motion: computing one costs more than storing it.
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

/// Two groups of plain arrays, without and with a Body, that exchange rows.
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

/// Row of entity k after entities 0 to k - 1 are gone and the last row has filled each hole.
std::size_t row_of_next(std::size_t k, std::size_t count) { return std::min(k, count - 1); }

/// A World whose entities are created again before each run, in memory that is already there.
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

/// Bytes that raw reads and writes when it moves a thing to the other group: the thing and the one that fills
/// its hole.
constexpr double moved_bytes = 4 * thing_bytes;

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

struct Bits {
    std::vector<std::uint64_t> words;
    explicit Bits(std::uint32_t n) : words((n + 63) / 64) {}
    void set(std::size_t i) { words[i / 64] |= std::uint64_t{1} << (i % 64); }
    void clear(std::size_t i) { words[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
};

/// Sets the tag on all entities, then clears it on all. For the hash, every third entity gets it once more.
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

// ---- the whole state --------------------------------------------------------------------------------------

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

Contest snapshot(std::uint32_t n) {
    auto s = state(n);
    Side thaum{{}, [s] { ecs::save(*s->world, s->thaum_copy); }, [s] { return hash_of(s->thaum_copy); }};
    const auto bytes = 2.0 * static_cast<double>(s->saved.size());
    return {"snapshot", n, 1.0 * n, bytes, bytes, copy_saved(s), thaum, calls_for(n)};
}

/// Raw is memcpy and computes no hash, so the two hashes differ here.
Contest state_hash(std::uint32_t n) {
    auto s = state(n);
    Side thaum{{}, [s] { s->hash = ecs::state_hash(*s->world); }, [s] { return s->hash; }};
    const auto bytes = 2.0 * static_cast<double>(s->saved.size());
    return {"state_hash", n, 1.0 * n, bytes, bytes, copy_saved(s), thaum, calls_for(n)};
}

using Make = Contest (*)(std::uint32_t);
constexpr std::array<Make, 16> cases{
    iterate_1,
    iterate_2,
    iterate_3_half,
    rare_view,
    empty_view,
    random_get<Look>,
    random_get<Prop>,
    random_get<Motion>,
    [](std::uint32_t n) { return create_3(n, true); },
    [](std::uint32_t n) { return create_3(n, false); },
    destroy_all,
    add_1,
    remove_1,
    tag_churn,
    snapshot,
    state_hash,
};

}  // namespace
}  // namespace thaum::bench::things

void thaum::bench::ecs(const Options& options, Report& report) {
    std::vector<std::uint32_t> sizes{1'000, 100'000, 1'000'000};
    if (options.quick) sizes.pop_back();
    for (const auto& make : things::cases) {
        for (const auto n : sizes) things::hold(make(n), options, report);
    }
}
