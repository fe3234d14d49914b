// tools/bench/ecs_bench.cpp: compares the World with plain arrays, case by case.
//
// `raw` is a lower limit, not a design: 64-byte aligned arrays, one per component, without handles and
// checks. If only some entities match, the matching ones lie together. It is never made slower than
// necessary:
//
//     iterate_3_half   the matching half in arrays of its own
//     rare_view        a list of indices into the big arrays; arrays of their own for the few would be
//                      the layout of the World
//     random_get       a shuffled list of indices
//     create_2         appends to two vectors, because creating one entity at a time must test for room
//     add_1, remove_1  moves rows between two groups of arrays; the last row fills the hole, so that
//                      both groups stay contiguous, as iterate_3_half needs; rows are known without
//                      a look-up
//     destroy_all      fills holes in the same way and order
//     tag_churn        one bit per entity
//     snapshot         memcpy of the same number of bytes; state_hash likewise
//
// gb_per_s of a raw row counts the bytes it reads and writes. memcpy_gb_per_s is memcpy between the halves
// of a buffer as large as the row's data, counted in the same way. ratio_to_raw is the median over the
// rounds, min_ratio_to_raw that of the fastest samples. If the two differ much, the machine was too busy.
//
// At 100,000 entities most cases have a target: a ratio to raw, or a time if raw is so fast that a ratio
// means nothing. Reaching one of the two is enough. target_met is 1 or 0, by the medians.
#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <numeric>

#include "core/hash.h"
#include "core/random.h"
#include "core/text.h"
#include "ecs/snapshot.h"
#include "ecs/world.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using ecs::Entity;
using ecs::World;

/// Three floats as separate members instead of an fvec3. GLM declares x, y and z inside unions, and GCC 12
/// vectorises no loop over those. The raw arrays would be three times slower than possible and make the
/// World look better than it is.
struct Floats3 {
    float x{}, y{}, z{};

    static constexpr auto fields() {
        return std::tuple(ecs::field("x", &Floats3::x), ecs::field("y", &Floats3::y),
                          ecs::field("z", &Floats3::z));
    }
};

struct Position {
    Floats3 at{};
    static constexpr std::string_view name = "Position";
    static constexpr auto fields() { return std::tuple(ecs::field("at", &Position::at)); }
};

struct Velocity {
    Floats3 linear{};
    static constexpr std::string_view name = "Velocity";
    static constexpr auto fields() { return std::tuple(ecs::field("linear", &Velocity::linear)); }
};

struct Push {
    Floats3 acceleration{};
    static constexpr std::string_view name = "Push";
    static constexpr auto fields() { return std::tuple(ecs::field("acceleration", &Push::acceleration)); }
};

struct Absent {
    Floats3 value{};
    static constexpr std::string_view name = "Absent";
    static constexpr auto fields() { return std::tuple(ecs::field("value", &Absent::value)); }
};

struct Marked {
    static constexpr std::string_view name = "Marked";
};

constexpr float dt = 0.001F;
constexpr Floats3 drift{0.001F, 0.002F, 0.003F};

/// a += b * s, the work of all iterations.
inline void add_scaled(Floats3& a, const Floats3& b, float s) {
    a.x += b.x * s;
    a.y += b.y * s;
    a.z += b.z * s;
}

Position position(std::uint32_t i) { return {{static_cast<float>(i), 1, 2}}; }
Velocity velocity(std::uint32_t i) { return {{1, static_cast<float>(i), 3}}; }
Push push(std::uint32_t i) { return {{1, 2, static_cast<float>(i)}}; }

template <class T>
struct Aligned {
    using value_type = T;
    Aligned() = default;
    template <class U>
    Aligned(const Aligned<U>&) {}
    T* allocate(std::size_t n) {
        return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64}));
    }
    void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{64}); }
    bool operator==(const Aligned&) const { return true; }
};

template <class T>
using Array = std::vector<T, Aligned<T>>;

/// Plain arrays of equal length.
struct Arrays {
    Array<Position> positions;
    Array<Velocity> velocities;
    Array<Push> pushes;

