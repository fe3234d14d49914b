#include "input/detail/hd_api.h"

#include <dlfcn.h>

#include <array>
#include <cstring>
#include <list>
#include <mutex>

#include "core/environment.h"
#include "core/one_line.h"
#include "core/text.h"

namespace thaum::input::hd {
namespace {

constexpr std::size_t max_said = 80;  ///< longest text of the library that is used (bytes)

/// Printable part of a string from the library, which may be invalid, very long or unterminated.
std::string said(const char* by_library) {
    if (by_library == nullptr) return {};
    return printable({by_library, ::strnlen(by_library, max_said + 4)}, max_said);
}

const char* find_all(void* library, Api& api) {
#define THAUM_FIND(function) \
    if (!api.function.find(library, #function)) return #function
    THAUM_FIND(hdInitDevice);
    THAUM_FIND(hdDisableDevice);
    THAUM_FIND(hdMakeCurrentDevice);
    THAUM_FIND(hdBeginFrame);
    THAUM_FIND(hdEndFrame);
    THAUM_FIND(hdGetIntegerv);
    THAUM_FIND(hdGetDoublev);
    THAUM_FIND(hdSetDoublev);
    THAUM_FIND(hdGetString);
    THAUM_FIND(hdEnable);
    THAUM_FIND(hdGetError);
    THAUM_FIND(hdGetErrorString);
    THAUM_FIND(hdStartScheduler);
    THAUM_FIND(hdStopScheduler);
    THAUM_FIND(hdSetSchedulerRate);
    THAUM_FIND(hdScheduleSynchronous);
    THAUM_FIND(hdScheduleAsynchronous);
    THAUM_FIND(hdUnschedule);
    THAUM_FIND(hdCheckCalibration);
    THAUM_FIND(hdCheckCalibrationStyle);
    THAUM_FIND(hdUpdateCalibration);
#undef THAUM_FIND
    return nullptr;
}

std::string string_of(const Api& api, Name name) {
    auto text = said(api.hdGetString(name));
    take_error(api);
    return text;
}

/// Value of a parameter, from 0 to `most`; 0 if the library returns anything else.
double number_of(const Api& api, Name name, double most) {
    double value = 0;
    api.hdGetDoublev(name, &value);
    return take_error(api) == 0 && value >= 0 && value <= most ? value : 0;
}

int integer_of(const Api& api, Name name, int most) {
    int value = 0;
    api.hdGetIntegerv(name, &value);
    return take_error(api) == 0 && value >= 0 && value <= most ? value : 0;
}

vec3 workspace_of(const Api& api) {
    constexpr double most = 10;  // longest edge of a workspace that is believed (m)
    std::array<double, 6> mm{};
    api.hdGetDoublev(usable_workspace, mm.data());
    const vec3 edges = vec3(mm[3] - mm[0], mm[4] - mm[1], mm[5] - mm[2]) * 1e-3;
    if (take_error(api) != 0) return vec3(0);
    const bool possible = is_finite(edges) && glm::all(glm::greaterThanEqual(edges, vec3(0))) &&
                          glm::all(glm::lessThanEqual(edges, vec3(most)));
    return possible ? edges : vec3(0);
}

}  // namespace

// ---- loading the library ----------------------------------------------------------------------------------

template <class R, class... Arguments>
bool Function<R(Arguments...)>::find(void* library, const char* name) {
    call_ = reinterpret_cast<R (*)(Arguments...)>(::dlsym(library, name));
    name_ = name;
    return call_ != nullptr;
}

std::string library_name() { return environment_value("THAUM_LIBHD").value_or("libHD.so"); }

namespace {

/// Functions of one library. Kept for the whole run of the program, because calls that the library makes late
/// may still use them.
struct Loaded {
    void* library{};
    Api api{};
};

/// All loaded libraries. Never destroyed, because a library may still call, or be called, as the program
/// ends.
struct LoadedLibraries {
    std::mutex mutex;
    std::list<Loaded> all;
};

LoadedLibraries& loaded_libraries() {
    static auto* libraries = new LoadedLibraries();
    return *libraries;
}

/// Stores the functions found when the library was first loaded. Loading it again finds the same ones.
const Api* keep(void* library, const Api& api) {
    auto& libraries = loaded_libraries();
    const std::lock_guard lock(libraries.mutex);
    for (const Loaded& one : libraries.all)
        if (one.library == library) return &one.api;
    return &libraries.all.emplace_back(Loaded{library, api}).api;
}

/// Returns the message of dlerror about the last failure of dlopen or dlsym; empty: none failed. The C
/// library keeps a thread's message until the next call of dlerror, so dlerror is called twice to free it.
std::string take_linker_error() {
    const char* why = ::dlerror();
    std::string message = why != nullptr ? why : "";
    ::dlerror();
    return message;
}

}  // namespace

// RTLD_GLOBAL, because libHD uses symbols of libraries that come with it.
Expected<const Api*> load(const std::string& name) {
    void* library = ::dlopen(name.c_str(), RTLD_LAZY | RTLD_GLOBAL);
    if (library == nullptr) {
        const auto why = take_linker_error();
        return fail(
            text("no OpenHaptics: ", printable(why.empty() ? name : why, 400),
                 "; install the arm's driver and OpenHaptics, or say in THAUM_LIBHD where libHD.so is"));
    }
    Api api;
    const char* missing = find_all(library, api);
    if (missing == nullptr) return keep(library, api);
    take_linker_error();  // drops the message about the missing function, which is named below
    return fail(
        text(printable(name, 400), " is too old: it lacks ", missing, "; install OpenHaptics 3.4 or newer"));
}

// ---- errors of the library --------------------------------------------------------------------------------

unsigned int take_error(const Api& api) {
    constexpr int more_than_a_stack = 64;
    unsigned int first = 0;
    for (int i = 0; i < more_than_a_stack; ++i) {
        const auto code = api.hdGetError().code;
        if (code == 0) break;
        first = code;  // the library gives the newest error first, so the last is the oldest
    }
    return first;
}

void copy_error_string(const Api& api, unsigned int code, char* to, std::size_t size) {
    const char* words = api.hdGetErrorString(code);
    if (words == nullptr) words = "unknown";
    const auto length = ::strnlen(words, size - 1);
    std::memcpy(to, words, length);
    to[length] = '\0';
}

std::string advice(unsigned int code, std::string_view by_library) {
    const auto what = text(printable(by_library, max_said), " (", hex(code).substr(12), ")");
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

std::string advice(const Api& api, unsigned int code) {
    std::array<char, max_said + 4> words{};
    copy_error_string(api, code, words.data(), words.size());
    return advice(code, words.data());
}

// ---- facts and measurements -------------------------------------------------------------------------------

ArmFacts facts_of(const Api& api) {
    // Largest values that are believed. No arm of this class is stronger or stiffer, so a larger value has
    // another unit or is invalid.
    constexpr double max_force = 100, max_stiffness_n_per_mm = 100, max_damping_n_s_per_mm = 1;
    constexpr int max_freedom = 16, max_rate = 100'000;
    ArmFacts facts;
    auto& spec = facts.spec;
    spec.name = string_of(api, model_type);
    spec.sensed = integer_of(api, input_dof, max_freedom);
    spec.actuated = integer_of(api, output_dof, max_freedom);
    spec.peak_force = number_of(api, nominal_max_force, max_force);
    spec.continuous_force = number_of(api, nominal_max_continuous_force, max_force);
    spec.max_stiffness = number_of(api, nominal_max_stiffness, max_stiffness_n_per_mm) * 1e3;
    spec.max_damping = number_of(api, nominal_max_damping, max_damping_n_s_per_mm) * 1e3;
    spec.workspace = workspace_of(api);
    spec.update_rate = integer_of(api, update_rate, max_rate);
    facts.family = "phantom";
    facts.serial = string_of(api, serial_number);
    facts.driver = string_of(api, version);
    return facts;
}

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

void write(const Api& api, vec3 force) { api.hdSetDoublev(current_force, &force.x); }

bool write_zero_frame(const Api& api, Handle handle) {
    api.hdBeginFrame(handle);
    write(api, vec3(0));
    api.hdEndFrame(handle);
    return take_error(api) == 0;
}

}  // namespace thaum::input::hd
