// tools/bench/ecs_contest.h: the cases of the ECS benchmark. Each compares plain arrays ("raw") with a World.
#pragma once
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "tools/bench/ecs_things.h"
#include "tools/bench/report.h"

namespace thaum::bench::things {

struct Side {
    std::function<void()> setup;  ///< runs before each run; empty: runs can follow each other without it
    std::function<void()> run;
    std::function<std::uint64_t()> result;  ///< hash of the data; called once, after one run
};

struct Contest {
    std::string_view name;
    std::uint32_t n{};
    double matches{};      ///< number of entities that one run visits; the reported times are per entity
    double bytes{};        ///< number of bytes that the raw arrays read and write in one run
    double working_set{};  ///< size of the raw arrays' data (bytes)
    Side raw, thaum;
    std::size_t calls = 1;
    std::string unit = "ns_per_entity";
    std::optional<std::pair<std::string, Value>> setting{};  ///< additional setting in the row of the report
};

/// Number of runs per sample. Short runs are repeated, because the clock is too coarse for them.
inline std::size_t calls_for(std::uint32_t n) { return std::max<std::size_t>(1, 100'000 / n); }

// Cases that iterate over components or read them at random (ecs_iteration.cpp).

Contest iterate_1(std::uint32_t n);
Contest iterate_2(std::uint32_t n);
Contest iterate_3_half(std::uint32_t n);
Contest rare_view(std::uint32_t n);
/// Views over a component that one entity had once and none has any more.
Contest empty_view(std::uint32_t n);
/// Reads one component of all entities in random order: the smallest, the middle or the largest one.
template <class C>
Contest random_get(std::uint32_t n);

// Cases that create, destroy or change entities, or read the whole state (ecs_structure.cpp).

/// Creates entities in reserved memory whose pages have already been written, or in memory that grows from
/// nothing. All entities have the same Motion, because computing different ones would cost more than storing
/// them.
Contest create_3(std::uint32_t n, bool reserved);
Contest destroy_all(std::uint32_t n);
Contest add_1(std::uint32_t n);
Contest remove_1(std::uint32_t n);
/// Sets the tag on all entities, then clears it on all. Finally every third entity gets it again, so that the
/// hash depends on it.
Contest tag_churn(std::uint32_t n);
Contest snapshot(std::uint32_t n);
/// Hashes a whole World. The plain arrays ("raw") are only copied by memcpy and not hashed, so the results of
/// the two differ.
Contest state_hash(std::uint32_t n);

}  // namespace thaum::bench::things
