#include "game/jackets/makers/bhaptics.h"

#include <libwebsockets.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/text.h"
#include "game/jackets/bhaptics_messages.h"
#include "game/jackets/jacket.h"
#include "input/tactile_playback.h"

namespace thaum::game::inline jackets {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds longest_connecting{1000};
constexpr std::chrono::milliseconds longest_first_reply{300};
/// Longest time that a request may wait for the bHaptics Player before the connection to it is ended.
constexpr std::chrono::milliseconds longest_waiting{500};
/// Longest time from a ping to the answer of the bHaptics Player before the connection to it is ended.
constexpr std::chrono::milliseconds longest_pong{1000};
constexpr std::chrono::milliseconds between_pings{
    250};  ///< shortest time between pings, which go out with requests only
constexpr std::chrono::milliseconds longest_parting{100};
constexpr std::chrono::milliseconds between_looks{2};
/// Size of the system's buffer for outgoing data: a few requests, so that those for a slow Player do not pile
/// up (bytes).
constexpr int send_buffer = 4096;

/// Lock for creating and destroying contexts of libwebsockets, which share some state.
std::mutex& context_mutex() {
    static std::mutex mutex;
    return mutex;
}

/// One connection to a bHaptics Player, the program that drives the vest. Only one thread uses it.
class PlayerLink {
public:
    PlayerLink() = default;
    ~PlayerLink();
    PlayerLink(const PlayerLink&) = delete;
    PlayerLink& operator=(const PlayerLink&) = delete;

    Expected<void> connect(const NetAddress& address);
    /// Sends a request as soon as the Player takes it. An earlier request that still waits is dropped.
    void send(std::string request);
    /// Sends and receives what is possible at once, without waiting.
    void serve();
    /// Sends and receives until a condition holds. Returns false if it did not hold within the given time.
    template <class Condition>
    bool serve_until(Condition condition, Clock::duration longest);

    bool is_up() const { return up_; }
    bool is_idle() const { return request_.empty(); }
    const std::optional<BhapticsReply>& reply() const { return newest_; }

private:
    static int on_event(lws* socket, lws_callback_reasons reason, void*, void* data, std::size_t size);
    int take_event(lws_callback_reasons reason, const char* data, std::size_t size);
    void begin();
    void drop();
    int write();
    int put(const std::string& payload, lws_write_protocol kind);
    int take_piece(const char* data, std::size_t size);
    bool start_context();