    void push_back(std::uint32_t i) {
        positions.push_back(position(i));
        velocities.push_back(velocity(i));
        pushes.push_back(push(i));
    }
};

Arrays arrays(std::uint32_t n, std::uint32_t step = 1) {
    Arrays a;
    for (std::uint32_t i = 0; i < n; i += step) a.push_back(i);
    return a;
}

std::unique_ptr<World> new_world() {
    auto world = std::make_unique<World>();
    world->declare<Position>();
    world->declare<Velocity>();
    world->declare<Push>();
    world->declare<Absent>();
    world->declare<Marked>();
    return world;
}

/// A World of n entities. Every `step`th has a Push as well (0: none).
std::unique_ptr<World> world_of(std::uint32_t n, std::uint32_t step = 0) {
    auto world = new_world();
    for (std::uint32_t i = 0; i < n; ++i) {
        if (step != 0 && i % step == 0) {
            world->create(position(i), velocity(i), push(i));
        } else {
            world->create(position(i), velocity(i));
        }
    }
    return world;
}

template <class... Ts>
std::uint64_t hash_of(const Ts&... columns) {
    std::uint64_t h = 0;
    ((h = hash_combine(h, hash_bytes(std::as_bytes(std::span(columns))))), ...);
    return h;
}

/// Components C of all entities that have every component in With, in the order of iteration.
template <class C, class... With>
std::vector<C> column(World& world) {
    std::vector<C> out;
    world.view<const C, const With...>().each([&](const C& c, const auto&...) { out.push_back(c); });
    return out;
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
    std::string memory{};  ///< value of the row's setting `memory`; empty: none
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
    if (!contest.memory.empty()) row.setting.emplace_back("memory", contest.memory);
    row.time_us = times(samples);
    row.is_default = store == "thaum";
    row.metrics.emplace_back(contest.unit, row.time_us->median * 1000 / contest.matches);
    return row;
}

struct Target {
    std::string_view name;
    double ratio;  ///< largest ratio to raw; 0: no such target
    double ns;     ///< largest time in the unit of the case; 0: no such target
};

constexpr std::uint32_t target_n = 100'000;
constexpr std::array targets{
    Target{"iterate_1", 1.15, 0}, Target{"iterate_2", 1.15, 0}, Target{"iterate_3_half", 1.5, 0},
    Target{"rare_view", 1.5, 0},  Target{"empty_view", 0, 10},  Target{"random_get", 12, 0},
    Target{"create_2", 2, 30},    Target{"destroy_all", 0, 25}, Target{"add_1", 3, 15},
    Target{"remove_1", 4.5, 12},  Target{"tag_churn", 7.5, 20},
};

void judge(const Contest& contest, double ns, double ratio_to_raw, Row& row) {
    const auto target =
        std::find_if(targets.begin(), targets.end(), [&](const Target& t) { return t.name == contest.name; });
    if (contest.n != target_n || target == targets.end()) return;
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
                 auto* p = a->positions.data();
                 for (std::size_t i = 0, count = a->positions.size(); i < count; ++i)
                     add_scaled(p[i].at, drift, 1);
             },
             [a] { return hash_of(a->positions); }};
    Side thaum{{},
               [world] { world->view<Position>().each([](Position& p) { add_scaled(p.at, drift, 1); }); },
               [world] { return hash_of(column<Position>(*world)); }};
    return {"iterate_1", n, 1.0 * n, 24.0 * n, 12.0 * n, raw, thaum, calls_for(n)};
}

Contest iterate_2(std::uint32_t n) {
    auto a = std::make_shared<Arrays>(arrays(n));
    std::shared_ptr<World> world = world_of(n);
    Side raw{{},
             [a] {
                 auto* p = a->positions.data();
                 const auto* v = a->velocities.data();
                 for (std::size_t i = 0, count = a->positions.size(); i < count; ++i) {
                     add_scaled(p[i].at, v[i].linear, dt);
                 }
             },
             [a] { return hash_of(a->positions); }};
    Side thaum{{},
               [world] {
                   world->view<Position, const Velocity>().each(
                       [](Position& p, const Velocity& v) { add_scaled(p.at, v.linear, dt); });
               },
               [world] { return hash_of(column<Position>(*world)); }};
    return {"iterate_2", n, 1.0 * n, 36.0 * n, 24.0 * n, raw, thaum, calls_for(n)};
}

