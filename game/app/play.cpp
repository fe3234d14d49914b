// thaum play: a match.
#include <cstdio>
#include <cstdlib>

#include "core/text.h"
#include "game/app/arguments.h"
#include "game/app/command.h"
#include "game/app/offscreen_duel.h"

namespace thaum::app {
namespace {

constexpr std::string_view help =
    R"(usage: thaum [play] [--vs | --solo LEVEL | --demo] [OPTIONS]

A duel in a window. Every match is recorded; `thaum replay` plays it again.

  --vs             two players: mouse and keyboard against a pad, or against the
                   keypad where there is no pad (default)
  --solo LEVEL     against a bot (level 1)
  --demo           two bots

  --rules NAME     thaum (default); classic is not there yet
  --arena NAME     boiling_court (default)
  --set KEY=VALUE  another value for one number, such as bolt.shot.damage=12
  --seed N         of all that is random
  --record FILE    the log; default: a new file in the data folder
  --headless       no window: two bots, faster than real time
  --seconds S      ends after that; headless: 60
  --out DIR        where headless leaves duel.png, duel.thaumlog, duel.txt (out)

With no display it says so and plays headless.
)";

constexpr Option options[] = {{"--vs"},       {"--solo", 1},      {"--demo"},    {"--rules", 1},
                              {"--arena", 1}, {"--set", 1, true}, {"--seed", 1}, {"--record", 1},
                              {"--headless"}, {"--seconds", 1},   {"--out", 1}};

bool display_there() {
    for (const auto* name : {"WAYLAND_DISPLAY", "DISPLAY"}) {
        const char* value = std::getenv(name);
        if (value != nullptr && *value != '\0') return true;
    }
    return false;
}

int run(const std::vector<std::string>& words) {
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    if (!arguments->plain().empty()) return refuse({text("play takes no '", arguments->plain()[0], "'")});
    const auto seed = arguments->whole("--seed", 0, ~std::uint64_t{0}, 1);
    if (!seed) return refuse(seed.error());
    const auto duration = arguments->number("--seconds", 0.001, 36000, 60);
    if (!duration) return refuse(duration.error());
    game::DataChoice data;
    if (const auto arena = arguments->value("--arena")) data.arena = *arena;
    data.overrides = arguments->values("--set");
    if (!arguments->has("--headless") && !display_there())
        std::printf("no display: two bots play off-screen\n");
    OffscreenDuel duel{.assets = game::find_assets(), .data = data, .seed = *seed, .seconds = *duration};
    duel.out = arguments->value("--out").value_or("out");
    duel.log = arguments->value("--record").value_or("");
    return play_offscreen_duel(duel);
}

}  // namespace

Command play_command() { return {"play", "a match: --vs, --solo LEVEL or --demo", help, run}; }

}  // namespace thaum::app
