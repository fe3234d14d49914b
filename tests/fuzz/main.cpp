// Runs the inputs in a child process, so that a crash, a hang or too much memory can be reported with the
// number of the run, which reproduces the input.
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>
#include <thread>

#include "core/file.h"
#include "core/sanitizers.h"
#include "core/text.h"
#include "fuzz/fuzz.h"
#include "game/data/match_data.h"

#if THAUM_ADDRESS_SANITIZER
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "max_allocation_size_mb=512:hard_rss_limit_mb=2048";
}
#endif

namespace thaum::fuzz {
namespace {

using Clock = std::chrono::steady_clock;
/// Maximum processor time for one input, with sanitizers, and maximum real time, after which the child counts
/// as hanging. Real time is longer because a busy machine may make the child wait.
constexpr auto max_work = std::chrono::seconds(10), max_time = std::chrono::seconds(600);
/// Limit of address space in builds without sanitizers (bytes)
constexpr rlim_t max_memory = rlim_t{1} << 30U;
/// From this many runs on, more than 1 % of the inputs must be accepted and more than 1 % refused. Otherwise
/// the mutants are too one-sided.
constexpr std::uint64_t proof = 100;

/// Progress of the child process, in shared memory.
struct Progress {
    std::atomic<std::uint64_t> done{0}, accepted{0}, refused{0}, slowest_us{0};
    std::array<char, 1000> fault{};
};

struct RunPlan {
    const Reader* reader{};
    std::uint64_t runs = 10'000, seed = 1, from = 0;
};

std::string input_of(const RunPlan& plan, const std::vector<std::string>& seeds, std::uint64_t run) {
    Random random = random_stream(plan.seed, run);
    return plan.reader->mutate(seeds, random);
}

/// Fault in a run's outcome: a reported one, or a refusal that is not one line of printable text. Empty:
/// none.
std::string fault_of(const Outcome& outcome) {
    if (!outcome.fault.empty()) return outcome.fault;
    if (!outcome.accepted && outcome.refusal.empty()) return "refused without a message";
    if (outcome.refusal.size() > 2000) return text("a message of ", outcome.refusal.size(), " bytes");
    const bool plain = std::none_of(outcome.refusal.begin(), outcome.refusal.end(),
                                    [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
    return plain ? "" : text("not one line of text: ", outcome.refusal);
}

void limit_memory() {
    // The address sanitizer needs terabytes of address space for its shadow memory; see
    // __asan_default_options.
    if (THAUM_ADDRESS_SANITIZER) return;
    const rlimit limit{max_memory, max_memory};
    ::setrlimit(RLIMIT_AS, &limit);
}

void run_all(const RunPlan& plan, const std::vector<std::string>& seeds, const Places& places,
             Progress& progress) {
    limit_memory();
    for (auto run = plan.from; run < plan.from + plan.runs; ++run) {
        const auto input = input_of(plan, seeds, run);
        const auto before = Clock::now();
        const auto outcome = plan.reader->read(input, places);
        const auto took =
            std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - before).count();
        progress.slowest_us = std::max(progress.slowest_us.load(), static_cast<std::uint64_t>(took));
        (outcome.accepted ? progress.accepted : progress.refused)++;
        if (const auto fault = fault_of(outcome); !fault.empty()) {
            std::strncpy(progress.fault.data(), fault.c_str(), progress.fault.size() - 1);
            std::exit(1);
        }
        ++progress.done;
    }
    std::exit(0);
}

/// Processor time of the child process so far.
std::chrono::nanoseconds work_of(pid_t child) {
    clockid_t clock{};
    timespec work{};
    if (::clock_getcpuclockid(child, &clock) != 0 || ::clock_gettime(clock, &work) != 0) return {};
    return std::chrono::seconds(work.tv_sec) + std::chrono::nanoseconds(work.tv_nsec);
}

/// Watches the child process until it ends. Returns its fault; empty: none.
std::string watch(pid_t child, const Progress& progress, long& peak_mib) {
    auto seen = progress.done.load();
    auto since = Clock::now();
    auto work_before = work_of(child);
    for (;;) {
        int status = 0;
        rusage use{};
        const auto ended = ::wait4(child, &status, WNOHANG, &use);
        if (ended == child) {
            peak_mib = use.ru_maxrss / 1024;
            if (WIFSIGNALED(status)) return text("killed by signal ", WTERMSIG(status));
            if (progress.fault[0] != '\0') return progress.fault.data();
            return WEXITSTATUS(status) == 0 ? "" : text("ended with exit code ", WEXITSTATUS(status));
        }
        if (progress.done != seen) {
            seen = progress.done;
            since = Clock::now();
            work_before = work_of(child);
        }
        const bool hangs = Clock::now() - since > max_time;
        if (hangs || work_of(child) - work_before > max_work) {
            ::kill(child, SIGKILL);
            ::waitpid(child, &status, 0);
            return hangs ? "hung" : "computed longer than 10 s";
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

int report(const RunPlan& plan, const std::vector<std::string>& seeds, const Progress& progress,
           const std::string& fault, long peak_mib) {
    const auto name = std::string(plan.reader->name);
    if (!fault.empty()) {
        const auto run = plan.from + progress.done;
        const auto file = text("fuzz_", name, "_", plan.seed, "_", run);
        (void)write_text_file(file, input_of(plan, seeds, run));
        std::printf(
            "%s: run %llu: %s\n  its input is in ./%s; again: thaum_fuzz %s --seed %llu --from %llu --runs "
            "1\n",
            name.c_str(), static_cast<unsigned long long>(run), fault.c_str(), file.c_str(), name.c_str(),
            static_cast<unsigned long long>(plan.seed), static_cast<unsigned long long>(run));
        return 1;
    }
    std::printf("%s: %llu runs, %llu accepted, %llu refused in one line; slowest %.1f ms, at most %ld MiB\n",
                name.c_str(), static_cast<unsigned long long>(plan.runs),
                static_cast<unsigned long long>(progress.accepted),
                static_cast<unsigned long long>(progress.refused),
                static_cast<double>(progress.slowest_us) / 1e3, peak_mib);
    const bool proves =
        plan.runs < proof || (progress.accepted > plan.runs / 100 && progress.refused > plan.runs / 100);
    if (!proves)
        std::printf("%s: nearly all inputs were accepted, or nearly all refused, which proves little\n",
                    name.c_str());
    return proves ? 0 : 1;
}

Places make_places(const std::filesystem::path& folder) {
    Places places{folder / "assets", folder / "scratch"};
    std::filesystem::create_directories(places.scratch);
    std::filesystem::copy(std::filesystem::path(THAUM_SOURCE_DIR) / "assets", places.assets,
                          std::filesystem::copy_options::recursive);
    return places;
}

std::vector<std::string> seeds_of(const Reader& reader, const Places& places) {
    auto seeds = reader.seeds(places);
    const auto folder = std::filesystem::path(THAUM_SOURCE_DIR) / "tests/fuzz/seeds" / reader.name;
    std::vector<std::filesystem::path> files;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none)) files.push_back(entry.path());
    // Without a real input the test would prove nothing, so this is an error.
    if (seeds.empty()) return seeds;
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        if (auto content = read_text_file(file, 1U << 20U)) seeds.push_back(std::move(*content));
    }
    // The largest seed (real input from which mutants are made) is a whole file. It is used several times,
    // because mutants of a whole file get further than those of a fragment.
    constexpr std::size_t most_of_them = 6;
    const auto& whole = *std::max_element(seeds.begin(), seeds.end(),
                                          [](const auto& a, const auto& b) { return a.size() < b.size(); });
    seeds.resize(seeds.size() + most_of_them, std::string(whole));
    return seeds;
}

int run(const RunPlan& plan) {
    const TemporaryFolder folder;
    if (folder.path().empty()) return std::perror("thaum_fuzz"), 2;
    const auto places = make_places(folder.path());
    const auto seeds = seeds_of(*plan.reader, places);
    void* shared =
        ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (seeds.empty() || shared == MAP_FAILED)
        return std::fprintf(stderr, "thaum_fuzz: no seeds, or no shared memory\n"), 2;
    auto& progress = *new (shared) Progress;
    const auto child = ::fork();
    if (child < 0) return std::perror("thaum_fuzz"), 2;
    if (child == 0) run_all(plan, seeds, places, progress);
    long peak_mib = 0;
    const auto fault = watch(child, progress, peak_mib);
    return report(plan, seeds, progress, fault, peak_mib);
}

std::optional<RunPlan> read_wish(std::span<char*> words) {
    RunPlan plan;
    for (const auto& reader : readers()) {
        if (!words.empty() && reader.name == words[0]) plan.reader = &reader;
    }
    if (plan.reader == nullptr || words.size() % 2 == 0) return {};
    for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
        const std::string_view name = words[i], value = words[i + 1];
        auto* number = name == "--runs"   ? &plan.runs
                       : name == "--seed" ? &plan.seed
                       : name == "--from" ? &plan.from
                                          : nullptr;
        if (number == nullptr) return {};
        const auto end = value.data() + value.size();
        if (std::from_chars(value.data(), end, *number).ptr != end) return {};
    }
    return plan;
}

}  // namespace

std::span<const Reader> readers() {
    static const std::array list{log_reader,
                                 scenario_reader,
                                 settings_reader,
                                 arena_reader,
                                 rules_reader,
                                 wizard_reader,
                                 wand_reader,
                                 blast_reader,
                                 lob_reader,
                                 potion_reader,
                                 bot_reader,
                                 range_reader,
                                 lessons_reader,
                                 device_reader,
                                 lab_reader,
                                 sound_reader,
                                 layout_reader,
                                 effect_reader,
                                 tact_reader,
                                 bhaptics_reader,
                                 jacket_reader,
                                 stroke_reader,
                                 gesture_reader,
                                 gzip_reader,
                                 profile_reader,
                                 nrrd_reader,
                                 nhdr_reader,
                                 raw_volume_reader,
                                 volume_session_reader,
                                 carving_tool_reader,
                                 materials_reader,
                                 voxels_reader};
    return list;
}

}  // namespace thaum::fuzz

int main(int argc, char** argv) {
    const auto plan = thaum::fuzz::read_wish({argv + 1, argv + argc});
    if (!plan) {
        std::fprintf(stderr, "usage: thaum_fuzz READER [--runs N] [--seed S] [--from I]\nreaders:");
        for (const auto& reader : thaum::fuzz::readers())
            std::fprintf(stderr, " %s", std::string(reader.name).c_str());
        std::fprintf(stderr, "\n");
        return 2;
    }
    return thaum::fuzz::run(*plan);
}
