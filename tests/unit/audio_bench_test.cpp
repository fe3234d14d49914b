// Runs the benchmark of the mixer in its short form: the rows of its report must keep the bounds that hold on
// any machine. The time of a block is not tested here.
#include <gtest/gtest.h>

#include <algorithm>

#include "tools/bench/areas.h"
#include "tools/bench/invariants.h"

namespace thaum::bench {
namespace {

TEST(BenchAudio, MixingAllocatesNothingAndLevelsAreExact) {
    auto report = empty_report();
    audio({.areas = {}, .quick = true, .json = {}}, report);
    ASSERT_EQ(report.rows.size(), 6U);
    check_invariants(report);
    for (const auto& fault : report.faults) ADD_FAILURE() << fault;
    const auto max_voices = [](const Row& row) {
        const auto found = std::find_if(row.metrics.begin(), row.metrics.end(),
                                        [](const auto& metric) { return metric.first == "voices"; });
        return found == row.metrics.end() ? 0.0 : found->second;
    };
    double most = 0;
    for (const auto& row : report.rows) most = std::max(most, max_voices(row));
    EXPECT_EQ(most, 128) << "64 voices for each of two listeners";
}

}  // namespace
}  // namespace thaum::bench