    lws_context* context_ = nullptr;
    lws* socket_ = nullptr;
    bool up_ = false, failed_ = false;
    std::string request_{};  ///< request that waits to be sent; empty: none
    Clock::time_point queued_{};
    bool pinged_ = false;  ///< true: a ping has not been answered yet
    Clock::time_point pinged_at_{};
    std::string reply_{};                    ///< the part of a reply received so far
    std::optional<BhapticsReply> newest_{};  ///< the newest reply that says something about devices
};

bool PlayerLink::start_context() {
    static const std::array<lws_protocols, 2> protocols{{{"", on_event, 0, 4096, 0, nullptr, 0}, {}}};
    lws_context_creation_info info{};
    info.port = CONTEXT_PORT_NO_LISTEN;
    info.protocols = protocols.data();
    info.uid = -1;
    info.gid = -1;
    info.user = this;
    info.fd_limit_per_thread = 16;
    // Without this value, libwebsockets would obey the variable http_proxy and connect to another machine.
    info.http_proxy_address = "none:0";
    const std::lock_guard lock(context_mutex());
    lws_set_log_level(0, nullptr);
    context_ = lws_create_context(&info);
    return context_ != nullptr;
}

PlayerLink::~PlayerLink() {
    const std::lock_guard lock(context_mutex());
    if (context_ != nullptr) lws_context_destroy(context_);
}

Expected<void> PlayerLink::connect(const NetAddress& address) {
    if (!start_context()) return fail("the system has no room for a connection");
    const std::string path(bhaptics_path);
    lws_client_connect_info info{};
    info.context = context_;
    info.address = info.host = info.origin = address.host.c_str();
    info.port = address.port;
    info.path = path.c_str();
    info.pwsi = &socket_;
    info.ietf_version_or_minus_one = -1;
    failed_ = lws_client_connect_via_info(&info) == nullptr || failed_;
    const bool decided = serve_until([this] { return up_ || failed_; }, longest_connecting);
    if (!decided) return fail("the Player does not answer; start it anew");
    if (!up_) return fail("no bHaptics Player is there; start it");
    return {};
}

template <class Condition>
bool PlayerLink::serve_until(Condition condition, Clock::duration longest) {
    for (const auto end = Clock::now() + longest; !condition();) {
        if (Clock::now() >= end) return false;
        serve();
        if (!condition()) std::this_thread::sleep_for(between_looks);
    }
    return true;
}

void PlayerLink::serve() {
    if (failed_) return;
    // A negative timeout: the call does not wait.
    lws_service(context_, -1);
    if (!up_) return;
    const auto now = Clock::now();
    const bool stuck = !request_.empty() && now > queued_ + longest_waiting;
    if (stuck || (pinged_ && now > pinged_at_ + longest_pong)) drop();
}

/// Ends the connection and discards requests that the system has not sent yet.
void PlayerLink::drop() {
    up_ = false;
    const linger at_once{1, 0};
    ::setsockopt(lws_get_socket_fd(socket_), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
}

void PlayerLink::send(std::string request) {
    if (!up_) return;
    if (request_.empty()) queued_ = Clock::now();
    request_ = std::move(request);
    lws_callback_on_writable(socket_);
    serve();
    // The ping has just been written, so the request is written in a second call.
    if (!request_.empty()) serve();
}

int PlayerLink::on_event(lws* socket, lws_callback_reasons reason, void*, void* data, std::size_t size) {
    auto* const link = static_cast<PlayerLink*>(lws_context_user(lws_get_context(socket)));
    return link->take_event(reason, static_cast<const char*>(data), size);
}

/// Handles one event of the connection. Returns 0; other values end the connection.
int PlayerLink::take_event(lws_callback_reasons reason, const char* data, std::size_t size) {
    switch (reason) {
        case LWS_CALLBACK_CLIENT_ESTABLISHED: begin(); return 0;
        case LWS_CALLBACK_CLIENT_WRITEABLE: return write();
        case LWS_CALLBACK_CLIENT_RECEIVE_PONG: pinged_ = false; return 0;
        case LWS_CALLBACK_CLIENT_RECEIVE: return take_piece(data, size);
        // A redirection is refused: the settings choose the machine, and the Player must not send the game to
        // another one.
        case LWS_CALLBACK_CLIENT_HTTP_REDIRECT: return -1;
        case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
        case LWS_CALLBACK_CLIENT_CLOSED:
            failed_ = true;
            up_ = false;
            return 0;
        default: return 0;
    }
}

void PlayerLink::begin() {
    up_ = true;
    const int socket = lws_get_socket_fd(socket_);
    ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &send_buffer, sizeof send_buffer);
    // Without TCP_NODELAY, the system may hold a request back for 40 ms, until the one before is
    // acknowledged.
    const int on = 1;
    ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

/// Writes the waiting request. libwebsockets calls again when there is room for another one.
int PlayerLink::write() {
    if (request_.empty()) return 0;
    const auto now = Clock::now();
    if (!pinged_ && now >= pinged_at_ + between_pings) {
        pinged_ = true;
        pinged_at_ = now;
        lws_callback_on_writable(socket_);
        return put("", LWS_WRITE_PING);
    }
    return put(std::exchange(request_, {}), LWS_WRITE_TEXT);
}

int PlayerLink::put(const std::string& payload, lws_write_protocol kind) {
    std::vector<unsigned char> bytes(LWS_PRE + payload.size());
    std::copy(payload.begin(), payload.end(), bytes.begin() + LWS_PRE);
    return lws_write(socket_, bytes.data() + LWS_PRE, payload.size(), kind) < 0 ? -1 : 0;
}

int PlayerLink::take_piece(const char* data, std::size_t size) {
    if (reply_.size() + size > max_reply_bytes) return -1;
    reply_.append(data, size);
    if (lws_remaining_packet_payload(socket_) > 0 || lws_is_final_fragment(socket_) == 0) return 0;
    // A message that is no reply is ignored.
    if (const auto reply = read_bhaptics_reply(reply_); reply && (reply->devices || reply->vest))
        newest_ = *reply;
    reply_.clear();
    return 0;
}

constexpr const char* no_vest = "the Player has no vest; switch it on and pair it";

class BhapticsJacket final : public input::TactileOutput {
public:
    explicit BhapticsJacket(NetAddress address) : address_(std::move(address)) {}
    ~BhapticsJacket() override { end(); }

    Expected<void> open() override;
    void write(const tactile::TactileFrame& frame, double now_s) override;
    void silence() override;
    bool is_connected() override;
    std::string fault() override;
    void close() override { end(); }
    std::string name() const override { return text("bHaptics Player at ", words_of(address_)); }

private:
    bool has_vest() const { return link_->reply().value_or(BhapticsReply{}).may_have_vest(); }
    void end();

    const NetAddress address_;
    const std::string silent_ = bhaptics_request({});
    std::unique_ptr<PlayerLink> link_{};
    std::string last_{};     ///< the last request that was sent
    double again_at_s_ = 0;  ///< time at which the last request is sent again (s)
};

Expected<void> BhapticsJacket::open() {
    link_ = std::make_unique<PlayerLink>();
    if (auto connected = link_->connect(address_); !connected) {
        link_.reset();
        return connected;
    }
    // Stops motors that an earlier program left on. The Player, the program that drives the vest, may reply.
    // Its reply also says whether a vest is connected.
    silence();
    link_->serve_until([this] { return !link_->is_up() || link_->reply(); }, longest_first_reply);
    if (link_->is_up() && has_vest()) return {};
    const bool up = link_->is_up();
    link_.reset();
    return fail(up ? no_vest : "the Player closes the connection");
}

void BhapticsJacket::write(const tactile::TactileFrame& frame, double now_s) {
    if (link_ == nullptr) return;
    auto request = bhaptics_request(frame);
    if (request == last_ && (request == silent_ || now_s < again_at_s_)) return;
    link_->send(request);
    last_ = std::move(request);
    const double life_s = 1e-3 * static_cast<double>(frame.time_to_live);
    again_at_s_ = now_s + std::min(life_s, input::TactilePlayback::longest_life_s) / 2;
}

void BhapticsJacket::silence() {
    if (link_ == nullptr) return;
    link_->send(silent_);
    last_ = silent_;
}

bool BhapticsJacket::is_connected() {
    if (link_ == nullptr) return false;
    link_->serve();
    return link_->is_up() && has_vest();
}

std::string BhapticsJacket::fault() {
    return link_ != nullptr && link_->is_up() && !has_vest() ? no_vest : "it is gone";
}

void BhapticsJacket::end() {
    if (link_ == nullptr) return;
    silence();
    link_->serve_until([this] { return !link_->is_up() || link_->is_idle(); }, longest_parting);
    link_.reset();
    last_.clear();
}

std::unique_ptr<input::TactileOutput> make(const Jacket& jacket, std::uint32_t) {
    return bhaptics_jacket(read_address(jacket.place).value());
}

const JacketRegistration registration({.name = "bhaptics",
                                       .order = 1,
                                       .forms = {{"bhaptics", {"x40", 40}, bhaptics_place}},
                                       .shown = {"bhaptics"},
                                       .read = read_net_place,
                                       .make = make});

}  // namespace

std::unique_ptr<input::TactileOutput> bhaptics_jacket(const NetAddress& player) {
    return std::make_unique<BhapticsJacket>(player);
}

}  // namespace thaum::game::inline jackets
