// thaum replay: replays a log to check it, to watch it, or to write tables and pictures.
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/file.h"
#include "core/file_writer.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/feel.h"
#include "game/app/replay_body.h"
#include "game/app/replay_sound.h"
#include "game/app/shots.h"
#include "game/app/watch.h"
#include "game/command_line/arguments.h"
#include "game/jackets/felt_rows.h"
#include "game/match/header_text.h"
#include "game/match/tables.h"
#include "game/settings/recorded_names.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view replay_help =
    R"(usage: thaum replay LOG [OPTIONS]

Replays a recorded match: everything but the input is computed again, without bots.

  (no option)         watch the match in a window, whose bar names the keys
  --at S --speed X    start at second S; 0.25 to 16 times as fast. Without a display:
                      one picture of second S and its state in --out DIR (out)
  --header            print the header: players, devices, settings, data files, kinds
  --verify            compare every state hash; exit 1 at the first that differs
  --events FILE.csv   all events, one row each
  --state FILE.csv    place, speed, health, energy and gaze of both players
  --every N             at every Nth tick (1)
  --forces FILE.csv   both hands' devices, one row a tick of play: position and force
  --tactile FILE.csv  what both bodies feel, one row a frame of 8 ticks: 40 cells;
                      --felt-sound music, effects or both: those sounds, too
  --wav FILE.wav      what both players hear; --ears N: player N alone (1 or 2)
  --feel DEVICE       plays the forces of --player N (1) on a force feedback arm, in real
                      time. DEVICE: the arm's name or number in `thaum doctor`
  --shots DIR         pictures (PNG), by default every 10 s; --size WxH (1280x720)
  --shot-every S, --shot-at S   every S seconds; at second S, which may be repeated
  --shot-on KIND        at events of that kind (death, spawn, ..., mark); repeats
  --dump TICK FILE    write the whole state at a tick, for `thaum diff`

Options with files, --verify and --shots can be combined. Every replay is compared
with the log's hashes. At a difference it prints the tick, leaves no files, and exits
with code 1. An existing FILE is replaced, but never LOG, data or a recording.
)";

/// The outputs that one pass over the log is to write.
struct Pass {
    bool verify = false;
    std::optional<std::filesystem::path> events{}, state{}, forces{}, tactile{}, wav{};
    std::optional<FeltGroups> felt_sound{};  ///< groups of sounds felt in `tactile`; std::nullopt: none
    std::optional<std::uint32_t> ears{};     ///< player from whose place `wav` is heard; std::nullopt: both
    Tick state_every = 1;
    std::optional<ShotPlan> shots{};

    bool any() const { return verify || events || state || forces || tactile || wav || shots; }
};

void warn(const std::string& line) {
    if (!line.empty()) tell_user(text("thaum: ", line));
}

/// A CSV file that a pass writes. Its rows are collected in memory first.
struct Table {
    std::optional<FileWriter> file;
    std::string rows;

    Expected<void> open(const std::optional<std::filesystem::path>& path, std::string_view header) {
        if (!path) return {};
        auto made = FileWriter::create(*path);
        if (!made) return made.error();
        file.emplace(std::move(*made));
        file->write(header);
        return {};
    }
    void put() {
        if (file) file->write(rows);
        rows.clear();
    }
    Expected<void> close() { return file ? file->close() : Expected<void>(); }
};

struct Outputs {
    Table events{}, state{}, forces{}, tactile{};
    Tick felt = 0;  ///< ticks of play whose forces have been written
    EventTable what_happened{};
    std::optional<Shots> shots{};
    std::optional<ReplaySound> sound{};
    std::optional<ReplayBody> body{};
};

Expected<void> open_body(const Pass& pass, const Playback& playback, Outputs& out) {
    if (!pass.tactile) return {};
    if (auto opened = out.tactile.open(pass.tactile, felt_header()); !opened) return opened;
    auto body = ReplayBody::create(playback.match().data(), find_assets(), pass.felt_sound);
    if (!body) return body.error();
    out.body.emplace(std::move(*body));
    return {};
}

