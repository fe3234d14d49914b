// A receiver of UDP messages on this machine, at a port that the system chooses.
#pragma once
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "unit/jacket_rig.h"

namespace thaum::input::rig {

class UdpReceiver {
public:
    /// Listens at 127.0.0.1, not at ::1.
    explicit UdpReceiver(std::uint16_t port = 0) : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in here{};
        here.sin_family = AF_INET;
        here.sin_port = htons(port);
        here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof here;
        auto* const address = reinterpret_cast<sockaddr*>(&here);
        if (::bind(socket_, address, size) == 0 && ::getsockname(socket_, address, &size) == 0)
            port_ = ntohs(here.sin_port);
    }
    ~UdpReceiver() { ::close(socket_); }
    UdpReceiver(const UdpReceiver&) = delete;
    UdpReceiver& operator=(const UdpReceiver&) = delete;

    /// Port of the receiver; 0: the wanted port was in use.
    std::uint16_t port() const { return port_; }
    /// The next message; std::nullopt if none comes within `wait_ms`.
    std::optional<std::string> next(int wait_ms = patience_ms) {
        pollfd state{socket_, POLLIN, 0};
        if (::poll(&state, 1, wait_ms) <= 0) return std::nullopt;
        std::array<char, 2048> bytes{};
        sockaddr_in from{};
        socklen_t from_size = sizeof from;
        const auto size = ::recvfrom(socket_, bytes.data(), bytes.size(), 0,
                                     reinterpret_cast<sockaddr*>(&from), &from_size);
        if (size < 0) return std::nullopt;
        sender_port_ = ntohs(from.sin_port);
        return std::string(bytes.data(), static_cast<std::size_t>(size));
    }
    /// Port from which the last message came.
    std::uint16_t sender_port() const { return sender_port_; }
    /// Waits until this message comes. Returns false if it does not come in time.
    bool gets(const std::string& wanted) {
        for (int i = 0; i < 10'000; ++i) {
            const auto message = next();
            if (!message) return false;
            if (*message == wanted) return true;
        }
        return false;
    }
    /// Number of messages received before a certain one.
    int count_until(const std::string& last) {
        int count = 0;
        for (auto message = next(); message && *message != last; message = next()) ++count;
        return count;
    }

private:
    int socket_;
    std::uint16_t port_ = 0;
    std::uint16_t sender_port_ = 0;
};

}  // namespace thaum::input::rig
