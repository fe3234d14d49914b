// Holds a force of 1 N with an arm (a haptic device) for 300 ticks. Prints one line with the result:
// "played", "lost: ..." or "refused: ...". Each call of the arm's library may take up to half a second.
//
//     arm_probe LIBRARY [END]
//
// END says how the program ends instead, after 100 ticks:
//
//     fault, abort, assertion, exception, exit, divide
//     overrun        the stack overflows
//     pipe           a write to a pipe without a reader
//     raise=SIGNAL   that signal
//     tick_...       one of the ends above, in the arm's own thread
//     beside_...     one of the ends above, at the same time in two threads beside the main thread
//     wait           the program runs until it is killed
//     ending         as wait, but the arm has been told to give no force
//     impatient      the program is asked to end before it opens the arm
#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <latch>
#include <stdexcept>
#include <string>

#include "core/assert.h"
#include "core/clock.h"
#include "core/threads.h"
#include "drivers/fake_hd/fake_hd.h"
#include "input/arm_silence.h"
#include "input/open_arm.h"

using namespace thaum;
using namespace thaum::input;

namespace {

int overrun(volatile int* before) {  // the endless recursion is the fault to test
    volatile int here[1024] = {before == nullptr ? 0 : before[0]};
    return here[0] == 1 ? 0 : overrun(here) + here[1];
}

void write_to_nobody() {
    int ends[2]{};
    if (::pipe(ends) != 0 || ::close(ends[0]) != 0) std::exit(4);
    if (::write(ends[1], "x", 1) == 1) std::exit(5);
}

[[noreturn]] void wait_to_be_killed() {
    std::printf("waits\n");
    std::fflush(stdout);
    for (;;) sleep_until_ns(monotonic_ns() + 1'000'000'000);
}

void end_by(const std::string& how) {
    static volatile int zero = 0;
    if (how.starts_with("raise=")) std::raise(std::stoi(how.substr(6)));
    if (how == "pipe") write_to_nobody();
    if (how == "fault") std::raise(SIGSEGV);
    if (how == "abort") std::abort();
    if (how == "assertion") THAUM_ASSERT(zero != 0, "an assertion that fails");
    if (how == "exception") throw std::runtime_error("an exception that nobody catches");
    if (how == "exit") std::exit(3);
    if (how == "overrun") std::exit(overrun(nullptr));
    if (how == "divide") std::exit(7 / zero);
    if (how == "wait") wait_to_be_killed();
    if (how == "ending") {
        silence_arms_and_wait();
        wait_to_be_killed();
    }
    if (how.starts_with("beside_")) {
        std::latch both(2);
        const auto end = [&] {
            both.arrive_and_wait();
            end_by(how.substr(7));
        };
        const auto one = start_thread(end), other = start_thread(end);
        wait_to_be_killed();
    }
}

struct Hand {
    std::atomic<std::uint64_t> ticks{0};
    std::string end{};

    static vec3 step(void* context, const ArmReading&) {
        auto& hand = *static_cast<Hand*>(context);
        if (++hand.ticks == 100 && hand.end.starts_with("tick_")) end_by(hand.end.substr(5));
        return {0, 0, 1};
    }
};

/// Waits until `enough` ticks have been played or the arm is lost. Returns the arm's last status.
ArmStatus play(const OpenArm& arm, const Hand& hand, std::uint64_t enough) {
    for (;;) {
        auto status = arm.status();
        if (status.state != ArmPresence::present || hand.ticks >= enough) return status;
        sleep_until_ns(monotonic_ns() + 2'000'000);
    }
}

/// If the fake library's script makes it call tasks after its end (callback=after_end), waits for 100 such
/// calls.
void outlive_calls_after_end(const char* library) {
    const char* script = std::getenv("FAKE_HD");
    if (script == nullptr || std::string(script).find("after_end") == std::string::npos) return;
    const auto report =
        reinterpret_cast<FakeHdReport (*)()>(::dlsym(::dlopen(library, RTLD_LAZY), "fakeHdReport"));
    while (report().calls_after_end < 100) sleep_until_ns(monotonic_ns() + 2'000'000);
}

/// Time limit for the library to open and to close the arm. The test of modes (arm_modes_test.cpp) sets the
/// variable only where the call must hang; in other cases a busy machine may delay a call that works.
std::int64_t patience_ns(const char* variable) {
    constexpr std::int64_t generous_ms = 60'000;
    const char* ms = std::getenv(variable);
    return (ms != nullptr ? std::atoll(ms) : generous_ms) * 1'000'000;
}

std::string run(const char* library, const std::string& end) {
    const std::atomic<bool> impatient = end == "impatient";
    ::setenv("THAUM_LIBHD", library, 1);
    const auto places = arm_places();
    if (places.empty()) return "refused: no driver";
    auto arm =
        open_arm(places.front(), impatient ? ArmPatience{.enough = &impatient}
                                           : ArmPatience{.open_ns = patience_ns("ARM_PROBE_OPEN_MS"),
                                                         .close_ns = patience_ns("ARM_PROBE_CLOSE_MS")});
    if (!arm) return "refused: " + arm.error().message;
    auto hand = std::make_unique<Hand>();
    hand->end = end;
    if (const auto started = (*arm)->start({Hand::step, hand.get()}); !started)
        return "refused: " + started.error().message;
    const auto status = play(**arm, *hand, end.empty() ? 300 : 100);
    if (!end.empty()) end_by(end);
    const auto name = name_of((*arm)->facts()) + " " + (*arm)->facts().driver;
    arm->reset();
    const auto ticks = hand->ticks.load();
    outlive_calls_after_end(library);
    if (hand->ticks != ticks) return "called after its end";
    return status.state == ArmPresence::present ? "played with " + name : "lost: " + status.text;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    std::printf("%s\n", run(argv[1], argc > 2 ? argv[2] : "").c_str());
    if (!arms_hang()) return 0;
    std::fflush(nullptr);
    std::_Exit(0);
}
