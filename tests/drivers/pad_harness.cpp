// Runs a program with a fake Xbox 360 pad (045e:028e) made by umockdev, or also with an Xbox One pad (045e:02d1). It
// does not need /dev/uinput:
//
//     umockdev-wrapper pad_harness [--two] [--felt FILE] PROGRAM ARGS...
//
// The first pad has motors, the second one none. FILE gets one line for each call of the program on the motors, with
// "2." before it for the second pad:
//
//     upload ID STRONG WEAK MS    an effect: its number, the magnitudes of both motors, its length
//     play ID VALUE               an effect begins (1) or stops (0)
//     remove ID
//
// A pad that is unplugged refuses all calls, as Linux does. Its effects are gone when it is plugged in again.
//
// The steps come from standard input, one line "WHAT VALUE" each, and happen at once. WHAT is one of the
// following, with "2." before it for the second pad:
//
//     a, b, x, y, lb, rb, back, start   a button: 1 or 0
//     lx, ly, rx, ry                    an axis: -32768 to 32767, positive to the right and down
//     lt, rt                            a trigger: 0 to 255
//     plugged                           1 or 0
//     signal                            the number of a signal for the program
//
// Returns the program's exit code.
#include <fcntl.h>
#include <linux/input.h>
#include <signal.h>
#include <sys/wait.h>
#include <umockdev.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace {

struct Model {
    std::uint16_t product{}, version{};
    const char* name{};
    bool motors{};
};
constexpr std::array models{Model{0x028e, 0x0114, "Microsoft X-Box 360 pad", true},
                            Model{0x02d1, 0x0101, "Microsoft X-Box One pad", false}};
constexpr int most_effects = 16;

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

// ---- answers to the program's questions about the pad -----------------------------------------------------

void set_bit(std::vector<guint8>& bits, unsigned bit) {
    if (bit / 8 < bits.size()) bits[bit / 8] = static_cast<guint8>(bits[bit / 8] | (1U << (bit % 8)));
}

input_absinfo range_of(unsigned axis) {
    if (axis == ABS_Z || axis == ABS_RZ) return {0, 0, 255, 0, 0, 0};
    if (axis == ABS_HAT0X || axis == ABS_HAT0Y) return {0, -1, 1, 0, 0, 0};
    return {0, -32768, 32767, 16, 128, 0};
}

struct Pad {
    UMockdevTestbed* testbed{};
    Model model{};
    int fd = -1;
    std::filesystem::path link{}, target{};
    std::string device{};  ///< path of the device in /sys
    std::string prefix{};  ///< of the lines about its motors
    int felt = -1;         ///< file for these lines; below 0: none
    std::atomic<bool> plugged{true};
    /// Effects that the program has uploaded.
    std::array<std::atomic<bool>, most_effects> effects{};
    /// Present values of the axes. Programs read them again after each report.
    std::array<std::atomic<int>, ABS_CNT> axis_values{};
};

std::vector<guint8> answer(const Pad& pad, unsigned number, std::size_t size) {
    std::vector<guint8> out(size, 0);
    const auto copy = [&](const void* from, std::size_t n) {
        std::memcpy(out.data(), from, std::min(n, size));
    };
    if (number == _IOC_NR(EVIOCGID)) {
        const input_id id{BUS_USB, 0x045e, pad.model.product, pad.model.version};
        copy(&id, sizeof id);
    } else if (number == _IOC_NR(EVIOCGNAME(0))) {
        copy(pad.model.name, std::strlen(pad.model.name) + 1);
    } else if (number == 0x20) {
        for (const unsigned type : std::array<unsigned, 3>{EV_SYN, EV_KEY, EV_ABS}) set_bit(out, type);
        if (pad.model.motors) set_bit(out, EV_FF);
    } else if (number == 0x20 + EV_FF && pad.model.motors) {
        set_bit(out, FF_RUMBLE);
    } else if (number == _IOC_NR(EVIOCGEFFECTS) && pad.model.motors) {
        copy(&most_effects, sizeof most_effects);
    } else if (number == 0x20 + EV_KEY || number == 0x20 + EV_ABS) {
        for (const auto& [name, part] : parts) {
            if (part.type == number - 0x20) set_bit(out, part.code);
        }
    } else if (number >= 0x40 && number < 0x40 + ABS_CNT) {
        auto range = range_of(number - 0x40);
        range.value = pad.axis_values[number - 0x40];
        copy(&range, sizeof range);
    }
    return out;
}

