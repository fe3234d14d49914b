// A make-believe libHD.so: the functions of OpenHaptics that drivers call, with a simulated arm in a simulated hand behind them. It
// holds programs to the documented rules, counts where they break them, and can be told to go wrong. It knows no code of the
// driver that it tests.
//
// $FAKE_HD, read at hdInitDevice, is a list of words with commas between them:
//     absent, busy, no_permission, no_licence   hdInitDevice fails
//     no_null_name      the arm has a name and only that opens it
//     needs_update      it wants hdUpdateCalibration; manual: only a hand can calibrate it
//     mute              hdGetString says nothing and no limits are told
//     vanish=N          at tick N the arm no longer answers;  warm=N: its motors are too warm
//     back=K            after a vanish, a stop or a warm hdInitDevice fails K times, and then all is well
//     nan=N             tick N and the nine after it measure no number
//     late=N            every Nth tick comes 5 ms late;  burst: and what was missed follows at once
//     stop=N            after tick N no more ticks come
//     rate=HZ           its clock is not ours: ticks come so often
//     record=FILE       what the arm exerted and where it was, a line a tick: "fx fy fz x y z" (N, m), written when it is let go of
//     path=FILE         where the hand wants to be: lines "ms x_mm y_mm z_mm buttons", straight between them
#include "drivers/fake_hd/fake_hd.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "haptics/simulated.h"

namespace {

using namespace thaum;
using Clock = std::chrono::steady_clock;
using Callback = unsigned int (*)(void*);

constexpr unsigned int only_handle = 7, no_handle = 0xffffffff;
constexpr double max_force = 3.3;
constexpr double absurd_force = 100;  // N: a force in mN or a stiffness for N/m was meant

enum Error : unsigned int {
    invalid_enum = 0x0100,
    invalid_value = 0x0101,
    invalid_operation = 0x0102,
    bad_handle = 0x0104,
    warm_motors = 0x0200,
    exceeded_max_force = 0x0201,
    already_initiated = 0x0301,
    comm_error = 0x0302,
    illegal_begin = 0x0400,
    illegal_end = 0x0401,
    frame_error = 0x0402,
    invalid_priority = 0x0500,
    invalid_licence = 0x0600,
};

struct Place {
    double ms{};
    vec3 target{};  // m
    int buttons{};
};

struct Script {
    std::map<std::string, std::string> words;
    std::vector<Place> path;

    bool has(const char* word) const { return words.contains(word); }
    /// A tick; 0: never.
    std::uint64_t tick(const char* word) const {
        const auto found = words.find(word);
        return found == words.end() ? 0 : std::strtoull(found->second.c_str(), nullptr, 10);
    }
};

std::vector<Place> read_path(const std::string& file) {
    std::vector<Place> path;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        Place p;
        std::istringstream words(line);
        if (words >> p.ms >> p.target.x >> p.target.y >> p.target.z >> p.buttons) {
            p.target *= 1e-3;
            path.push_back(p);
        }
    }
    return path;
}

Script read_script() {
    Script script;
    const char* told = std::getenv("FAKE_HD");
    std::istringstream words(told != nullptr ? told : "");
    for (std::string word; std::getline(words, word, ',');) {
        const auto is = word.find('=');
        script.words[word.substr(0, is)] = is == std::string::npos ? "" : word.substr(is + 1);
    }
    if (script.has("path")) script.path = read_path(script.words["path"]);
    return script;
}

Place place_at(const std::vector<Place>& path, double ms) {
    if (path.empty()) return {};
    const auto next = std::find_if(path.begin(), path.end(), [&](const Place& p) { return p.ms > ms; });
    if (next == path.begin()) return path.front();
    if (next == path.end()) return path.back();
    const auto& before = *(next - 1);
    const double share = (ms - before.ms) / (next->ms - before.ms);
    return {ms, before.target + share * (next->target - before.target), before.buttons};
}

/// Numbers of a Touch.
haptics::DeviceSpec touch_spec() {
    haptics::DeviceSpec spec;
    spec.name = "Touch";
    spec.sensed = 6;
    spec.actuated = 3;
    spec.peak_force = max_force;
    spec.continuous_force = 0.88;
    spec.max_stiffness = 400;
    spec.max_damping = 4;
    spec.workspace = {0.16, 0.12, 0.07};
    spec.position_quantum = 5.5e-5;
    spec.mass = 0.045;
    spec.damping = 0.2;
    spec.coulomb_friction = 0.26;
    spec.update_rate = 1000;
    return spec;
}

struct Task {
    unsigned long number;
    unsigned short priority;
    Callback run;
    void* context;
};

