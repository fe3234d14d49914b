#include "game/app/jacket.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>

#include "core/one_line.h"
#include "core/text.h"
#include "game/app/bhaptics_jacket.h"
#include "game/app/bhaptics_messages.h"

namespace thaum::app {
namespace {

constexpr std::size_t longest_host = 253;  ///< characters, as in the domain name system
constexpr std::size_t most_words_shown = 60;
constexpr std::string_view forms = "use \"\", \"bhaptics\", \"osc:HOST:PORT\" or \"osc16:HOST:PORT\"";

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

tl::unexpected<Error> no_jacket(std::string_view words, std::string_view why) {
    return fail(text("'", printable(words, most_words_shown), "' is no jacket: ", why));
}

}  // namespace

std::string_view name_of(Jacket::Layout layout) {
    constexpr std::array<std::string_view, 3> names{"", "x40", "x16"};
    return names.at(static_cast<std::size_t>(layout));
}

std::size_t motors_of(Jacket::Layout layout) {
    constexpr std::array<std::size_t, 3> motors{0, 40, 16};
    return motors.at(static_cast<std::size_t>(layout));
}

Expected<Jacket> parse_jacket(std::string_view words) {
    if (words.empty()) return Jacket{};
    if (words == "bhaptics")
        return Jacket{Jacket::Link::bhaptics, {"127.0.0.1", bhaptics_port}, Jacket::Layout::x40};
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

std::unique_ptr<input::TactileOutput> jacket_output(const Jacket& jacket) {
    if (jacket.link == Jacket::Link::none) return nullptr;
    if (jacket.link == Jacket::Link::bhaptics) return bhaptics_jacket(jacket.address);
    return input::osc_jacket(jacket.address, motors_of(jacket.layout));
}

}  // namespace thaum::app
