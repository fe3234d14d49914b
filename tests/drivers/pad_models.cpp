// Emulates pads from SDL's table of mappings: umockdev-wrapper pad_models SEED COUNT
//
// Draws COUNT random mappings for Linux from SDL's table, simulates a joystick with the device numbers,
// buttons and axes of each, and plugs these in one after the other. On each, the button A, the left stick and
// the right trigger must act as on an Xbox pad. Then the pad of a mapping that is added, and one from
// SDL_GAMECONTROLLERCONFIG (set by the caller for the joystick f00d:0002), must work as well. Prints a line
// for each model that does not.
#include <SDL.h>
#include <umockdev.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <thread>

#include "core/random.h"
#include "core/text.h"
#include "drivers/fake_pad.h"
#include "input/pads.h"

namespace {

using namespace thaum;
using input::PadAxis;
using input::PadReader;
using input::PadState;

/// A part of a joystick as SDL writes it in a mapping, with its number: "b0", "h0.4", "a2", "+a2", "-a2",
/// "a2~".
struct Part {
    char kind{};          ///< b (button), h (hat) or a (axis)
    char half{};          ///< '+' or '-': only the positive or negative half of the axis; 0: all of it
    bool turned = false;  ///< true: the axis acts in the opposite direction
    std::size_t number{};
    unsigned direction{};  ///< bit of the hat's direction
};

std::optional<Part> part_of(std::string words) {
    Part part;
    if (words.starts_with('+') || words.starts_with('-')) {
        part.half = words.front();
        words.erase(0, 1);
    }
    if (words.size() < 2) return {};
    part.kind = words.front();
    part.turned = words.ends_with('~');
    char* remaining = nullptr;
    part.number = std::strtoul(words.c_str() + 1, &remaining, 10);
    if (part.kind == 'h') part.direction = static_cast<unsigned>(std::strtoul(remaining + 1, nullptr, 10));
    return part;
}

/// A mapping of SDL, with the numbers of buttons, axes and hats that its joystick needs.
struct Mapping {
    std::string guid{}, name{};
    std::vector<std::pair<std::string, Part>> parts{};
    std::size_t buttons = 0, axes = 0, hats = 0;

    const Part* of(const std::string& field) const {
        for (const auto& [name_, part] : parts)
            if (name_ == field) return &part;
        return nullptr;
    }
};

Mapping parsed(const std::string& line) {
    Mapping mapping;
    std::istringstream words(line);
    std::getline(words, mapping.guid, ',');
    std::getline(words, mapping.name, ',');
    for (std::string word; std::getline(words, word, ',');) {
        const auto colon = word.find(':');
        if (colon == std::string::npos || word.starts_with("platform") || word.starts_with("hint") ||
            word.starts_with("crc"))
            continue;
        const auto part = part_of(word.substr(colon + 1));
        if (!part) continue;
        mapping.parts.emplace_back(word.substr(0, colon), *part);
        auto& count = part->kind == 'b' ? mapping.buttons : part->kind == 'a' ? mapping.axes : mapping.hats;
        count = std::max(count, part->number + 1);
    }
    return mapping;
}

unsigned byte_of(const std::string& guid, std::size_t number) {
    return static_cast<unsigned>(std::strtoul(guid.substr(2 * number, 2).c_str(), nullptr, 16));
}
std::uint16_t number_of(const std::string& guid, std::size_t byte) {
    return static_cast<std::uint16_t>(byte_of(guid, byte) | byte_of(guid, byte + 1) << 8U);
}

/// Whether a mapping is for a Linux device. Mappings for SDL's own drivers have a mark at the end of the
/// guid, and some mappings name the device instead of giving its numbers.
bool is_of_device(const Mapping& mapping) {
    // Some mappings have button numbers above `max_buttons`, for which Linux has no codes.
    constexpr std::size_t max_buttons = 64;
    return mapping.guid.size() == 32 &&
           mapping.guid.find_first_not_of("0123456789abcdef") == std::string::npos &&
           byte_of(mapping.guid, 14) == 0 && mapping.buttons <= max_buttons &&
           number_of(mapping.guid, 4) != 0 && number_of(mapping.guid, 6) == 0 && mapping.of("a") != nullptr;
}

fake::Model model_of(const Mapping& mapping) {
    auto model = fake::stick(std::max<std::size_t>(mapping.buttons, 1),
                             std::max<std::size_t>(mapping.axes, 2), mapping.hats);
    model.bus = number_of(mapping.guid, 0);
    model.vendor = number_of(mapping.guid, 4);
    model.product = number_of(mapping.guid, 8);
    model.version = number_of(mapping.guid, 12);
    model.name = "Emulated joystick";
    for (const auto* field : {"lefttrigger", "righttrigger"}) {
        const auto* part = mapping.of(field);
        if (part == nullptr || part->kind != 'a' || part->half != 0) continue;
        for (auto& axis : model.axes)
            if (axis.code == fake::axis_code(part->number))
                axis.rest = part->turned ? axis.highest : axis.lowest;
    }
    return model;
}

std::vector<Mapping> table() {
    SDL_Init(SDL_INIT_GAMECONTROLLER);
    std::vector<Mapping> mappings;
    for (int i = 0; i < SDL_GameControllerNumMappings(); ++i) {
        const std::unique_ptr<char, decltype(&SDL_free)> line(SDL_GameControllerMappingForIndex(i), SDL_free);
        if (line != nullptr) mappings.push_back(parsed(line.get()));
    }
    SDL_Quit();
    std::erase_if(mappings, [](const auto& mapping) { return !is_of_device(mapping); });
    return mappings;
}

class Bench {
public:
    Bench(PadReader& reader, UMockdevTestbed* testbed) : reader_(reader), testbed_(testbed) {}

