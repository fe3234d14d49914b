#include "input/detail/hd_ticks.h"

#include <pthread.h>
#include <sched.h>

#include <cstdint>

#include "core/clock.h"
#include "core/threads.h"
#include "input/detail/silence.h"

namespace thaum::input::hd {
namespace {

/// How far the call is that is within the ticks. The step's context belongs to others, so it may only be used while they know.
enum Phase : std::uint64_t { nobody = 0, with_library = 1, in_step = 2, left_behind = 3 };

/// The number of the ticks that count, and a Phase: one word, so that a call is let in, or not, by one comparison.
std::atomic<std::uint64_t> gate{0};
std::atomic<Ticks*> current{nullptr};
std::atomic<bool> silence{false};
std::atomic<int> stops{0};
thread_local Phase phase_of_thread = nobody;
/// The thread of the newest tick, named by its phase_of_thread.
std::atomic<const Phase*> newest_thread{nullptr};

constexpr std::uint64_t word(std::uint64_t number, Phase phase) { return number << 2U | phase; }

bool change(std::uint64_t number, Phase from, Phase to) {
    auto expected = word(number, from);
    if (!gate.compare_exchange_strong(expected, word(number, to))) return false;
    phase_of_thread = to;
    return true;
}

/// True where the thread now goes before ordinary ones. The library may have seen to that itself.
bool prefer_this_thread() {
    constexpr int above_all_ordinary = 50;
    int policy = 0;
    sched_param now{};
    if (::pthread_getschedparam(::pthread_self(), &policy, &now) == 0 && policy != SCHED_OTHER) return true;
    const sched_param wanted{.sched_priority = above_all_ordinary};
    return ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &wanted) == 0;
}

/// At its first tick.
void prepare_this_thread(Ticks& ticks) {
    static FaultStack stack;  // of the one thread that ticks
    stack.begin_use();
    ticks.preferred = prefer_this_thread();
}

/// The frame ends without force, and so do the ticks. The frame may have failed, so another one is tried.
unsigned int end_ticks(Ticks& ticks, unsigned int code) {
    const auto& api = *ticks.api;
    write(api, vec3(0));
    api.hdEndFrame(ticks.handle);
    ticks.without_force = take_error(api) == 0 || write_zero_frame(api, ticks.handle);
    if (code != 0) copy_error_string(api, code, ticks.error_said.data(), ticks.error_said.size());
    ticks.code = code;
    ticks.ended = true;
    return callback_done;
}

/// The force that answers the measurement (N). Nothing where the ticks were closed while the library kept this call waiting.
std::optional<vec3> answer(Ticks& ticks, const ArmReading& reading) {
    if (!change(ticks.number, with_library, in_step)) return {};
    const vec3 force = ticks.tick.step(ticks.tick.context, reading);
    change(ticks.number, in_step, with_library);
    return is_finite(force) ? limited(force, ticks.peak_force) : vec3(0);
}

unsigned int do_tick(Ticks& ticks) {
    const auto& api = *ticks.api;
    const auto now = monotonic_ns();
    if (ticks.times.newest_ns() == 0) prepare_this_thread(ticks);
    ticks.times.begins(now);
    api.hdBeginFrame(ticks.handle);
    const auto reading = read(api, now);
    if (const auto code = take_error(api); code != 0) return end_ticks(ticks, code);
    ticks.silent = false;  // before the look: whoever wants silence after it waits for the next tick
    const bool silent = silence || stops != 0 || !ticks.accepted;
    const auto force = ticks.ending ? std::nullopt : silent ? vec3(0) : answer(ticks, reading);
    if (!force) return end_ticks(ticks, 0);
    write(api, *force);
    api.hdEndFrame(ticks.handle);
    ticks.times.ends(monotonic_ns());
    const auto code = take_error(api);
    ticks.silent = silent;
    if (code == 0) return callback_continue;
    api.hdBeginFrame(ticks.handle);
    return end_ticks(ticks, code);
}

}  // namespace

void open_ticks(Ticks& ticks) {
    static std::atomic<std::uint64_t> opened{0};
    ticks.number = ++opened;
    current = &ticks;
    gate = word(ticks.number, nobody);
}

void* argument_of(const Ticks& ticks) {
    return reinterpret_cast<void*>(static_cast<std::uintptr_t>(ticks.number));
}

unsigned int run_tick(void* argument) {
    const auto number = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(argument));
    if (!change(number, nobody, with_library))
        return gate.load() >> 2U == number ? callback_continue : callback_done;
    newest_thread = &phase_of_thread;
    const auto next = do_tick(*current);
    change(number, with_library, nobody);
    phase_of_thread = nobody;
    return next;
}

bool close_ticks(Ticks& ticks) {
    constexpr std::int64_t patience_ns = 1'000'000'000, look_ns = 200'000;
    const auto until = monotonic_ns() + patience_ns;
    for (;;) {
        auto idle = word(ticks.number, nobody), waits = word(ticks.number, with_library);
        if (gate.compare_exchange_strong(idle, 0)) return true;
        const bool tired = monotonic_ns() > until;
        if (tired && gate.compare_exchange_strong(waits, word(ticks.number, left_behind))) return false;
        // A step is ours and short: it is waited for.
        sleep_until_ns(monotonic_ns() + look_ns);
    }
}

// ---- silence -----------------------------------------------------------------------------------------------------------

void silence_ticks(bool wanted) noexcept { silence = wanted; }
void begin_stop() noexcept { ++stops; }
void end_stop() noexcept { --stops; }

bool ticks_are_silent() noexcept {
    const auto now = gate.load();
    if (now == 0 || (now & 3U) == left_behind) return true;
    const Ticks& ticks = *current;
    return ticks.silent || ticks.ended;
}

bool is_arms_thread() noexcept { return gate != 0 && newest_thread == &phase_of_thread; }

void end_broken_tick() noexcept {
    const Ticks& ticks = *current;
    if (ticks.ended) return;
    if (phase_of_thread == nobody) ticks.api->hdBeginFrame(ticks.handle);
    write(*ticks.api, vec3(0));
    ticks.api->hdEndFrame(ticks.handle);
}

}  // namespace thaum::input::hd
