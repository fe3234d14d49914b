// tools/bench/bench.h: `thaum bench [AREA ...] [--json FILE] [--quick] [--stress]`.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/bench/report.h"

namespace thaum::bench {

struct Options {
    std::vector<std::string> areas;             ///< empty: all
    bool quick = false;                         ///< at most 20 s an area: every case, at smaller sizes
    bool stress = false;                        ///< the areas' long stability attacks instead
    std::optional<std::uint64_t> ticks{};       ///< of a stress; none: as long as it is meant to be
    std::optional<std::filesystem::path> json;  ///< "-": standard output
};

struct Area {
    std::string_view name;
    void (*run)(const Options& options, Report& report);               ///< appends rows
    void (*stress)(const Options& options, Report& report) = nullptr;  ///< the same; null: it has none
};

/// In the order in which they run. A new area is one line in areas.cpp.
std::span<const Area> areas();

/// Runs, prints the table and writes the JSON. The exit code: 0; 1 where a row breaks its own
/// invariant, an area has measured nothing or a stress has found a fault; 2 where the JSON cannot be written, and for
/// an unknown area or one without the stress asked for.
int run(const Options& options);

}  // namespace thaum::bench
