// tools/bench/bench.h: the command `thaum bench [AREA ...] [--json FILE] [--quick] [--stress]`.
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
    std::vector<std::string> areas;  ///< areas (groups of benchmarks) to run; empty: all
    /// true: run every case at smaller sizes, so that each area (group of benchmarks) takes at most 20 s.
    bool quick = false;
    bool stress = false;  ///< true: run the long stress tests of the areas (groups of benchmarks) instead
    std::optional<std::uint64_t> ticks{};       ///< length of a stress test (ticks); std::nullopt: its full
                                                ///< length
    std::optional<std::filesystem::path> json;  ///< file for the report; "-": standard output
};

struct Area {
    std::string_view name;
    /// Function that measures the area (group of benchmarks) and appends its rows to the report.
    void (*run)(const Options& options, Report& report);
    /// Stress test of the area (group of benchmarks); null: it has none.
    void (*stress)(const Options& options, Report& report) = nullptr;
};

/// All areas (groups of benchmarks) in the order in which they run. To add an area, add a line to areas.cpp.
std::span<const Area> areas();

/// Runs the areas (groups of benchmarks), prints the table and writes the JSON. Returns the exit code: 0; 1
/// if a row breaks an invariant, an area has measured nothing or a stress test has found a fault; 2 if the
/// JSON cannot be written, an area is unknown, or an area has no stress test.
int run(const Options& options);

}  // namespace thaum::bench
