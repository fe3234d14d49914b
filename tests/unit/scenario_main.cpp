// run_scenario SCRIPT [OUT]: one scenario, for CTest. 0: passed, 1: failed, 77: it needs pictures, and there are none here.
#include <cstdio>

#include "game/scenario/runner.h"

int main(int count, char** arguments) {
    using namespace thaum::game;
    if (count < 2) return 2;
    ScenarioOptions options;
    options.assets = std::filesystem::path(THAUM_SOURCE_DIR) / "assets";
    options.scripts = scenarios_beside(options.assets);
    if (count > 2) options.out = arguments[2];
    const auto results = run_scenarios({arguments[1]}, options, [](const ScenarioResult& result) {
        std::printf("%s%s %s: %llu ticks%s%s\n", result.output.c_str(), result.passed ? "passed" : "FAILED",
                    result.name.c_str(), static_cast<unsigned long long>(result.ticks),
                    result.message.empty() ? "" : ": ", result.message.c_str());
        for (const auto& file : result.files) std::printf("  %s\n", file.c_str());
    });
    if (!results) {
        std::fprintf(stderr, "%s\n", results.error().message.c_str());
        return 2;
    }
    const auto& result = results->front();
    return result.passed ? 0 : result.no_picture ? 77 : 1;
}
