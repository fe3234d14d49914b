// tools/bench/ecs_bench.cpp: compares the World (the store of entities and components) with plain arrays,
// case by case.
//
// The entities are loose objects, and their components are as large as those of the game (ecs_things.h). The
// plain arrays, `raw`, are a lower limit of the time and no usable design: 64-byte aligned arrays, one per
// component, without handles and checks. If only some entities match a query, the arrays hold those entities
// next to each other. In each case `raw` uses the fastest layout:
//     iterate_2        one loop; with vectors switched off it takes as long, and so does EnTT's order, pages
//                      of 1,024 rows from last to first
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
#include <cstring>

#include "core/text.h"
#include "tools/bench/areas.h"
#include "tools/bench/ecs_contest.h"
#include "tools/bench/measure.h"

namespace thaum::bench::things {
namespace {

/// Copies between the two halves of a buffer of `size` bytes, often enough for the clock's resolution.
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
    double ratio;  ///< largest allowed ratio of the World's time to that of plain arrays; 0: no such target
    double ns;     ///< largest allowed time in the unit of the case; 0: no such target
    std::uint32_t min_n;  ///< smallest number of entities to which the target applies
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
    if (target == targets.end() || contest.n < target->min_n) return;
    if (target->ratio > 0) row.metrics.emplace_back("target_ratio", target->ratio);
    if (target->ns > 0) row.metrics.emplace_back("target_ns", target->ns);
    row.metrics.emplace_back("target_met", ratio_to_raw <= target->ratio || ns <= target->ns ? 1 : 0);
}

using Make = Contest (*)(std::uint32_t);

/// Hashes of the plain arrays and of the World after one run on fresh data. After the timed runs they would
/// differ from one call of the program to the next, since the number of runs depends on their time.
std::pair<std::string, std::string> hashes(Make make, std::uint32_t n) {
    const auto hash = [](const Side& side) {
        if (side.setup) side.setup();
        side.run();
        return hex(side.result());
    };
    const auto fresh = make(n);
    return {hash(fresh.raw), hash(fresh.thaum)};
}

void hold(Make make, std::uint32_t n, const Options& options, Report& report) {
    const auto [raw_hash, thaum_hash] = hashes(make, n);
    const auto contest = make(n);
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
    raw.hash = raw_hash;
    auto thaum = row_of(contest, "thaum", samples[1]);
    const double ns = thaum.metrics.back().second;
    const double ratio_to_raw = ratio(samples[1], samples[0]);
    thaum.metrics.emplace_back("ratio_to_raw", ratio_to_raw);
    thaum.metrics.emplace_back("min_ratio_to_raw", thaum.time_us->min / raw.time_us->min);
    judge(contest, ns, ratio_to_raw, thaum);
    thaum.hash = thaum_hash;
    report.rows.push_back(std::move(raw));
    report.rows.push_back(std::move(thaum));
}

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
        for (const auto n : sizes) things::hold(make, n, options, report);
    }
}
