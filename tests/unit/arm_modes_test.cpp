// Tests a program with an arm whose library misbehaves in every way of tests/drivers/fake_hd/modes.h, and a
// program that is ended in every possible way. The program must print one line or go on, must neither hang
// nor crash, and the last force must be zero. Each case runs in a process of its own.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include "core/clock.h"
#include "core/file.h"
#include "core/one_line.h"
#include "core/text.h"
#include "drivers/fake_hd/fake_hd.h"
#include "drivers/fake_hd/modes.h"

namespace thaum::input {
namespace {

using fake_hd::Ending;
using fake_hd::Mode;

/// Time after which a process counts as hanging (ns). It is generous, so that a slow machine does not reach
/// it.
constexpr std::int64_t hangs_after_ns = 90'000'000'000;

/// A process that runs the program arm_probe, which holds a force with the fake arm.
struct Probe {
    std::string words{}, end{};
    bool opens = true;  ///< false: opening the arm must fail; a call that hangs then gets little time
    pid_t pid = -1;
    std::optional<int> status{};  ///< status of waitpid; std::nullopt: the process hangs
    std::string line{};           ///< line that the process printed
    FakeHdLive arm{};             ///< state of the fake arm at the end

    bool has_ended() {
        int current = 0;
        if (!status && ::waitpid(pid, &current, WNOHANG) == pid) status = current;
        return status.has_value();
    }
    bool exited_well() const { return status && WIFEXITED(*status) && WEXITSTATUS(*status) == 0; }
    bool died_by(int signal) const { return status && WIFSIGNALED(*status) && WTERMSIG(*status) == signal; }
};

void start(Probe& p, const std::filesystem::path& file) {
    const std::string script = (p.words.empty() ? "" : p.words + ",") + "live=" + file.string() + ".live";
    std::ofstream(file, std::ios::binary).flush();
    p.pid = ::fork();
    if (p.pid != 0) return;
    // The process that runs the tests may ignore some signals, so all get their default effect here.
    for (int signal = 1; signal < SIGRTMIN; ++signal) std::signal(signal, SIG_DFL);
    ::setenv("FAKE_HD", script.c_str(), 1);
    constexpr const char* little_ms = "500";
    constexpr std::array<std::string_view, 3> long_calls{"blocks", "slow", "returns_late"};
    const bool hangs = std::ranges::any_of(
        long_calls, [&](std::string_view word) { return script.find(word) != std::string::npos; });
    if (hangs && !p.opens) ::setenv("ARM_PROBE_OPEN_MS", little_ms, 1);
    if (hangs) ::setenv("ARM_PROBE_CLOSE_MS", little_ms, 1);
    ::dup2(::open(file.c_str(), O_WRONLY | O_APPEND), STDOUT_FILENO);
    ::dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
    ::execl(ARM_PROBE, ARM_PROBE, FAKE_HD, p.end.empty() ? nullptr : p.end.c_str(), nullptr);
    ::_exit(127);
}

void wait_for_end(Probe& p, const std::filesystem::path& file, std::int64_t until) {
    while (!p.has_ended() && monotonic_ns() < until) sleep_until_ns(monotonic_ns() + 5'000'000);
    if (!p.status) {
        ::kill(p.pid, SIGKILL);
        ::waitpid(p.pid, nullptr, 0);
    }
    std::ifstream said(file, std::ios::binary);
    p.line.assign(std::istreambuf_iterator<char>(said), {});
    std::ifstream(file.string() + ".live", std::ios::binary)
        .read(reinterpret_cast<char*>(&p.arm), sizeof p.arm);
}

/// Runs the probes, a few at a time. They spend nearly all of their time waiting.
void run_all(std::vector<Probe>& probes) {
    constexpr std::size_t at_once = 8;
    const TemporaryFolder folder;
    const auto file = [&](std::size_t i) { return folder.path() / std::to_string(i); };
    for (std::size_t first = 0; first < probes.size(); first += at_once) {
        const auto last = std::min(first + at_once, probes.size());
        for (auto i = first; i < last; ++i) start(probes[i], file(i));
        const auto until = monotonic_ns() + hangs_after_ns;
        for (auto i = first; i < last; ++i) wait_for_end(probes[i], file(i), until);
    }
}

void expect_no_force(const Probe& p) {
    for (const double newton : p.arm.force) EXPECT_EQ(newton, 0) << "the arm goes on pushing";
    // The last force is not checked if calls never return or always fail: then no zero force can be sent.
    const auto is_told = [&](const char* word) { return p.words.find(word) != std::string::npos; };
    if (is_told("blocks") || (is_told("from=") && !is_told("until="))) return;
    for (const double newton : p.arm.left) EXPECT_EQ(newton, 0) << "the arm was let go of with a force";
}

/// Expects one line of printable text.
void expect_clear_line(const Probe& p) {
    ASSERT_FALSE(p.line.empty());
    EXPECT_EQ(p.line.back(), '\n');
    EXPECT_LT(p.line.size(), 600U);
    EXPECT_EQ(printable(p.line.substr(0, p.line.size() - 1), 1000), p.line.substr(0, p.line.size() - 1));
}

void expect_ending(const Probe& p, Ending wanted) {
    constexpr std::array<std::string_view, 3> begins{"played", "lost: ", "refused: "};
    EXPECT_TRUE(p.line.starts_with(begins[static_cast<std::size_t>(wanted)])) << p.line;
}

void expect_modes(const std::vector<Mode>& modes) {
    std::vector<Probe> probes;
    for (const auto& mode : modes)
        probes.push_back({.words = mode.words, .opens = mode.wanted != Ending::refused});
    run_all(probes);
    for (std::size_t i = 0; i < probes.size(); ++i) {
        SCOPED_TRACE(modes[i].words + ": " + probes[i].line);
        EXPECT_TRUE(probes[i].status) << "the process hangs";
        EXPECT_TRUE(!probes[i].status || probes[i].exited_well())
            << "the process dies, status " << *probes[i].status;
        expect_clear_line(probes[i]);
        expect_ending(probes[i], modes[i].wanted);
        expect_no_force(probes[i]);
    }
}

TEST(ArmModes, AFunctionThatFailsHangsOrCallsBack) { expect_modes(fake_hd::modes_of_calls()); }
TEST(ArmModes, MeasurementsWordsAndTicksThatAreWrong) { expect_modes(fake_hd::modes_of_answers()); }

/// The library calls the servo's ticks before hdScheduleAsynchronous, which registers them, returns. The
/// function may still fail then, so no force may act yet.
TEST(ArmModes, NoForceBeforeTheLibraryHasTakenTheTicksUp) {
    std::vector<Probe> probes{{.words = "hdScheduleAsynchronous=returns_late", .opens = false}};
    run_all(probes);
    EXPECT_TRUE(probes[0].line.starts_with("refused: ")) << probes[0].line;
    EXPECT_GT(probes[0].arm.ticks, 0U);
    EXPECT_EQ(probes[0].arm.max_force, 0);
    expect_no_force(probes[0]);
}

/// The program is asked to end before the wait of 15 s begins, so it must report the short time that
/// passed.
TEST(ArmModes, SaysHowLongItHasWaited) {
    std::vector<Probe> probes{{.words = "hdInitDevice=blocks", .end = "impatient"}};
    run_all(probes);
    EXPECT_NE(probes[0].line.find("has not returned for 0."), std::string::npos) << probes[0].line;
}

// ---- ends of the program ----------------------------------------------------------------------------------

/// A way in which a program that exerts 1 N ends. Signal 0: it calls exit.
struct WayToEnd {
    std::string end;
    int signal;
    std::string words{};
};

void expect_ends(const std::vector<WayToEnd>& ways) {
    std::vector<Probe> probes;
    for (const auto& way : ways) probes.push_back({.words = way.words, .end = way.end});
    run_all(probes);
    for (std::size_t i = 0; i < probes.size(); ++i) {
        SCOPED_TRACE(ways[i].end + ways[i].words);
        const auto& p = probes[i];
        ASSERT_TRUE(p.status) << "the process hangs";
        EXPECT_TRUE(ways[i].signal == 0 ? WIFEXITED(*p.status) : p.died_by(ways[i].signal)) << *p.status;
        EXPECT_GE(p.arm.ticks, 99U);
        EXPECT_EQ(p.arm.max_force, 1);
        expect_no_force(p);
    }
}

TEST(ArmEnds, HoweverItEndsTheLastForceIsZero) {
    const std::vector<WayToEnd> ways{
        {"fault", SIGSEGV},
        {"abort", SIGABRT},
        {"assertion", SIGABRT},
        {"exception", SIGABRT},
        {"exit", 0},
        {"overrun", SIGSEGV},
        {"divide", SIGFPE},
        {"tick_fault", SIGSEGV},
        {"tick_abort", SIGABRT},
        {"tick_exit", 0},
        {"tick_divide", SIGFPE},
        {"tick_exception", SIGABRT},
        {"tick_assertion", SIGABRT},
        {"", SIGSEGV, "hdStopScheduler=crashes"},
        {"", SIGSEGV, "hdGetDoublev=crashes,from=400"},
        {"", SIGSEGV, "crash=200"},
        {"", SIGTERM, "hdGetDoublev=interrupts,from=400"},
        {"", SIGTERM, "interrupt=200"},
        {"pipe", SIGPIPE},
        {"tick_pipe", SIGPIPE},
        {"tick_overrun", SIGSEGV},
        {"beside_overrun", SIGSEGV},
        {"beside_fault", SIGSEGV},
    };
    expect_ends(ways);
}

/// Every signal that ends a program without a handler, except SIGKILL.
TEST(ArmEnds, NoSignalEndsItWithAForce) {
    std::vector<WayToEnd> ways;
    for (const int signal :
         {SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGTRAP, SIGABRT,   SIGBUS,  SIGFPE, SIGUSR1, SIGSEGV, SIGUSR2,
          SIGPIPE, SIGALRM, SIGTERM, SIGXCPU, SIGXFSZ, SIGVTALRM, SIGPROF, SIGIO,  SIGPWR,  SIGSYS}) {
        for (const char* where : {"", "tick_"}) ways.push_back({where + text("raise=", signal), signal});
    }
    expect_ends(ways);
}

/// A program with an arm that waits until it is killed.
struct Waiting {
    TemporaryFolder folder{};
    Probe p{};
    std::int64_t until = monotonic_ns() + hangs_after_ns;

