// The haptic mode `follow`, in which a hand slides along a flow, lets a hand find its way without sight: a
// bot that knows only its own positions and the force finds the hidden core of 30 orbs at least twice as fast
// as the same bot without forces, in the median. The bot is the scenario follow_mode_guides_blind.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/file.h"
#include "core/text.h"
#include "game/scenario/runner.h"

namespace thaum::game::test {
namespace {

constexpr int seeds = 30;
/// Time after which a bot gives up its search (s). The wizard's focus, the energy that a hand in the orb uses
/// up, is enough for 50 s.
constexpr double limit = 45;

const std::filesystem::path root = THAUM_SOURCE_DIR;

/// Time that a bot needs to find the core with `percent` of the force (s); `limit` if it does not find the
/// core.
double search(const std::string& script, int seed, int percent) {
    const std::string_view values = "local seed, percent, limit = 1, 100, 20\n";
    auto source = script;
    const auto at = source.find(values);
    EXPECT_NE(at, std::string::npos);
    source.replace(at, values.size(),
                   text("local seed, percent, limit = ", seed, ", ", percent, ", ", limit, "\n"));
    ScenarioOptions options;
    options.assets = root / "assets";
    options.same_again = SameAgain::unchecked;
    const auto result = run_scenario_source(source, text("follow_", seed, "_", percent), options);
    EXPECT_TRUE(result.passed) << result.message;
    const std::string_view found = "found after ";
    if (!result.output.starts_with(found)) return limit;
    return std::stod(result.output.substr(found.size()));
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

TEST(OrbFollow, GuidesTheBlind) {
    const auto script =
        read_text_file(root / "tests/scenarios/follow_mode_guides_blind.lua", 1U << 20U).value();
    std::vector<double> guided, blind;
    for (int seed = 1; seed <= seeds; ++seed) {
        guided.push_back(search(script, seed, 100));
        blind.push_back(search(script, seed, 0));
    }
    const auto gave_up = [](const std::vector<double>& times) { return std::ranges::count(times, limit); };
    EXPECT_LE(gave_up(guided), 1) << "with forces hardly any core stays hidden";
    EXPECT_GE(median(blind), 2 * median(guided));
    RecordProperty("guided_s", text(median(guided)));
    RecordProperty("blind_s", text(median(blind)));
    RecordProperty("guided_gave_up", text(gave_up(guided)));
    RecordProperty("blind_gave_up", text(gave_up(blind)));
}

}  // namespace
}  // namespace thaum::game::test
