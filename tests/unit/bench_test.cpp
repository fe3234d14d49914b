// Tests of the benchmark framework: format of the report, Pareto front, stopwatch, and count of
// allocations.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/bench.h"
#include "tools/bench/invariants.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

Row row(std::string name, std::int64_t n, double us, double error) {
    Row r;
    r.area = "made_up";
    r.name = std::move(name);
    r.setting = {{"solver", std::string("thaum")}, {"n", n}};
    r.time_us = Times{us / 2, us, us * 2};
    r.error = ErrorMeasure{"rms", error};
    return r;
}

/// An invented report with two cases. In case "a" the third row is slower and less accurate than the second,
/// and the fourth is as accurate as the first but slower.
Report made_up() {
    auto report = empty_report();
    report.rows = {row("a", 16, 10, 0.1), row("a", 32, 20, 0.01), row("a", 33, 30, 0.02),
                   row("a", 15, 11, 0.1), row("b", 16, 99, 0.5)};
    report.rows[1].is_default = true;
    report.rows[1].hash = "00ff";
    report.rows[1].metrics = {{"ns_per_entity", 1.25}};
    return report;
}

TEST(BenchReport, FrontHoldsTheRowsThatNoOtherRowBeats) {
    auto rows = made_up().rows;
    mark_fronts(rows);
    std::vector<bool> fronts;
    for (const auto& r : rows) fronts.push_back(r.front);
    EXPECT_EQ(fronts, (std::vector<bool>{true, true, false, false, true}));
}

TEST(BenchReport, EqualRowsShareTheFrontAndRowsWithoutAnErrorOrWithAFailedOneAreNotOnIt) {
    std::vector<Row> rows{row("a", 1, 10, 0.1), row("a", 2, 10, 0.1), row("a", 3, 1, 0), row("a", 4, 1, 0)};
    rows[2].error.reset();
    rows[3].error->value = std::numeric_limits<double>::quiet_NaN();
    mark_fronts(rows);
    EXPECT_TRUE(rows[0].front && rows[1].front);
    EXPECT_FALSE(rows[2].front || rows[3].front);
}

TEST(BenchReport, JsonHasTheFieldsOfTheInterface) {
    auto report = made_up();
    mark_fronts(report.rows);
    const auto json = nlohmann::json::parse(to_json(report));
    EXPECT_FALSE(json.at("thaum").get<std::string>().empty());
    EXPECT_TRUE(json.at("machine").at("cpu").is_string());
    EXPECT_GE(json.at("machine").at("cores").get<int>(), 1);
    EXPECT_TRUE(json.at("machine").at("build").is_string());
    const auto& r = json.at("rows").at(1);
    EXPECT_EQ(r.at("area"), "made_up");
    EXPECT_EQ(r.at("case"), "a");
    EXPECT_EQ(r.at("setting").at("solver"), "thaum");
    EXPECT_TRUE(r.at("setting").at("n").is_number_integer());
    EXPECT_EQ(r.at("time_us"), (nlohmann::json{{"min", 10.0}, {"median", 20.0}, {"p99", 40.0}}));
    EXPECT_EQ(r.at("error"), (nlohmann::json{{"name", "rms"}, {"value", 0.01}}));
    EXPECT_EQ(r.at("front"), true);
    EXPECT_EQ(r.at("default"), true);
    EXPECT_EQ(r.at("metrics").at("ns_per_entity"), 1.25);
    EXPECT_EQ(r.at("hash"), "00ff");
}

TEST(BenchReport, JsonLeavesOutMissingValues) {
    auto report = empty_report();
    report.rows.push_back({.area = "made_up", .name = "bare"});
    const auto r = nlohmann::json::parse(to_json(report)).at("rows").at(0);
    for (const auto* key : {"time_us", "error", "metrics", "hash"}) EXPECT_FALSE(r.contains(key)) << key;
    EXPECT_TRUE(r.at("setting").is_object());
}

TEST(BenchReport, TableHasAColumnForEverySettingAndMetricAndMarksFrontAndDefault) {
    auto report = made_up();
    mark_fronts(report.rows);
    const auto table = to_table(report);
    for (const auto* part : {"made_up\n", "case", "solver", "median us", "rms", "mark", "ns_per_entity",
                             "hash", "1.25", "00ff", "*d"}) {
        EXPECT_NE(table.find(part), std::string::npos) << part << " is missing in\n" << table;
    }
}