    explicit Waiting(const char* end, const char* words = "") {
        p.words = words;
        p.end = end;
        start(p, file());
        wait_until([&] { return std::filesystem::file_size(file()) > 0; });
    }
    std::filesystem::path file() const { return folder.path() / "0"; }
    const FakeHdLive& arm() {
        std::ifstream(file().string() + ".live", std::ios::binary)
            .read(reinterpret_cast<char*>(&p.arm), sizeof p.arm);
        return p.arm;
    }
    template <class F>
    void wait_until(F holds) {
        while (!holds() && !p.has_ended() && monotonic_ns() < until)
            sleep_until_ns(monotonic_ns() + 1'000'000);
    }
    void expect_stops_by(int signal) {
        int status = 0;
        ::kill(p.pid, signal);
        ASSERT_EQ(::waitpid(p.pid, &status, WUNTRACED), p.pid);
        ASSERT_TRUE(WIFSTOPPED(status));
        EXPECT_EQ(arm().force[2], 0);
        ::kill(p.pid, SIGCONT);
    }
    void expect_ends_without_force() {
        ::kill(p.pid, SIGTERM);
        wait_for_end(p, file(), until);
        EXPECT_TRUE(p.died_by(SIGTERM));
        expect_no_force(p);
    }
};

/// A program without signal handlers of its own gets a signal that ends it, while its arm exerts a force.
TEST(ArmEnds, ASignalThatEndsItLeavesNoForce) {
    Waiting program("wait");
    program.wait_until([&] { return program.arm().max_force == 1; });
    program.expect_ends_without_force();
}

/// A call of the library hangs, or the library's thread stops calling, and nothing closes the arm.
TEST(ArmHangs, TheWatchdogEndsTheForce) {
    for (const char* words : {"felt,hdBeginFrame=blocks,from=400", "felt,hdGetDoublev=blocks,from=800",
                              "hdEndFrame=blocks,from=400", "hdGetError=blocks,from=800", "felt,stop=200"}) {
        SCOPED_TRACE(words);
        Waiting program("wait", words);
        program.wait_until([&] { return program.arm().max_force == 1; });
        program.wait_until([&] { return program.arm().force[2] == 0; });
        EXPECT_FALSE(program.p.has_ended());
        EXPECT_EQ(program.arm().max_force, 1);
        EXPECT_EQ(program.arm().force[2], 0);
        ::kill(program.p.pid, SIGKILL);
        wait_for_end(program.p, program.file(), program.until);
    }
}

TEST(ArmEnds, StoppedItGivesNoForceAndContinuedItDoes) {
    Waiting program("wait");
    for (const int signal : {SIGTSTP, SIGTTIN, SIGTTOU}) {
        program.wait_until([&] { return program.arm().force[2] == 1; });
        program.expect_stops_by(signal);
        program.wait_until([&] { return program.arm().force[2] == 1; });
        EXPECT_EQ(program.arm().force[2], 1);
    }
    program.expect_ends_without_force();
}

/// A program with an arm gets SIGINT, SIGTSTP (stop) and SIGCONT (go on). It must still end, and without a
/// force.
TEST(ArmEnds, StoppedWhileItEndsItGivesNoForceAfterwards) {
    Waiting program("ending");
    EXPECT_EQ(program.arm().force[2], 0);
    program.expect_stops_by(SIGTSTP);
    for (int round = 0; round < 5; ++round) {
        const auto then = program.arm().ticks;
        program.wait_until([&] { return program.arm().ticks > then + 10; });
        EXPECT_EQ(program.arm().force[2], 0);
    }
    program.expect_ends_without_force();
}

}  // namespace
}  // namespace thaum::input
