// Runs a program with fake pads (drivers/fake_pad.h):
//
//     umockdev-wrapper pad_harness [--two] [--equal NUMBER] [--felt FILE] [--version NUMBER] [--stick] [--locked]
//                                  PROGRAM ARGS...
//
// The first pad is an Xbox 360 pad (045e:028e) with motors, of the version NUMBER (hexadecimal). --stick
// makes it a joystick without a name for any button: 12 buttons, 6 axes of which the last two rest at their
// lowest value, and a hat. --locked removes all permissions to read it. --two adds an Xbox One pad
// (045e:02d1) without motors, --equal adds NUMBER pads like the first one, up to eight together.
//
// FILE gets one line for each call of the program on the motors, with "2." before it for the second pad, and
// so on:
//
//     upload ID STRONG WEAK MS    an effect: its number, the magnitudes of both motors, its length
//     play ID VALUE               an effect begins (1) or stops (0)
//     remove ID
//
// A pad that is unplugged refuses all calls, as Linux does. Its effects are gone when it is plugged in again.
//
// Input for the pads comes from standard input, one line "WHAT VALUE" each, and takes effect at once. WHAT is
// one of the following, with "2." before it for the second pad, and so on:
//
//     a, b, x, y, lb, rb, back, start   a button: 1 or 0
//     lx, ly, rx, ry                    an axis: -32768 to 32767, positive to the right and down
//     lt, rt                            a trigger: 0 to 255
//     hx, hy                            the directional pad: -1 to 1
//     button.N, axis.N                  by SDL's number on a joystick
//     plugged                           1 or 0
//     signal                            the number of a signal for the program
//
// Returns the program's exit code.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <umockdev.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>

#include "drivers/fake_pad.h"

namespace {

struct Part {
    std::uint16_t type{}, code{};
};
const std::map<std::string, Part> parts{
    {"a", {EV_KEY, BTN_A}},         {"b", {EV_KEY, BTN_B}},         {"x", {EV_KEY, BTN_X}},
    {"y", {EV_KEY, BTN_Y}},         {"lb", {EV_KEY, BTN_TL}},       {"rb", {EV_KEY, BTN_TR}},
    {"back", {EV_KEY, BTN_SELECT}}, {"start", {EV_KEY, BTN_START}}, {"guide", {EV_KEY, BTN_MODE}},
    {"l3", {EV_KEY, BTN_THUMBL}},   {"r3", {EV_KEY, BTN_THUMBR}},   {"lx", {EV_ABS, ABS_X}},
    {"ly", {EV_ABS, ABS_Y}},        {"lt", {EV_ABS, ABS_Z}},        {"rx", {EV_ABS, ABS_RX}},
    {"ry", {EV_ABS, ABS_RY}},       {"rt", {EV_ABS, ABS_RZ}},       {"hx", {EV_ABS, ABS_HAT0X}},
    {"hy", {EV_ABS, ABS_HAT0Y}}};

/// A button or axis by its name, or by SDL's number on a joystick.
std::optional<Part> part_of(std::string_view what) {
    constexpr std::string_view button = "button.", axis = "axis.";
    const auto number = [&](std::string_view before) {
        return static_cast<std::size_t>(std::atoi(what.substr(before.size()).data()));
    };
    if (what.starts_with(button)) return Part{EV_KEY, fake::button_code(number(button))};
    if (what.starts_with(axis)) return Part{EV_ABS, fake::axis_code(number(axis))};
    const auto named = parts.find(std::string(what));
    return named == parts.end() ? std::nullopt : std::optional(named->second);
}

using Pads = std::array<fake::Pad, 8>;

void perform(Pads& pads, pid_t game, std::string_view what, int value) {
    std::size_t number = 0;
    if (what.size() > 2 && what[1] == '.' && what[0] >= '2' && what[0] <= '8') {
        number = static_cast<std::size_t>(what[0] - '1');
        what.remove_prefix(2);
    }
    auto& pad = pads.at(number);
    if (what == "plugged")
        fake::plug(pad, value != 0);
    else if (what == "signal")
        kill(game, value);
    else if (const auto part = part_of(what))
        fake::report(pad, part->type, part->code, value);
    else
        std::cerr << "pad: no part '" << what << "'\n";
}

void perform_as_told(Pads& pads, pid_t game) {
    std::string what;
    for (int value = 0; std::cin >> what >> value;) perform(pads, game, what, value);
}

/// A joystick that SDL does not know.
fake::Model unknown_stick() {
    constexpr std::size_t buttons = 12, axes = 6;
    auto model = fake::stick(buttons, axes, 1);
    model.vendor = 0xf00d;
    model.product = 0x0001;
    model.version = 0x0001;
    model.name = "Stick of wood and string";
    for (auto& axis : model.axes)
        if (axis.code == fake::axis_code(axes - 2) || axis.code == fake::axis_code(axes - 1))
            axis.rest = axis.lowest;
    return model;
}

struct Wishes {
    bool two = false, stick = false, locked = false;
    std::size_t equal = 0;
    const char *felt = nullptr, *version = nullptr;
};

/// Reads the options, and returns the arguments after them.
char** read_options(char** words, Wishes& wishes) {
    for (; *words != nullptr; ++words) {
        const std::string_view word = *words;
        const bool has_value = words[1] != nullptr;
        if (word == "--two")
            wishes.two = true;
        else if (word == "--stick")
            wishes.stick = true;
        else if (word == "--locked")
            wishes.locked = true;
        else if (word == "--equal" && has_value)
            wishes.equal = static_cast<std::size_t>(std::atoi(*++words));
        else if (word == "--felt" && has_value)
            wishes.felt = *++words;
        else if (word == "--version" && has_value)
            wishes.version = *++words;
        else
            break;
    }
    return words;
}

void make_pads(Pads& pads, const Wishes& wishes) {
    auto* testbed = umockdev_testbed_new();
    auto first = wishes.stick ? unknown_stick() : fake::xbox_360();
    if (wishes.version != nullptr)
        first.version = static_cast<std::uint16_t>(std::strtoul(wishes.version, nullptr, 16));
    fake::make_pad(pads[0], testbed, first, 0);
    if (wishes.locked) chmod(pads[0].link.c_str(), 0);
    if (wishes.two) fake::make_pad(pads[1], testbed, fake::xbox_one(), 1);
    for (std::size_t i = 1; i <= wishes.equal && i < pads.size(); ++i)
        fake::make_pad(pads.at(i), testbed, first, i);
    for (std::size_t i = 1; i < pads.size(); ++i) pads.at(i).prefix = std::to_string(i + 1) + ".";
}

}  // namespace

int main(int, char** argv) {
    Wishes wishes;
    char** program = read_options(argv + 1, wishes);
    const int felt =
        wishes.felt != nullptr ? open(wishes.felt, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666) : -1;
    if (*program == nullptr || (wishes.felt != nullptr && felt < 0)) return 2;
    // The pads are never destroyed, because threads read from them until the process ends.
    auto& pads = *std::make_unique<Pads>().release();
    for (auto& pad : pads) pad.felt = felt;
    make_pads(pads, wishes);
    const auto child = fork();
    if (child == 0) {
        execvp(*program, program);
        std::perror(*program);
        _exit(127);
    }
    for (auto& pad : pads)
        if (pad.fd >= 0 && felt >= 0) std::thread([&pad] { fake::follow_motors(pad); }).detach();
    perform_as_told(pads, child);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
