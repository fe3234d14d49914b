// Benchmark of the energy that passive sources of force, such as springs and walls, create at the hand. It
// plays every haptic scenario and reports the largest energy.

#include "core/file.h"
#include "core/text.h"
#include "game/hud/hud.h"
#include "game/scenario/runner.h"
#include "tests/scenes/passivity.h"
#include "tools/bench/areas.h"

namespace thaum::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_script = 1U << 20U, max_table = 128U << 20U;

bool is_haptic(const fs::path& script) {
    const auto source = read_text_file(script, max_script);
    return source && source->find(".force_") != std::string::npos;
}

game::ScenarioOptions options_in(const fs::path& folder) {
    game::ScenarioOptions options;
    options.assets = game::find_assets();
    options.scripts = game::scenarios_beside(options.assets);
    options.out = folder;
    options.same_again = game::SameAgain::unchecked;
    options.read_screen = game::words_over_views;
    // The pictures are not used here, so an empty one is enough.
    options.take_picture = [](const auto&, auto, const auto&) -> Expected<game::Pixels> {
        return game::Pixels{1, 1, {0, 0, 0}};
    };
    return options;
}

}  // namespace

void passivity(Report& report) {
    const TemporaryFolder folder;
    const auto options = options_in(folder.path());
    const auto scripts = game::find_scenarios({}, options);
    if (!scripts || folder.path().empty()) {
        report.faults.push_back(
            text("haptics passivity: ", scripts ? "no temporary folder" : scripts.error().message));
        return;
    }
    PassiveEnergy all;
    std::string worst;
    std::int64_t count = 0;
    for (const auto& script : *scripts) {
        if (!is_haptic(script)) continue;
        const auto result = game::run_scenario(script, options);
        const auto csv = read_text_file(options.out / (result.name + ".forces.csv"), max_table);
        const auto energy = csv ? passive_energy(*csv) : Expected<PassiveEnergy>(csv.error());
        if (!result.passed || !energy) {
            report.faults.push_back(text("haptics passivity: scenario ", result.name, ": ",
                                         result.passed ? energy.error().message : result.message));
            continue;
        }
        ++count;
        if (worst.empty() || energy->created > all.created) worst = result.name;
        all.created = std::max(all.created, energy->created);
        all.held = std::max(all.held, energy->held);
        all.moved += energy->moved;
    }
    report.rows.push_back({.area = "haptics",
                           .name = "passivity",
                           .setting = {{"worst", worst}},
                           .metrics = {{"energy_j", all.created},
                                       {"held_j", all.held},
                                       {"moved_j", all.moved},
                                       {"scenarios", static_cast<double>(count)}}});
}

}  // namespace thaum::bench
