#include "input/detail/arm_ticks.h"

#include <pthread.h>
#include <sched.h>

#include <array>
#include <optional>

#include "core/clock.h"
#include "core/threads.h"
#include "input/detail/silence.h"
#include "input/open_arm.h"

namespace thaum::input {
namespace {

/// Progress of the call that runs a tick. The step is a function of the code that uses the arm, with a
/// context that belongs to that code. A tick may use the context only in the phase `in_step`, during which
/// close_ticks waits.
enum Phase : std::uint64_t { nobody = 0, in_driver = 1, in_step = 2, left_behind = 3 };

/// The entry of an open arm in the table of this process.
struct Slot {
    /// Number of the open arm and the Phase of its tick in one word, so that one comparison admits or refuses
    /// a call; 0: free.
    std::atomic<std::uint64_t> gate{0};
    std::atomic<ArmTicks*> ticks{nullptr};
    /// Servo thread of the newest tick: address of its thread_mark.
    std::atomic<const char*> thread{nullptr};
};

constexpr int servo_priority = 50;  // priority above all ordinary threads

std::array<Slot, max_open_arms> slots;
std::atomic<bool> silence_wanted{false};
std::atomic<int> stops{0};
thread_local char thread_mark = 0;  ///< the address of this variable identifies the thread

constexpr std::uint64_t word(std::uint64_t number, Phase phase) { return number << 2U | phase; }

/// The entry, in the table of open arms, of the arm whose ticks have this number.
Slot& slot_of(std::uint64_t number) { return slots[number % slots.size()]; }

bool change(std::uint64_t number, Phase from, Phase to) {
    auto expected = word(number, from);
    return slot_of(number).gate.compare_exchange_strong(expected, word(number, to));
}

// ---- functions of the servo thread ------------------------------------------------------------------------

/// A signal stack for a vendor's thread, which start_thread has not given one. Freed when the thread ends.
struct ThreadsFaultStack {
    std::unique_ptr<FaultStack> stack = std::make_unique_for_overwrite<FaultStack>();
    ThreadsFaultStack() { stack->begin_use(); }
    ~ThreadsFaultStack() { stack->end_use(); }
    ThreadsFaultStack(const ThreadsFaultStack&) = delete;
    ThreadsFaultStack& operator=(const ThreadsFaultStack&) = delete;
};

/// Prepares the servo thread at the arm's first tick.
void prepare_this_thread(ArmTicks& ticks) {
    static thread_local const ThreadsFaultStack stack;
    static_cast<void>(stack);
    ticks.preferred = prefer_this_thread(servo_priority);
}

/// Ends the ticks with zero as the last force. The zero comes before the driver's `note`, which stores the
/// vendor's message about the fault, because the driver may hang in it.
bool end_ticks(ArmTicks& ticks, ArmFault fault) {
    if (ticks.driver->write_zero()) ticks.pushes = false;
    if (fault != 0) ticks.driver->note(fault);
    ticks.fault = fault;
    ticks.ended = true;
    return false;
}

/// Passes the measurement to the step function of the code that uses the arm, and returns the force that it
/// wants (N). std::nullopt if close_ticks() was called while this tick hung in the driver.
std::optional<vec3> answer(ArmTicks& ticks, const ArmReading& reading) {
    if (!change(ticks.number, in_driver, in_step)) return {};
    const vec3 force = ticks.tick.step(ticks.tick.context, reading);
    change(ticks.number, in_step, in_driver);
    return is_finite(force) ? limited(force, ticks.peak_force) : vec3(0);
}

/// The force to send. If ticks had stopped and the watchdog has ended the force, it comes back gradually,
/// over `ramp_ticks`.
vec3 resumed(ArmTicks& ticks, vec3 force) {
    constexpr std::uint32_t ramp_ticks = 50;
    if (ticks.stalled.exchange(false)) ticks.resumed = 1;
    if (ticks.resumed == 0) return force;
    const vec3 part = force * ((ticks.resumed - 1.0) / ramp_ticks);
    ticks.resumed = ticks.resumed < ramp_ticks ? ticks.resumed + 1 : 0;
    return part;
}

/// Sends a force to the arm. `pushes` is set before a force and cleared after a zero, so that the watchdog
/// never takes a pushing arm for a resting one.
ArmFault give(ArmTicks& ticks, vec3 force) {
    const bool pushes = force != vec3(0);
    if (pushes) ticks.pushes = true;
    const auto fault = ticks.driver->write(force);
    if (!pushes && fault == 0) ticks.pushes = false;
    return fault;
}

bool do_tick(ArmTicks& ticks) {
    const auto now = monotonic_ns();
    if (ticks.times.newest_ns() == 0) prepare_this_thread(ticks);
    ticks.times.begins(now);
    ArmReading reading{.time_ns = now};
    if (const auto fault = ticks.driver->read(reading); fault != 0) return end_ticks(ticks, fault);
    // Cleared before the check below: if another thread asks for silence after this check, it must wait for
    // the next tick.
    ticks.silent = false;
    const bool silent = silence_wanted || stops != 0 || !ticks.accepted;
    const auto force = ticks.ending ? std::nullopt : silent ? vec3(0) : answer(ticks, reading);
    if (!force) return end_ticks(ticks, 0);
    const auto fault = give(ticks, resumed(ticks, *force));
    ticks.times.ends(monotonic_ns());
    ticks.silent = silent;
    return fault == 0 || end_ticks(ticks, fault);
}

}  // namespace

bool prefer_this_thread(int priority) {
    int policy = 0;
    sched_param now{};
    // The vendor's library may already have raised the priority of its own thread, which then stays as it is.
    if (::pthread_getschedparam(::pthread_self(), &policy, &now) == 0 && policy != SCHED_OTHER) return true;
    const sched_param wanted{.sched_priority = priority};
    return ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &wanted) == 0;
}

