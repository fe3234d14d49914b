#include "game/app/offscreen_duel.h"

#include <cstdio>

#include "core/file.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/bots/duel.h"
#include "game/hud/still.h"
#include "game/match/highlight.h"
#include "game/match/playback.h"
#include "game/match/record.h"
#include "game/match/result.h"

namespace thaum::game::inline app {
namespace {

struct Played {
    BotDuel duel;
    Highlight highlight;
    std::optional<Error> log_fault;  ///< reason why the log is not complete
};

Expected<Played> play(const OffscreenDuel& plan, const std::shared_ptr<const MatchData>& data,
                      const std::filesystem::path& log_file) {
    auto duel = make_bot_duel(plan.assets, data, plan.bots, plan.seed);
    if (!duel) return duel.error();
    Played played{std::move(*duel), {}, {}};
    auto& match = *played.duel.match;
    auto log = input::LogWriter::create(
        log_file, log_header(*data, match.setup(), {text("bot ", plan.bots[0]), text("bot ", plan.bots[1])}),
        input::WhenBehind::wait);
    if (!log) return log.error();
    std::optional<Tick> over_at;
    while (over_at ? match.now() < *over_at + log_after_end : match.now() < ticks(plan.seconds)) {
        tick_and_record(match, played.duel.next_frame(), &*log);
        if (!over_at) watch_for_highlight(match, played.highlight);
        if (!over_at && match.match().phase == Phase::over) over_at = match.now();
    }
    if (auto closed = close_log(*log, match); !closed) played.log_fault = closed.error();
    return played;
}

struct Picture {
    std::string line;            ///< path of the picture, or the reason why there is none
    std::optional<Error> fault;  ///< error if a drawn picture could not be saved
};

/// Draws and saves the highlight of the duel, the moment that makes the best picture. Its tick is known only
/// at the end, so this replays the log up to it. Without a highlight, or if the log ends before it, the
/// picture shows the end of the duel.
Expected<void> save_highlight(Still& still, const OffscreenDuel& duel, const Played& played,
                              const std::filesystem::path& log, const std::filesystem::path& file) {
    if (played.highlight.tick != 0) {
        auto again = Playback::open(log, duel.assets);
        if (again && again->play_to(played.highlight.tick)) return still.save(again->match(), {}, file);
    }
    return still.save(*played.duel.match, {}, file);
}

/// Draws and saves the picture of the duel, unless this machine cannot draw.
Picture picture(const OffscreenDuel& duel, const std::shared_ptr<const MatchData>& data, const Played& played,
                const std::filesystem::path& log) {
    auto still = Still::create(*data, duel.assets, {1280, 720});
    if (!still) return {text("none: ", still.error().message), {}};
    const auto file = duel.out / "duel.png";
    if (const auto saved = save_highlight(*still, duel, played, log, file); !saved)
        return {text("none: ", saved.error().message), saved.error()};
    return {file.string(), {}};
}

/// ", mutators fog, one_wand"; empty without any.
std::string mutator_words(const DataChoice& choice) {
    std::string words;
    for (const auto& name : choice.mutators) words += text(words.empty() ? ", mutators " : ", ", name);
    return words;
}

std::string report(const OffscreenDuel& duel, const Played& played, const std::filesystem::path& log,
                   const std::string& picture_line) {
    const auto& match = *played.duel.match;
    const auto& world = match.world();
    std::string lines =
        text("Thaum ", THAUM_VERSION, ", duel in ", match.data().arena.name, ", seed ", duel.seed, "\n");
    lines += text("result   ", result_line(match), "\n");
    lines += text("bots     ", duel.bots[0], " and ", duel.bots[1], ", rules ", duel.data.rules, ", match ",
                  duel.data.match, mutator_words(duel.data), "\n");
    lines += result_table(match);
    lines += text("ticks    ", match.now(), " of 1 ms\n");
    lines += text("state    ", hex(match.state_hash()), "\n");
    lines += text("physics  ", match.physics().counters().steps, " steps, ",
                  match.physics().counters().skipped, " skipped asleep\n");
    lines += text("world    ", world.size(), " entities in ", world.tables().size(), " tables\n");
    lines += text("picture  ", picture_line, "\n");
    lines += text("log      ", log.string(),
                  played.log_fault ? text(" is not whole: ", played.log_fault->message) : "", "\n");
    lines += text("check    thaum replay ", log.string(), " --verify\n");
    lines += "play     on a machine with a display: thaum --vs, or thaum --solo 1\n";
    return lines;
}

}  // namespace

int play_offscreen_duel(const OffscreenDuel& duel) {
    auto loaded = load_match_data(duel.assets, duel.data);
    if (!loaded) return refuse(loaded.error());
    const auto data = std::make_shared<const MatchData>(std::move(*loaded));
    if (const auto made = make_folder(duel.out); !made) return refuse(made.error());
    for (const auto* file : {"duel.png", "duel.txt"}) {
        if (const auto free = check_output(duel.out / file); !free) return refuse(free.error());
    }
    const auto log = duel.log.empty() ? duel.out / "duel.thaumlog" : duel.log;
    if (const auto free = duel.log.empty() ? input::remove_log(log) : Expected<void>(); !free)
        return refuse(free.error());
    const auto played = play(duel, data, log);
    if (!played) return refuse(played.error());
    const auto drawn = picture(duel, data, *played, log);
    const auto lines = report(duel, *played, log, drawn.line);
    print_lines(lines);
    for (const auto& fault : {played->log_fault, drawn.fault})
        if (fault) tell_user(text("thaum: ", fault->message));
    if (const auto written = write_text_file(duel.out / "duel.txt", lines); !written)
        return refuse(written.error());
    return played->log_fault || drawn.fault ? does_not_hold : done;
}

}  // namespace thaum::game::inline app
