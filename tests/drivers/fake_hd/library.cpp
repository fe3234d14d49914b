#include "drivers/fake_hd/library.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace thaum::fake_hd {
namespace {

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

void record(Library& l, vec3 force) {
    const vec3 at = l.arm.position;
    if (l.script.has("record")) l.recorded.push_back({force.x, force.y, force.z, at.x, at.y, at.z});
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

FakeHdLive* map_live(const std::string& file) {
    const int fd = ::open(file.c_str(), O_RDWR | O_CREAT, 0600);
    if (fd < 0 || ::ftruncate(fd, sizeof(FakeHdLive)) != 0) return nullptr;
    void* memory = ::mmap(nullptr, sizeof(FakeHdLive), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    ::close(fd);
    return memory == MAP_FAILED ? nullptr : static_cast<FakeHdLive*>(memory);
}

std::array<double, 3> numbers_of(vec3 v) { return {v.x, v.y, v.z}; }

/// Tick number by which the script's words count: since hdInitDevice, or since the first force.
std::uint64_t script_ticks(const Library& l) {
    if (!l.script.has("felt")) return l.report.ticks;
    return l.felt_at == 0 ? 0 : l.report.ticks - l.felt_at;
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
    if (!l.frame) return broken(l, fake_hd_outside_frame, frame_error), false;
    return true;
}

void take_device(Library& l) {
    l.device = haptics::simulated_device(touch_spec(), haptics::Hand{});
    l.arm = haptics::resting_at(place_at(l.script.path, 0).target);
    l.initiated = true;
    l.frame = l.force_output = l.clamping = l.updated = false;
    l.told = l.setting = vec3(0);
    l.tasks.clear();
    l.recorded.clear();
    l.report = {};
    l.felt_at = 0;
    if (l.live == nullptr && l.script.has("live")) l.live = map_live(l.script.of("live"));
    update_live(l);
}

void let_go(Library& l) {
    // A force set after the last tick has not been recorded yet.
    record(l, exerted(l));
    write_record(l);
    l.report.left = numbers_of(exerted(l));
    l.initiated = false;
    update_live(l);
}

vec3 exerted(const Library& l) { return l.initiated && l.force_output ? l.told : vec3(0); }

void move_arm(Library& l) {
    const auto& place = place_at(l.script.path, static_cast<double>(l.report.ticks));
    const vec3 force = exerted(l);
    l.arm = haptics::step(l.device, l.arm, place.target, force);
    l.buttons = place.buttons;
    ++l.report.ticks;
    l.report.force = numbers_of(force);
    l.report.position = numbers_of(l.arm.position);
    l.report.greatest_force = std::max(l.report.greatest_force, glm::length(force));
    if (l.felt_at == 0 && force != vec3(0)) l.felt_at = l.report.ticks;
    record(l, force);
    update_live(l);
}

void update_live(Library& l) {
    if (l.live == nullptr) return;
    l.live->force = numbers_of(exerted(l));
    l.live->left = l.report.left;
    l.live->greatest_force = std::max(l.live->greatest_force, l.report.greatest_force);
    l.live->ticks = l.report.ticks;
    l.live->initiated = l.initiated ? 1 : 0;
}

bool goes_wrong(Library& l, const char* word) {
    const auto at = l.script.number(word);
    if (at == 0 || script_ticks(l) < at || l.came_back) return false;
    l.went_wrong = true;
    return true;
}

bool is_missing(Library& l) {
    if (!l.went_wrong || !l.script.has("back") || l.came_back) return false;
    if (l.refused++ < l.script.number("back")) return true;
    l.came_back = true;
    return false;
}

}  // namespace thaum::fake_hd