bool open_ticks(ArmTicks& ticks) {
    static std::atomic<std::uint64_t> opened{0};
    const auto generation = ++opened;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        auto& slot = slots[i];
        const auto number = generation * slots.size() + i;
        std::uint64_t free = 0;
        if (!slot.gate.compare_exchange_strong(free, word(number, left_behind))) continue;
        ticks.number = number;
        slot.ticks = &ticks;
        slot.thread = nullptr;
        slot.gate = word(number, nobody);
        return true;
    }
    return false;
}

bool run_tick(std::uint64_t number) noexcept {
    auto& slot = slot_of(number);
    if (!change(number, nobody, in_driver)) return slot.gate.load() >> 2U == number;
    slot.thread = &thread_mark;
    auto& ticks = *slot.ticks.load();
    const bool more = do_tick(ticks);
    ++ticks.done;
    change(number, in_driver, nobody);
    return more;
}

bool close_ticks(ArmTicks& ticks) {
    constexpr std::int64_t patience_ns = 1'000'000'000, look_ns = 200'000;
    auto& gate = slot_of(ticks.number).gate;
    const auto until = monotonic_ns() + patience_ns;
    for (;;) {
        auto idle = word(ticks.number, nobody), waits = word(ticks.number, in_driver);
        if (gate.compare_exchange_strong(idle, 0)) return true;
        const bool tired = monotonic_ns() > until;
        if (tired && gate.compare_exchange_strong(waits, word(ticks.number, left_behind))) return false;
        // The step function of the code that uses the arm is short, so this thread waits until it has ended.
        sleep_until_ns(monotonic_ns() + look_ns);
    }
}

// ---- ending the forces ------------------------------------------------------------------------------------

namespace ticks {
namespace {

bool is_of_this_thread(const Slot& slot) { return slot.gate != 0 && slot.thread == &thread_mark; }

bool is_silent(const Slot& slot) {
    const auto gate = slot.gate.load();
    if (gate == 0 || (gate & 3U) == left_behind) return true;
    const ArmTicks& open = *slot.ticks;
    return open.silent || open.ended;
}

}  // namespace

void silence(bool wanted) noexcept { silence_wanted = wanted; }
void begin_stop() noexcept { ++stops; }
void end_stop() noexcept { --stops; }

bool are_silent() noexcept {
    for (const auto& slot : slots)
        if (!is_silent(slot)) return false;
    return true;
}

bool is_arms_thread() noexcept {
    for (const auto& slot : slots)
        if (is_of_this_thread(slot)) return true;
    return false;
}

void end_broken() noexcept {
    for (auto& slot : slots) {
        if (!is_of_this_thread(slot)) continue;
        ArmTicks& open = *slot.ticks;
        if (!open.ended) open.driver->write_zero();
        open.ended = true;  // so that no other thread waits for a further tick of this arm
    }
}

}  // namespace ticks
}  // namespace thaum::input
