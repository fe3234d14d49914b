// thaum diff: finds the first difference between two states, or between two replays of one log.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <functional>

#include "core/file.h"
#include "core/jobs.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "ecs/diff.h"
#include "game/app/command.h"
#include "game/command_line/arguments.h"
#include "game/match/playback.h"

extern char** environ;

namespace thaum::game::inline app {
namespace {

constexpr std::string_view diff_help =
    R"(usage: thaum diff A.dump B.dump
       thaum diff LOG --exe OTHER_THAUM
       thaum diff LOG --threads N,M

Prints every difference: component, entity, field and both values.

  A.dump B.dump    two states, as `thaum replay LOG --dump TICK FILE` writes them
  --exe OTHER      replay the log here and with another build, and bisect to the
                   first tick whose state differs
  --threads N,M    run N replays at once, then M at once, each on its own
                   thread, and bisect in the same way

Exit code 0: no difference; 1: a difference.
)";

constexpr std::size_t max_dump = std::size_t{1} << 30U;

int print(const std::vector<ecs::Difference>& differences) {
    for (const auto& d : differences) {
        const auto what = d.component.empty() ? std::string("entity") : d.component;
        const auto where = d.entity == ecs::none ? std::string("all entities") : text("entity ", d.entity);
        std::printf("%-12s %-13s %-24s ", what.c_str(), where.c_str(), d.field.c_str());
        print_line(text(d.a, " | ", d.b));
    }
    if (differences.empty()) std::printf("no difference\n");
    return differences.empty() ? done : does_not_hold;
}

/// Prints the differences of two states. `names`: text that names the two states in an error.
int compare(std::span<const std::byte> a, std::span<const std::byte> b, const std::string& names = {}) {
    const auto differences = ecs::diff(a, b);
    return differences ? print(*differences) : refuse({differences.error().message + names});
}

int compare_files(const std::string& a, const std::string& b) {
    const auto left = read_file(a, max_dump);
    if (!left) return refuse(left.error());
    const auto right = read_file(b, max_dump);
    if (!right) return refuse(right.error());
    return compare(*left, *right, text(" (A is ", a, ", B is ", b, ")"));
}

/// Function that computes the state of a replay at a tick.
using StateAt = std::function<Expected<Bytes>(Tick)>;

Expected<Bytes> state_here(const std::string& log, Tick tick) {
    auto playback = Playback::open(log, find_assets());
    if (!playback) return playback.error();
    playback->play_to(tick);
    Bytes state;
    playback->match().save(state);
    return state;
}

/// State of a replay at a tick. While it is computed, `threads` - 1 further replays of the log run beside it,
/// each on its own thread. So a state that wrongly depends on what other threads do is found.
Expected<Bytes> state_among(const std::string& log, Tick tick, std::uint64_t threads) {
    Jobs jobs(static_cast<unsigned>(threads - 1));
    for (std::uint64_t i = 1; i < threads; ++i) jobs.run([&] { (void)state_here(log, tick); });
    return state_here(log, tick);
}

/// Runs PROGRAM replay LOG --dump TICK FILE and reads the dumped state.
Expected<Bytes> state_elsewhere(const std::string& program, const std::string& log, Tick tick) {
    const TemporaryFolder folder;
    if (folder.path().empty()) return fail("diff: cannot create a temporary folder");
    const auto file = folder.path() / "state.dump";
    const auto tick_text = text(tick);
    const std::vector<std::string> words{program, "replay", log, "--dump", tick_text, file.string()};
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (const auto& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", 1, 0);
    pid_t child = 0;
    const int spawned = posix_spawn(&child, program.c_str(), &quiet, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&quiet);
    if (spawned != 0) return fail(text(program, ": cannot be started"));
    int status = 0;
    waitpid(child, &status, 0);
    // A replay that diverges from its log exits with does_not_hold. Its state is needed all the same, since
    // this command looks for the divergence.
    if (!WIFEXITED(status) || WEXITSTATUS(status) > does_not_hold)
        return fail(text(program, ": could not replay ", log));
    return read_file(file, max_dump);
}

struct Sides {
    StateAt a, b;
};

/// Tests whether the two states differ at this tick.
Expected<bool> differ(const Sides& sides, Tick tick) {
    const auto a = sides.a(tick);
    if (!a) return a.error();
    const auto b = sides.b(tick);
    if (!b) return b.error();
    return *a != *b;
}

/// Finds the first tick with different states by bisection, which works because states that differ once stay
/// different.
int bisect(const Sides& sides, Tick length) {
    auto at_end = differ(sides, length);
    if (!at_end) return refuse(at_end.error());
    if (!*at_end) {
        std::printf("no difference in %llu ticks\n", static_cast<unsigned long long>(length));
        return done;
    }
    Tick same = 0;  // last tick known to have equal states; meaningless if the states differ at tick 0
                    // already
    Tick different = length;
    if (const auto at_start = differ(sides, 0); !at_start) {
        return refuse(at_start.error());
    } else if (*at_start) {
        different = 0;
    }
    while (different > same + 1) {
        const Tick middle = same + (different - same) / 2;
        const auto differs = differ(sides, middle);
        if (!differs) return refuse(differs.error());
        (*differs ? different : same) = middle;
    }
    std::printf("first difference after %llu ticks\n", static_cast<unsigned long long>(different));
    const auto a = sides.a(different);
    const auto b = sides.b(different);
    if (!a) return refuse(a.error());
    if (!b) return refuse(b.error());
    return compare(*a, *b);
}

int run_diff(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--exe", 1}, {"--threads", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    const auto& files = arguments->plain();
    if (files.size() == 2 && !arguments->has("--exe") && !arguments->has("--threads")) {
        return compare_files(files[0], files[1]);
    }
    if (files.size() != 1 || arguments->has("--exe") == arguments->has("--threads")) {
        return refuse({"diff needs two dumps, or one log and --exe or --threads; see `thaum diff --help`"});
    }
    const auto log = files[0];
    const auto playback = Playback::open(log, find_assets());
    if (!playback) return refuse(playback.error());
    const Tick length = playback->log().ticks();
    if (const auto other = arguments->value("--exe")) {
        return bisect({[&](Tick t) { return state_here(log, t); },
                       [&](Tick t) { return state_elsewhere(*other, log, t); }},
                      length);
    }
    const auto counts = arguments->value("--threads").value();
    const auto comma = counts.find(',');
    const auto a = parse_whole(counts.substr(0, comma), "--threads", 1, 64);
    const auto b =
        parse_whole(comma == std::string::npos ? "" : counts.substr(comma + 1), "--threads", 1, 64);
    if (!a) return refuse(a.error());
    if (!b) return refuse(b.error());
    return bisect(
        {[&](Tick t) { return state_among(log, t, *a); }, [&](Tick t) { return state_among(log, t, *b); }},
        length);
}

const CommandRegistration registration_of_diff({.name = "diff", .help = diff_help, .run = run_diff});

}  // namespace

}  // namespace thaum::game::inline app