Expected<Outputs> open_outputs(const Pass& pass, const Playback& playback) {
    Outputs out;
    if (auto opened = out.events.open(pass.events, EventTable::header()); !opened) return opened.error();
    if (auto opened = out.state.open(pass.state, state_header(playback.match())); !opened)
        return opened.error();
    if (auto opened = out.forces.open(pass.forces, forces_header()); !opened) return opened.error();
    if (auto opened = open_body(pass, playback, out); !opened) return opened.error();
    if (pass.shots) {
        auto shots = Shots::create(*pass.shots, playback.match().data(), find_assets());
        if (!shots) return shots.error();
        out.shots.emplace(std::move(*shots));
    }
    if (pass.wav) {
        auto sound = ReplaySound::create(*pass.wav, pass.ears, playback.match().data(), find_assets());
        if (!sound) return sound.error();
        out.sound.emplace(std::move(*sound));
    }
    return out;
}

/// Writes the rows and pictures that are due at the playback's current tick.
Expected<void> put_outputs(const Pass& pass, const Playback& playback, Outputs& out) {
    if (out.events.file) out.what_happened.follow(playback, out.events.rows);
    out.events.put();
    if (out.state.file && playback.match().now() % pass.state_every == 0)
        append_state(playback.match(), out.state.rows);
    out.state.put();
    const auto played = playback.match().match().played;
    if (out.forces.file && out.felt != played) append_forces(playback.match(), out.forces.rows);
    out.felt = played;
    out.forces.put();
    if (out.body) out.body->follow(playback.match(), out.tactile.rows);
    out.tactile.put();
    if (out.sound) out.sound->follow(playback.match());
    return out.shots ? out.shots->follow(playback) : Expected<void>();
}

Expected<void> close_outputs(const Playback& playback, Outputs& out) {
    if (out.events.file) out.what_happened.finish(playback, out.events.rows);
    out.events.put();
    if (auto closed = out.events.close(); !closed) return closed;
    if (auto closed = out.state.close(); !closed) return closed;
    if (auto closed = out.forces.close(); !closed) return closed;
    if (auto closed = out.tactile.close(); !closed) return closed;
    return out.sound ? out.sound->close() : Expected<void>();
}

/// Tests whether the replay has diverged from the recorded match, and prints the difference.
bool has_diverged(const Playback& playback) {
    if (!playback.divergence()) return false;
    print_line(described(*playback.divergence()));
    return true;
}

/// Prints a line unless it is empty. Returns whether it printed.
bool says(const std::string& line) {
    if (!line.empty()) print_line(line);
    return !line.empty();
}

/// Plays the log from the first tick to the last. If the replay diverges, no table is written, and pictures
/// after the last equal hash are deleted: they would show what never happened.
int run_pass(const Pass& pass, Playback& playback) {
    const auto start = std::chrono::steady_clock::now();
    if (pass.verify && says(playback.missing_hashes())) return does_not_hold;
    auto out = open_outputs(pass, playback);
    if (!out) return refuse(out.error());
    std::size_t compared = 0;
    Tick last_compared = 0;
    do {
        if (const auto put = put_outputs(pass, playback, *out); !put) return refuse(put.error());
        if (playback.log().hash_at(playback.match().now())) {
            ++compared;
            last_compared = playback.match().now();
            if (out->shots && !playback.divergence()) out->shots->confirm();
        }
        if (has_diverged(playback)) {
            if (out->shots) out->shots->remove_unconfirmed();
            return does_not_hold;
        }
    } while (playback.step());
    const bool damaged = playback.log().ending() == input::LogEnding::damaged;
    if (pass.verify && damaged && says(playback.log().ending_reason())) return does_not_hold;
    if (pass.verify && says(playback.wrong_result())) return does_not_hold;
    if (const auto closed = close_outputs(playback, *out); !closed) return refuse(closed.error());
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const auto checked =
        pass.verify ? text(", ", compared, " state hashes agree, the last at tick ", last_compared) : "";
    const auto drawn = out->shots ? text(", ", out->shots->taken(), " pictures") : std::string();
    print_line(text(playback.match().now(), " ticks", checked, drawn, "; ",
                    result_line(playback.match(), recorded_names(playback.log().header())), " (",
                    fixed(took, 2), " s, ", fixed(seconds(playback.match().now()) / took, 1),
                    " x real time)"));
    return done;
}

