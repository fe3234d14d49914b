#include "input/drivers/openhaptics.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>

#include "core/clock.h"
#include "core/text.h"

namespace thaum::input {
namespace {

// ---- the library's words ---------------------------------------------------------------------------------------------

using Handle = unsigned int;
using Callback = unsigned int (*)(void*);

constexpr Handle invalid_handle = 0xffffffff;
constexpr unsigned int callback_done = 0, callback_continue = 1;
constexpr unsigned short first_priority = 65535;
constexpr unsigned long servo_hz = 1000;

enum Name : unsigned int {
    current_buttons = 0x2000,
    current_position = 0x2050,   // mm
    current_transform = 0x2052,  // 16 numbers, column by column
    version = 0x2500,
    model_type = 0x2501,
    serial_number = 0x2504,
    usable_workspace = 0x2551,  // mm: least x y z, most x y z
    input_dof = 0x2553,
    output_dof = 0x2554,
    update_rate = 0x2600,
    nominal_max_stiffness = 0x2602,  // N/mm
    nominal_max_force = 0x2603,      // N
    nominal_max_continuous_force = 0x2604,
    nominal_max_damping = 0x2609,  // N/(mm/s)
    current_force = 0x2700,        // N
    force_output = 0x4000,
    max_force_clamping = 0x4001,
    force_ramping = 0x4002,
    calibration_ok = 0x5000,
    calibration_needs_update = 0x5001,
};

enum Code : unsigned int {
    warm_motors = 0x0200,
    last_force_error = 0x02ff,
    device_fault = 0x0300,
    already_initiated = 0x0301,
    comm_error = 0x0302,
    comm_config = 0x0303,
    timer_error = 0x0304,
    invalid_license = 0x0600,
};

struct ErrorInfo {
    unsigned int code;
    int internal;
    Handle device;
};

/// The functions that we call. All are needed: a library without one of them is too old.
struct Api {
    Handle (*hdInitDevice)(const char*);
    void (*hdDisableDevice)(Handle);
    void (*hdMakeCurrentDevice)(Handle);
    void (*hdBeginFrame)(Handle);
    void (*hdEndFrame)(Handle);
    void (*hdGetIntegerv)(unsigned int, int*);
    void (*hdGetDoublev)(unsigned int, double*);
    void (*hdSetDoublev)(unsigned int, const double*);
    const char* (*hdGetString)(unsigned int);
    void (*hdEnable)(unsigned int);
    ErrorInfo (*hdGetError)();
    const char* (*hdGetErrorString)(unsigned int);
    void (*hdStartScheduler)();
    void (*hdStopScheduler)();
    void (*hdSetSchedulerRate)(unsigned long);
    void (*hdScheduleSynchronous)(Callback, void*, unsigned short);
    unsigned long (*hdScheduleAsynchronous)(Callback, void*, unsigned short);
    void (*hdUnschedule)(unsigned long);
    unsigned int (*hdCheckCalibration)();
    unsigned int (*hdCheckCalibrationStyle)();
    void (*hdUpdateCalibration)(unsigned int);
};

/// Finds functions by name; remembers the first that is missing.
struct Finder {
    void* library;
    const char* missing = nullptr;

