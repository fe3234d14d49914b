// A fake of the bHaptics Player, at a port that the system chooses. It implements HTTP and WebSocket (RFC
// 6455) byte by byte, so that it can also break their rules.
#pragma once
#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace thaum::game::rig {

/// Behaviour of the fake Player (the vest maker's program) towards its client.
enum class Manner : std::uint8_t {
    replies,          ///< answers each request, with one device
    replies_no_vest,  ///< answers each request, with no device
    replies_head,     ///< answers each request, with a device for the head alone
    never_replies,    ///< accepts requests and never replies
    never_answers,    ///< accepts the connection and sends nothing
    answers_404,      ///< does not support WebSocket
    answers_noise,    ///< sends random bytes instead of an HTTP response
    sends_noise,      ///< sends random bytes instead of frames, after a correct HTTP response
    sends_nonsense,   ///< sends correct frames whose texts are not replies
    sends_gibibyte,   ///< sends one message of 1 GiB
    sends_pieces,     ///< sends replies in many fragments, with pings between them
    never_reads,      ///< sends a correct HTTP response, then reads nothing more
    hangs_up,         ///< closes the connection after the first request
    redirects,        ///< redirects the client to another port, that of redirect_to
};

class FakeBhaptics {
public:
    explicit FakeBhaptics(Manner manner);
    ~FakeBhaptics();
    FakeBhaptics(const FakeBhaptics&) = delete;
    FakeBhaptics& operator=(const FakeBhaptics&) = delete;

    std::uint16_t port() const { return port_; }
    void behave(Manner manner) { manner_ = manner; }
    void redirect_to(std::uint16_t port) { other_port_ = port; }
    /// All requests that the fake has got so far.
    std::vector<std::string> texts() const;
    /// First line of the last connection's HTTP request.
    std::string first_line() const;
    std::size_t connections() const;
    std::uint64_t bytes_sent() const { return sent_; }
    /// Waits until a condition on the requests so far holds. A test that waits for ever is ended by its time
    /// limit.
    template <class Condition>
    void wait(Condition condition) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return condition(texts_); });
    }
    /// Waits until the request `wanted` has come, not counting the first `before` requests.
    void wait_for(const std::string& wanted, std::size_t before = 0);
    void wait_for_connections(std::size_t count);

private:
    void run();
    void serve(int peer);
    bool answer(int peer);
    void speak(int peer);
    bool take_frame(int peer);
    bool react(int peer, const std::string& request);
    bool read(int peer, void* to, std::size_t size);
    bool write(int peer, const std::string& bytes);
    void send_gibibyte(int peer);
    bool send_pieces(int peer);
    void stay(int peer);

    int listener_ = -1;
    std::uint16_t port_ = 0;
    std::atomic<Manner> manner_;
    std::atomic<std::uint16_t> other_port_{};
    std::atomic<bool> stop_{};
    std::atomic<std::uint64_t> sent_{};
    mutable std::mutex mutex_;  ///< protects texts_, first_line_ and connections_
    std::vector<std::string> texts_;
    std::string first_line_;
    std::size_t connections_ = 0;
    std::condition_variable changed_;
    std::jthread thread_;
};

}  // namespace thaum::game::rig
