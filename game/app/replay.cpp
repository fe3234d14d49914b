// thaum replay: a log played again, checked, dumped or watched.
#include <chrono>
#include <cstdio>

#include "core/file.h"
#include "core/text.h"
#include "game/app/arguments.h"
#include "game/app/command.h"
#include "game/app/watch.h"
#include "game/match/playback.h"

namespace thaum::app {
namespace {

constexpr std::string_view help =
    R"(usage: thaum replay LOG [--verify] [--at S] [--dump TICK FILE] [--out DIR]

Replays a recorded match. The log holds what came from the devices; everything
else is computed again, without bots and devices.

  (nothing)         watch it in a window
  --at S            from second S on; with no display: one picture of that
                    moment and its state in --out (default: out)
  --verify          compute it all and compare every state hash; exit 1 at the
                    first that differs, naming its tick
  --dump TICK FILE  write the whole state at a tick, for `thaum diff`
)";

void warn(const std::string& line) {
    if (!line.empty()) std::fprintf(stderr, "thaum: %s\n", line.c_str());
}

int verify(game::Playback& playback) {
    const auto start = std::chrono::steady_clock::now();
    std::size_t compared = 0;
    while (playback.step()) {
        if (const auto wrong = playback.mismatch()) {
            std::printf("tick %llu: state differs: the log has %s, here it is %s\n",
                        static_cast<unsigned long long>(wrong->tick), hex(wrong->state).c_str(),
                        hex(playback.match().state_hash()).c_str());
            return does_not_hold;
        }
        compared += playback.log().hash_at(playback.match().now()) ? 1U : 0U;
    }
    if (playback.log().ending() == input::LogEnding::damaged) {
        std::printf("%s\n", playback.log().ending_reason().c_str());
        return does_not_hold;
    }
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double played = seconds(playback.match().now());
    std::printf("%llu ticks, %zu state hashes agree; %s (%s s, %s x real time)\n",
                static_cast<unsigned long long>(playback.match().now()), compared,
                game::result_line(playback.match()).c_str(), fixed(took, 2).c_str(),
                fixed(played / took, 1).c_str());
    return done;
}

int dump(game::Playback& playback, const std::vector<std::string>& values) {
    const auto tick = parse_whole(values[0], "--dump", 0, ~std::uint64_t{0});
    if (!tick) return refuse(tick.error());
    if (!playback.play_to(*tick)) {
        return refuse({text("--dump ", *tick, ": the log has ", playback.log().ticks(), " ticks")});
    }
    Bytes state;
    playback.match().save(state);
    if (const auto written = write_file(values[1], state); !written) return refuse(written.error());
    std::printf("tick %llu: state %s written to %s\n", static_cast<unsigned long long>(*tick),
                hex(playback.match().state_hash()).c_str(), values[1].c_str());
    return done;
}

int run(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--verify"}, {"--at", 1}, {"--dump", 2}, {"--out", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    if (arguments->plain().size() != 1)
        return refuse({"replay needs one log; `thaum replay --help` tells more"});
    auto playback = game::Playback::open(arguments->plain()[0], game::find_assets());
    if (!playback) return refuse(playback.error());
    warn(game::probe_warning(playback->log().header()));
    if (!playback->log().ended_cleanly()) warn(playback->log().ending_reason());
    if (arguments->has("--verify")) return verify(*playback);
    if (arguments->has("--dump")) return dump(*playback, arguments->values("--dump"));
    const auto at = arguments->number("--at", 0, 1e6, 0);
    if (!at) return refuse(at.error());
    if (!playback->play_to(ticks(*at))) {
        return refuse(
            {text("--at ", *at, ": the log has ", fixed(seconds(playback->log().ticks()), 1), " s")});
    }
    return watch(std::move(*playback), arguments->value("--out").value_or("out"));
}

}  // namespace

Command replay_command() { return {"replay", "play a recorded match again, or check it", help, run}; }

}  // namespace thaum::app