    template <class F>
    void find(F& function, const char* name) {
        function = reinterpret_cast<F>(::dlsym(library, name));
        if (function == nullptr && missing == nullptr) missing = name;
    }
};

const char* find_all(void* library, Api& api) {
    Finder finder{library};
    finder.find(api.hdInitDevice, "hdInitDevice");
    finder.find(api.hdDisableDevice, "hdDisableDevice");
    finder.find(api.hdMakeCurrentDevice, "hdMakeCurrentDevice");
    finder.find(api.hdBeginFrame, "hdBeginFrame");
    finder.find(api.hdEndFrame, "hdEndFrame");
    finder.find(api.hdGetIntegerv, "hdGetIntegerv");
    finder.find(api.hdGetDoublev, "hdGetDoublev");
    finder.find(api.hdSetDoublev, "hdSetDoublev");
    finder.find(api.hdGetString, "hdGetString");
    finder.find(api.hdEnable, "hdEnable");
    finder.find(api.hdGetError, "hdGetError");
    finder.find(api.hdGetErrorString, "hdGetErrorString");
    finder.find(api.hdStartScheduler, "hdStartScheduler");
    finder.find(api.hdStopScheduler, "hdStopScheduler");
    finder.find(api.hdSetSchedulerRate, "hdSetSchedulerRate");
    finder.find(api.hdScheduleSynchronous, "hdScheduleSynchronous");
    finder.find(api.hdScheduleAsynchronous, "hdScheduleAsynchronous");
    finder.find(api.hdUnschedule, "hdUnschedule");
    finder.find(api.hdCheckCalibration, "hdCheckCalibration");
    finder.find(api.hdCheckCalibrationStyle, "hdCheckCalibrationStyle");
    finder.find(api.hdUpdateCalibration, "hdUpdateCalibration");
    return finder.missing;
}

// ---- loading -----------------------------------------------------------------------------------------------------------

std::string library_name(const std::string& given) {
    if (!given.empty()) return given;
    const char* set = std::getenv("THAUM_LIBHD");
    return set != nullptr && *set != '\0' ? set : "libHD.so";
}

/// libHD takes symbols of libraries that it brings along, hence RTLD_GLOBAL.
Expected<Api> load(const std::string& name) {
    void* library = ::dlopen(name.c_str(), RTLD_LAZY | RTLD_GLOBAL);
    if (library == nullptr) {
        const char* why = ::dlerror();
        return fail(text("no OpenHaptics: ", why != nullptr ? why : name.c_str(),
                         "; install the arm's driver and OpenHaptics, or say in THAUM_LIBHD where libHD.so "
                         "is"));
    }
    Api api{};
    if (const char* missing = find_all(library, api); missing != nullptr)
        return fail(text(name, " is too old: it lacks ", missing, "; install OpenHaptics 3.4 or newer"));
    return api;
}

/// All that went wrong since the last call; the first of it, since the others follow from it.
unsigned int take_error(const Api& api) {
    constexpr int more_than_a_stack = 64;
    unsigned int first = 0;
    for (int i = 0; i < more_than_a_stack; ++i) {
        const auto code = api.hdGetError().code;
        if (code == 0) break;
        first = code;  // the stack gives the newest first
    }
    return first;
}

std::string name_of_code(const Api& api, unsigned int code) {
    const char* said = api.hdGetErrorString(code);
    return text(said != nullptr ? said : "unknown", " (", hex(code).substr(12), ")");
}

std::string advice(const Api& api, unsigned int code) {
    const auto what = name_of_code(api, code);
    switch (code) {
        case already_initiated: return text("another program has the arm: close it; ", what);
        case comm_error:
        case comm_config:
            return text(
                "the arm does not answer: plug it in and switch it on; if it is, this user may not open its "
                "port: give it the right (a udev rule, or the group that owns the port); ",
                what);
        case device_fault: return text("the arm reports a fault: switch it off and on; ", what);
        case invalid_license: return text("OpenHaptics has no valid licence: install one; ", what);
        case warm_motors: return text("the arm's motors are too warm: let them rest; ", what);
        default: break;
    }
    if (code > warm_motors && code <= last_force_error)
        return text("the arm has cut the force out: let go of it and start again; ", what);
    return text("OpenHaptics refuses: ", what);
}

/// On some systems only one of the names of the default arm works.
Expected<Handle> init_device(const Api& api) {
    unsigned int gravest = 0;
    for (const char* name : {static_cast<const char*>(nullptr), "Default Device", "Default PHANToM"}) {
        const auto handle = api.hdInitDevice(name);
        const auto code = take_error(api);
        if (code == 0 && handle != invalid_handle) return handle;
        gravest = std::max(gravest, code);  // a wrong name has a lower code than what is wrong with the arm
    }
    return fail(advice(api, gravest));
}

std::string string_of(const Api& api, Name name) {
    const char* said = api.hdGetString(name);
    take_error(api);
    return said != nullptr ? said : "";
}

double number_of(const Api& api, Name name) {
    double value = 0;
    api.hdGetDoublev(name, &value);
    return take_error(api) == 0 && std::isfinite(value) ? value : 0;
}

int integer_of(const Api& api, Name name) {
    int value = 0;
    api.hdGetIntegerv(name, &value);
    return take_error(api) == 0 ? value : 0;
}

vec3 workspace_of(const Api& api) {
    std::array<double, 6> mm{};
    api.hdGetDoublev(usable_workspace, mm.data());
    const vec3 edges = vec3(mm[3] - mm[0], mm[4] - mm[1], mm[5] - mm[2]) * 1e-3;
    return take_error(api) == 0 && is_finite(edges) ? edges : vec3(0);
}

ArmFacts facts_of(const Api& api) {
    ArmFacts facts;
    auto& spec = facts.spec;
    spec.name = string_of(api, model_type);
    spec.sensed = integer_of(api, input_dof);
    spec.actuated = integer_of(api, output_dof);
    spec.peak_force = number_of(api, nominal_max_force);
    spec.continuous_force = number_of(api, nominal_max_continuous_force);
    spec.max_stiffness = number_of(api, nominal_max_stiffness) * 1e3;
    spec.max_damping = number_of(api, nominal_max_damping) * 1e3;
    spec.workspace = workspace_of(api);
    spec.update_rate = integer_of(api, update_rate);
    facts.serial = string_of(api, serial_number);
    facts.driver = string_of(api, version);
    return facts;
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

}  // namespace

// ---- the arm -----------------------------------------------------------------------------------------------------------

struct OpenHaptics::State {
    Api api{};
    Handle handle = invalid_handle;
    ArmFacts facts{};
    ArmTick tick{};
    unsigned long task = 0;
    bool running = false;
    TickTimes times{};
    std::atomic<unsigned int> code{0};  ///< the error that ended the ticks
    std::atomic<bool> ending{false};    ///< the next tick is the last
    std::atomic<bool> ended{false};
    std::atomic<bool> preferred{false};