struct Library {
    std::mutex mutex{};  // of all below, but while a task runs
    Script script{};
    haptics::SimulatedDevice device{};
    haptics::SimulatedState arm{};
    bool initiated = false, frame = false, force_output = false, clamping = false, updated = false;
    vec3 told{};  // N, by the last frame that ended
    vec3 setting{};
    std::vector<unsigned int> errors{};
    std::vector<Task> tasks{};
    unsigned long next_task = 1;
    FakeHdReport report{};
    std::vector<std::array<double, 6>> recorded{};
    int buttons = 0;
    bool went_wrong = false, came_back = false;
    std::uint64_t refused = 0;

    std::thread thread{};
    std::atomic<bool> running{false};
    std::atomic<std::thread::id> own_thread{};
};

Library& library() {
    static Library the;
    return the;
}

using Lock = std::unique_lock<std::mutex>;

void push(Library& l, unsigned int code) { l.errors.push_back(code); }

void broken(Library& l, FakeHdRule rule, unsigned int code) {
    ++l.report.broken[rule];
    push(l, code);
}

bool on_own_thread(const Library& l) { return std::this_thread::get_id() == l.own_thread.load(); }

/// Whether state may be asked for or set now.
bool may(Library& l) {
    if (l.running && !on_own_thread(l)) return broken(l, fake_hd_wrong_thread, invalid_operation), false;
    if (!l.frame) return broken(l, fake_hd_outside_frame, frame_error), false;
    return true;
}

void record(Library& l, vec3 force) {
    const vec3 at = l.arm.position;
    if (l.script.has("record")) l.recorded.push_back({force.x, force.y, force.z, at.x, at.y, at.z});
}

vec3 exerted(const Library& l) { return l.force_output ? l.told : vec3(0); }

/// One ms of the arm.
void move_arm(Library& l) {
    const auto& place = place_at(l.script.path, static_cast<double>(l.report.ticks));
    const vec3 force = exerted(l);
    l.arm = haptics::step(l.device, l.arm, place.target, force);
    l.buttons = place.buttons;
    ++l.report.ticks;
    for (int i = 0; i < 3; ++i) {
        l.report.force[static_cast<std::size_t>(i)] = force[i];
        l.report.position[static_cast<std::size_t>(i)] = l.arm.position[i];
    }
    l.report.greatest_force = std::max(l.report.greatest_force, glm::length(force));
    record(l, force);
}

void write_record(const Library& l) {
    if (!l.script.has("record")) return;
    std::ofstream out(l.script.words.at("record"));
    out.precision(17);
    for (const auto& tick : l.recorded) {
        for (const double number : tick) out << number << ' ';
        out << '\n';
    }
}

/// Whether it is time to go wrong in that way. Once is enough for an arm that comes back.
bool goes_wrong(Library& l, const char* word) {
    const auto at = l.script.tick(word);
    if (at == 0 || l.report.ticks < at || l.came_back) return false;
    l.went_wrong = true;
    return true;
}

/// An arm that went wrong: true while it is not there.
bool is_missing(Library& l) {
    if (!l.went_wrong || !l.script.has("back") || l.came_back) return false;
    if (l.refused++ < l.script.tick("back")) return true;
    l.came_back = true;
    return false;
}

/// What a task leaves open is closed for it.
void close_frame(Library& l) {
    if (!l.frame) return;
    broken(l, fake_hd_unpaired, frame_error);
    l.frame = false;
}

void run_tasks(Library& l) {
    std::vector<Task> now;
    {
        const Lock lock(l.mutex);
        now = l.tasks;
    }
    std::stable_sort(now.begin(), now.end(), [](auto& a, auto& b) { return a.priority > b.priority; });
    for (const auto& task : now) {
        const bool done = task.run(task.context) == 0;
        const Lock lock(l.mutex);
        close_frame(l);
        if (done) std::erase_if(l.tasks, [&](const Task& t) { return t.number == task.number; });
    }
}

void run_thread(Library& l) {
    l.own_thread = std::this_thread::get_id();
    constexpr auto ms = std::chrono::milliseconds(1);
    const auto hz = l.script.tick("rate");
    const auto period = hz == 0 ? std::chrono::microseconds(ms) : std::chrono::microseconds(1'000'000 / hz);
    auto due = Clock::now();
    while (l.running) {
        due += period;
        std::uint64_t tick = 0;
        {
            const Lock lock(l.mutex);
            move_arm(l);
            tick = l.report.ticks;
        }
        const auto late = l.script.tick("late");
        if (late != 0 && tick % late == 0) {
            std::this_thread::sleep_for(5 * ms);
            if (!l.script.has("burst")) due = Clock::now();
        }
        if (!goes_wrong(l, "stop")) run_tasks(l);
        std::this_thread::sleep_until(due);
    }
}

