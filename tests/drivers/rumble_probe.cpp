// Runs the motors of pads as a match does:
//
//     rumble_probe FILE
//
// The first two pads belong to the two players. FILE is a FIFO with lines "PLAYER LEFT RIGHT FRAMES": player
// 1 or 2 gets that number of frames of 8 ms, each with a time to live of 48 ms. A line replaces the one
// before. The program ends when the FIFO is closed. It prints "player 1 feels" and "player 1 feels nothing"
// when this changes, and the counts at its end.
#include <array>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <thread>

#include "core/clock.h"
#include "game/live/tactile.h"
#include "input/pads.h"

namespace {

using namespace thaum;

struct Order {
    std::size_t player = 1;
    float left{}, right{};
    int frames = 0;
};

/// Requests read from the FIFO, by a thread of their own.
struct Orders {
    std::mutex mutex;
    Order newest;
    std::atomic<bool> ended = false;

    void read(const char* path) {
        std::ifstream in(path);
        for (Order order; in >> order.player >> order.left >> order.right >> order.frames;) {
            const std::lock_guard lock(mutex);
            newest = order;
        }
        ended = true;
    }
    /// Takes one frame of the newest request. `player` counts from 0.
    bool take(std::size_t& player, tactile::TactileFrame& frame) {
        const std::lock_guard lock(mutex);
        if (newest.frames <= 0) return false;
        --newest.frames;
        player = newest.player - 1;
        frame = {.time_to_live = 48, .count = 2};
        frame.amplitude[0] = newest.left;
        frame.amplitude[1] = newest.right;
        return true;
    }
};

class Probe {
public:
    /// Simulates eight milliseconds of a match, the length of one frame of the motors.
    void step(Orders& orders) {
        const auto& pads = reader_.poll();
        for (std::uint32_t p = 0; p < felt_.size(); ++p) {
            tactile_.use_pad(p, &pads.at(p));
            if (const bool feels = tactile_.feels(p); feels != std::exchange(felt_.at(p), feels))
                say(p, feels ? "feels" : "feels nothing");
        }
        tactile_.tell_status();
        std::size_t player = 0;
        tactile::TactileFrame frame;
        if (orders.take(player, frame)) tactile_.feel(static_cast<std::uint32_t>(player), frame);
    }
    void tell_counts() const {
        const auto counts = tactile_.report(0);
        std::printf("sent %llu silenced %llu opened %llu\n",
                    static_cast<unsigned long long>(counts.frames_sent),
                    static_cast<unsigned long long>(counts.times_silenced),
                    static_cast<unsigned long long>(counts.times_opened));
    }

private:
    static void say(std::uint32_t player, const char* what) {
        std::printf("player %u %s\n", player + 1, what);
        std::fflush(stdout);
    }

    input::PadReader reader_{};
    game::LiveTactile tactile_{};
    std::array<bool, 2> felt_{};
};

}  // namespace

int main(int argc, char** argv) {
    constexpr std::int64_t frame_ns = 8'000'000;
    if (argc != 2) return 2;
    Orders orders;
    const std::jthread reader([&] { orders.read(argv[1]); });
    Probe probe;
    for (auto due = monotonic_ns(); !orders.ended; due = std::max(due + frame_ns, monotonic_ns())) {
        probe.step(orders);
        sleep_until_ns(due + frame_ns);
    }
    probe.tell_counts();
}