/// Writes the state at a tick. The state of a diverged replay is written as well, because `thaum diff` can
/// show the difference.
int dump(Playback& playback, const std::vector<std::string>& values) {
    const auto tick = parse_whole(values[0], "--dump", 0, ~std::uint64_t{0});
    if (!tick) return refuse(tick.error());
    if (auto free = check_output(values[1]); !free) return refuse(free.error());
    if (!playback.play_to(*tick)) {
        return refuse({text("--dump ", *tick, ": the log has ", playback.log().ticks(), " ticks")});
    }
    Bytes state;
    playback.match().save(state);
    if (const auto written = write_file(values[1], state); !written) return refuse(written.error());
    print_line(
        text("tick ", *tick, ": state ", hex(playback.match().state_hash()), " written to ", values[1]));
    return has_diverged(playback) ? does_not_hold : done;
}

Expected<void> read_kinds(const std::vector<std::string>& words, ShotPlan& plan) {
    for (const auto& word : words) {
        const auto kind = word == "none" ? std::nullopt : event_kind(word);
        if (word == "mark") {
            plan.on_marks = true;
        } else if (kind) {
            plan.on[static_cast<std::size_t>(*kind)] = true;
        } else {
            auto names = std::string("mark");
            for (const auto& info : event_kinds().kinds) {
                if (!info.name.empty() && info.name != "none") names += text(", ", info.name);
            }
            return fail(text("--shot-on '", word, "': there are ", names));
        }
    }
    return {};
}

Expected<ShotPlan> read_shots(const Arguments& arguments, Tick log_ticks) {
    ShotPlan plan;
    plan.folder = *arguments.value("--shots");
    const auto every = arguments.number("--shot-every", 0.001, 1e6, 0);
    if (!every) return every.error();
    plan.every = ticks(*every);
    for (const auto& word : arguments.values("--shot-at")) {
        const auto at = parse_number(word, "--shot-at", 0, seconds(log_ticks));
        if (!at) return at.error();
        plan.at.push_back(ticks(*at));
    }
    std::sort(plan.at.begin(), plan.at.end());
    if (auto read = read_kinds(arguments.values("--shot-on"), plan); !read) return read.error();
    if (const auto word = arguments.value("--size")) {
        const auto size = parse_size(*word, "--size");
        if (!size) return size.error();
        plan.size = *size;
    }
    if (!plan.any()) plan.every = ticks(10);
    return plan;
}

/// Rejects options that are given without the option on which they depend.
Expected<void> check_company(const Arguments& arguments, const Pass& pass) {
    for (const auto* word : {"--shot-every", "--shot-at", "--shot-on", "--size"}) {
        if (arguments.has(word) && !pass.shots) return fail(text(word, " needs --shots"));
    }
    if (arguments.has("--every") && !pass.state) return fail("--every needs --state");
    if (arguments.has("--ears") && !pass.wav) return fail("--ears needs --wav");
    if (arguments.has("--felt-sound") && !pass.tactile) return fail("--felt-sound needs --tactile");
    if (arguments.has("--player") && !arguments.has("--feel")) return fail("--player needs --feel");
    for (const auto* word : {"--at", "--speed", "--out", "--dump", "--feel"}) {
        if (arguments.has(word) && pass.any())
            return fail(text(
                word,
                " does not go with --verify, --events, --state, --forces, --tactile, --wav and --shots"));
    }
    return {};
}

Expected<Pass> read_pass(const Arguments& arguments, Tick log_ticks) {
    Pass pass;
    pass.verify = arguments.has("--verify");
    if (const auto file = arguments.value("--events")) pass.events = *file;
    if (const auto file = arguments.value("--state")) pass.state = *file;
    if (const auto file = arguments.value("--forces")) pass.forces = *file;
    if (const auto file = arguments.value("--tactile")) pass.tactile = *file;
    if (const auto file = arguments.value("--wav")) pass.wav = *file;
    if (const auto groups = arguments.value("--felt-sound")) {
        constexpr std::array<std::string_view, 3> names{"music", "effects", "both"};
        const auto found = std::find(names.begin(), names.end(), *groups);
        if (found == names.end())
            return fail(text("--felt-sound is music, effects or both, not '", *groups, "'"));
        pass.felt_sound = static_cast<FeltGroups>(found - names.begin());
    }
    if (arguments.has("--ears")) {
        const auto ears = arguments.whole("--ears", 1, players, 1);
        if (!ears) return ears.error();
        pass.ears = static_cast<std::uint32_t>(*ears - 1);
    }
    const auto every = arguments.whole("--every", 1, Tick{1} << 27U, 1);
    if (!every) return every.error();
    pass.state_every = *every;
    if (arguments.has("--shots")) {
        auto shots = read_shots(arguments, log_ticks);
        if (!shots) return shots.error();
        pass.shots = std::move(*shots);
    }
    if (auto fits = check_company(arguments, pass); !fits) return fits.error();
    return pass;
}