unsigned long schedule(Library& l, Callback run, void* context, unsigned short priority) {
    const Lock lock(l.mutex);
    if (!l.initiated) broken(l, fake_hd_wrong_order, invalid_operation);
    l.tasks.push_back({l.next_task, priority, run, context});
    return l.next_task++;
}

/// Of those that hdInitDevice may give.
unsigned int refusal(const Script& script, const char* name) {
    if (script.has("no_licence")) return invalid_licence;
    const bool by_name = script.has("no_null_name");
    const bool known = name == nullptr ? !by_name : std::strcmp(name, "Default PHANToM") == 0 || !by_name;
    if (!known) return invalid_value;
    if (script.has("absent") || script.has("no_permission")) return comm_error;
    return script.has("busy") ? already_initiated : 0U;
}

vec3 measured_mm(const Library& l) {
    const auto nan = l.script.tick("nan"), tick = l.report.ticks;
    if (nan != 0 && tick >= nan && tick < nan + 10) return vec3(std::nan(""));
    return haptics::measured_position(l.device, l.arm) * 1e3;
}

/// The stylus leans with the place, 10 rad/m, as an arm's does.
void put_transform(const Library& l, double* to) {
    const auto at = measured_mm(l);
    const auto q = rotation({0, 1, 0}, at.x * 1e-3 * 10);
    const auto turned = glm::mat3_cast(q);
    std::fill_n(to, 16, 0.0);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) to[4 * column + row] = turned[column][row];
    }
    for (int row = 0; row < 3; ++row) to[12 + row] = at[row];
    to[15] = 1;
}

/// Limits, told in any place.
bool put_limit(const Library& l, unsigned int name, double* to) {
    const bool mute = l.script.has("mute");
    const std::map<unsigned int, double> limits{
        {0x2602, 0.4}, {0x2603, max_force}, {0x2604, 0.88}, {0x2609, 0.004}};
    if (const auto found = limits.find(name); found != limits.end())
        return *to = mute ? 0 : found->second, true;
    if (name != 0x2551) return false;
    const std::array<double, 6> box{-80, -60, -35, 80, 60, 35};
    std::copy(box.begin(), box.end(), to);
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

FAKE_HD_CALL FakeHdReport fakeHdReport() {
    auto& l = library();
    const Lock lock(l.mutex);
    return l.report;
}

FAKE_HD_CALL unsigned int hdInitDevice(const char* name) {
    auto& l = library();
    const Lock lock(l.mutex);
    l.script = read_script();
    if (is_missing(l)) return push(l, comm_error), no_handle;
    if (const auto code = l.initiated ? already_initiated : refusal(l.script, name); code != 0)
        return push(l, code), no_handle;
    l.device = haptics::simulated_device(touch_spec(), haptics::Hand{});
    l.arm = haptics::resting_at(place_at(l.script.path, 0).target);
    l.initiated = true;
    l.frame = l.force_output = l.clamping = l.updated = false;
    l.told = l.setting = vec3(0);
    l.tasks.clear();
    l.recorded.clear();
    l.report = {};
    return only_handle;
}

FAKE_HD_CALL void hdDisableDevice(unsigned int handle) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (handle != only_handle || !l.initiated) return broken(l, fake_hd_wrong_value, bad_handle);
    if (l.running) broken(l, fake_hd_wrong_order, invalid_operation);
    l.initiated = false;
    // What it was told last may have come after its last tick.
    record(l, exerted(l));
    write_record(l);
}

FAKE_HD_CALL void hdMakeCurrentDevice(unsigned int handle) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (handle != only_handle) broken(l, fake_hd_wrong_value, bad_handle);
}

FAKE_HD_CALL void hdBeginFrame(unsigned int handle) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (handle != only_handle) return broken(l, fake_hd_wrong_value, bad_handle);
    if (l.running && !on_own_thread(l)) return broken(l, fake_hd_wrong_thread, illegal_begin);
    if (l.frame) return broken(l, fake_hd_unpaired, illegal_begin);
    l.frame = true;
    l.setting = l.told;
    if (goes_wrong(l, "vanish")) push(l, comm_error);
    if (goes_wrong(l, "warm")) push(l, warm_motors);
}

FAKE_HD_CALL void hdEndFrame(unsigned int handle) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (handle != only_handle) return broken(l, fake_hd_wrong_value, bad_handle);
    if (l.running && !on_own_thread(l)) return broken(l, fake_hd_wrong_thread, illegal_end);
    if (!l.frame) return broken(l, fake_hd_unpaired, illegal_end);
    l.frame = false;
    l.told = l.setting;
}

