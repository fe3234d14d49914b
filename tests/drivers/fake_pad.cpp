#include "drivers/fake_pad.h"

#include <umockdev.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>

namespace fake {
namespace {

// ---- models of pads ---------------------------------------------------------------------------------------

Model xbox(std::uint16_t product, std::uint16_t version, const char* name, bool motors) {
    return {.vendor = 0x045e,
            .product = product,
            .version = version,
            .name = name,
            .buttons = {BTN_A, BTN_B, BTN_X, BTN_Y, BTN_TL, BTN_TR, BTN_SELECT, BTN_START, BTN_MODE,
                        BTN_THUMBL, BTN_THUMBR},
            .axes = {{ABS_X},
                     {ABS_Y},
                     {ABS_Z, 0, 255},
                     {ABS_RX},
                     {ABS_RY},
                     {ABS_RZ, 0, 255},
                     {ABS_HAT0X, -1, 1},
                     {ABS_HAT0Y, -1, 1}},
            .motors = motors};
}

// ---- answers to the program's questions about the pad -----------------------------------------------------

void set_bit(std::vector<guint8>& bits, unsigned bit) {
    if (bit / 8 < bits.size()) bits[bit / 8] = static_cast<guint8>(bits[bit / 8] | (1U << (bit % 8)));
}

input_absinfo range_of(const Pad& pad, unsigned code) {
    const auto& axes = pad.model.axes;
    const auto axis = std::find_if(axes.begin(), axes.end(), [&](const Axis& a) { return a.code == code; });
    if (axis == axes.end()) return {};
    return {pad.axis_values.at(code), axis->lowest, axis->highest, 0, 0, 0};
}

std::vector<guint8> answer(const Pad& pad, unsigned number, std::size_t size) {
    std::vector<guint8> out(size, 0);
    const auto copy = [&](const void* from, std::size_t n) {
        std::memcpy(out.data(), from, std::min(n, size));
    };
    const auto& model = pad.model;
    if (number == _IOC_NR(EVIOCGID)) {
        const input_id id{model.bus, model.vendor, model.product, model.version};
        copy(&id, sizeof id);
    } else if (number == _IOC_NR(EVIOCGNAME(0))) {
        copy(model.name.c_str(), model.name.size() + 1);
    } else if (number == 0x20) {
        for (const unsigned type : std::array<unsigned, 3>{EV_SYN, EV_KEY, EV_ABS}) set_bit(out, type);
        if (model.motors) set_bit(out, EV_FF);
    } else if (number == 0x20 + EV_FF && model.motors) {
        set_bit(out, FF_RUMBLE);
    } else if (number == _IOC_NR(EVIOCGEFFECTS) && model.motors) {
        copy(&max_effects, sizeof max_effects);
    } else if (number == 0x20 + EV_KEY) {
        for (const auto code : model.buttons) set_bit(out, code);
    } else if (number == 0x20 + EV_ABS) {
        for (const auto& axis : model.axes) set_bit(out, axis.code);
    } else if (number >= 0x40 && number < 0x40 + ABS_CNT) {
        const auto range = range_of(pad, number - 0x40);
        copy(&range, sizeof range);
    }
    return out;
}

// ---- motors of a pad --------------------------------------------------------------------------------------

/// Adds a line to the file about the motors with a single write, since several threads write.
void tell(const Pad& pad, const std::string& line) {
    const auto whole = pad.prefix + line + "\n";
    if (pad.felt >= 0 && write(pad.felt, whole.data(), whole.size()) < 0) std::perror("pad");
}

/// Stores an effect, and numbers it if it is new. Returns an error number.
int upload(Pad& pad, ff_effect& effect) {
    if (!pad.model.motors || effect.type != FF_RUMBLE) return EINVAL;
    for (int id = 0; effect.id < 0 && id < max_effects; ++id) {
        if (!pad.effects.at(static_cast<std::size_t>(id)).exchange(true))
            effect.id = static_cast<std::int16_t>(id);
    }
    if (effect.id < 0) return ENOSPC;
    if (effect.id >= max_effects || !pad.effects.at(static_cast<std::size_t>(effect.id))) return EINVAL;
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

/// The set of a model's buttons as the system prints it: hexadecimal words, the highest first.
std::string words_of_buttons(const Model& model) {
    std::array<std::uint64_t, KEY_CNT / 64> words{};
    for (const auto code : model.buttons) words.at(code / 64) |= std::uint64_t{1} << (code % 64);
    std::string out;
    for (auto word = words.rbegin(); word != words.rend(); ++word) {
        std::array<char, 20> hex{};
        std::snprintf(hex.data(), hex.size(), "%s%lx", out.empty() ? "" : " ",
                      static_cast<unsigned long>(*word));
        out += hex.data();
    }
    return out;
}

/// Description of the device as the system gives it. SDL treats devices with the same device number (dev) as
/// a single device.
std::string description_of(const Pad& pad, std::size_t number) {
    constexpr std::size_t first_minor = 64;
    const auto digit = std::to_string(number), event = "event" + digit;
    const auto input = "/devices/virtual/input/input" + digit;
    return "P: " + input + "\nE: SUBSYSTEM=input\nA: name=" + pad.model.name +
           "\nA: capabilities/key=" + words_of_buttons(pad.model) + "\n\nP: " + input + "/" + event +
           "\nN: input/" + event + "\nE: DEVNAME=/dev/input/" + event +
           "\nA: dev=13:" + std::to_string(first_minor + number) +
           "\nE: SUBSYSTEM=input\nE: ID_INPUT=1\nE: ID_INPUT_JOYSTICK=1\nL: device=../../input" + digit +
           "\n";
}

}  // namespace

Model xbox_360() { return xbox(0x028e, 0x0114, "Microsoft X-Box 360 pad", true); }
Model xbox_one() { return xbox(0x02d1, 0x0101, "Microsoft X-Box One pad", false); }

std::uint16_t button_code(std::size_t number) {
    // Linux has 32 codes in a row for buttons of joysticks and pads. Codes of further buttons begin at
    // another place.
    constexpr std::size_t block = 32;
    return static_cast<std::uint16_t>(number < block ? BTN_JOYSTICK + number
                                                     : BTN_TRIGGER_HAPPY + number - block);
}

std::uint16_t axis_code(std::size_t number) {
    // Codes from here on are those of hats (direction pads), so further axes begin after them.
    constexpr std::size_t first = ABS_BRAKE + 1;
    return static_cast<std::uint16_t>(number < first ? number : ABS_PRESSURE + number - first);
}

Model stick(std::size_t buttons, std::size_t axes, std::size_t hats) {
    Model model;
    for (std::size_t i = 0; i < buttons; ++i) model.buttons.push_back(button_code(i));
    for (std::size_t i = 0; i < axes; ++i) model.axes.push_back({axis_code(i)});
    for (std::size_t i = 0; i < 2 * hats; ++i)
        model.axes.push_back({static_cast<std::uint16_t>(ABS_HAT0X + i), -1, 1});
    return model;
}

void make_pad(Pad& pad, _UMockdevTestbed* testbed, const Model& model, std::size_t number) {
    const auto digit = std::to_string(number);
    const auto node = "/dev/input/event" + digit;
    pad.testbed = testbed;
    pad.model = model;
    for (const auto& axis : model.axes) pad.axis_values.at(axis.code) = axis.rest;
    pad.device = "/sys/devices/virtual/input/input" + digit + "/event" + digit;
    GError* error = nullptr;
    if (umockdev_testbed_add_from_string(testbed, description_of(pad, number).c_str(), &error) == 0)
        g_error("%s", error->message);
    auto* handler = umockdev_ioctl_base_new();
    g_signal_connect(handler, "handle-ioctl", G_CALLBACK(on_ioctl), &pad);
    if (umockdev_testbed_attach_ioctl(testbed, node.c_str(), handler, &error) == 0)
        g_error("%s", error->message);
    pad.fd = umockdev_testbed_get_dev_fd(testbed, node.c_str());
    const auto* root = std::getenv("UMOCKDEV_DIR");
    pad.link = std::filesystem::path(root == nullptr ? "" : root) / node.substr(1);
    std::error_code error_code;
    pad.target = std::filesystem::read_symlink(pad.link, error_code);
}

void report(Pad& pad, std::uint16_t type, std::uint16_t code, int value) {
    if (type == EV_ABS) pad.axis_values.at(code) = value;
    std::array<input_event, 2> events{};
    events[0].type = type;
    events[0].code = code;
    events[0].value = value;
    events[1].type = EV_SYN;
    if (write(pad.fd, events.data(), sizeof events) != static_cast<ssize_t>(sizeof events))
        std::perror("pad");
}

// Removes or restores the link to the device node, and notifies programs.
void plug(Pad& pad, bool in) {
    pad.plugged = in;
    for (auto& effect : pad.effects) effect = false;
    std::error_code error;
    if (in && !std::filesystem::is_symlink(pad.link))
        std::filesystem::create_symlink(pad.target, pad.link, error);
    if (!in) std::filesystem::remove(pad.link, error);
    if (error) std::fprintf(stderr, "pad: %s\n", error.message().c_str());
    umockdev_testbed_uevent(pad.testbed, pad.device.c_str(), in ? "add" : "remove");
}

void follow_motors(Pad& pad) {
    input_event event{};
    std::size_t filled = 0;
    for (;;) {
        const auto got = read(pad.fd, reinterpret_cast<char*>(&event) + filled, sizeof event - filled);
        if (got <= 0) {  // no program has opened the pad
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

}  // namespace fake