Contest iterate_3_half(std::uint32_t n) {
    auto a = std::make_shared<Arrays>(arrays(n, 2));
    std::shared_ptr<World> world = world_of(n, 2);
    Side raw{{},
             [a] {
                 auto* p = a->positions.data();
                 auto* v = a->velocities.data();
                 const auto* f = a->pushes.data();
                 for (std::size_t i = 0, count = a->positions.size(); i < count; ++i) {
                     add_scaled(v[i].linear, f[i].acceleration, dt);
                     add_scaled(p[i].at, v[i].linear, dt);
                 }
             },
             [a] { return hash_of(a->positions, a->velocities); }};
    Side thaum{
        {},
        [world] {
            world->view<Position, Velocity, const Push>().each([](Position& p, Velocity& v, const Push& f) {
                add_scaled(v.linear, f.acceleration, dt);
                add_scaled(p.at, v.linear, dt);
            });
        },
        [world] { return hash_of(column<Position, Push>(*world), column<Velocity, Push>(*world)); }};
    return {"iterate_3_half", n, 0.5 * n, 30.0 * n, 18.0 * n, raw, thaum, 2 * calls_for(n)};
}

/// Big arrays, and a list of the rows that have a Push.
struct Rare {
    Arrays all;
    std::vector<std::uint32_t> rows;
    Array<Push> pushes;  ///< one Push for each of the rows
};

std::shared_ptr<Rare> rare(std::uint32_t n, std::uint32_t step) {
    auto r = std::make_shared<Rare>();
    r->all = arrays(n);
    for (std::uint32_t i = 0; i < n; i += step) {
        r->rows.push_back(i);
        r->pushes.push_back(push(i));
    }
    return r;
}

std::uint64_t hash_rare(const Rare& r) {
    std::vector<Position> positions;
    for (const auto row : r.rows) positions.push_back(r.all.positions[row]);
    return hash_of(positions);
}

Contest rare_view(std::uint32_t n) {
    constexpr std::uint32_t few = 1000;
    auto r = rare(n, n / few);
    std::shared_ptr<World> world = world_of(n, n / few);
    Side raw{{},
             [r] {
                 auto* p = r->all.positions.data();
                 const auto* v = r->all.velocities.data();
                 const auto* f = r->pushes.data();
                 const auto* rows = r->rows.data();
                 for (std::size_t i = 0, count = r->rows.size(); i < count; ++i) {
                     add_scaled(p[rows[i]].at, v[rows[i]].linear, dt);
                     add_scaled(p[rows[i]].at, f[i].acceleration, dt);
                 }
             },
             [r] { return hash_rare(*r); }};
    Side thaum{{},
               [world] {
                   world->view<Position, const Velocity, const Push>().each(
                       [](Position& p, const Velocity& v, const Push& f) {
                           add_scaled(p.at, v.linear, dt);
                           add_scaled(p.at, f.acceleration, dt);
                       });
               },
               [world] { return hash_of(column<Position, Push>(*world)); }};
    return {"rare_view", n, 1.0 * few, 52.0 * few, 40.0 * few, raw, thaum, calls_for(few)};
}

/// Views over a component that one entity had once and none has now.
Contest empty_view(std::uint32_t n) {
    constexpr std::uint32_t views = 1000;  // views per run
    auto a = std::make_shared<Arrays>();
    std::shared_ptr<World> world = world_of(n);
    world->destroy(world->create(position(0), Absent{}));
    Side raw{{},
             [a] {
                 for (std::uint32_t k = 0; k < views; ++k) {
                     do_not_optimise(a.get());
                     for (auto& p : a->positions) add_scaled(p.at, drift, 1);
                 }
             },
             [a] { return a->positions.size(); }};
    Side thaum{{},
               [world] {
                   for (std::uint32_t k = 0; k < views; ++k) {
                       do_not_optimise(world.get());
                       world->view<Position, const Absent>().each(
                           [](Position& p, const Absent&) { add_scaled(p.at, drift, 1); });
                   }
               },
               [world] { return world->view<const Position, const Absent>().count(); }};
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
    for (std::uint32_t i = 0; i < n; ++i) in_order.push_back(l->world->create(position(i), velocity(i)));
    for (const auto i : l->indices) l->handles.push_back(in_order[i]);
    return l;
}

