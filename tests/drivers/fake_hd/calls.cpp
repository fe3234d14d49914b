// A fake libHD.so: the functions of OpenHaptics that drivers call, with two simulated arms in simulated
// hands. The library checks the documented rules, counts violations, and simulates the faults that a script
// asks for (script.h). It shares no code with the driver under test.
// NOLINTBEGIN(readability-identifier-naming): the names are OpenHaptics'.
#include <algorithm>
#include <chrono>
#include <cstring>

#include "drivers/fake_hd/misbehaviour.h"

namespace {

using namespace thaum;
using namespace thaum::fake_hd;

/// Error code with which hdInitDevice refuses a device of this name; 0: it opens the device.
unsigned int refusal(const Script& script, const char* name) {
    if (script.has("no_licence")) return invalid_licence;
    const bool by_name = script.has("no_null_name");
    const bool known = name == nullptr ? !by_name : std::strcmp(name, "Default PHANToM") == 0 || !by_name;
    if (!known) return invalid_value;
    if (script.has("absent") || script.has("no_permission")) return comm_error;
    return script.has("busy") ? already_initiated : 0U;
}

/// The handle that hdInitDevice returns for the first arm.
unsigned int handle_of(const Library& l) {
    const auto how = l.script.of("handle");
    return how == "zero" ? 0U : how == "other" ? 12345U : first_handle;
}

/// Index of the arm that a name opens: the second arm for its own name, the first for any other.
std::size_t arm_named(const char* name) {
    const auto second = read_second_script();
    const auto called = second.has("name") ? second.of("name") : "Right";
    return name != nullptr && !second.has("absent") && called == name ? 1 : 0;
}

/// The device of a handle; null if there is none.
Device* device_of(Library& l, unsigned int handle) {
    for (auto& d : l.devices)
        if (d.initiated && d.handle == handle) return &d;
    return nullptr;
}

/// A report of the library for one arm, shared by the exported functions that give it to tests. An exported
/// function must not call another one: two of these libraries may be loaded, and then the call would reach
/// the first library.
FakeHdReport report_of(std::size_t arm) {
    auto& l = library();
    const Lock lock(l.mutex);
    auto report = l.devices[arm].report;
    report.ticks = l.report.ticks;
    report.broken = l.report.broken;
    report.calls_after_end = l.report.calls_after_end;
    report.stops = l.report.stops;
    report.stops_with_force = l.report.stops_with_force;
    return report;
}

/// Runs or drops a synchronous task as the script's option `sync` says. Returns true if the caller must not
/// run the task itself. The old version of the library has no synchronous tasks.
[[maybe_unused]] bool synchronous_goes_wrong(Library& l, Callback run, void* context) {
    if (l.script.is("sync", "never")) return true;
    if (l.script.is("sync", "twice")) return run(context), false;
    if (!l.script.is("sync", "late")) return false;
    std::jthread([=] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        run(context);
    }).detach();
    return true;
}

}  // namespace

