// thaum scenario: runs gameplay scenarios, and checks that a scenario always gives the same match.
#include <algorithm>
#include <cstdio>

#include "core/environment.h"
#include "core/file.h"
#include "core/one_line.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "core/write_rule.h"
#include "game/app/command.h"
#include "game/command_line/arguments.h"
#include "game/hud/still.h"
#include "game/scenario/runner.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view scenario_help =
    R"(usage: thaum scenario [NAME|FILE ...] [--json FILE] [--out DIR]
                      [--once | --twice]

Plays scenarios (Lua scripts) through the players' own devices, faster than real
time. The log of each is replayed and must give equal hashes. Without a name: all of them.
What a script prints stands below its result.

  --json FILE   the results as JSON, replacing an older file; - for standard output
  --out DIR     folder for logs, traces and pictures; older ones are replaced
                (default: out/scenarios)
  --once        without the replay
  --twice       plays each script, and its bots, twice instead of replaying its log

The hands' forces are compared with the traces in tests/replays/forces, to the
bit; THAUM_KEEP_FORCES=tests/replays/forces records new traces.

Exit code 0: all passed; 1: one failed.
)";

render::Split split_of(Split split) {
    return split == Split::side_by_side ? render::Split::side_by_side : render::Split::top_bottom;
}

/// OpenGL context and renderer, shared by all pictures of a run. A match with other data needs a new context
/// and renderer.
class Painter {
public:
    Expected<Pixels> take(const Simulation& match, Split split, const std::filesystem::path& file) {
        if (!still_ || painted_ != &match.data()) {
            still_.reset();  // the old context must be destroyed before the next one is created
            auto still = Still::create(match.data(), find_assets(), {640, 360});
            if (!still) return still.error();
            still_ = std::make_unique<Still>(std::move(*still));
            painted_ = &match.data();
        }
        HudSettings settings;
        settings.split = split_of(split);
        auto image = still_->draw(match, settings);
        if (!file.empty()) {
            if (const auto written = render::write_png(file, image); !written) return written.error();
        }
        return Pixels{image.width, image.height, std::move(image.rgb)};
    }

private:
    std::unique_ptr<Still> still_;
    const MatchData* painted_ = nullptr;
};

/// Prints a result, and below it what the script has printed.
void print_result(const ScenarioResult& result) {
    constexpr std::size_t longest = 1000;
    std::printf("%-6s %-28s %8llu ticks  ", result.passed ? "passed" : "FAILED",
                printable(result.name, longest).c_str(), static_cast<unsigned long long>(result.ticks));
    print_line(result.message);
    for (std::string_view remaining = result.output; !remaining.empty();) {
        const auto end = std::min(remaining.find('\n'), remaining.size());
        std::string line(remaining.substr(0, end));
        std::ranges::replace(line, '\t', ' ');  // Lua's print separates its values by tabs
        std::printf("       %s\n", printable(line, longest).c_str());
        remaining.remove_prefix(std::min(end + 1, remaining.size()));
    }
}

ScenarioOptions options_of(const Arguments& arguments, Painter& painter) {
    ScenarioOptions chosen;
    chosen.assets = find_assets();
    chosen.scripts = scenarios_beside(chosen.assets);
    std::error_code unknown;
    if (!std::filesystem::exists(chosen.scripts, unknown))
        chosen.scripts = scenarios_beside(shipped_assets());
    chosen.out = arguments.value("--out").value_or("out/scenarios");
    chosen.take_picture = [&painter](const auto& match, auto split, const auto& file) {
        return painter.take(match, split, file);
    };
    if (arguments.has("--once")) chosen.same_again = SameAgain::unchecked;
    if (arguments.has("--twice")) chosen.same_again = SameAgain::by_second_run;
    chosen.read_screen = words_over_views;
    chosen.keep_forces = environment_value("THAUM_KEEP_FORCES").value_or("");
    return chosen;
}

/// Protects the scripts, and the recorded forces with which their runs are compared, from being overwritten.
void protect_scripts(const std::vector<std::filesystem::path>& scripts, const ScenarioOptions& chosen) {
    for (const auto& script : scripts) {
        protect_input(script);
        if (const auto forces = forces_folder(script, chosen); chosen.keep_forces.empty() && !forces.empty())
            protect_input(forces);
    }
}

int run_scenario(const std::vector<std::string>& words) {
    static constexpr Option options[] = {output("--json"), {"--out", 1}, {"--once"}, {"--twice"}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    const auto json = arguments->value("--json");
    Painter painter;
    const auto chosen = options_of(*arguments, painter);
    const auto scripts = find_scenarios(arguments->plain(), chosen);
    if (!scripts) return refuse(scripts.error());
    protect_scripts(*scripts, chosen);
    if (const auto made = make_folder(chosen.out); !made) return refuse(made.error());
    if (const auto free = json && json != "-" ? check_output(*json) : Expected<void>(); !free)
        return refuse(free.error());
    const auto results = run_scenarios(arguments->plain(), chosen, json == "-" ? nullptr : print_result);
    if (!results) return refuse(results.error());
    const auto report = scenario_report(*results);
    if (json == "-") {
        std::printf("%s", report.c_str());
    } else if (json) {
        if (const auto written = write_text_file(*json, report); !written) return refuse(written.error());
    }
    for (const auto& result : *results) {
        if (!result.passed) return does_not_hold;
    }
    return done;
}

const CommandRegistration registration_of_scenario({.name = "scenario",
                                                    .help = scenario_help,
                                                    .run = run_scenario});

}  // namespace

}  // namespace thaum::game::inline app