// ---- motors -----------------------------------------------------------------------------------------------

/// Adds a line to the file, in one piece, since several threads write.
void tell(const Pad& pad, const std::string& line) {
    const auto whole = pad.prefix + line + "\n";
    if (pad.felt >= 0 && write(pad.felt, whole.data(), whole.size()) < 0) std::perror("pad");
}

/// Keeps an effect, and gives a new one a number. Returns an error number.
int upload(Pad& pad, ff_effect& effect) {
    if (!pad.model.motors || effect.type != FF_RUMBLE) return EINVAL;
    for (int id = 0; effect.id < 0 && id < most_effects; ++id) {
        if (!pad.effects.at(static_cast<std::size_t>(id)).exchange(true))
            effect.id = static_cast<std::int16_t>(id);
    }
    if (effect.id < 0) return ENOSPC;
    if (effect.id >= most_effects || !pad.effects.at(static_cast<std::size_t>(effect.id))) return EINVAL;
    tell(pad, "upload " + std::to_string(effect.id) + " " + std::to_string(effect.u.rumble.strong_magnitude) +
                  " " + std::to_string(effect.u.rumble.weak_magnitude) + " " +
                  std::to_string(effect.replay.length));
    return 0;
}

/// Copies the bytes of an argument into a value. Returns whether there are enough.
template <class Value>
bool copy_from(UMockdevIoctlData* argument, Value& value) {
    guint8* bytes = nullptr;
    int size = 0;
    umockdev_ioctl_data_retrieve(argument, &bytes, &size);
    const bool enough = size >= static_cast<int>(sizeof value);
    if (enough) std::memcpy(&value, bytes, sizeof value);
    g_free(bytes);
    return enough;
}

int on_upload(Pad& pad, UMockdevIoctlData* argument) {
    auto* target = umockdev_ioctl_data_resolve(argument, 0, sizeof(ff_effect), nullptr);
    if (target == nullptr) return EFAULT;
    ff_effect effect{};
    const int error = copy_from(target, effect) ? upload(pad, effect) : EFAULT;
    umockdev_ioctl_data_update(target, 0, reinterpret_cast<guint8*>(&effect), sizeof effect);
    umockdev_ioctl_data_unref(target);
    return error;
}

int on_remove(Pad& pad, UMockdevIoctlData* argument) {
    unsigned long id = 0;
    if (!copy_from(argument, id)) return EFAULT;
    if (id >= pad.effects.size() || !pad.effects.at(id).exchange(false)) return EINVAL;
    tell(pad, "remove " + std::to_string(id));
    return 0;
}

/// Reads what programs write to the pad: the beginnings and ends of effects.
void follow_motors(Pad& pad) {
    input_event event{};
    std::size_t filled = 0;
    for (;;) {
        const auto got = read(pad.fd, reinterpret_cast<char*>(&event) + filled, sizeof event - filled);
        if (got <= 0) {  // nobody has opened the pad
            usleep(1000);
            continue;
        }
        filled += static_cast<std::size_t>(got);
        if (filled < sizeof event) continue;
        filled = 0;
        if (event.type == EV_FF && pad.plugged)
            tell(pad, "play " + std::to_string(event.code) + " " + std::to_string(event.value));
    }
}

gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data) {
    auto& pad = *static_cast<Pad*>(data);
    const auto request = static_cast<unsigned>(umockdev_ioctl_client_get_request(client));
    if (_IOC_TYPE(request) != 'E') return FALSE;
    const bool uploads = request == EVIOCSFF, removes = request == EVIOCRMFF;
    if (!pad.plugged || uploads || removes) {
        auto* argument = umockdev_ioctl_client_get_arg(client);
        const int error = !pad.plugged ? ENODEV
                          : uploads    ? on_upload(pad, argument)
                                       : on_remove(pad, argument);
        umockdev_ioctl_client_complete(client, error == 0 ? 0 : -1, error);
        return TRUE;
    }
    const auto size = static_cast<std::size_t>(_IOC_SIZE(request));
    if (_IOC_DIR(request) == _IOC_READ && size > 0) {
        auto* argument = umockdev_ioctl_client_get_arg(client);
        auto* target = umockdev_ioctl_data_resolve(argument, 0, size, nullptr);
        if (target == nullptr) return FALSE;
        auto bytes = answer(pad, _IOC_NR(request), size);
        umockdev_ioctl_data_update(target, 0, bytes.data(), static_cast<gint>(bytes.size()));
        umockdev_ioctl_data_unref(target);
    }
    umockdev_ioctl_client_complete(client, 0, 0);
    return TRUE;
}