/// The loop sums bits as integers, not floats: an integer sum does not make an access wait for the one
/// before.
Contest random_get(std::uint32_t n) {
    auto l = lookup(n);
    Side raw{{},
             [l] {
                 const auto* p = l->arrays.positions.data();
                 std::uint32_t sum = 0;
                 for (const auto i : l->indices) sum += std::bit_cast<std::uint32_t>(p[i].at.x);
                 l->raw_sum = sum;
             },
             [l] { return l->raw_sum; }};
    Side thaum{{},
               [l] {
                   const World& world = *l->world;
                   std::uint32_t sum = 0;
                   for (const auto e : l->handles) {
                       sum += std::bit_cast<std::uint32_t>(world.get<Position>(e).at.x);
                   }
                   l->thaum_sum = sum;
               },
               [l] { return l->thaum_sum; }};
    return {"random_get", n, 1.0 * n, 8.0 * n, 16.0 * n, raw, thaum, calls_for(n)};
}

// ---- structure --------------------------------------------------------------------------------------------

/// Creates entities in reserved memory whose pages have been touched, or in a store that grows from
/// nothing.
Contest create_2(std::uint32_t n, bool reserved) {
    auto a = std::make_shared<Arrays>();
    auto world = std::make_shared<std::unique_ptr<World>>(new_world());
    Side raw{[=] {
                 if (!reserved) *a = {};
                 a->positions.clear();
                 a->velocities.clear();
             },
             [=] {
                 for (std::uint32_t i = 0; i < n; ++i) {
                     a->positions.push_back(position(i));
                     a->velocities.push_back(velocity(i));
                 }
             },
             [=] { return hash_of(a->positions, a->velocities); }};
    Side thaum{[=] {
                   if (reserved) {
                       (*world)->clear();
                   } else {
                       *world = new_world();
                   }
               },
               [=] {
                   World& w = **world;
                   for (std::uint32_t i = 0; i < n; ++i) w.create(position(i), velocity(i));
               },
               [=] { return hash_of(column<Position>(**world), column<Velocity>(**world)); }};
    return {"create_2", n,     1.0 * n,        24.0 * n,        24.0 * n,
            raw,        thaum, std::size_t{1}, "ns_per_entity", reserved ? "reserved" : "growing"};
}

/// Two groups of plain arrays, with and without a Push, that exchange rows.
struct Groups {
    Arrays plain, pushed;
    std::size_t plain_count = 0, pushed_count = 0;
};

std::shared_ptr<Groups> groups(std::uint32_t n) {
    auto g = std::make_shared<Groups>();
    g->plain = arrays(n);
    g->pushed = arrays(n);
    return g;
}

/// Row of entity k after entities 0 to k - 1 are gone and the last row has filled each hole.
std::size_t row_of_next(std::size_t k, std::size_t count) { return std::min(k, count - 1); }

void copy_bodies(const Arrays& from, std::size_t row, Arrays& to, std::size_t to_row) {
    to.positions[to_row] = from.positions[row];
    to.velocities[to_row] = from.velocities[row];
}

std::uint64_t hash_first(const Arrays& a, std::size_t count) {
    return hash_of(std::span(a.positions.data(), count), std::span(a.velocities.data(), count));
}

/// A World whose entities are created again before each run, in memory that is already there.
struct Crowd {
    std::unique_ptr<World> world = new_world();
    std::vector<Entity> entities;
};

std::shared_ptr<Crowd> crowd(std::uint32_t n) {
    auto c = std::make_shared<Crowd>();
    c->world->reserve_entities(n);
    c->world->reserve<Position, Velocity>(n);
    c->world->reserve<Position, Velocity, Push>(n);
    return c;
}

