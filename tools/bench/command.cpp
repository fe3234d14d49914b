// thaum bench: time, error and cost, as a table and as JSON. It stands here and not with the other commands, since
// the game must not include its tools.
#include "game/app/command.h"
#include "game/app/arguments.h"
#include "tools/bench/bench.h"

namespace thaum::app {
namespace {

constexpr std::string_view help =
    R"(usage: thaum bench [AREA ...] [--quick] [--json FILE]

Measures and prints one row for each setting of a case. Areas: ecs, tick,
physics, replay, skip; without one, all.

  --quick       at most 20 s an area: every case, at smaller sizes
  --json FILE   the report as JSON; - for standard output
)";

int run(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--quick"}, {"--json", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    bench::Options chosen;
    chosen.areas = arguments->plain();
    chosen.quick = arguments->has("--quick");
    if (const auto json = arguments->value("--json")) chosen.json = *json;
    return bench::run(chosen);
}

}  // namespace

Command bench_command() { return {"bench", "measure time against error", help, run}; }

}  // namespace thaum::app