FAKE_HD_CALL void hdGetIntegerv(unsigned int name, int* to) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (name == 0x2553) return void(*to = 6);
    if (name == 0x2554) return void(*to = 3);
    if (name == 0x2600) return void(*to = 1000);
    if (name != 0x2000) return broken(l, fake_hd_wrong_value, invalid_enum);
    if (may(l)) *to = l.buttons;
}

FAKE_HD_CALL void hdGetDoublev(unsigned int name, double* to) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (put_limit(l, name, to)) return;
    if (name != 0x2050 && name != 0x2052) return broken(l, fake_hd_wrong_value, invalid_enum);
    if (!may(l)) return;
    const auto at = measured_mm(l);
    if (name == 0x2052) return put_transform(l, to);
    for (int i = 0; i < 3; ++i) to[i] = at[i];
}

FAKE_HD_CALL void hdSetDoublev(unsigned int name, const double* from) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (name != 0x2700) return broken(l, fake_hd_wrong_value, invalid_enum);
    if (!may(l)) return;
    const vec3 force(from[0], from[1], from[2]);
    const double size = glm::length(force);
    if (!(size < absurd_force)) return broken(l, fake_hd_wrong_units, invalid_value);
    if (size > max_force * (1 + 1e-9) && !l.clamping) return push(l, exceeded_max_force);
    l.setting = limited(force, max_force);
}

FAKE_HD_CALL const char* hdGetString(unsigned int name) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (l.script.has("mute")) return nullptr;
    const std::map<unsigned int, const char*> known{
        {0x2500, "3.50.0"}, {0x2501, "Touch"}, {0x2502, "2024.1"}, {0x2503, "nobody"}, {0x2504, "F0000001"}};
    const auto found = known.find(name);
    if (found != known.end()) return found->second;
    broken(l, fake_hd_wrong_value, invalid_enum);
    return nullptr;
}

FAKE_HD_CALL void hdEnable(unsigned int name) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (name < 0x4000 || name > 0x4004) return broken(l, fake_hd_wrong_value, invalid_enum);
    if (name == 0x4000) l.force_output = true;
    if (name == 0x4001) l.clamping = true;
}

FAKE_HD_CALL HDErrorInfo hdGetError() {
    auto& l = library();
    const Lock lock(l.mutex);
    if (l.errors.empty()) return {0, 0, l.initiated ? only_handle : no_handle};
    const auto code = l.errors.back();
    l.errors.pop_back();
    return {code, 0, only_handle};
}

FAKE_HD_CALL const char* hdGetErrorString(unsigned int code) {
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
    return found == known.end() ? nullptr : found->second;
}

FAKE_HD_CALL void hdSetSchedulerRate(unsigned long hz) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (hz != 500 && hz != 1000) broken(l, fake_hd_wrong_value, invalid_value);
}

FAKE_HD_CALL void hdStartScheduler() {
    auto& l = library();
    {
        const Lock lock(l.mutex);
        if (!l.initiated || l.running) return broken(l, fake_hd_wrong_order, invalid_operation);
        l.running = true;
    }
    l.thread = std::thread([&l] { run_thread(l); });
}

FAKE_HD_CALL void hdStopScheduler() {
    auto& l = library();
    if (!l.running.exchange(false)) return;
    l.thread.join();
}

FAKE_HD_CALL unsigned long hdScheduleAsynchronous(Callback run, void* context, unsigned short priority) {
    return schedule(library(), run, context, priority);
}

#ifndef FAKE_HD_OLD
FAKE_HD_CALL void hdScheduleSynchronous(Callback run, void* context, unsigned short priority) {
    auto& l = library();
    const auto number = schedule(l, run, context, priority);
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
    auto& l = library();
    const Lock lock(l.mutex);
    if (std::erase_if(l.tasks, [&](const Task& t) { return t.number == number; }) == 0)
        broken(l, fake_hd_wrong_value, invalid_value);
}

FAKE_HD_CALL unsigned int hdCheckCalibration() {
    auto& l = library();
    const Lock lock(l.mutex);
    if (!may(l)) return 0;
    if (l.script.has("manual")) return 0x5002;
    return l.script.has("needs_update") && !l.updated ? 0x5001 : 0x5000;
}

FAKE_HD_CALL unsigned int hdCheckCalibrationStyle() { return 2; }

FAKE_HD_CALL void hdUpdateCalibration(unsigned int style) {
    auto& l = library();
    const Lock lock(l.mutex);
    if (style != 2) return broken(l, fake_hd_wrong_value, invalid_value);
    if (may(l)) l.updated = true;
}

}  // extern "C"