extern "C" {

struct HDErrorInfo {
    unsigned int errorCode;
    int internalErrorCode;
    unsigned int hHD;
};

#define FAKE_HD_CALL __attribute__((visibility("default")))

FAKE_HD_CALL FakeHdReport fakeHdReport() { return report_of(0); }
FAKE_HD_CALL FakeHdReport fakeHdReportOf(int arm) { return report_of(arm == 1 ? 1 : 0); }

FAKE_HD_CALL unsigned int hdInitDevice(const char* name) {
    if (misbehave(library(), "hdInitDevice") != 0) return no_handle;
    auto& l = library();
    const Lock lock(l.mutex);
    if (l.running) return broken(l, fake_hd_wrong_order, invalid_operation), no_handle;
    const auto arm = arm_named(name);
    auto& d = l.devices[arm];
    if (arm == 0) l.script = read_script();
    d.script = arm == 0 ? l.script : read_second_script();
    if (is_missing(d)) return push(l, comm_error), no_handle;
    const auto code = d.initiated ? already_initiated : arm == 0 ? refusal(l.script, name) : 0U;
    if (code != 0) return push(l, code), no_handle;
    take_device(l, d);
    l.current = arm;
    d.handle = arm == 0 ? handle_of(l) : second_handle;
    return d.handle;
}

FAKE_HD_CALL void hdDisableDevice(unsigned int handle) {
    if (misbehave(library(), "hdDisableDevice") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    auto* d = device_of(l, handle);
    if (d == nullptr) return broken(l, fake_hd_wrong_value, bad_handle);
    if (l.running) broken(l, fake_hd_wrong_order, invalid_operation);
    let_go(*d);
    if (l.script.is("callback", "after_end")) call_after_end(l);
}

FAKE_HD_CALL void hdMakeCurrentDevice(unsigned int handle) {
    if (misbehave(library(), "hdMakeCurrentDevice") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    const auto* d = device_of(l, handle);
    if (d == nullptr) return broken(l, fake_hd_wrong_value, bad_handle);
    // The current device is shared by all threads. Changing it while the library's own thread runs would
    // mislead that thread.
    if (l.running && !on_own_thread(l)) broken(l, fake_hd_wrong_thread, invalid_operation);
    l.current = static_cast<std::size_t>(d - l.devices.data());
}

FAKE_HD_CALL void hdBeginFrame(unsigned int handle) {
    if (misbehave(library(), "hdBeginFrame") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    auto* d = device_of(l, handle);
    if (d == nullptr) return broken(l, fake_hd_wrong_value, bad_handle);
    if (l.running && !on_own_thread(l)) return broken(l, fake_hd_wrong_thread, illegal_begin);
    if (d->frame) return broken(l, fake_hd_unpaired, illegal_begin);
    d->frame = true;
    d->setting = d->told;
    if (goes_wrong(*d, "vanish")) push(l, comm_error);
    if (goes_wrong(*d, "warm")) push(l, warm_motors);
}

FAKE_HD_CALL void hdEndFrame(unsigned int handle) {
    if (misbehave(library(), "hdEndFrame") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    auto* d = device_of(l, handle);
    if (d == nullptr) return broken(l, fake_hd_wrong_value, bad_handle);
    if (l.running && !on_own_thread(l)) return broken(l, fake_hd_wrong_thread, illegal_end);
    if (!d->frame) return broken(l, fake_hd_unpaired, illegal_end);
    d->frame = false;
    d->told = d->setting;
    update_live(*d);
}

FAKE_HD_CALL void hdGetIntegerv(unsigned int name, int* to) {
    if (misbehave(library(), "hdGetIntegerv") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    if (name == 0x2553) return void(*to = degrees_of_freedom(l, 6));
    if (name == 0x2554) return void(*to = degrees_of_freedom(l, 3));
    if (name == 0x2600) return void(*to = 1000);
    if (name != 0x2000) return broken(l, fake_hd_wrong_value, invalid_enum);
    if (may(l)) *to = l.script.is("buttons", "all") ? -1 : current(l).buttons;
}

FAKE_HD_CALL void hdGetDoublev(unsigned int name, double* to) {
    if (misbehave(library(), "hdGetDoublev") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    if (put_limit(l, name, to)) return;
    if (name != 0x2050 && name != 0x2052) return broken(l, fake_hd_wrong_value, invalid_enum);
    if (!may(l)) return;
    const auto at = measured_mm(current(l));
    if (name == 0x2052) return put_transform(current(l), to);
    for (int i = 0; i < 3; ++i) to[i] = at[i];
}

FAKE_HD_CALL void hdSetDoublev(unsigned int name, const double* from) {
    if (misbehave(library(), "hdSetDoublev") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    if (name != 0x2700) return broken(l, fake_hd_wrong_value, invalid_enum);
    if (!may(l)) return;
    const vec3 force(from[0], from[1], from[2]);
    const double size = glm::length(force);
    if (!(size < absurd_force)) return broken(l, fake_hd_wrong_units, invalid_value);
    auto& d = current(l);
    if (size > max_force * (1 + 1e-9) && !d.clamping) return push(l, exceeded_max_force);
    d.setting = limited(force, max_force);
}

FAKE_HD_CALL const char* hdGetString(unsigned int name) {
    if (misbehave(library(), "hdGetString") != 0) return nullptr;
    auto& l = library();
    const Lock lock(l.mutex);
    if (l.script.has("mute")) return nullptr;
    const std::map<unsigned int, const char*> known{{0x2500, "3.50.0"},
                                                    {0x2501, "Touch"},
                                                    {0x2502, "2024.1"},
                                                    {0x2503, "nobody"},
                                                    {0x2504, l.current == 0 ? "F0000001" : "F0000002"}};
    const auto found = known.find(name);
    if (found != known.end()) return said(l, "strings", found->second);
    broken(l, fake_hd_wrong_value, invalid_enum);
    return nullptr;
}

FAKE_HD_CALL void hdEnable(unsigned int name) {
    if (misbehave(library(), "hdEnable") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    if (name < 0x4000 || name > 0x4004) return broken(l, fake_hd_wrong_value, invalid_enum);
    if (name == 0x4000) current(l).force_output = true;
    if (name == 0x4001) current(l).clamping = true;
}

FAKE_HD_CALL HDErrorInfo hdGetError() {
    if (misbehave(library(), "hdGetError") != 0) return {0, 0, no_handle};
    auto& l = library();
    const Lock lock(l.mutex);
    if (l.script.is("errors", "endless")) return {comm_error, 0, first_handle};
    if (l.errors.empty()) return {0, 0, current(l).initiated ? current(l).handle : no_handle};
    const auto code = l.errors.back();
    l.errors.pop_back();
    return {code, 0, current(l).handle};
}

FAKE_HD_CALL const char* hdGetErrorString(unsigned int code) {
    if (misbehave(library(), "hdGetErrorString") != 0) return nullptr;
    static const std::map<unsigned int, const char*> known{{invalid_enum, "Invalid enum"},
                                                           {invalid_value, "Invalid value"},
                                                           {invalid_operation, "Invalid operation"},
                                                           {bad_handle, "Bad handle"},
                                                           {warm_motors, "Warm motors"},
                                                           {exceeded_max_force, "Exceeded max force"},
                                                           {already_initiated, "Device already initiated"},
                                                           {comm_error, "Communication error"},
                                                           {frame_error, "Frame error"},
                                                           {invalid_licence, "Invalid license"}};
    const auto found = known.find(code);
    auto& l = library();
    const Lock lock(l.mutex);
    return said(l, "error_strings", found == known.end() ? nullptr : found->second);
}

FAKE_HD_CALL void hdSetSchedulerRate(unsigned long hz) {
    if (misbehave(library(), "hdSetSchedulerRate") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    if (hz != 500 && hz != 1000) broken(l, fake_hd_wrong_value, invalid_value);
}

FAKE_HD_CALL void hdStartScheduler() {
    if (misbehave(library(), "hdStartScheduler") != 0) return;
    auto& l = library();
    {
        const Lock lock(l.mutex);
        const bool any = std::any_of(l.devices.begin(), l.devices.end(), [](auto& d) { return d.initiated; });
        if (!any || l.running) return broken(l, fake_hd_wrong_order, invalid_operation);
        l.running = true;
    }
    start_threads(l);
}

FAKE_HD_CALL void hdStopScheduler() {
    if (misbehave(library(), "hdStopScheduler") != 0) return;
    auto& l = library();
    if (!l.running.exchange(false)) return;
    stop_threads(l);
    const Lock lock(l.mutex);
    ++l.report.stops;
    const bool pushes =
        std::any_of(l.devices.begin(), l.devices.end(), [](auto& d) { return exerted(d) != vec3(0); });
    l.report.stops_with_force += pushes ? 1 : 0;
}

FAKE_HD_CALL unsigned long hdScheduleAsynchronous(Callback run, void* context, unsigned short priority) {
    if (misbehave(library(), "hdScheduleAsynchronous") != 0) return 0;
    auto& l = library();
    const auto number = schedule(l, run, context, priority, false);
    if (l.script.is("hdScheduleAsynchronous", "returns_late"))
        std::this_thread::sleep_for(std::chrono::seconds(2));
    return number;
}

#ifndef FAKE_HD_OLD
FAKE_HD_CALL void hdScheduleSynchronous(Callback run, void* context, unsigned short priority) {
    if (misbehave(library(), "hdScheduleSynchronous") != 0) return;
    auto& l = library();
    if (synchronous_goes_wrong(l, run, context)) return;
    const auto number = schedule(l, run, context, priority, true);
    for (;;) {
        {
            const Lock lock(l.mutex);
            if (std::none_of(l.tasks.begin(), l.tasks.end(), [&](auto& t) { return t.number == number; }))
                return;
        }
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
}
#endif

FAKE_HD_CALL void hdUnschedule(unsigned long number) {
    if (misbehave(library(), "hdUnschedule") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    if (std::erase_if(l.tasks, [&](const Task& t) { return t.number == number; }) == 0)
        broken(l, fake_hd_wrong_value, invalid_value);
}

FAKE_HD_CALL unsigned int hdCheckCalibration() {
    if (misbehave(library(), "hdCheckCalibration") != 0) return 0;
    auto& l = library();
    const Lock lock(l.mutex);
    if (!may(l)) return 0;
    if (l.script.has("manual")) return 0x5002;
    if (l.script.is("calibration", "garbage")) return 0xdeadbeef;
    return l.script.has("needs_update") && !current(l).updated ? 0x5001 : 0x5000;
}

FAKE_HD_CALL unsigned int hdCheckCalibrationStyle() {
    auto& l = library();
    if (misbehave(l, "hdCheckCalibrationStyle") != 0) return 0;
    const Lock lock(l.mutex);
    return l.script.is("style", "garbage") ? 0xdeadbeef : 2;
}

FAKE_HD_CALL void hdUpdateCalibration(unsigned int style) {
    if (misbehave(library(), "hdUpdateCalibration") != 0) return;
    auto& l = library();
    const Lock lock(l.mutex);
    if (style != 2) return broken(l, fake_hd_wrong_value, invalid_value);
    if (may(l)) current(l).updated = true;
}

}  // end of extern "C"
// NOLINTEND(readability-identifier-naming)
