// input/detail/hd_api.h: the vendor's libHD.so: constants and functions with their documented values and
// signatures. Values that it returns are checked before other code uses them.
#pragma once
#include <cstddef>
#include <string>

#include "core/error.h"
#include "input/arm.h"
#include "input/detail/watchdog.h"

namespace thaum::input::hd {

using Handle = unsigned int;
using Callback = unsigned int (*)(void*);

constexpr Handle invalid_handle = 0xffffffff;
constexpr unsigned int callback_done = 0, callback_continue = 1;
constexpr unsigned short first_priority = 65535;
constexpr unsigned long servo_hz = 1000;

enum Name : unsigned int {
    current_buttons = 0x2000,
    current_position = 0x2050,   // position of the tip (mm)
    current_transform = 0x2052,  // the pose as a matrix of 16 numbers, column by column
    version = 0x2500,
    model_type = 0x2501,
    serial_number = 0x2504,
    usable_workspace = 0x2551,  // lowest x, y, z, then highest x, y, z (mm)
    input_dof = 0x2553,
    output_dof = 0x2554,
    update_rate = 0x2600,
    nominal_max_stiffness = 0x2602,  // largest stiffness (N/mm)
    nominal_max_force = 0x2603,      // largest force, for a short time (N)
    nominal_max_continuous_force = 0x2604,
    nominal_max_damping = 0x2609,  // largest damping (N/(mm/s))
    current_force = 0x2700,        // force that the arm exerts from now on (N)
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

/// A function of the library. Each call is noted for the watchdog of the calling thread (detail/watchdog.h).
template <class F>
class Function;

template <class R, class... Arguments>
class Function<R(Arguments...)> {
public:
    R operator()(Arguments... arguments) const {
        const NotedCall note(name_);
        return call_(arguments...);
    }
    /// Looks the function up in the library. Returns false if the library has no function called `name`.
    bool find(void* library, const char* name);

private:
    R (*call_)(Arguments...){};
    const char* name_{};
};

/// Functions that the driver calls. A library that lacks one of them is too old.
struct Api {
    // NOLINTBEGIN(readability-identifier-naming): the names are OpenHaptics'.
    Function<Handle(const char*)> hdInitDevice;
    Function<void(Handle)> hdDisableDevice;
    Function<void(Handle)> hdMakeCurrentDevice;
    Function<void(Handle)> hdBeginFrame;
    Function<void(Handle)> hdEndFrame;
    Function<void(unsigned int, int*)> hdGetIntegerv;
    Function<void(unsigned int, double*)> hdGetDoublev;
    Function<void(unsigned int, const double*)> hdSetDoublev;
    Function<const char*(unsigned int)> hdGetString;
    Function<void(unsigned int)> hdEnable;
    Function<ErrorInfo()> hdGetError;
    Function<const char*(unsigned int)> hdGetErrorString;
    Function<void()> hdStartScheduler;
    Function<void()> hdStopScheduler;
    Function<void(unsigned long)> hdSetSchedulerRate;
    Function<void(Callback, void*, unsigned short)> hdScheduleSynchronous;
    Function<unsigned long(Callback, void*, unsigned short)> hdScheduleAsynchronous;
    Function<void(unsigned long)> hdUnschedule;
    Function<unsigned int()> hdCheckCalibration;
    Function<unsigned int()> hdCheckCalibrationStyle;
    Function<void(unsigned int)> hdUpdateCalibration;
    // NOLINTEND(readability-identifier-naming)
};

/// Loads the library with this file name or path. It is never unloaded, so its functions live as long as the
/// process.
Expected<const Api*> load(const std::string& name);
/// File name or path of the library: $THAUM_LIBHD, else libHD.so.
std::string library_name();

/// Empties the library's stack of errors. Returns the oldest code, because the others follow from it; 0: no
/// error.
unsigned int take_error(const Api& api);
/// Copies the library's text for a code, cut to `size` bytes with a terminating zero. Any thread may call it.
void copy_error_string(const Api& api, unsigned int code, char* to, std::size_t size);
/// One line for an error: what is wrong, then what to do. `by_library` is the library's text for it.
std::string advice(unsigned int code, std::string_view by_library);
/// One line for an error; asks the library for its text.
std::string advice(const Api& api, unsigned int code);

/// Facts about the current device. Values that are missing or impossible are zero or empty.
ArmFacts facts_of(const Api& api);

/// Measures the current device; called within a frame of the library (hdBeginFrame).
ArmReading read(const Api& api, std::int64_t now_ns);
/// Sets the force of the current device (N, device frame); called within a frame of the library
/// (hdBeginFrame).
void write(const Api& api, vec3 force);
/// Sets zero force on the current device, in a library frame of its own. Returns whether the library accepted
/// it.
bool write_zero_frame(const Api& api, Handle handle);

}  // namespace thaum::input::hd
