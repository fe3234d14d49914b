// thaum-bench: measures time, error and cost, and reports them as a table and as JSON. `thaum bench` starts
// this program.
#include <cstdio>

#include "core/text.h"
#include "game/app/command.h"
#include "game/app/program.h"
#include "game/command_line/arguments.h"
#include "tools/bench/bench.h"

namespace thaum::game {
namespace {

constexpr std::string_view bench_usage =
    R"(usage: thaum bench [AREA ...] [--quick | --stress [--ticks N]] [--json FILE]

Measures and prints one row for each setting of a case; without an AREA, of all:
)";

constexpr std::string_view bench_options = R"(
  --quick       at most 20 s an area: every case, at smaller sizes
  --stress      the long attack instead: tick plays ten million ticks of the best
                bots, alone and on two threads, and looks at hashes, bounds, memory;
                fluid is pushed, thickened and thinned for 100,000 steps
  --ticks N     so many ticks or steps instead
  --json FILE   the report as JSON, replacing an older one; - for stdout
)";

/// Names of the areas (groups of benchmarks), wrapped to the width of a terminal.
std::string names_of_areas() {
    constexpr std::size_t widest = 80;
    std::string result = " ";
    std::size_t wide = 1;
    for (const auto& area : bench::areas()) {
        if (wide + 1 + area.name.size() > widest) {
            result.append("\n ");
            wide = 1;
        }
        result.append(" ").append(area.name);
        wide += 1 + area.name.size();
    }
    return result.append("\n");
}

int run_bench(std::vector<std::string> words) {
    if (asks_for_help(words)) {
        std::printf("%s", text(bench_usage, names_of_areas(), bench_options).c_str());
        return done;
    }
    protect_inputs("bench");
    static constexpr Option options[] = {{"--quick"}, {"--stress"}, {"--ticks", 1}, output("--json")};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    bench::Options chosen;
    chosen.areas = arguments->plain();
    chosen.quick = arguments->has("--quick");
    chosen.stress = arguments->has("--stress");
    const auto ticks = arguments->whole("--ticks", 1, 1'000'000'000'000, 1);
    if (!ticks) return refuse(ticks.error());
    if (arguments->has("--ticks")) {
        if (!chosen.stress) return refuse({"--ticks needs --stress"});
        chosen.ticks = *ticks;
    }
    if (const auto json = arguments->value("--json")) chosen.json = *json;
    return bench::run(chosen);
}

}  // namespace

}  // namespace thaum::game

int main(int argc, char** argv) { return thaum::game::run_program(argc, argv, thaum::game::run_bench); }
