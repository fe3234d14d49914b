#include "game/jackets/makers/osc.h"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>
#include <vector>

#include "core/one_line.h"
#include "core/text.h"
#include "game/jackets/jacket.h"
#include "game/jackets/osc_message.h"
#include "input/tactile_playback.h"

namespace thaum::game::inline jackets {
namespace {

using Clock = std::chrono::steady_clock;

/// Number of messages that stop all motors, several because UDP may lose some, and the time between two of
/// them.
constexpr int messages_of_silence = 8;
constexpr std::chrono::milliseconds between_silences{50};
constexpr std::size_t max_of_host_shown = 60;  ///< longest part of a host's name in messages (bytes)
constexpr std::size_t max_addresses = 8;       ///< most addresses of one host to which messages go

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
        return fail(text("no address for '", printable(address.host, max_of_host_shown),
                         "': ", ::gai_strerror(failure), "; correct the jacket in the settings file"));
    return Addresses(found);
}

/// One address of the jacket's host, with the socket for it.
struct Peer {
    int socket = -1;
    sockaddr_storage address{};
    socklen_t size{};
};

class OscJacket final : public input::TactileOutput {
public:
    OscJacket(NetAddress address, std::size_t motors)
        : address_(std::move(address)), motors_(motors), silent_(osc_message({}, motors)) {}
    ~OscJacket() override { end(); }

    Expected<void> open() override;
    void write(const tactile::TactileFrame& frame, double now_s) override;
    void silence() override;
    bool is_connected() override;
    void close() override { end(); }
    std::string name() const override { return text("jacket at ", words_of(address_)); }

private:
    bool send(const std::string& message);
    void send_silence();
    void end();

    const NetAddress address_;
    const std::size_t motors_;
    const std::string silent_;  ///< the message with all motors off
    /// All addresses of the host, such as ::1 and 127.0.0.1 for localhost. UDP does not tell at which of them
    /// the jacket listens, and it may begin to listen later, so each message goes to all addresses.
    std::vector<Peer> peers_{};
    std::string last_{};     ///< the last message that was sent
    double again_at_s_ = 0;  ///< time at which the last message is sent again (s)
    int silences_left_ = 0;  ///< number of messages that stop all motors, still to be sent
    Clock::time_point next_silence_{};
};

/// Sends a message. Returns false if that failed, because there is no network or the system's queue is full.
/// A later message may succeed.
bool send_to(const Peer& peer, const std::string& message) {
    return ::sendto(peer.socket, message.data(), message.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                    reinterpret_cast<const sockaddr*>(&peer.address),
                    peer.size) == static_cast<ssize_t>(message.size());
}

/// Tells the jacket the address of this program. If no port can be bound, no ping is sent; that does no harm,
/// because frames need no answer.
void send_ping(const Peer& peer) {
    sockaddr_storage own{};  // an address that means any address and port of this machine
    own.ss_family = peer.address.ss_family;
    socklen_t size = peer.size;
    auto* const address = reinterpret_cast<sockaddr*>(&own);
    if (::bind(peer.socket, address, size) != 0 || ::getsockname(peer.socket, address, &size) != 0) return;
    const auto port = own.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6*>(&own)->sin6_port
                                                : reinterpret_cast<const sockaddr_in*>(&own)->sin_port;
    send_to(peer, osc_ping(ntohs(port)));
}

Expected<void> OscJacket::open() {
    end();
    const auto found = look_up(address_);
    if (!found) return found.error();
    for (const auto* one = found->get(); one != nullptr && peers_.size() < max_addresses;
         one = one->ai_next) {
        // The socket is not connected, because otherwise the system would report a dead jacket as an error of
        // a later send.
        Peer peer{.socket = ::socket(one->ai_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0),
                  .size = one->ai_addrlen};
        if (peer.socket < 0) continue;
        std::memcpy(&peer.address, one->ai_addr, one->ai_addrlen);
        peers_.push_back(peer);
    }
    if (peers_.empty()) return fail(text("no socket: ", std::strerror(errno)));
    for (const Peer& peer : peers_) send_ping(peer);
    // Stops motors that an earlier program left running.
    silence();
    return {};
}

void OscJacket::write(const tactile::TactileFrame& frame, double now_s) {
    auto message = osc_message(frame, motors_);
    if (message == silent_) {
        if (last_ != silent_) silence();
        return;
    }
    silences_left_ = 0;
    if (message == last_ && now_s < again_at_s_) return;
    if (!send(message)) return;
    last_ = std::move(message);
    const double life_s = 1e-3 * static_cast<double>(frame.time_to_live);
    again_at_s_ = now_s + std::min(life_s, input::TactilePlayback::longest_life_s) / 2;
}

void OscJacket::silence() {
    silences_left_ = messages_of_silence;
    send_silence();
}

/// Sends the stop messages that are due. The thread that plays on jackets (TactilePlayer) calls this often
/// enough.
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

/// Sends a message to all addresses. Returns false if that failed for each of them.
bool OscJacket::send(const std::string& message) {
    bool sent = false;
    for (const Peer& peer : peers_) sent = send_to(peer, message) || sent;
    return sent;
}

void OscJacket::end() {
    if (peers_.empty()) return;
    // These are the last messages of this output. UDP may lose them, so three are sent.
    for (int i = 0; i < 3; ++i) send(silent_);
    for (const Peer& peer : peers_) ::close(peer.socket);
    peers_.clear();
    last_.clear();
    silences_left_ = 0;
}

std::unique_ptr<input::TactileOutput> make(const Jacket& jacket, std::uint32_t) {
    return osc_jacket(read_address(jacket.place).value(), jacket.layout().motors);
}

JacketCheck check(const Jacket& jacket, input::TactileOutput& output) {
    auto checked = check_by_opening(jacket, output);
    if (checked.usable) checked.words = " is sent to; nobody can tell whether it listens";
    return checked;
}

const JacketRegistration registration({.name = "osc",
                                       .order = 2,
                                       .forms = {{"osc", {"x40", 40}}, {"osc16", {"x16", 16}}},
                                       .shown = {"osc:HOST:PORT", "osc16:HOST:PORT"},
                                       .read = read_net_place,
                                       .make = make,
                                       .check = check});

}  // namespace

std::unique_ptr<input::TactileOutput> osc_jacket(const NetAddress& address, std::size_t motors) {
    return std::make_unique<OscJacket>(address, motors);
}

}  // namespace thaum::game::inline jackets
