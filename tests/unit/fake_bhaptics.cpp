#include "unit/fake_bhaptics.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <libwebsockets.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>

#include "core/text.h"

namespace thaum::game::rig {
namespace {

/// Constants of the WebSocket protocol (RFC 6455).
constexpr const char* handshake_guid = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
constexpr unsigned char final_text = 0x81, first_text = 0x01, more = 0x00, final_more = 0x80, ping = 0x89,
                        pong = 0x8A;

constexpr std::string_view one_device =
    R"({"ConnectedDeviceCount":1,"ActiveKeys":[],"ConnectedPositions":["Vest"],"RegisteredKeys":[],"Status":{}})";
constexpr std::string_view head_device =
    R"({"ConnectedDeviceCount":1,"ActiveKeys":[],"ConnectedPositions":["Head"],"RegisteredKeys":[],"Status":{}})";
constexpr std::string_view no_device =
    R"({"ConnectedDeviceCount":0,"ActiveKeys":[],"ConnectedPositions":[],"RegisteredKeys":[],"Status":{}})";

/// A WebSocket frame of at most 65,535 bytes from a server, which is not masked.
std::string frame_of(unsigned char opcode, std::string_view payload) {
    std::string frame{static_cast<char>(opcode)};
    if (payload.size() < 126) {
        frame += static_cast<char>(payload.size());
    } else {
        frame += static_cast<char>(126);
        frame += static_cast<char>(payload.size() >> 8U);
        frame += static_cast<char>(payload.size() & 0xFFU);
    }
    return frame.append(payload);
}

std::string noise(std::size_t size) {
    std::string bytes;
    for (std::uint32_t state = 1; bytes.size() < size; state = state * 1664525 + 1013904223)
        bytes += static_cast<char>(state >> 24U);
    return bytes;
}

std::string accept_key(const std::string& request) {
    constexpr std::string_view name = "sec-websocket-key:";
    std::string small(request);
    std::transform(small.begin(), small.end(), small.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto at = small.find(name);
    if (at == std::string::npos) return "";
    const auto from = request.find_first_not_of(' ', at + name.size());
    const auto key = request.substr(from, request.find('\r', from) - from) + handshake_guid;
    std::array<unsigned char, 20> hash{};
    lws_SHA1(reinterpret_cast<const unsigned char*>(key.data()), key.size(), hash.data());
    std::array<char, 64> words{};
    lws_b64_encode_string(reinterpret_cast<const char*>(hash.data()), hash.size(), words.data(),
                          words.size());
    return words.data();
}

}  // namespace

FakeBhaptics::FakeBhaptics(Manner manner)
    : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)), manner_(manner) {
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof here;
    auto* const address = reinterpret_cast<sockaddr*>(&here);
    EXPECT_EQ(::bind(listener_, address, size), 0);
    EXPECT_EQ(::getsockname(listener_, address, &size), 0);
    EXPECT_EQ(::listen(listener_, 8), 0);
    port_ = ntohs(here.sin_port);
    thread_ = std::jthread([this] { run(); });
}

FakeBhaptics::~FakeBhaptics() {
    stop_ = true;
    thread_.join();
    ::close(listener_);
}

std::vector<std::string> FakeBhaptics::texts() const {
    const std::lock_guard lock(mutex_);
    return texts_;
}

std::string FakeBhaptics::first_line() const {
    const std::lock_guard lock(mutex_);
    return first_line_;
}

std::size_t FakeBhaptics::connections() const {
    const std::lock_guard lock(mutex_);
    return connections_;
}

void FakeBhaptics::wait_for(const std::string& wanted, std::size_t before) {
    wait([&](const auto& texts) {
        return texts.size() > before && std::find(texts.begin() + static_cast<std::ptrdiff_t>(before),
                                                  texts.end(), wanted) != texts.end();
    });
}

void FakeBhaptics::wait_for_connections(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return connections_ >= count; });
}

void FakeBhaptics::run() {
    while (!stop_) {
        pollfd state{listener_, POLLIN, 0};
        if (::poll(&state, 1, 5) <= 0) continue;
        const int peer = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (peer < 0) continue;
        {
            const std::lock_guard lock(mutex_);
            ++connections_;
        }
        changed_.notify_all();
        serve(peer);
        ::close(peer);
    }
}

void FakeBhaptics::serve(int peer) {
    if (manner_ == Manner::never_answers) return stay(peer);
    if (!answer(peer)) return;
    speak(peer);
    while (!stop_ && take_frame(peer)) {}
}