    static inline std::atomic<bool> in_use{false};

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State();
};

namespace {

/// What a task in the library's thread is to do with the calibration, and what it finds.
struct Calibration {
    const Api& api;
    Handle handle;
    unsigned int status{};
    unsigned int code{};
};

unsigned int check_calibration(void* context) {
    auto& calibration = *static_cast<Calibration*>(context);
    const auto& api = calibration.api;
    api.hdBeginFrame(calibration.handle);
    calibration.status = api.hdCheckCalibration();
    api.hdEndFrame(calibration.handle);
    calibration.code = take_error(api);
    return callback_done;
}

unsigned int update_calibration(void* context) {
    auto& calibration = *static_cast<Calibration*>(context);
    const auto& api = calibration.api;
    api.hdBeginFrame(calibration.handle);
    api.hdUpdateCalibration(api.hdCheckCalibrationStyle());
    api.hdEndFrame(calibration.handle);
    calibration.code = take_error(api);
    return callback_done;
}

/// An arm that calibrates itself is asked to; others need a hand.
Expected<void> calibrate(const Api& api, Handle handle) {
    Calibration calibration{api, handle};
    api.hdScheduleSynchronous(check_calibration, &calibration, first_priority);
    if (calibration.code == 0 && calibration.status == calibration_needs_update) {
        api.hdScheduleSynchronous(update_calibration, &calibration, first_priority);
        if (calibration.code == 0) api.hdScheduleSynchronous(check_calibration, &calibration, first_priority);
    }
    if (calibration.code != 0) return fail(advice(api, calibration.code));
    if (calibration.status == calibration_ok) return {};
    return fail(
        "the arm is not calibrated: put the stylus into its inkwell (or the arm into its rest position) "
        "until "
        "its light is steady, and start again");
}

/// In a frame.
ArmReading read(const Api& api, std::int64_t now_ns) {
    ArmReading reading{.time_ns = now_ns};
    vec3 mm{};
    std::array<double, 16> transform{};
    int buttons = 0;
    api.hdGetDoublev(current_position, &mm.x);
    api.hdGetDoublev(current_transform, transform.data());
    api.hdGetIntegerv(current_buttons, &buttons);
    mat3 rotation;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row)
            rotation[column][row] =
                transform[static_cast<std::size_t>(column) * 4 + static_cast<std::size_t>(row)];
    }
    const vec3 turned = rotation_vector(rotation);
    reading.usable = is_finite(mm) && is_finite(turned);
    if (!reading.usable) return reading;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        reading.position_um[i] = quantised(mm[axis] * 1e3);
        reading.rotation_urad[i] = quantised(turned[axis] * 1e6);
    }
    reading.buttons = static_cast<std::uint32_t>(buttons);
    return reading;
}

/// In a frame.
void write(const Api& api, vec3 force) { api.hdSetDoublev(current_force, &force.x); }