TEST(BenchReport, ARowThatBreaksItsInvariantIsMarkedAndIsAFault) {
    auto report = empty_report();
    report.rows = {{.area = "replay", .name = "verify", .metrics = {{"compared", 78}, {"mismatches", 78}}},
                   {.area = "replay", .name = "verify", .metrics = {{"compared", 0}, {"mismatches", 0}}},
                   {.area = "replay", .name = "verify", .metrics = {{"compared", 78}, {"mismatches", 0}}},
                   {.area = "tick", .name = "alloc", .metrics = {{"allocations", 178}, {"shots", 9}}},
                   {.area = "replay", .name = "verify", .metrics = {{"compared", 78}}},
                   {.area = "made_up", .name = "nan", .metrics = {{"us", std::nan("")}}},
                   row("infinite", 1, 1, std::numeric_limits<double>::infinity()),
                   {.area = "fluid",
                    .name = "gaussian_turn",
                    .setting = {{"solver", "classic"}},
                    .metrics = {{"amount_change", -0.4}}}};
    check_invariants(report);
    EXPECT_EQ(report.rows[7].fault, "") << "the baseline may lose amounts";
    EXPECT_EQ(report.rows[0].fault, "mismatches is 78, must be 0");
    EXPECT_EQ(report.rows[1].fault, "compared is 0, must be at least 1");
    EXPECT_EQ(report.rows[2].fault, "");
    EXPECT_EQ(report.rows[3].fault, "allocations is 178, must be 0");
    EXPECT_EQ(report.rows[4].fault, "mismatches is missing");
    EXPECT_EQ(report.rows[5].fault, "us is not finite");
    EXPECT_EQ(report.rows[6].fault, "rms is not finite");
    ASSERT_EQ(report.faults.size(), 6U);
    EXPECT_EQ(report.faults[0], "replay verify: mismatches is 78, must be 0");
    EXPECT_NE(to_table(report).find('!'), std::string::npos);
    const auto read = from_json(to_json(report)).value();
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(read.rows[i].fault, report.rows[i].fault);
}

TEST(BenchReport, ABaselineThatMayDivergeMayHaveAnInfiniteErrorAndNothingElse) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    auto report = empty_report();
    report.rows = {row("diverged", 1, 1, infinity), row("broken", 1, 1, std::nan("")),
                   row("diverged", 1, 1, infinity)};
    for (auto& row : report.rows) row.error->may_diverge = true;
    report.rows[2].metrics = {{"us", infinity}};
    check_invariants(report);
    EXPECT_EQ(report.rows[0].fault, "");
    EXPECT_EQ(report.rows[1].fault, "rms is not finite");
    EXPECT_EQ(report.rows[2].fault, "us is not finite");
}

TEST(BenchRun, ReplaysHaveNoFault) {
    auto report = empty_report();
    Options options;
    options.quick = true;
    replay(options, report);
    check_invariants(report);
    ASSERT_EQ(report.rows.size(), 2U);
    for (const auto& row : report.rows) EXPECT_EQ(row.fault, "") << row.name;
}

TEST(BenchMeasure, ContestantsAreCalledEquallyOftenAndSetupIsNotTimed) {
    int setups = 0;
    std::array<int, 2> runs{};
    const std::array<Contestant, 2> two{
        Contestant{[&] {
                       ++setups;
                       std::this_thread::sleep_for(std::chrono::milliseconds(20));
                   },
                   [&] { ++runs[0]; }},
        Contestant{{}, [&] { ++runs[1]; }}};
    const auto samples = measure(two, {.seconds = 0, .least = 5, .most = 100, .calls = 3});
    ASSERT_EQ(samples.size(), 2U);
    EXPECT_EQ(samples[0].size(), 5U);
    EXPECT_EQ(samples[1].size(), 5U);
    EXPECT_EQ(setups, 6);  // 5 counted rounds, and a first one, which is not counted
    EXPECT_EQ(runs, (std::array{18, 18}));
    EXPECT_LT(times(samples[0]).min, 5000);
}

TEST(BenchMeasure, ASleepTakesItsTime) {
    const std::array<Contestant, 2> two{
        Contestant{{}, [] { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }},
        Contestant{{}, [] {}}};
    const auto samples = measure(two, {.seconds = 0, .least = 3});
    EXPECT_GE(times(samples[0]).min, 2000);
    EXPECT_GT(ratio(samples[0], samples[1]), 1);
}

TEST(BenchMeasure, PercentilesAreNearestRanks) {
    std::vector<double> samples;
    for (int i = 100; i >= 1; --i) samples.push_back(i);
    const auto t = times(samples);
    EXPECT_EQ(t.min, 1);
    EXPECT_EQ(t.median, 50);
    EXPECT_EQ(t.p99, 99);
    EXPECT_EQ(percentile({7}, 0.99), 7);
    EXPECT_EQ(ratio(std::array{2.0, 30.0, 8.0}, std::array{1.0, 10.0, 2.0}), 3);
}

