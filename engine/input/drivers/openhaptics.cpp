#include "input/drivers/openhaptics.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "core/clock.h"
#include "core/text.h"
#include "input/arm_silence.h"
#include "input/detail/hd_ticks.h"

namespace thaum::input {

using namespace hd;

/// What the threads that call the library share.
struct OpenHaptics::State {
    ArmPatience patience{};
    const Api* api{};
    Handle handle = invalid_handle;
    ArmFacts facts{};
    bool running = false;                ///< the library's scheduler
    std::atomic<unsigned long> task{0};  ///< the scheduler's number of our ticks, once they are accepted
    std::int64_t started_ns = 0;         ///< when ticks were asked for; 0: not yet
    std::unique_ptr<Ticks> ticks = std::make_unique<Ticks>();
};

namespace {

std::atomic<bool> in_use{false};
std::atomic<int> hanging{0};  ///< threads that wait for the library and were left behind

// ---- calibration -------------------------------------------------------------------------------------------------------

/// A task in the library's thread. It lives for ever, since the library may run it late.
struct Calibration {
    const Api* api{};
    Handle handle{};
    bool update = false;             ///< wanted: the arm calibrates itself, else: how it is
    std::atomic<bool> asked{false};  ///< the task counts once
    std::atomic<bool> done{false};
    std::atomic<unsigned int> status{0}, code{0};
};

Calibration& calibration() {
    static Calibration the;
    return the;
}

unsigned int do_calibration(void*) {
    auto& c = calibration();
    if (!c.asked.exchange(false)) return callback_done;
    const auto& api = *c.api;
    api.hdBeginFrame(c.handle);
    if (c.update)
        api.hdUpdateCalibration(api.hdCheckCalibrationStyle());
    else
        c.status = api.hdCheckCalibration();
    api.hdEndFrame(c.handle);
    c.code = take_error(api);
    c.done = true;
    return callback_done;
}

/// Runs the task, and returns the error: the task's, or that of a library that did not run it.
unsigned int run_calibration(const Api& api, Handle handle, bool update) {
    auto& c = calibration();
    c.api = &api;
    c.handle = handle;
    c.update = update;
    c.status = c.code = 0;
    c.done = false;
    c.asked = true;
    api.hdScheduleSynchronous(do_calibration, nullptr, first_priority);
    c.asked = false;
    const auto refused = take_error(api);
    return c.done ? c.code.load() : refused;
}

/// An arm that calibrates itself is asked to; others need a hand.
Expected<void> calibrate(const Api& api, Handle handle) {
    auto code = run_calibration(api, handle, false);
    if (code == 0 && calibration().status == calibration_needs_update) {
        code = run_calibration(api, handle, true);
        if (code == 0) code = run_calibration(api, handle, false);
    }
    if (code != 0) return fail(advice(api, code));
    if (calibration().status == calibration_ok) return {};
    return fail(
        "the arm is not calibrated: put the stylus into its inkwell (or the arm into its rest position) "
        "until "
        "its light is steady, and start again");
}

// ---- opening and closing, on a thread that may hang ------------------------------------------------------------------

/// On some systems only one of the names of the default arm works.
Expected<Handle> init_device(const Api& api) {
    unsigned int gravest = 0;
    take_error(api);  // what went wrong before is not this arm's fault
    for (const char* name : {static_cast<const char*>(nullptr), "Default Device", "Default PHANToM"}) {
        const auto handle = api.hdInitDevice(name);
        const auto code = take_error(api);
        if (code == 0 && handle != invalid_handle) return handle;
        gravest = std::max(gravest, code);  // a wrong name has a lower code than what is wrong with the arm
    }
    return fail(advice(api, gravest));
}

template <class State>
Expected<void> start_library(State& s, const std::string& library) {
    const auto loaded = load(library);
    if (!loaded) return tl::unexpected(loaded.error());
    const auto& api = **loaded;
    s.api = &api;
    const auto handle = init_device(api);
    if (!handle) return tl::unexpected(handle.error());
    s.handle = *handle;
    api.hdMakeCurrentDevice(*handle);
    if (const auto code = take_error(api); code != 0) return fail(advice(api, code));
    s.facts = facts_of(api);
    for (const auto capability : {force_output, max_force_clamping, force_ramping}) api.hdEnable(capability);
    api.hdSetSchedulerRate(servo_hz);
    api.hdStartScheduler();
    s.running = true;
    if (const auto code = take_error(api); code != 0) return fail(advice(api, code));
    if (auto calibrated = calibrate(api, *handle); !calibrated) return calibrated;
    if (s.facts.spec.peak_force <= 0) return fail("the arm does not say how much force it can give");
    return {};
}

template <class State>
void stop_library(State& s) {
    if (s.running) {
        s.api->hdStopScheduler();
        if (s.started_ns != 0 && !s.ticks->without_force) write_zero_frame(*s.api, s.handle);
        if (s.ticks->accepted && !s.ticks->ended) s.api->hdUnschedule(s.task);
    }
    if (s.handle != invalid_handle) s.api->hdDisableDevice(s.handle);
    if (s.api != nullptr) take_error(*s.api);
}

// ---- watched -----------------------------------------------------------------------------------------------------------

/// run_watched, which counts work that hangs until it returns after all.
Watched run_counted(std::int64_t limit_ns, const std::atomic<bool>* enough, std::function<void()> work,
                    const std::function<void()>& if_late) {
    auto watched = run_watched(limit_ns, enough, std::move(work), [=] {
        if_late();
        --hanging;
    });
    if (watched.end == Watched::End::hangs) ++hanging;
    return watched;
}

template <class State>
Expected<void> open_watched(const std::shared_ptr<State>& state, const std::string& library) {
    const auto result = std::make_shared<Expected<void>>();
    const auto watched = run_counted(
        state->patience.open_ns, state->patience.enough,
        [=] {
            *result = start_library(*state, library);
            if (!*result) stop_library(*state);
        },
        [=] {
            if (*result) stop_library(*state);
            in_use = false;
        });
    if (watched.end == Watched::End::in_time && *result) return {};
    if (watched.end != Watched::End::hangs) in_use = false;
    return watched.end == Watched::End::in_time ? *result : fail(watched.line);
}

/// Without force from the next tick on, for as long as ticks come; then nothing calls the step any more.
void end_ticks(Ticks& ticks) {
    constexpr std::int64_t patience_ns = 200'000'000, look_ns = 500'000;
    ticks.ending = true;
    const auto until = monotonic_ns() + patience_ns;
    while (!ticks.ended && monotonic_ns() < until) sleep_until_ns(monotonic_ns() + look_ns);
}

template <class State>
void close_watched(const std::shared_ptr<State>& state) {
    const auto stop = [=] { stop_library(*state); };
    const auto watched = run_counted(state->patience.close_ns, nullptr, stop, [] { in_use = false; });
    if (watched.end == Watched::End::no_thread) stop();
    if (watched.end != Watched::End::hangs) {
        in_use = false;
        return;
    }
    // The arm may still exert the last force. Its other door may be open, though the scheduler hangs.
    const auto disable = [=] {
        if (state->handle != invalid_handle) state->api->hdDisableDevice(state->handle);
    };
    run_watched(state->patience.close_ns, nullptr, disable, [] {});
}

/// Ticks in which the library hangs are never freed: it may come back to them.
template <class State>
void keep_for_ever(const std::shared_ptr<State>& state) {
    static auto* mutex = new std::mutex();
    static auto* kept = new std::vector<std::shared_ptr<State>>();
    const std::lock_guard lock(*mutex);
    kept->push_back(state);
}

}  // namespace

// ---- the arm -----------------------------------------------------------------------------------------------------------

OpenHaptics::OpenHaptics(std::shared_ptr<State> state) : state_(std::move(state)) {}

OpenHaptics::~OpenHaptics() {
    auto& s = *state_;
    if (s.started_ns != 0) {
        end_ticks(*s.ticks);
        if (!close_ticks(*s.ticks)) keep_for_ever(state_);
    }
    close_watched(state_);
}

bool OpenHaptics::hangs() { return hanging > 0; }

Expected<std::unique_ptr<OpenHaptics>> OpenHaptics::open(const std::string& library,
                                                         const ArmPatience& patience) {
    guard_ends();
    if (hangs())
        return fail(
            "the arm's library still hangs: end this program, switch the arm off and on, and start again");
    if (in_use.exchange(true)) return fail("OpenHaptics holds one arm, and that is open already");
    auto state = std::make_shared<State>();
    state->patience = patience;
    if (const auto opened = open_watched(state, library_name(library)); !opened)
        return tl::unexpected(opened.error());
    return std::unique_ptr<OpenHaptics>(new OpenHaptics(std::move(state)));
}

const ArmFacts& OpenHaptics::facts() const { return state_->facts; }

Expected<void> OpenHaptics::start(ArmTick tick) {
    auto& s = *state_;
    if (s.started_ns != 0) return fail("the arm was started already");
    s.started_ns = monotonic_ns();
    auto& ticks = *s.ticks;
    ticks.api = s.api;
    ticks.handle = s.handle;
    ticks.peak_force = s.facts.spec.peak_force;
    ticks.tick = tick;
    open_ticks(ticks);
    const auto result = std::make_shared<Expected<void>>();
    const auto schedule = [state = state_, result] {
        const auto& api = *state->api;
        state->task = api.hdScheduleAsynchronous(run_tick, argument_of(*state->ticks), first_priority);
        if (const auto code = take_error(api); code != 0)
            *result = fail(advice(api, code));
        else
            state->ticks->accepted = true;
    };
    const auto watched = run_counted(s.patience.open_ns, s.patience.enough, schedule, [] {});
    if (watched.end != Watched::End::in_time) return fail(watched.line);
    if (*result) s.started_ns = monotonic_ns();
    return *result;
}

ArmStatus OpenHaptics::status() const {
    constexpr std::int64_t silence_ns = 500'000'000;
    const auto& s = *state_;
    const auto newest = s.ticks->times.newest_ns();
    if (const auto code = s.ticks->code.load(); code != 0) {
        const bool silent = code == comm_error || code == comm_config || code == timer_error;
        return {silent ? ArmPresence::lost : ArmPresence::fault, advice(code, s.ticks->error_said.data()),
                newest};
    }
    if (s.started_ns == 0 || monotonic_ns() <= std::max(newest, s.started_ns) + silence_ns)
        return {.newest_ns = newest};
    return {ArmPresence::lost,
            newest != 0 ? "the arm's ticks have stopped: plug it in again"
                        : "the arm's ticks do not come: plug it in again; its driver may not be running",
            newest};
}

TickReport OpenHaptics::times() const { return state_->ticks->times.report(); }
bool OpenHaptics::preferred() const { return state_->ticks->preferred; }

}  // namespace thaum::input