/// The frame ends without force, and so do the ticks.
template <class State>
unsigned int end_ticks(State& s, unsigned int code) {
    write(s.api, vec3(0));
    s.api.hdEndFrame(s.handle);
    take_error(s.api);
    s.code = code;
    s.ended = true;
    return callback_done;
}

/// One tick, in the library's thread.
template <class State>
unsigned int run_tick(void* context) {
    auto& s = *static_cast<State*>(context);
    const auto now = monotonic_ns();
    if (s.times.newest_ns() == 0) s.preferred = prefer_this_thread();
    s.times.begins(now);
    s.api.hdBeginFrame(s.handle);
    const auto reading = read(s.api, now);
    if (const auto code = take_error(s.api); code != 0) return end_ticks(s, code);
    if (s.ending) return end_ticks(s, 0);
    const vec3 force = s.tick.step(s.tick.context, reading);
    write(s.api, is_finite(force) ? limited(force, s.facts.spec.peak_force) : vec3(0));
    s.api.hdEndFrame(s.handle);
    s.times.ends(monotonic_ns());
    const auto code = take_error(s.api);
    if (code == 0) return callback_continue;
    s.api.hdBeginFrame(s.handle);
    return end_ticks(s, code);
}

}  // namespace

OpenHaptics::State::~State() {
    constexpr std::int64_t patience_ns = 100'000'000, look_ns = 500'000;
    if (running) {
        ending = true;
        const auto until = monotonic_ns() + patience_ns;
        while (task != 0 && !ended && monotonic_ns() < until) sleep_until_ns(monotonic_ns() + look_ns);
        api.hdStopScheduler();
        if (task != 0 && !ended) api.hdUnschedule(task);
    }
    if (handle != invalid_handle) api.hdDisableDevice(handle);
    in_use = false;
}

OpenHaptics::OpenHaptics(std::unique_ptr<State> state) : state_(std::move(state)) {}
OpenHaptics::~OpenHaptics() = default;

Expected<std::unique_ptr<OpenHaptics>> OpenHaptics::open(const std::string& library) {
    if (State::in_use.exchange(true)) return fail("OpenHaptics holds one arm, and that is open already");
    auto state = std::make_unique<State>();
    auto api = load(library_name(library));
    if (!api) return tl::unexpected(api.error());
    state->api = *api;
    const auto handle = init_device(state->api);
    if (!handle) return tl::unexpected(handle.error());
    state->handle = *handle;
    api->hdMakeCurrentDevice(*handle);
    state->facts = facts_of(*api);
    for (const auto capability : {force_output, max_force_clamping, force_ramping}) api->hdEnable(capability);
    api->hdSetSchedulerRate(servo_hz);
    api->hdStartScheduler();
    if (const auto code = take_error(*api); code != 0) return fail(advice(*api, code));
    state->running = true;
    if (auto calibrated = calibrate(*api, *handle); !calibrated) return tl::unexpected(calibrated.error());
    if (state->facts.spec.peak_force <= 0) return fail("the arm does not say how much force it can give");
    return std::unique_ptr<OpenHaptics>(new OpenHaptics(std::move(state)));
}

const ArmFacts& OpenHaptics::facts() const { return state_->facts; }

Expected<void> OpenHaptics::start(ArmTick tick) {
    if (state_->task != 0) return fail("the arm was started already");
    state_->tick = tick;
    const auto task = state_->api.hdScheduleAsynchronous(run_tick<State>, state_.get(), first_priority);
    if (const auto code = take_error(state_->api); code != 0) return fail(advice(state_->api, code));
    state_->task = task;
    return {};
}

ArmStatus OpenHaptics::status() const {
    constexpr std::int64_t silence_ns = 500'000'000;
    const auto& s = *state_;
    const auto newest = s.times.newest_ns();
    if (const auto code = s.code.load(); code != 0) {
        const bool silent = code == comm_error || code == comm_config || code == timer_error;
        return {silent ? ArmPresence::lost : ArmPresence::fault, advice(s.api, code), newest};
    }
    if (newest != 0 && monotonic_ns() > newest + silence_ns)
        return {ArmPresence::lost, "the arm's ticks have stopped: plug it in again", newest};
    return {.newest_ns = newest};
}

TickReport OpenHaptics::times() const { return state_->times.report(); }
bool OpenHaptics::preferred() const { return state_->preferred; }

}  // namespace thaum::input
