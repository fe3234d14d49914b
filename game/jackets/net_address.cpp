#include "game/jackets/net_address.h"

#include <algorithm>
#include <charconv>

#include "core/one_line.h"
#include "core/text.h"

namespace thaum::game::inline jackets {
namespace {

constexpr std::size_t longest_host = 253;      ///< longest name of a host, as in the domain name system
                                               ///< (characters)
constexpr std::size_t max_of_host_shown = 60;  ///< longest part of a host's name in messages (bytes)

bool fits_host(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '.' || c == '_';
}
/// Whether a character may stand in an IPv6 address in brackets; such an address may have a zone:
/// "fe80::1%eth0".
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

/// Text "HOST:PORT". The host is put in brackets if it contains one of the characters in `bracketed`.
std::string with_port(std::string_view host, std::uint16_t port, std::string_view bracketed) {
    const bool brackets = host.find_first_of(bracketed) != std::string_view::npos;
    return text(brackets ? "[" : "", host, brackets ? "]:" : ":", port);
}

}  // namespace

std::optional<NetAddress> read_address(std::string_view words) {
    const auto colon = words.rfind(':');
    if (colon == std::string_view::npos) return std::nullopt;
    auto host = host_of(words.substr(0, colon));
    const auto port = port_of(words.substr(colon + 1));
    if (!host || !port) return std::nullopt;
    return NetAddress{std::move(*host), *port};
}

std::string place_of(const NetAddress& address) { return with_port(address.host, address.port, ":%"); }

std::string words_of(const NetAddress& address) {
    return with_port(printable(address.host, max_of_host_shown), address.port, ":");
}

Expected<std::string> read_net_place(std::string_view word, std::string_view place) {
    if (const auto address = read_address(place)) return place_of(*address);
    return fail(
        text("write \"", word, ":HOST:PORT\", with a port of 1 to 65535 and an IPv6 address in brackets"));
}

}  // namespace thaum::game::inline jackets
