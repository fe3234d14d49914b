// kill_recording RUNS [SEED]: records matches of two bots in real time and kills the recording process with
// SIGKILL at a random moment, RUNS times, two at a time. Every log must replay with equal hashes up to 1 s
// before the kill. The program exits with 1 if a log does not.
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "core/clock.h"
#include "core/file.h"
#include "core/random.h"
#include "core/text.h"
#include "game/bots/duel.h"
#include "game/match/playback.h"

using namespace thaum;

namespace {

constexpr Tick may_be_lost = ticks(1);
constexpr std::int64_t ns_per_tick = 1'000'000;

struct Runner {
    pid_t process = 0;
    std::filesystem::path log{};
    /// Ticks that the match has played, in memory that outlives the process.
    std::atomic<Tick>* done = nullptr;
    std::int64_t kill_at_ns = 0;
};

[[noreturn]] void record_until_killed(const Runner& runner, std::uint64_t seed) {
    const auto assets = game::find_assets();
    auto data = game::load_match_data(assets, {});
    if (!data) std::abort();
    auto duel = game::make_bot_duel(assets, std::make_shared<const game::MatchData>(std::move(*data)),
                                    {"level_1", "level_1"}, seed);
    if (!duel) std::abort();
    auto& match = *duel->match;
    auto log = input::LogWriter::create(runner.log,
                                        game::log_header(match.data(), match.setup(), {"bot 1", "bot 1"}));
    if (!log) std::abort();
    const auto start = monotonic_ns();
    for (;;) {
        game::tick_and_record(match, duel->next_frame(), &*log);
        *runner.done = match.now();
        sleep_until_ns(start + static_cast<std::int64_t>(match.now()) * ns_per_tick);
    }
}

void start(Runner& runner, std::uint64_t seed, std::int64_t life_ns) {
    *runner.done = 0;
    runner.process = ::fork();
    if (runner.process == 0) record_until_killed(runner, seed);
    runner.kill_at_ns = monotonic_ns() + life_ns;
}

/// Fault of a log after the kill; empty if the log replays and contains enough ticks.
std::string fault_of(const Runner& runner, Tick killed_at, Tick& kept) {
    auto playback = game::Playback::open(runner.log, game::find_assets());
    // A process that was killed before its first tick may not have created the file.
    if (!playback) return killed_at == 0 ? "" : playback.error().message;
    kept = playback->log().ticks();
    if (playback->log().ending() != input::LogEnding::cut_off) return "does not read as cut off";
    if (kept + may_be_lost < killed_at) return text("only ", kept, " ticks of ", killed_at);
    while (playback->step()) {
        if (const auto wrong = playback->mismatch()) return text("differs at tick ", wrong->recorded.tick);
    }
    return {};
}

/// Kills the recording process when its time has come and checks its log. Returns true if the log has no
/// fault.
bool end(Runner& runner, int run, Tick& max_lost) {
    sleep_until_ns(runner.kill_at_ns);
    ::kill(runner.process, SIGKILL);
    int status = 0;
    ::waitpid(runner.process, &status, 0);
    if (!WIFSIGNALED(status) || WTERMSIG(status) != SIGKILL)
        return std::printf("run %d: ended by itself\n", run), false;
    const Tick killed_at = *runner.done;
    Tick kept = 0;
    const auto fault = fault_of(runner, killed_at, kept);
    std::filesystem::remove(runner.log);
    if (!fault.empty()) return std::printf("run %d: %s\n", run, fault.c_str()), false;
    if (killed_at > kept) max_lost = std::max(max_lost, killed_at - kept);
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 1 ? std::atoi(argv[1]) : 0;
    if (runs <= 0) return std::fprintf(stderr, "usage: kill_recording RUNS [SEED]\n"), 2;
    Random random{argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1};
    const TemporaryFolder folder;
    if (folder.path().empty()) return std::perror("kill_recording"), 1;
    constexpr std::size_t at_once = 2;
    void* shared = ::mmap(nullptr, at_once * sizeof(std::atomic<Tick>), PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) return std::perror("kill_recording"), 1;
    std::array<Runner, at_once> runners;
    int failed = 0;
    Tick max_lost = 0;
    for (int run = 0; run < runs; run += static_cast<int>(at_once)) {
        for (std::size_t i = 0; i < at_once; ++i) {
            runners[i].log = folder.path() / text("log", i);
            runners[i].done = new (static_cast<std::atomic<Tick>*>(shared) + i) std::atomic<Tick>(0);
            start(runners[i], random.next(), static_cast<std::int64_t>(random.below(4'000'000'000)));
        }
        for (std::size_t i = 0; i < at_once; ++i)
            failed += end(runners[i], run + static_cast<int>(i), max_lost) ? 0 : 1;
    }
    std::printf("killed %d times: %d wrong, at most %llu ms lost\n", runs, failed,
                static_cast<unsigned long long>(max_lost));
    return failed == 0 ? 0 : 1;
}