// ---- changes of the pad -----------------------------------------------------------------------------------

void report(Pad& pad, const Part& part, int value) {
    if (part.type == EV_ABS) pad.axis_values[part.code] = value;
    std::array<input_event, 2> events{};
    events[0].type = part.type;
    events[0].code = part.code;
    events[0].value = value;
    events[1].type = EV_SYN;
    if (write(pad.fd, events.data(), sizeof events) != static_cast<ssize_t>(sizeof events))
        std::perror("pad");
}

/// Removes or restores the link to the device node. Programs watch the folder of that link.
void plug(Pad& pad, bool in) {
    pad.plugged = in;
    for (auto& effect : pad.effects) effect = false;
    std::error_code error;
    if (in)
        std::filesystem::create_symlink(pad.target, pad.link, error);
    else
        std::filesystem::remove(pad.link, error);
    if (error) std::fprintf(stderr, "pad: %s\n", error.message().c_str());
    umockdev_testbed_uevent(pad.testbed, pad.device.c_str(), in ? "add" : "remove");
}

using Pads = std::array<Pad, models.size()>;

void perform(Pads& pads, pid_t game, std::string_view what, int value) {
    const bool second = what.starts_with("2.");
    if (second) what.remove_prefix(2);
    auto& pad = pads[second ? 1 : 0];
    if (what == "plugged")
        plug(pad, value != 0);
    else if (what == "signal")
        kill(game, value);
    else if (const auto part = parts.find(std::string(what)); part != parts.end())
        report(pad, part->second, value);
    else
        std::cerr << "pad: no part '" << what << "'\n";
}

void perform_as_told(Pads& pads, pid_t game) {
    std::string what;
    for (int value = 0; std::cin >> what >> value;) perform(pads, game, what, value);
}

void make_pad(Pad& pad, UMockdevTestbed* testbed, std::size_t number) {
    const auto digit = std::to_string(number);
    const auto event = "event" + digit, node = "/dev/input/" + event;
    pad.testbed = testbed;
    pad.model = models[number];
    pad.device = "/sys/devices/virtual/input/input" + digit + "/" + event;
    const auto description = "P: " + pad.device.substr(4) + "\nN: input/" + event + "\nE: DEVNAME=" + node +
                             "\nE: SUBSYSTEM=input\nE: ID_INPUT=1\nE: ID_INPUT_JOYSTICK=1\n";
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(testbed, description.c_str(), &error))
        g_error("%s", error->message);
    auto* handler = umockdev_ioctl_base_new();
    g_signal_connect(handler, "handle-ioctl", G_CALLBACK(on_ioctl), &pad);
    if (!umockdev_testbed_attach_ioctl(testbed, node.c_str(), handler, &error)) g_error("%s", error->message);
    pad.fd = umockdev_testbed_get_dev_fd(testbed, node.c_str());
    const auto* root = std::getenv("UMOCKDEV_DIR");
    pad.link = std::filesystem::path(root == nullptr ? "" : root) / node.substr(1);
    std::error_code error_code;
    pad.target = std::filesystem::read_symlink(pad.link, error_code);
}

}  // namespace

int main(int argc, char** argv) {
    char** program = argv + 1;
    const auto takes = [&](std::string_view word) {
        const bool there = *program != nullptr && *program == word;
        if (there) ++program;
        return there;
    };
    const bool two = takes("--two"), tells = takes("--felt");
    const int felt =
        tells && *program != nullptr ? open(*program++, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666) : -1;
    if (argc < 2 || *program == nullptr || (tells && felt < 0)) return 2;
    // Never destroyed: threads that read from the pads use them to the end.
    auto& pads = *std::make_unique<Pads>().release();
    auto* testbed = umockdev_testbed_new();
    for (std::size_t i = 0; i < (two ? pads.size() : 1); ++i) {
        pads[i].felt = felt;
        pads[i].prefix = i == 0 ? "" : "2.";
        make_pad(pads[i], testbed, i);
    }
    const auto child = fork();
    if (child == 0) {
        execvp(*program, program);
        std::perror(*program);
        _exit(127);
    }
    for (auto& pad : pads)
        if (pad.fd >= 0 && felt >= 0) std::thread([&pad] { follow_motors(pad); }).detach();
    perform_as_told(pads, child);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
