// game/jackets/net_address.h: network address, a host and a port, at which a jacket or its program listens.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"

namespace thaum::game::inline jackets {

struct NetAddress {
    std::string host{};  ///< name, or IPv4 or IPv6 address without brackets
    std::uint16_t port{};
    bool operator==(const NetAddress&) const = default;
};

/// Reads "HOST:PORT". The host is a name, an IPv4 address, or an IPv6 address in brackets. std::nullopt for
/// any other text.
std::optional<NetAddress> read_address(std::string_view words);
/// The text of an address, which read_address reads back: "192.168.1.7:1027", "[::1]:1027".
std::string place_of(const NetAddress& address);
/// The text of an address for messages, in which a long host is cut.
std::string words_of(const NetAddress& address);

/// Reads the place of a setting "WORD:HOST:PORT" (JacketMaker::read).
Expected<std::string> read_net_place(std::string_view word, std::string_view place);

}  // namespace thaum::game::inline jackets