/// Reads the HTTP request and answers it.
bool FakeBhaptics::answer(int peer) {
    std::string request;
    while (!request.ends_with("\r\n\r\n")) {
        char c = 0;
        if (request.size() > 10'000 || !read(peer, &c, 1)) return false;
        request += c;
    }
    {
        const std::lock_guard lock(mutex_);
        first_line_ = request.substr(0, request.find('\r'));
    }
    if (manner_ == Manner::answers_404)
        return write(peer, "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n") && false;
    if (manner_ == Manner::redirects)
        return write(peer, text("HTTP/1.1 302 Found\r\nLocation: http://127.0.0.1:", other_port_.load(),
                                "/v2/feedbacks\r\nContent-Length: 0\r\n\r\n")) &&
               false;
    if (manner_ == Manner::answers_noise) return write(peer, noise(100'000)) && false;
    return write(peer,
                 "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                 "Sec-WebSocket-Accept: " +
                     accept_key(request) + "\r\n\r\n");
}

/// Sends what a fake with this behaviour (Manner) sends before any request.
void FakeBhaptics::speak(int peer) {
    switch (manner_) {
        case Manner::sends_noise: write(peer, noise(100'000)); break;
        case Manner::sends_nonsense:
            for (const auto* words : {"", "[", "{}", "\"x\"", "{\"ConnectedDeviceCount\":\"many\"}"})
                write(peer, frame_of(final_text, words));
            write(peer, frame_of(final_text, std::string(60'000, '[')));
            break;
        case Manner::sends_gibibyte: send_gibibyte(peer); break;
        case Manner::never_reads: stay(peer); break;
        default: break;
    }
}

/// Reads a frame from the client: masked, and at most 65,535 bytes.
bool FakeBhaptics::take_frame(int peer) {
    std::array<unsigned char, 2> head{}, longer{};
    std::array<unsigned char, 4> mask{};
    if (!read(peer, head.data(), head.size())) return false;
    std::size_t size = head[1] & 0x7FU;
    EXPECT_NE(head[1] & 0x80U, 0U) << "a client's frames are masked";
    EXPECT_LT(size, 127U);
    if (size == 126) {
        if (!read(peer, longer.data(), longer.size())) return false;
        size = longer[0] * 256U + longer[1];
    }
    std::string payload(size, '\0');
    if (!read(peer, mask.data(), mask.size()) || !read(peer, payload.data(), size)) return false;
    for (std::size_t i = 0; i < size; ++i)
        payload[i] = static_cast<char>(static_cast<unsigned char>(payload[i]) ^ mask.at(i % 4));
    const unsigned opcode = head[0] & 0x0FU;
    if (opcode == 0xA) return true;   // a pong frame needs no answer
    if (opcode == 0x8) return false;  // a close frame ends the connection
    if (opcode == 0x9) return write(peer, frame_of(pong, payload));
    EXPECT_EQ(head[0], final_text);
    return react(peer, payload);
}

bool FakeBhaptics::react(int peer, const std::string& request) {
    {
        const std::lock_guard lock(mutex_);
        texts_.push_back(request);
    }
    changed_.notify_all();
    switch (manner_) {
        case Manner::replies: return write(peer, frame_of(final_text, one_device));
        case Manner::replies_no_vest: return write(peer, frame_of(final_text, no_device));
        case Manner::replies_head: return write(peer, frame_of(final_text, head_device));
        case Manner::sends_pieces: return send_pieces(peer);
        case Manner::hangs_up: return false;
        default: return true;
    }
}

bool FakeBhaptics::send_pieces(int peer) {
    std::string bytes = frame_of(first_text, one_device.substr(0, 1));
    for (std::size_t i = 1; i < one_device.size(); ++i)
        bytes += frame_of(more, one_device.substr(i, 1)) + frame_of(ping, "here?");
    return write(peer, bytes + frame_of(final_more, ""));
}

void FakeBhaptics::send_gibibyte(int peer) {
    std::string head{static_cast<char>(final_text), 127};
    for (const unsigned shift : {56U, 48U, 40U, 32U, 24U, 16U, 8U, 0U})
        head += static_cast<char>((1ULL << 30U >> shift) & 0xFFU);
    const std::string piece(1U << 16U, ' ');
    bool taken = write(peer, head);
    for (std::uint64_t sent = 0; taken && sent < 1ULL << 30U; sent += piece.size())
        taken = write(peer, piece);
}

/// Waits until the client disconnects, and reads nothing.
void FakeBhaptics::stay(int peer) {
    while (!stop_) {
        pollfd state{peer, POLLRDHUP, 0};
        if (::poll(&state, 1, 5) > 0) return;
    }
}

/// Reads `size` bytes. Returns false if the connection or the test has ended.
bool FakeBhaptics::read(int peer, void* to, std::size_t size) {
    for (std::size_t done = 0; done < size;) {
        pollfd state{peer, POLLIN, 0};
        if (stop_) return false;
        if (::poll(&state, 1, 5) <= 0) continue;
        const auto got = ::recv(peer, static_cast<char*>(to) + done, size - done, 0);
        if (got <= 0) return false;
        done += static_cast<std::size_t>(got);
    }
    return true;
}

bool FakeBhaptics::write(int peer, const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        pollfd state{peer, POLLOUT, 0};
        if (stop_) return false;
        if (::poll(&state, 1, 5) <= 0) continue;
        const auto put = ::send(peer, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
        if (put <= 0) return false;
        done += static_cast<std::size_t>(put);
        sent_ += static_cast<std::uint64_t>(put);
    }
    return true;
}

}  // namespace thaum::game::rig
