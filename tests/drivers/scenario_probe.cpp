// scenario_probe SCRIPT: plays a scenario once, without pictures. Builds with the thread sanitizer use this
// program instead of `thaum scenario --once`.
#include <cstdio>

#include "game/data/match_data.h"
#include "game/scenario/runner.h"

using namespace thaum::game;

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const auto result = run_scenario(argv[1], {.assets = find_assets(), .same_again = SameAgain::unchecked});
    std::printf("%s: %s\n", result.name.c_str(), result.passed ? "passed" : result.message.c_str());
    return result.passed ? 0 : 1;
}
