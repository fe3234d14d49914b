#include "input/osc_jacket.h"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "core/one_line.h"
#include "core/text.h"
#include "input/detail/osc_message.h"
#include "input/tactile_playback.h"

namespace thaum::input {
namespace {

using Clock = std::chrono::steady_clock;

/// Messages of silence, and the time between two.
constexpr int messages_of_silence = 8;
constexpr std::chrono::milliseconds between_silences{50};
constexpr std::size_t most_of_host_shown = 60;  ///< bytes of a host's name in messages

struct FreeAddresses {
    void operator()(addrinfo* list) const { ::freeaddrinfo(list); }
};
using Addresses = std::unique_ptr<addrinfo, FreeAddresses>;

Expected<Addresses> look_up(const NetAddress& address) {
    addrinfo wanted{};
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_DGRAM;
    wanted.ai_flags = AI_NUMERICSERV;
    addrinfo* found = nullptr;
    const auto port = text(address.port);
    const int failure = ::getaddrinfo(address.host.c_str(), port.c_str(), &wanted, &found);
    if (failure != 0)
        return fail(text("no address for '", printable(address.host, most_of_host_shown),
                         "': ", ::gai_strerror(failure), "; correct the jacket in the settings file"));
    return Addresses(found);
}

class OscJacket final : public TactileOutput {
public:
    OscJacket(NetAddress address, std::size_t motors)
        : address_(std::move(address)), motors_(motors), silent_(detail::osc_message({}, motors)) {}
    ~OscJacket() override { end(); }

    Expected<void> open() override;
    void write(const tactile::TactileFrame& frame, double now_s) override;
    void silence() override;
    bool is_connected() override;
    void close() override { end(); }
    std::string name() const override { return text("jacket at ", words_of(address_)); }

private:
    bool send(const std::string& message);
    void send_ping();
    void send_silence();
    void end();

    const NetAddress address_;
    const std::size_t motors_;
    const std::string silent_;  ///< the message with all motors off
    int socket_ = -1;
    sockaddr_storage peer_{};
    socklen_t peer_size_{};
    std::string last_{};     ///< the last message that went out
    double again_at_s_ = 0;  ///< when the last message goes out again
    int silences_left_ = 0;  ///< messages of silence still to send
    Clock::time_point next_silence_{};
};

Expected<void> OscJacket::open() {
    end();
    const auto found = look_up(address_);
    if (!found) return found.error();
    for (const auto* one = found->get(); one != nullptr && socket_ < 0; one = one->ai_next) {
        // Without a connection of the socket, the system does not report a dead jacket as an error of a later send.
        socket_ = ::socket(one->ai_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        if (socket_ < 0) continue;
        std::memcpy(&peer_, one->ai_addr, one->ai_addrlen);
        peer_size_ = one->ai_addrlen;
    }
    if (socket_ < 0) return fail(text("no socket: ", std::strerror(errno)));
    send_ping();
    // Motors that an earlier program left on stop.
    silence();
    return {};
}

/// Tells the jacket where we are. Without a port of our own it is left out: the frames need no answer.
void OscJacket::send_ping() {
    sockaddr_storage own{};  // any address and port
    own.ss_family = peer_.ss_family;
    socklen_t size = peer_size_;
    auto* const address = reinterpret_cast<sockaddr*>(&own);
    if (::bind(socket_, address, size) != 0 || ::getsockname(socket_, address, &size) != 0) return;
    const auto port = own.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6*>(&own)->sin6_port
                                                : reinterpret_cast<const sockaddr_in*>(&own)->sin_port;
    send(detail::osc_ping(ntohs(port)));
}

void OscJacket::write(const tactile::TactileFrame& frame, double now_s) {
    auto message = detail::osc_message(frame, motors_);
    if (message == silent_) {
        if (last_ != silent_) silence();
        return;
    }
    silences_left_ = 0;
    if (message == last_ && now_s < again_at_s_) return;
    if (!send(message)) return;
    last_ = std::move(message);
    const double life_s = 1e-3 * static_cast<double>(frame.time_to_live);
    again_at_s_ = now_s + std::min(life_s, TactilePlayback::longest_life_s) / 2;
}

void OscJacket::silence() {
    silences_left_ = messages_of_silence;
    send_silence();
}

/// Sends the messages of silence that are due. The player asks several times in between.
bool OscJacket::is_connected() {
    if (silences_left_ > 0 && Clock::now() >= next_silence_) send_silence();
    return true;
}

void OscJacket::send_silence() {
    send(silent_);
    last_ = silent_;
    --silences_left_;
    next_silence_ = Clock::now() + between_silences;
}

/// Returns false if the message did not go out: no network, or the system's queue is full. A later one will.
bool OscJacket::send(const std::string& message) {
    return ::sendto(socket_, message.data(), message.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                    reinterpret_cast<const sockaddr*>(&peer_),
                    peer_size_) == static_cast<ssize_t>(message.size());
}

void OscJacket::end() {
    if (socket_ < 0) return;
    // There is no later chance, and one of the three may be lost.
    for (int i = 0; i < 3; ++i) send(silent_);
    ::close(std::exchange(socket_, -1));
    last_.clear();
    silences_left_ = 0;
}

}  // namespace

std::string words_of(const NetAddress& address) {
    const bool colons = address.host.find(':') != std::string::npos;
    const auto host = printable(address.host, most_of_host_shown);
    return text(colons ? "[" : "", host, colons ? "]:" : ":", address.port);
}

std::unique_ptr<TactileOutput> osc_jacket(const NetAddress& address, std::size_t motors) {
    return std::make_unique<OscJacket>(address, motors);
}

}  // namespace thaum::input
