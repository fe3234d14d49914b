#include "drivers/fake_hd/misbehaviour.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <limits>

namespace thaum::fake_hd {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns the correct value `well`, or the wrong value that the scripted fault `how` puts in its place.
double spoilt(const std::string& how, double well) {
    if (how == "nan") return std::nan("");
    if (how == "inf") return infinite;
    if (how == "negative") return -well;
    if (how == "huge") return 1e300;
    return how == "zero" ? 0 : well;
}

/// Calls the program's tick task again, inside a library function that this task has called.
void call_back(Library& l) {
    thread_local bool within = false;
    if (within) return;
    within = true;
    call_ticks(l);
    within = false;
}

std::string due(Library& l, const char* call) {
    const Lock lock(l.mutex);
    auto how = l.script.of(call);
    if (how.empty()) return {};
    const auto calls = ++l.calls[call], until = l.script.number("until");
    return calls < l.script.number("from") || (until != 0 && calls >= until) ? "" : how;
}

}  // namespace

unsigned int misbehave(Library& l, const char* call) {
    const auto how = due(l, call);
    if (how.empty()) return 0;
    if (how == "blocks") {
        for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
    }
    if (how == "crashes") std::raise(SIGSEGV);
    if (how == "interrupts") return std::raise(SIGTERM), 0U;
    if (how == "returns_late") return 0;  // hdScheduleAsynchronous simulates this fault itself
    if (how == "calls_back") return call_back(l), 0U;
    if (how == "slow") return std::this_thread::sleep_for(std::chrono::seconds(2)), 0U;
    const auto code = static_cast<unsigned int>(std::strtoul(how.c_str(), nullptr, 16));
    const Lock lock(l.mutex);
    push(l, code);
    return code;
}

vec3 measured_mm(const Device& d) {
    const auto nan = d.script.number("nan"), tick = d.ticks;
    if (nan != 0 && tick >= nan && tick < nan + 10) return vec3(std::nan(""));
    const auto how = d.script.of("pose");
    const vec3 well = haptics::measured_position(d.device, d.arm) * 1e3;
    if (how == "stuck") return {1, 2, 3};
    if (how == "jumps") return tick % 2 == 0 ? well : vec3(80, -60, 35);
    return {spoilt(how, well.x), spoilt(how, well.y), well.z};
}

void put_transform(const Device& d, double* to) {
    const auto how = d.script.of("turn");
    const auto at = measured_mm(d);
    const auto q = rotation({0, 1, 0}, how == "jumps" ? (d.ticks % 2 == 0 ? 3.0 : -3.0) : at.x * 1e-3 * 10);
    const auto turned = glm::mat3_cast(q);
    std::fill_n(to, 16, 0.0);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) to[4 * column + row] = spoilt(how, turned[column][row]);
    }
    for (int row = 0; row < 3; ++row) to[12 + row] = at[row];
    to[15] = 1;
}

bool put_limit(const Library& l, unsigned int name, double* to) {
    const std::map<unsigned int, double> limits{
        {0x2602, 0.4}, {0x2603, max_force}, {0x2604, 0.88}, {0x2609, 0.004}};
    if (const auto found = limits.find(name); found != limits.end())
        return *to = l.script.has("mute") ? 0 : spoilt(l.script.of("limits"), found->second), true;
    if (name != 0x2551) return false;
    std::array<double, 6> box{-80, -60, -35, 80, 60, 35};
    const auto how = l.script.of("box");
    if (how == "inverted") std::reverse(box.begin(), box.end());
    for (auto& edge : box) edge = how == "inverted" ? edge : spoilt(how, edge);
    std::copy(box.begin(), box.end(), to);
    return true;
}

int degrees_of_freedom(const Library& l, int well) {
    const auto how = l.script.of("dof");
    return how == "negative" ? -well : how == "huge" ? std::numeric_limits<int>::max() : well;
}

const char* said(const Library& l, const char* word, const char* well) {
    static const std::string long_one(1'000'000, 'A');
    const auto how = l.script.of(word);
    if (how == "null") return nullptr;
    if (how == "empty") return "";
    if (how == "control")
        return "\x1b]0;pwned\x07\x1b[2J\r\n\x7f\xc2\x9b"
               "31m\xe2\x80\xae Touch";
    if (how == "invalid") return "\xff\xfe\xc0\xaf\xed\xa0\x80\xf4\x90\x80\x80 Touch";
    return how == "long" ? long_one.c_str() : well;
}

}  // namespace thaum::fake_hd
