// Reads a log in one of four ways.
//
//     live_log_probe LOG
//
// Prints the input: devices that left or joined, and pauses; then one line per device with sums, buttons and
// the player's faders for the brew's effects; and the result of a replay ("same" or the first tick with a
// different hash of the state or of the forces).
//
//     live_log_probe LOG --input
//
// Prints the same without the pauses and the result, which need a replay: tests that wait for an input ask
// for it again and again.
//
//     live_log_probe LOG --model-ages
//
// Prints a table of the age of each arm's haptic model in each tick (ticks; 0: the tick has no sample of the
// arm). If the machine delays an arm or the match, the age is large or 0.
//
//     live_log_probe LOG --follow STATES
//
// Follows a log that is being written, so that a test can ask repeatedly for the state of the match, and only
// new ticks are replayed. For each line on standard input, writes the newest states (one every 32 ticks, as
// `thaum replay --state`) to STATES and prints the result so far, or an empty line while there is no log.
#include <algorithm>
#include <cstdio>
#include <deque>
#include <fstream>
#include <iostream>

#include "game/match/record.h"
#include "game/match/tables.h"

using namespace thaum;

namespace {

struct Seen {
    std::array<long long, input::max_counts> least{}, most{}, sum{};
    std::uint32_t buttons = 0;
    unsigned long long skips = 0;
    bool away = false;  ///< true: the device was gone in the last sample
};

void note(const input::DeviceSample& sample, Seen& seen) {
    for (std::size_t i = 0; i < input::max_counts; ++i) {
        const long long v = sample.counts[i];
        seen.least[i] = std::min(seen.least[i], v);
        seen.most[i] = std::max(seen.most[i], v);
        seen.sum[i] += v;
    }
    seen.buttons |= sample.buttons;
    seen.skips += sample.skips;
}

void note_change(std::size_t device, Tick tick, const input::DeviceSample& sample, Seen& seen) {
    if (sample.away != seen.away)
        std::printf("device %zu %s at %llu\n", device, sample.away ? "left" : "joined",
                    static_cast<unsigned long long>(tick));
    seen.away = sample.away;
}

void print(std::size_t device, const input::DeviceSpec& spec, const Seen& s) {
    namespace hand = input::hand;
    std::printf(
        "device %zu: look %lld %lld wheel %lld strafe %lld..%lld forward %lld..%lld turn %lld..%lld trigger "
        "%lld "
        "buttons %x skips %llu kept_off",
        device, s.sum[hand::look_right], s.sum[hand::look_up], s.sum[hand::wheel], s.least[hand::strafe],
        s.most[hand::strafe], s.least[hand::forward], s.most[hand::forward], s.least[hand::turn_right],
        s.most[hand::turn_right], s.most[hand::trigger], s.buttons, s.skips);
    for (const auto& percent : spec.fluid_reduction)
        std::printf("%c%d", &percent == spec.fluid_reduction.data() ? ' ' : ',', percent);
    std::printf("\n");
}

/// A match that is replayed as far as its log has been written.
struct Followed {
    std::unique_ptr<game::Simulation> match;
    std::deque<std::string> states;  ///< states of the match, a row of CSV each, the newest last
};

/// Replays what has been added to the log since the last call. Returns false while there is no log.
bool catch_up(const char* path, Followed& followed) {
    constexpr Tick every = 32;
    constexpr std::size_t kept = 16;
    auto log = input::LogReader::open(path);
    if (!log) return false;
    if (followed.match == nullptr) {
        auto match = game::match_of_log(log->header(), game::find_assets());
        if (!match) return false;
        followed.match = std::move(*match);
    }
    auto& match = *followed.match;
    input::InputFrame frame;
    for (Tick tick = 0; log->next(frame); ++tick) {
        if (tick < match.now()) continue;
        match.tick(frame);
        if (match.now() % every != 0) continue;
        game::append_state(match, followed.states.emplace_back());
        if (followed.states.size() > kept) followed.states.pop_front();
    }
    return true;
}

int follow(const char* path, const char* states) {
    Followed followed;
    for (std::string line; std::getline(std::cin, line);) {
        const bool found = catch_up(path, followed);
        if (found) {
            std::ofstream out(states);
            out << game::state_header(*followed.match);
            for (const auto& row : followed.states) out << row;
        }
        std::printf("%s\n", found ? game::result_line(*followed.match).c_str() : "");
        std::fflush(stdout);
    }
    return 0;
}

int print_model_ages(const char* path) {
    auto log = input::LogReader::open(path);
    if (!log) return std::fprintf(stderr, "%s\n", log.error().message.c_str()), 1;
    std::printf("tick,p1_age,p2_age\n");
    input::InputFrame frame;
    for (unsigned long long tick = 1; log->next(frame); ++tick)
        std::printf("%llu,%u,%u\n", tick, frame.devices[0].model_age, frame.devices[1].model_age);
    return 0;
}

/// The match that a log replays.
struct Replayed {
    std::unique_ptr<game::Simulation> match;
    bool paused = false;
    Tick differs = 0;  ///< the first tick with another hash than the log's; 0: none

    void tick(const input::InputFrame& frame, const input::LogReader& log) {
        match->tick(frame);
        const auto now = match->now();
        const auto recorded = log.hash_at(now);
        if (differs == 0 && recorded &&
            (recorded->state != match->state_hash() || recorded->force != match->force_hash()))
            differs = now;
        const bool pause = match->match().paused != 0;
        if (pause != paused)
            std::printf("%s at %llu by %u\n", pause ? "paused" : "on", static_cast<unsigned long long>(now),
                        match->match().paused_by);
        paused = pause;
    }
};

/// Prints the input of a log and, with a match, the pauses.
void print_input(input::LogReader& log, Replayed* replayed) {
    std::array<Seen, input::max_devices> seen{};
    input::InputFrame frame;
    for (Tick tick = 1; log.next(frame); ++tick) {
        for (std::size_t d = 0; d < seen.size(); ++d) {
            note(frame.devices[d], seen[d]);
            note_change(d, tick, frame.devices[d], seen[d]);
        }
        if (replayed != nullptr) replayed->tick(frame, log);
    }
    for (std::size_t d = 0; d < log.header().devices.size(); ++d) print(d, log.header().devices[d], seen[d]);
    std::printf("ended %s: %s\n", log.ended_cleanly() ? "cleanly" : "early", log.result().c_str());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 4 && std::string_view(argv[2]) == "--follow") return follow(argv[1], argv[3]);
    if (argc == 3 && std::string_view(argv[2]) == "--model-ages") return print_model_ages(argv[1]);
    auto log = input::LogReader::open(argc > 1 ? argv[1] : "");
    if (!log) return std::fprintf(stderr, "%s\n", log.error().message.c_str()), 1;
    if (argc == 3 && std::string_view(argv[2]) == "--input") return print_input(*log, nullptr), 0;
    auto match = game::match_of_log(log->header(), game::find_assets());
    if (!match) return std::fprintf(stderr, "%s\n", match.error().message.c_str()), 1;
    Replayed replayed{std::move(*match)};
    print_input(*log, &replayed);
    if (replayed.differs == 0)
        std::printf("replay same\n");
    else
        std::printf("replay differs at %llu\n", static_cast<unsigned long long>(replayed.differs));
    return replayed.differs == 0 && log->ended_cleanly() ? 0 : 1;
}
