// thaum shots: makes the README's pictures from a replay.
#include "game/app/shots.h"
#include "core/file.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/command_line/arguments.h"
#include "game/match/highlight.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view shots_help =
    R"(usage: thaum shots LOG --out DIR

Makes the README's pictures from a recorded match; needs no display.

  --out DIR   folder for duel.png, which replaces an older one: the moment at which the two
              wizards were closest while player 1 saw the other and something flew
)";

/// Plays the replay to its end and returns its highlight, the moment that makes the best picture.
Highlight find_highlight(Playback& playback) {
    Highlight best;
    while (playback.step()) watch_for_highlight(playback.match(), best);
    return best;
}

int run_shots(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--out", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    const auto out = arguments->value("--out");
    if (arguments->plain().size() != 1 || !out)
        return refuse({"shots needs one log and --out; see `thaum shots --help`"});
    const auto& log = arguments->plain()[0];
    const auto file = std::filesystem::path(*out) / "duel.png";
    if (const auto made = make_folder(*out); !made) return refuse(made.error());
    if (const auto free = check_output(file); !free) return refuse(free.error());
    auto playback = Playback::open(log, find_assets());
    if (!playback) return refuse(playback.error());
    const Highlight best = find_highlight(*playback);
    if (playback->divergence()) {
        refuse({text(log, ": ", described(*playback->divergence()))});
        return does_not_hold;
    }
    if (best.tick == 0)
        return refuse({text(log, ": the two wizards never meet in this log; take a longer match")});
    playback = Playback::open(log, find_assets());
    if (!playback) return refuse(playback.error());
    const auto& match = playback->match();
    const auto senses = senses_of(match.data(), find_assets());
    while (match.now() < best.tick) {
        if (!playback->step())
            return refuse({text(log, ": the file changed while it was read; start again")});
        if (senses) senses->follow(match);
    }
    auto still = Still::create(match.data(), find_assets(), {1280, 720});
    if (!still) return refuse(still.error());
    if (const auto saved = still->save(match, hud_of(*playback), file, senses.get()); !saved)
        return refuse(saved.error());
    print_line(text("tick ", best.tick, " in ", file.string()));
    return done;
}

const CommandRegistration registration_of_shots({.name = "shots", .help = shots_help, .run = run_shots});

}  // namespace

}  // namespace thaum::game::inline app
