#include "input/open_arm.h"

#include <algorithm>
#include <mutex>
#include <set>

#include "core/clock.h"
#include "core/one_line.h"
#include "core/text.h"
#include "core/threads.h"
#include "input/arm_silence.h"
#include "input/detail/arm_ticks.h"
#include "input/detail/stall_watch.h"
#include "input/detail/watchdog.h"

namespace thaum::input {

/// State of a thread of the engine that calls an arm's driver: the servo thread, unless the driver brings its
/// own, or the watchdog.
enum class OwnThread : std::uint8_t { none, runs, ended, given_up };

namespace {

constexpr std::size_t max_name = 80;  ///< longest text of an arm, such as its serial number (bytes)
constexpr std::size_t max_line = 600;

}  // namespace

/// Data that all threads which call the driver share.
struct OpenArm::State : std::enable_shared_from_this<OpenArm::State> {
    ArmPlace place{};
    ArmPatience patience{};
    ArmFacts facts{};
    std::int64_t started_ns = 0;  ///< time at which ticks were started; 0: not yet (ns)
    std::atomic<OwnThread> servo{OwnThread::none}, watch{OwnThread::none};
    std::unique_ptr<ArmDriver> driver{};
    std::unique_ptr<ArmTicks> ticks = std::make_unique<ArmTicks>();
};

namespace {

// ---- arms in use ------------------------------------------------------------------------------------------

/// Arms that are open, and calls of drivers that hang. Never destroyed, because a
/// thread that hangs may use it late.
struct Usage {
    std::mutex mutex{};
    std::set<std::pair<std::string_view, std::string>> open{};
    std::multiset<std::string_view> hanging{};  ///< name of the driver for each thread that was abandoned
};

Usage& usage() {
    static auto* the = new Usage();
    return *the;
}

/// Reserves an arm, so that it is opened only once. The error says that the arm is open already, or that a
/// call of its driver hangs.
Expected<void> occupy(const ArmPlace& place) {
    auto& u = usage();
    const std::lock_guard lock(u.mutex);
    if (u.hanging.contains(place.kind->name))
        return fail(
            "the arm's library still hangs: end this program, switch the arm off and on, and start again");
    if (!u.open.emplace(place.kind->name, place.arm).second)
        return fail("the arm is open already: close it first");
    return {};
}

void vacate(const ArmPlace& place) {
    auto& u = usage();
    const std::lock_guard lock(u.mutex);
    u.open.erase({place.kind->name, place.arm});
}

void note_hanging(std::string_view driver, bool hangs) {
    auto& u = usage();
    const std::lock_guard lock(u.mutex);
    if (hangs)
        u.hanging.insert(driver);
    else if (const auto one = u.hanging.find(driver); one != u.hanging.end())
        u.hanging.erase(one);
}

/// Runs work on a thread of its own and waits for it for a limited time (run_watched). Work that does not
/// return in time is counted as hanging until it does.
Watched run_counted(std::string_view driver, std::int64_t limit_ns, const std::atomic<bool>* enough,
                    std::function<void()> work, const std::function<void()>& if_late) {
    auto watched = run_watched(limit_ns, enough, std::move(work), [=] {
        if_late();
        note_hanging(driver, false);
    });
    if (watched.end == Watched::End::hangs) note_hanging(driver, true);
    return watched;
}

// ---- checks of facts --------------------------------------------------------------------------------------

/// A number from 0 to `most`; 0 if it is anything else.
double believable(double value, double most) { return value >= 0 && value <= most ? value : 0; }

/// Facts with short, printable texts and possible numbers.
ArmFacts checked(ArmFacts facts) {
    // Largest values that are believed. No arm is stronger, stiffer or wider, so a larger value has another
    // unit or is invalid.
    constexpr double max_force = 100, max_stiffness = 1e5, max_damping = 1e3, max_edge = 10, max_rate = 1e5;
    constexpr int max_freedom = 16;
    auto& spec = facts.spec;
    for (auto* words : {&spec.name, &facts.serial, &facts.driver, &facts.family})
        *words = printable(*words, max_name);
    spec.sensed = std::clamp(spec.sensed, 0, max_freedom);
    spec.actuated = std::clamp(spec.actuated, 0, max_freedom);
    spec.peak_force = believable(spec.peak_force, max_force);
    spec.continuous_force = std::min(believable(spec.continuous_force, max_force), spec.peak_force);
    spec.max_stiffness = believable(spec.max_stiffness, max_stiffness);
    spec.max_damping = believable(spec.max_damping, max_damping);
    for (int axis = 0; axis < 3; ++axis) spec.workspace[axis] = believable(spec.workspace[axis], max_edge);
    spec.update_rate = believable(spec.update_rate, max_rate);
    return facts;
}

Error cleaned(const Error& error) { return Error{printable(error.message, max_line)}; }

// ---- opening and closing, on a thread that may hang -------------------------------------------------------

template <class State>
Expected<void> take_arm(State& s) {
    s.driver = s.place.kind->make(s.place.arm);
    if (auto opened = s.driver->open(); !opened) return cleaned(opened.error());
    s.facts = checked(s.driver->spec());
    if (s.facts.spec.peak_force > 0) return {};
    s.driver->close();
    return fail("the arm does not say how much force it can give");
}

template <class State>
Expected<void> open_watched(const std::shared_ptr<State>& state) {
    const auto result = std::make_shared<Expected<void>>();
    const auto watched = run_counted(
        state->place.kind->name, state->patience.open_ns, state->patience.enough,
        [=] { *result = take_arm(*state); },
        [=] {
            if (*result) state->driver->close();
            vacate(state->place);
        });
    if (watched.end == Watched::End::in_time && *result) return {};
    if (watched.end != Watched::End::hangs) vacate(state->place);
    return watched.end == Watched::End::in_time ? *result : fail(watched.line);
}

/// Ends the force at the next tick, which is also the last.
void end_ticks(ArmTicks& ticks) {
    constexpr std::int64_t patience_ns = 200'000'000, look_ns = 500'000;
    ticks.ending = true;
    const auto until = monotonic_ns() + patience_ns;
    while (!ticks.ended && monotonic_ns() < until) sleep_until_ns(monotonic_ns() + look_ns);
}

template <class State>
void close_watched(const std::shared_ptr<State>& state) {
    const auto& place = state->place;
    const auto close = [=] { state->driver->close(); };
    const auto watched = run_counted(place.kind->name, state->patience.close_ns, nullptr, close,
                                     [=] { vacate(state->place); });
    if (watched.end == Watched::End::no_thread) close();
    if (watched.end != Watched::End::hangs) return vacate(place);
    // The arm may still exert its last force, and another call of the driver may succeed in ending it.
    run_watched(
        state->patience.close_ns, nullptr, [=] { state->driver->give_up(); }, [] {});
}

/// Keeps the state of an arm in memory until the program ends. Its driver hangs, and may still use the state.
template <class State>
void keep_for_ever(const std::shared_ptr<State>& state) {
    static auto* mutex = new std::mutex();
    static auto* kept = new std::vector<std::shared_ptr<State>>();
    const std::lock_guard lock(*mutex);
    kept->push_back(state);
}

// ---- the engine's threads ---------------------------------------------------------------------------------

/// Runs the body in a thread. From the time at which the thread is given up until it ends, it is counted as
/// hanging.
template <class State, class Body>
Expected<void> start_own(const std::shared_ptr<State>& state, std::atomic<OwnThread> State::*which,
                         Body body) {
    (*state).*which = OwnThread::runs;
    auto thread = start_thread([=] {
        body(*state);
        if (((*state).*which).exchange(OwnThread::ended) == OwnThread::given_up)
            note_hanging(state->place.kind->name, false);
    });
    if (!thread) {
        (*state).*which = OwnThread::none;
        return thread.error();
    }
    thread->detach();  // the thread ends with the ticks; if it hangs in the driver, it cannot be joined
    return {};
}

/// Waits until a thread of the engine has left the driver, so that no other call of the driver runs beside
/// `close`.
void leave(std::atomic<OwnThread>& thread, std::string_view driver) {
    constexpr std::int64_t patience_ns = 100'000'000, look_ns = 200'000;
    const auto until = monotonic_ns() + patience_ns;
    while (thread == OwnThread::runs && monotonic_ns() < until) sleep_until_ns(monotonic_ns() + look_ns);
    auto runs = OwnThread::runs;
    if (thread.compare_exchange_strong(runs, OwnThread::given_up)) note_hanging(driver, true);
}

/// Runs a tick each millisecond until the arm needs no more ticks.
void run_servo(ArmTicks& ticks) {
    constexpr std::int64_t period_ns = 1'000'000, max_late_ns = 5 * period_ns;
    auto due = monotonic_ns();
    while (run_tick(ticks.number)) {
        due += period_ns;
        if (monotonic_ns() > due + max_late_ns) due = monotonic_ns();
        sleep_until_ns(due);
    }
}

/// Watches the ticks until the arm is closed, and ends the arm's force if they stop.
template <class State>
void run_watch(State& s) {
    // Longest time for which a give_up that hangs delays the next call of it. The driver may try another way
    // then.
    constexpr std::int64_t patience_ns = 200'000'000;
    const auto name = s.place.kind->name;
    const auto state = s.shared_from_this();
    watch_for_stalls(*s.ticks, s.place.kind->at_hang, [&] {
        run_counted(
            name, patience_ns, nullptr, [state] { state->driver->give_up(); }, [] {});
    });
}

template <class State>
Expected<void> start_watch(const std::shared_ptr<State>& state) {
    if (state->place.kind->at_hang == AtHang::keeps_force) return {};
    return start_own(state, &State::watch, [](State& s) { run_watch(s); });
}

/// Asks the driver to start ticks, or starts the engine's thread. Ticks give no force before the watchdog
/// runs.
template <class State>
Expected<void> start_ticks(const std::shared_ptr<State>& state) {
    const auto by_vendor = state->driver->start(state->ticks->number);
    if (!by_vendor) return cleaned(by_vendor.error());
    if (auto watched = start_watch(state); !watched) return watched;
    state->ticks->accepted = true;
    if (*by_vendor) return {};
    return start_own(state, &State::servo, [](State& s) { run_servo(*s.ticks); });
}

}  // namespace

// ---- OpenArm ----------------------------------------------------------------------------------------------

OpenArm::OpenArm(std::shared_ptr<State> state) : state_(std::move(state)) {}

OpenArm::~OpenArm() {
    auto& s = *state_;
    if (s.started_ns != 0) {
        end_ticks(*s.ticks);
        if (!close_ticks(*s.ticks)) keep_for_ever(state_);
        leave(s.servo, s.place.kind->name);
        s.ticks->unwatched = true;
        leave(s.watch, s.place.kind->name);
    }
    close_watched(state_);
}

const ArmFacts& OpenArm::facts() const { return state_->facts; }

Expected<void> OpenArm::start(ArmTick tick) {
    auto& s = *state_;
    if (s.started_ns != 0) return fail("the arm was started already");
    auto& ticks = *s.ticks;
    ticks.driver = s.driver.get();
    ticks.peak_force = s.facts.spec.peak_force;
    ticks.tick = tick;
    if (!open_ticks(ticks)) return fail(text("at most ", max_open_arms, " arms can tick: close another one"));
    s.started_ns = monotonic_ns();
    const auto result = std::make_shared<Expected<void>>();
    const auto watched = run_counted(
        s.place.kind->name, s.patience.open_ns, s.patience.enough,
        [state = state_, result] { *result = start_ticks(state); }, [] {});
    if (watched.end != Watched::End::in_time) return fail(watched.line);
    if (*result) s.started_ns = monotonic_ns();
    return *result;
}

ArmStatus OpenArm::status() const {
    constexpr std::int64_t silence_ns = 500'000'000;
    const auto& s = *state_;
    const auto newest = s.ticks->times.newest_ns();
    if (const auto fault = s.ticks->fault.load(); fault != 0) {
        auto status = s.driver->status(fault);
        status.text = printable(status.text, max_line);
        status.newest_ns = newest;
        return status;
    }
    if (s.started_ns == 0 || monotonic_ns() <= std::max(newest, s.started_ns) + silence_ns)
        return {.newest_ns = newest};
    return {ArmPresence::lost,
            newest != 0 ? "the arm's ticks have stopped: plug it in again"
                        : "the arm's ticks do not come: plug it in again; its driver may not be running",
            newest};
}

TickReport OpenArm::times() const { return state_->ticks->times.report(); }
bool OpenArm::preferred() const { return state_->ticks->preferred; }

// ---- the list of arms -------------------------------------------------------------------------------------

std::vector<ArmPlace> arm_places() {
    constexpr std::int64_t patience_ns = 3'000'000'000;
    std::vector<ArmPlace> places;
    for (const auto& kind : arm_drivers()) {
        const auto arms = std::make_shared<std::vector<std::string>>();
        const auto watched = run_counted(
            kind.name, patience_ns, nullptr, [find = kind.find, arms] { *arms = find(); }, [] {});
        if (watched.end != Watched::End::in_time) continue;
        for (auto& arm : *arms) places.push_back({&kind, std::move(arm)});
    }
    return places;
}

bool arms_hang() {
    auto& u = usage();
    const std::lock_guard lock(u.mutex);
    return !u.hanging.empty();
}

Expected<std::unique_ptr<OpenArm>> open_arm(const ArmPlace& place, const ArmPatience& patience) {
    guard_ends();
    if (auto free = occupy(place); !free) return free.error();
    auto state = std::make_shared<OpenArm::State>();
    state->place = place;
    state->patience = patience;
    if (const auto opened = open_watched(state); !opened) return opened.error();
    return std::unique_ptr<OpenArm>(new OpenArm(std::move(state)));
}

}  // namespace thaum::input
