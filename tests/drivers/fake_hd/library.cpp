#include "drivers/fake_hd/library.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace thaum::fake_hd {
namespace {

/// Specification of a Touch device.
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

void record(Device& d, vec3 force) {
    const vec3 at = d.arm.position;
    if (d.script.has("record")) d.recorded.push_back({force.x, force.y, force.z, at.x, at.y, at.z});
}

void write_record(const Device& d) {
    if (!d.script.has("record")) return;
    std::ofstream out(d.script.words.at("record"));
    out.precision(17);
    for (const auto& tick : d.recorded) {
        for (const double number : tick) out << number << ' ';
        out << '\n';
    }
}

FakeHdLive* map_live(const std::string& file) {
    const int fd = ::open(file.c_str(), O_RDWR | O_CREAT, 0600);
    if (fd < 0 || ::ftruncate(fd, sizeof(FakeHdLive)) != 0) return nullptr;
    void* memory = ::mmap(nullptr, sizeof(FakeHdLive), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    ::close(fd);
    return memory == MAP_FAILED ? nullptr : static_cast<FakeHdLive*>(memory);
}

std::array<double, 3> numbers_of(vec3 v) { return {v.x, v.y, v.z}; }

/// Number of the tick in the count that the script's times use: from the first force on, or since the
/// opening.
std::uint64_t script_ticks(const Device& d) {
    if (!d.script.has("felt")) return d.ticks;
    return d.felt_at == 0 ? 0 : d.ticks - d.felt_at;
}

}  // namespace

Library& library() {
    static auto* the = new Library();
    return *the;
}

void push(Library& l, unsigned int code) { l.errors.push_back(code); }

void broken(Library& l, FakeHdRule rule, unsigned int code) {
    ++l.report.broken[rule];
    push(l, code);
}

bool on_own_thread(const Library& l) {
    return std::this_thread::get_id() == l.own_thread.load() || l.script.is("callback", "two_threads");
}

bool may(Library& l) {
    if (l.running && !on_own_thread(l)) return broken(l, fake_hd_wrong_thread, invalid_operation), false;
    if (!current(l).frame) return broken(l, fake_hd_outside_frame, frame_error), false;
    return true;
}

Device& current(Library& l) { return l.devices[l.current]; }

void take_device(Library& l, Device& d) {
    d.device = haptics::simulated_device(touch_spec(), haptics::Hand{});
    d.arm = haptics::resting_at(place_at(d.script.path, 0).target);
    const bool alone = std::none_of(l.devices.begin(), l.devices.end(), [](auto& o) { return o.initiated; });
    if (alone) {
        l.tasks.clear();
        l.report = {};
    }
    d.initiated = true;
    d.frame = d.force_output = d.clamping = d.updated = false;
    d.told = d.setting = vec3(0);
    d.recorded.clear();
    d.report = {};
    d.ticks = d.felt_at = 0;
    if (d.live == nullptr && d.script.has("live")) d.live = map_live(d.script.of("live"));
    update_live(d);
}

void let_go(Device& d) {
    // The last force may have been set after the last tick, so it is recorded here.
    record(d, exerted(d));
    write_record(d);
    d.report.left = numbers_of(exerted(d));
    d.initiated = false;
    update_live(d);
}

vec3 exerted(const Device& d) { return d.initiated && d.force_output ? d.told : vec3(0); }

namespace {

void move_arm(Device& d) {
    const auto& place = place_at(d.script.path, static_cast<double>(d.ticks));
    const vec3 force = exerted(d);
    d.arm = haptics::step(d.device, d.arm, place.target, force);
    d.buttons = place.buttons;
    ++d.ticks;
    d.report.force = numbers_of(force);
    d.report.position = numbers_of(d.arm.position);
    d.report.max_force = std::max(d.report.max_force, glm::length(force));
    if (d.felt_at == 0 && force != vec3(0)) d.felt_at = d.ticks;
    record(d, force);
    update_live(d);
}

}  // namespace

void move_arms(Library& l) {
    ++l.report.ticks;
    for (auto& d : l.devices)
        if (d.initiated) move_arm(d);
}

void update_live(Device& d) {
    if (d.live == nullptr) return;
    d.live->force = numbers_of(exerted(d));
    d.live->left = d.report.left;
    d.live->max_force = std::max(d.live->max_force, d.report.max_force);
    d.live->ticks = d.ticks;
    d.live->initiated = d.initiated ? 1 : 0;
}

bool goes_wrong(Device& d, const char* word) {
    const auto at = d.script.number(word);
    if (at == 0 || script_ticks(d) < at || d.came_back) return false;
    d.went_wrong = true;
    return true;
}

bool is_missing(Device& d) {
    if (!d.went_wrong || !d.script.has("back") || d.came_back) return false;
    if (d.refused++ < d.script.number("back")) return true;
    d.came_back = true;
    return false;
}

}  // namespace thaum::fake_hd