/// Tick given by --at, checked against the length of the log.
Expected<Tick> start_of(const Arguments& arguments, const Playback& playback) {
    const auto at = arguments.number("--at", 0, 1e6, 0);
    if (!at) return at.error();
    if (ticks(*at) <= playback.log().ticks()) return ticks(*at);
    return fail(text("--at ", *at, ": the log has ", fixed(seconds(playback.log().ticks()), 1), " s"));
}

int watch_from(const Arguments& arguments, Playback playback) {
    const auto speed = arguments.number("--speed", 0.25, 16, 1);
    if (!speed) return refuse(speed.error());
    const auto start = start_of(arguments, playback);
    if (!start) return refuse(start.error());
    return watch(std::move(playback), {*start, *speed, arguments.value("--out").value_or("out")});
}

/// Plays the forces of a log on an arm, in real time only. At another speed a push would feel different: a
/// slower one would move the hand farther.
int feel_from(const Arguments& arguments, Playback playback) {
    if (arguments.has("--speed"))
        return refuse(
            {"--feel plays in real time only: at another --speed each push would last longer or "
             "shorter than it was made for"});
    if (arguments.has("--out")) return refuse({"--feel writes no files; leave --out away"});
    const auto player = arguments.whole("--player", 1, players, 1);
    if (!player) return refuse(player.error());
    const auto start = start_of(arguments, playback);
    if (!start) return refuse(start.error());
    playback.play_to(*start);
    return feel(std::move(playback),
                {.device = *arguments.value("--feel"), .player = static_cast<std::uint32_t>(*player - 1)});
}

/// Prints the header of a log. This also works for logs that this version cannot replay.
int print_header(const std::vector<std::string>& words, const std::string& path) {
    if (words.size() != 2) return refuse({"--header goes with no other option"});
    const auto log = input::LogReader::open(path);
    if (!log) return refuse(log.error());
    std::fputs(header_text(*log).c_str(), stdout);
    return done;
}

int run_replay(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--verify"},           {"--at", 1},
                                         {"--speed", 1},         output("--dump", 2),
                                         {"--out", 1},           output("--events"),
                                         output("--state"),      output("--forces"),
                                         {"--every", 1},         {"--shots", 1},
                                         {"--size", 1},          {"--shot-every", 1},
                                         {"--shot-at", 1, true}, {"--shot-on", 1, true},
                                         {"--feel", 1},          {"--player", 1},
                                         {"--header"},           output("--tactile"),
                                         output("--wav"),        {"--ears", 1},
                                         {"--felt-sound", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    if (arguments->plain().size() != 1) return refuse({"replay needs one log; see `thaum replay --help`"});
    if (arguments->has("--header")) return print_header(words, arguments->plain()[0]);
    auto playback = Playback::open(arguments->plain()[0], find_assets());
    if (!playback) return refuse(playback.error());
    const auto pass = read_pass(*arguments, playback->log().ticks());
    if (!pass) return refuse(pass.error());
    warn(build_warning(playback->log().header()));
    if (!playback->log().ended_cleanly()) warn(playback->log().ending_reason());
    if (pass->any()) return run_pass(*pass, *playback);
    if (arguments->has("--dump") && arguments->has("--feel"))
        return refuse({"--dump does not go with --feel"});
    if (arguments->has("--dump")) return dump(*playback, arguments->values("--dump"));
    if (arguments->has("--feel")) return feel_from(*arguments, std::move(*playback));
    return watch_from(*arguments, std::move(*playback));
}

const CommandRegistration registration_of_replay({.name = "replay", .help = replay_help, .run = run_replay});

}  // namespace

}  // namespace thaum::game::inline app