    /// Waits until a condition holds for the pad, whatever its index. The time limit only ends a test that
    /// hangs.
    bool wait(const std::function<bool(const PadState&)>& holds) {
        using namespace std::chrono;
        for (const auto end = steady_clock::now() + seconds(60); steady_clock::now() < end;) {
            const auto& pads = reader_.poll();
            const auto pad = std::find_if(pads.begin(), pads.end(), [](const auto& p) { return p.present; });
            if (holds(pad == pads.end() ? PadState{} : *pad)) return true;
            std::this_thread::sleep_for(milliseconds(1));
        }
        return false;
    }
    /// Tests a model. Returns what does not work; empty: everything works.
    std::string test(const Mapping& mapping) {
        const auto model = model_of(mapping);
        // The pad is never destroyed, because its threads may outlive this test.
        auto& pad = *std::make_unique<fake::Pad>().release();
        fake::make_pad(pad, testbed_, model, number_++);
        fake::plug(pad, true);
        auto fault = test_parts(pad, mapping);
        fake::plug(pad, false);
        if (!wait([](const auto& p) { return !p.present; })) fault += " it does not leave";
        return fault;
    }
    int skipped() const { return skipped_; }

private:
    std::string test_parts(fake::Pad& pad, const Mapping& mapping) {
        if (!wait([](const auto& p) { return p.present; })) return "it does not come;";
        std::string fault;
        if (!wait([](const auto& p) { return p.buttons == 0; })) fault += " a button is pressed at rest;";
        press(pad, mapping.of("a"));
        if (!wait([](const auto& p) { return p.buttons == 1; })) fault += " A does not press A;";
        fault += test_axis(pad, mapping, "leftx", PadAxis::left_x);
        fault += test_axis(pad, mapping, "righttrigger", PadAxis::right_trigger);
        return fault;
    }
    std::string test_axis(fake::Pad& pad, const Mapping& mapping, const std::string& field, PadAxis axis) {
        const auto* part = mapping.of(field);
        if (part == nullptr) part = mapping.of("+" + field);
        if (part == nullptr) {
            ++skipped_;
            return {};
        }
        const auto number = static_cast<std::size_t>(axis);
        std::string fault;
        if (!wait([&](const auto& p) { return std::abs(p.axes.at(number)) < 0.01; }))
            fault += " " + field + " is not at rest;";
        press(pad, part);
        if (!wait([&](const auto& p) { return p.axes.at(number) > 0.99; }))
            fault += " " + field + " does not move;";
        return fault;
    }
    static void press(fake::Pad& pad, const Part* part) {
        if (part->kind == 'b') fake::report(pad, EV_KEY, fake::button_code(part->number), 1);
        const auto hat = static_cast<std::uint16_t>(ABS_HAT0X + 2 * part->number);
        if (part->kind == 'h' && (part->direction & 10U) != 0)
            fake::report(pad, EV_ABS, hat, part->direction == 2 ? 1 : -1);
        if (part->kind == 'h' && (part->direction & 5U) != 0)
            fake::report(pad, EV_ABS, static_cast<std::uint16_t>(hat + 1), part->direction == 4 ? 1 : -1);
        const bool down = (part->half == '-') != part->turned;
        if (part->kind == 'a')
            fake::report(pad, EV_ABS, fake::axis_code(part->number), down ? -32768 : 32767);
    }

    PadReader& reader_;
    UMockdevTestbed* testbed_;
    std::size_t number_ = 0;
    int skipped_ = 0;
};

/// Draws random mappings, each at most once.
std::vector<Mapping> drawn(std::vector<Mapping> from, std::uint64_t seed, std::size_t count) {
    Random random = random_stream(seed, 0);
    std::vector<Mapping> out;
    for (; out.size() < count && !from.empty();) {
        const auto at = from.begin() + static_cast<std::ptrdiff_t>(random.next() % from.size());
        out.push_back(*at);
        from.erase(at);
    }
    return out;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    // The test bed must be made first, because its devices are invisible to a program that has looked for
    // devices before.
    auto* testbed = umockdev_testbed_new();
    const auto all = table();
    const auto mappings =
        drawn(all, std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10));
    PadReader reader;
    Bench bench(reader, testbed);
    int faults = 0;
    const auto test = [&](const std::string& what, const Mapping& mapping) {
        const auto fault = bench.test(mapping);
        if (fault.empty()) return;
        ++faults;
        std::printf("%s %s (%s):%s\n", what.c_str(), mapping.name.c_str(), mapping.guid.c_str(),
                    fault.c_str());
    };
    for (const auto& mapping : mappings) test("model", mapping);
    const auto playing = mappings.size() - static_cast<std::size_t>(faults);
    const std::string added =
        "030000000df000000100000001000000,Added,a:b3,leftx:a1~,righttrigger:+a0,platform:Linux,";
    if (const auto taken = reader.add(added); !taken) std::printf("%s\n", taken.error().message.c_str());
    test("added", parsed(added));
    test("from the environment",
         parsed("030000000df000000200000001000000,Own,a:b2,leftx:a1,righttrigger:b5"));
    std::printf("%zu of %zu models play, of %zu in the table; %d checks left out\n", playing, mappings.size(),
                all.size(), bench.skipped());
    return faults == 0 && mappings.size() >= std::strtoull(argv[2], nullptr, 10) ? 0 : 1;
}
