#include "game/jackets/jacket.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>

#include "core/one_line.h"
#include "core/text.h"
#include "game/jackets/audio_jacket.h"
#include "game/jackets/bhaptics_jacket.h"
#include "game/jackets/bhaptics_messages.h"
#include "game/jackets/felt_recorder.h"

namespace thaum::app {
namespace {

constexpr std::size_t longest_host = 253;  ///< characters, as in the domain name system
constexpr std::size_t most_words_shown = 60;
constexpr std::string_view forms =
    "use \"\", \"bhaptics\", \"osc:HOST:PORT\", \"osc16:HOST:PORT\", \"hid:VVVV:PPPP\", \"audio\", "
    "\"audio8\", "
    "\"audio:DEVICE\" or \"record:FILE.csv\"";
constexpr std::size_t longest_name = 1000;  ///< bytes of a device's name, or of a path

struct Form {
    std::string_view start;
    Jacket::Link link;
    Jacket::Layout layout;
};
constexpr std::array<Form, 3> addressed_forms{{{"osc:", Jacket::Link::osc, Jacket::Layout::x40},
                                               {"osc16:", Jacket::Link::osc, Jacket::Layout::x16},
                                               {"bhaptics:", Jacket::Link::bhaptics, Jacket::Layout::x40}}};

bool fits_host(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '.' || c == '_';
}
/// Characters of an IPv6 address in brackets, with a zone: "fe80::1%eth0".
bool fits_brackets(char c) { return fits_host(c) || c == ':' || c == '%'; }

std::optional<std::string> host_of(std::string_view words) {
    const bool brackets = words.size() > 2 && words.front() == '[' && words.back() == ']';
    if (brackets) words = words.substr(1, words.size() - 2);
    if (words.empty() || words.size() > longest_host) return std::nullopt;
    if (!std::all_of(words.begin(), words.end(), brackets ? fits_brackets : fits_host)) return std::nullopt;
    return std::string(words);
}

std::optional<std::uint16_t> port_of(std::string_view words) {
    std::uint16_t port = 0;
    const auto* const end = words.data() + words.size();
    const auto read = std::from_chars(words.data(), end, port);
    return read.ec == std::errc() && read.ptr == end && port > 0 ? std::optional(port) : std::nullopt;
}

std::optional<input::NetAddress> address_of(std::string_view words) {
    const auto colon = words.rfind(':');
    if (colon == std::string_view::npos) return std::nullopt;
    auto host = host_of(words.substr(0, colon));
    const auto port = port_of(words.substr(colon + 1));
    if (!host || !port) return std::nullopt;
    return input::NetAddress{std::move(*host), *port};
}

/// A number of exactly four hexadecimal digits.
std::optional<std::uint16_t> hid_number_of(std::string_view words) {
    std::uint16_t number = 0;
    const auto* const end = words.data() + words.size();
    const auto read = std::from_chars(words.data(), end, number, 16);
    return words.size() == 4 && read.ec == std::errc() && read.ptr == end ? std::optional(number)
                                                                          : std::nullopt;
}

bool fits_name(std::string_view words) {
    return !words.empty() && words.size() <= longest_name && printable(words, words.size()) == words;
}

Error no_jacket(std::string_view words, std::string_view why) {
    return fail(text("'", printable(words, most_words_shown), "' is no jacket: ", why));
}

Expected<Jacket> parse_hid(std::string_view words, std::string_view numbers) {
    const auto colon = numbers.find(':');
    const auto vendor = hid_number_of(numbers.substr(0, colon));
    const auto product =
        colon == std::string_view::npos ? std::nullopt : hid_number_of(numbers.substr(colon + 1));
    if (!vendor || !product)
        return no_jacket(words,
                         "write \"hid:VVVV:PPPP\" with four hexadecimal digits each, as `lsusb` prints them");
    Jacket jacket;
    jacket.link = Jacket::Link::hid;
    jacket.layout = Jacket::Layout::x40;
    jacket.hid = {*vendor, *product};
    return jacket;
}

/// `device`: what follows "audio" or "audio8", with its colon.
Expected<Jacket> parse_audio(std::string_view words, Jacket::Layout layout, std::string_view device) {
    Jacket jacket;
    jacket.link = Jacket::Link::audio;
    jacket.layout = layout;
    if (device.empty()) return jacket;
    if (device.front() != ':') return no_jacket(words, forms);
    if (!fits_name(device.substr(1)))
        return no_jacket(words, "write a device's name after the colon, as `thaum doctor` prints it");
    jacket.name = device.substr(1);
    return jacket;
}

Expected<Jacket> parse_record(std::string_view words, std::string_view file) {
    if (!fits_name(file) || !file.ends_with(".csv") || file == ".csv" || file.ends_with("/.csv"))
        return no_jacket(words, "write \"record:FILE.csv\"");
    Jacket jacket;
    jacket.link = Jacket::Link::record;
    jacket.layout = Jacket::Layout::figure;
    jacket.name = file;
    return jacket;
}

/// The forms without an address in the network; std::nullopt: it is none of them.
std::optional<Expected<Jacket>> parse_local(std::string_view words) {
    if (words.starts_with("hid:")) return parse_hid(words, words.substr(4));
    if (words.starts_with("audio8")) return parse_audio(words, Jacket::Layout::shakers8, words.substr(6));
    if (words.starts_with("audio")) return parse_audio(words, Jacket::Layout::speakers, words.substr(5));
    if (words.starts_with("record:")) return parse_record(words, words.substr(7));
    return std::nullopt;
}

std::string audio_name(const Jacket& jacket) {
    const auto where = jacket.name.empty() ? std::string("the usual sound device")
                                           : text("'", printable(jacket.name, most_words_shown), "'");
    return text(motors_of(jacket.layout), " shakers on ", where);
}

}  // namespace

std::string_view name_of(Jacket::Layout layout) {
    constexpr std::array<std::string_view, 7> names{"",         "x40",          "x16", "speakers",
                                                    "shakers8", "abstract_4x5", "own"};
    return names.at(static_cast<std::size_t>(layout));
}

std::size_t motors_of(Jacket::Layout layout) {
    constexpr std::array<std::size_t, 7> motors{0, 40, 16, 2, 8, 40, 0};
    return motors.at(static_cast<std::size_t>(layout));
}

Expected<Jacket> parse_jacket(std::string_view words) {
    if (words.empty()) return Jacket{};
    if (words == "bhaptics")
        return Jacket{Jacket::Link::bhaptics, {"127.0.0.1", bhaptics_port}, Jacket::Layout::x40};
    if (auto local = parse_local(words)) return std::move(*local);
    for (const auto& form : addressed_forms) {
        if (!words.starts_with(form.start)) continue;
        auto address = address_of(words.substr(form.start.size()));
        if (!address)
            return no_jacket(words,
                             text("write \"", form.start,
                                  "HOST:PORT\", with a port of 1 to 65535 and an IPv6 address in brackets"));
        return Jacket{form.link, std::move(*address), form.layout};
    }
    return no_jacket(words, forms);
}

Expected<tactile::Layout> load_own_layout(const std::string& words, const Jacket& jacket,
                                          const std::filesystem::path& assets) {
    const bool is_path = words.find('/') != std::string::npos;
    auto layout = tactile::load_layout(is_path ? std::filesystem::path(words)
                                               : assets / "tactile" / "layouts" / (words + ".toml"));
    if (!layout) return layout;
    // The table of a recording has a column for each cell of the figure.
    if (jacket.link == Jacket::Link::record)
        return fail("'jacket_layout': a recording always has the cells of the figure");
    const auto motors = motors_of(jacket.layout);
    if (layout->actuators.size() > motors)
        return fail(text("'jacket_layout': '", printable(words, most_words_shown), "' has ",
                         layout->actuators.size(), " actuators, and the jacket ", motors, " motors"));
    return layout;
}

bool is_same_device(const Jacket& a, const Jacket& b) {
    return a.link == b.link && a.address == b.address && a.hid == b.hid && a.name == b.name;
}

std::unique_ptr<input::TactileOutput> jacket_output(const Jacket& jacket, std::uint32_t player) {
    const auto motors = motors_of(jacket.layout);
    switch (jacket.link) {
        case Jacket::Link::none: return nullptr;
        case Jacket::Link::osc: return input::osc_jacket(jacket.address, motors);
        case Jacket::Link::bhaptics: return bhaptics_jacket(jacket.address);
        case Jacket::Link::hid: return hid_jacket(jacket.hid);
        case Jacket::Link::audio:
            return audio_jacket(audio_name(jacket), motors, audio::openal_channels(jacket.name, motors));
        case Jacket::Link::record: return felt_recorder(jacket.name, player);
    }
    return nullptr;
}

}  // namespace thaum::app