TEST(BenchAllocations, EveryKindIsCountedInEveryThread) {
    if (!allocations_are_counted()) GTEST_SKIP() << "not under a sanitizer";
    const auto before = allocation_count();
    const auto one = std::make_unique<int>(1);
    do_not_optimise(one.get());
    EXPECT_EQ(allocation_count(), before + 1);

    void* memory = std::realloc(std::calloc(1, 8), 4096);
    do_not_optimise(memory);
    std::free(memory);
    memory = std::aligned_alloc(64, 128);
    do_not_optimise(memory);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % 64, 0U);
    std::free(memory);
    EXPECT_EQ(allocation_count(), before + 4);

    std::jthread([] { do_not_optimise(std::make_unique<int>(2).get()); }).join();
    EXPECT_GT(allocation_count(), before + 4);
}

TEST(BenchRun, AStressThatAnAreaDoesNotHaveIsRefused) {
    Options options;
    options.areas = {"ecs"};
    options.stress = true;
    EXPECT_EQ(run(options), 2);
}

TEST(BenchRun, ASoakComesToTheSameStatesAloneAndSideBySide) {
    auto report = empty_report();
    Options options;
    options.ticks = 3000;
    soak(options, report);
    ASSERT_EQ(report.rows.size(), 3U);
    for (const auto& row : report.rows) EXPECT_EQ(row.hash, report.rows[0].hash);
    EXPECT_TRUE(report.faults.empty()) << report.faults[0];
    report.faults = {"something"};
    EXPECT_EQ(nlohmann::json::parse(to_json(report))["faults"], nlohmann::json({"something"}));
}

TEST(BenchRun, AnUnknownAreaIsRefused) {
    Options options;
    options.areas = {"no_such_area"};
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(options), 2);
    const auto message = testing::internal::GetCapturedStderr();
    EXPECT_NE(message.find("no_such_area"), std::string::npos);
    EXPECT_NE(message.find("ecs"), std::string::npos);
}

// ---- rows of the physics benchmark ------------------------------------------------------------------------

template <class T>
T setting(const Row& row, std::string_view name) {
    for (const auto& item : row.setting) {
        if (item.first == name) return std::get<T>(item.second);
    }
    return T{};
}

double metric(const Row& row, std::string_view name) {
    for (const auto& item : row.metrics)
        if (item.first == name) return item.second;
    return std::nan("");
}

/// Expects that a benchmark's `row` is not more accurate than `ours`, the row with the shipped settings.
/// Errors of single solutions are compared directly. Errors of stacks of boxes are random, so the confidence
/// intervals of their medians are compared.
void expect_not_beaten(const Row& ours, const Row& row, const std::string& name) {
    if (row.name != "stack") {
        EXPECT_LE(ours.error->value, row.error->value + 1e-9) << name;
        return;
    }
    EXPECT_LE(metric(ours, "error_low_m"), metric(row, "error_high_m")) << name;
    // The confidence intervals must be narrow enough to show that a larger time step is less accurate.
    if (setting<std::int64_t>(row, "dt_ms") > setting<std::int64_t>(ours, "dt_ms")) {
        EXPECT_LT(metric(ours, "error_high_m"), metric(row, "error_low_m")) << name;
    }
}

TEST(BenchPhysics, TheShippedStepIsOnTheFrontOfError) {
    Report report = empty_report();
    Options options;
    options.quick = true;
    physics(options, report);
    std::map<std::string, const Row*> shipped;
    for (const auto& row : report.rows) {
        if (!row.is_default) continue;
        ASSERT_TRUE(shipped.emplace(row.name, &row).second) << row.name;
    }
    ASSERT_EQ(shipped.size(), 4U);
    EXPECT_TRUE(report.faults.empty()) << report.faults.front();
    EXPECT_LT(shipped.at("free_fall")->error->value, 1e-9);
    EXPECT_LT(shipped.at("projectile")->error->value, 1e-9);
    for (const auto& row : report.rows) {
        ASSERT_TRUE(std::isfinite(row.error->value)) << row.name;
        // Without a row measured with the shipped settings there is nothing to compare.
        if (!shipped.contains(row.name)) continue;
        const Row& ours = *shipped.at(row.name);
        expect_not_beaten(ours, row,
                          row.name + ' ' + setting<std::string>(row, "scheme") + ' ' +
                              std::to_string(setting<std::int64_t>(row, "dt_ms")));
    }
}

}  // namespace
}  // namespace thaum::bench