template <class... More>
void refill(Crowd& c, std::uint32_t n) {
    c.world->clear();
    c.entities.clear();
    for (std::uint32_t i = 0; i < n; ++i) {
        c.entities.push_back(c.world->create(position(i), velocity(i), More{}...));
    }
}

void refill(Arrays& a, std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) {
        a.positions[i] = position(i);
        a.velocities[i] = velocity(i);
    }
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
                     copy_bodies(a, --count, a, row);
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
    return {"destroy_all", n, 1.0 * n, 24.0 * n, 24.0 * n, raw, thaum};
}

Contest add_1(std::uint32_t n) {
    auto g = groups(n);
    auto c = crowd(n);
    Side raw{[=] {
                 refill(g->plain, n);
                 g->plain_count = n;
                 g->pushed_count = 0;
             },
             [=] {
                 std::size_t count = g->plain_count;
                 for (std::size_t k = 0; k < n; ++k) {
                     const auto row = row_of_next(k, count);
                     copy_bodies(g->plain, row, g->pushed, k);
                     g->pushed.pushes[k] = Push{drift};
                     copy_bodies(g->plain, --count, g->plain, row);
                 }
                 g->plain_count = count;
                 g->pushed_count = n;
             },
             [=] { return hash_first(g->pushed, g->pushed_count); }};
    Side thaum{[=] { refill<>(*c, n); },
               [=] {
                   for (const auto e : c->entities) c->world->add(e, Push{drift});
               },
               [=] { return hash_of(column<Position, Push>(*c->world), column<Velocity, Push>(*c->world)); }};
    return {"add_1", n, 1.0 * n, 84.0 * n, 60.0 * n, raw, thaum};
}

Contest remove_1(std::uint32_t n) {
    auto g = groups(n);
    auto c = crowd(n);
    Side raw{[=] {
                 refill(g->pushed, n);
                 g->pushed_count = n;
                 g->plain_count = 0;
             },
             [=] {
                 std::size_t count = g->pushed_count;
                 for (std::size_t k = 0; k < n; ++k) {
                     const auto row = row_of_next(k, count);
                     copy_bodies(g->pushed, row, g->plain, k);
                     --count;
                     copy_bodies(g->pushed, count, g->pushed, row);
                     g->pushed.pushes[row] = g->pushed.pushes[count];
                 }
                 g->pushed_count = count;
                 g->plain_count = n;
             },
             [=] { return hash_first(g->plain, g->plain_count); }};
    Side thaum{[=] { refill<Push>(*c, n); },
               [=] {
                   for (const auto e : c->entities) c->world->remove<Push>(e);
               },
               [=] { return hash_of(column<Position>(*c->world), column<Velocity>(*c->world)); }};
    return {"remove_1", n, 1.0 * n, 84.0 * n, 60.0 * n, raw, thaum};
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
                 std::vector<Position> marked;
                 for (std::uint32_t i = 0; i < n; i += 3) bits->set(i);
                 for (std::uint32_t i = 0; i < n; ++i) {
                     if (((bits->words[i / 64] >> (i % 64)) & 1U) != 0) marked.push_back(position(i));
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
                   return hash_of(column<Position, Marked>(*c->world));
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

}  // namespace

void ecs(const Options& options, Report& report) {
    using Make = Contest (*)(std::uint32_t);
    const std::array<Make, 14> cases{
        iterate_1,
        iterate_2,
        iterate_3_half,
        rare_view,
        empty_view,
        random_get,
        [](std::uint32_t n) { return create_2(n, true); },
        [](std::uint32_t n) { return create_2(n, false); },
        destroy_all,
        add_1,
        remove_1,
        tag_churn,
        snapshot,
        state_hash,
    };
    std::vector<std::uint32_t> sizes{1'000, 100'000, 1'000'000};
    if (options.quick) sizes.pop_back();
    for (const auto& make : cases) {
        for (const auto n : sizes) hold(make(n), options, report);
    }
}

}  // namespace thaum::bench
