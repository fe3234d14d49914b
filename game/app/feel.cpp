#include "game/app/feel.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>

#include "core/clock.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/named_arm.h"
#include "game/components/hand_state.h"
#include "game/live/end_watch.h"
#include "game/live/live.h"
#include "input/arm_playback.h"
#include "input/open_arm.h"

namespace thaum::game::inline app {
namespace {

/// Number of ticks computed ahead of the arm. A busy machine may need longer to compute a tick than the arm
/// needs to play it.
constexpr std::size_t ahead = 12'000;
constexpr std::int64_t look_ns = 5'000'000;    ///< longest time between two checks of keyboard and arm (ns)
constexpr std::int64_t fade_ns = 150'000'000;  ///< time in which the last force fades to zero (ns)

// ---- requests to end -----------------------------------------------------------------------------------

/// Watches for requests to end: Ctrl-C, a termination signal, or any key on a terminal.
class StopWatch {
public:
    StopWatch() {
        terminal_ = ::isatty(STDIN_FILENO) != 0 && ::tcgetattr(STDIN_FILENO, &mode_) == 0;
        if (!terminal_) return;
        auto single_keys = mode_;
        single_keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        ::tcsetattr(STDIN_FILENO, TCSANOW, &single_keys);
    }
    ~StopWatch() {
        if (terminal_) ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &mode_);
    }
    StopWatch(const StopWatch&) = delete;
    StopWatch& operator=(const StopWatch&) = delete;

    bool asked() const {
        if (EndWatch::asked()) return true;
        pollfd keys{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
        return terminal_ && ::poll(&keys, 1, 0) > 0;
    }

private:
    EndWatch signals_{};
    termios mode_{};
    bool terminal_ = false;
};

// ---- the log's forces -------------------------------------------------------------------------------------

/// The forces on one player's hand in the log's ticks of play, in order.
class RecordedForces {
public:
    RecordedForces(Playback playback, std::uint32_t player)
        : playback_(std::move(playback)), player_(player), felt_(playback_.match().match().played) {}

    /// Replays the match ahead of the arm until enough forces are queued, or until about `budget_ns` ns have
    /// passed. Returns false if the log has ended or the replay has diverged from the recorded match.
    bool fill(input::ArmPlayback& hand, std::int64_t budget_ns) {
        const auto end_ns = monotonic_ns() + budget_ns;
        while (hand.waiting() < ahead && monotonic_ns() < end_ns) {
            if (!playback_.step() || playback_.divergence()) return false;
            put(hand);
        }
        return true;
    }
    /// Replays the match ahead of the arm until enough forces are queued. Returns false if the log has ended
    /// or the replay has diverged from the recorded match.
    bool fill(input::ArmPlayback& hand) {
        while (hand.waiting() < ahead) {
            if (!fill(hand, look_ns)) return false;
        }
        return true;
    }

    const std::optional<Divergence>& divergence() const { return playback_.divergence(); }

private:
    /// Queues the force of the current tick. Ticks in a pause or after a round's end had no force and are
    /// left out.
    void put(input::ArmPlayback& hand) {
        const auto& match = playback_.match();
        const auto& state = match.match();
        const bool played = state.played == felt_ + 1;
        const bool jumps = !followed_ || state.round != round_;
        followed_ = played;
        round_ = state.round;
        felt_ = state.played;
        if (!played) return;
        const auto& world = match.world();
        hand.push(world.get<HandState>(wizard_of(world, player_)).servo.safety.output, jumps);
    }

    Playback playback_;
    std::uint32_t player_;
    Tick felt_;
    std::uint32_t round_ = 0;
    bool followed_ = false;
};

// ---- the arm ----------------------------------------------------------------------------------------------

/// Largest share of the arm's peak force that the settings of this machine allow; 0: no forces.
double wished_share() {
    const auto settings = settings_to_play_with(settings_file(), find_assets()).settings;
    const auto percent = force_choices[settings.players[0].force].percent;
    return percent ? *percent / 100.0 : haptics::gentle_share;
}

/// Text with the numbers of ticks in which the arm got less force than recorded, by cause: "warm 12, capped
/// 3".
std::string held_back(const input::PlaybackReport& report) {
    std::string out;
    for (std::size_t i = 1; i < report.causes.size(); ++i) {
        if (report.causes[i] == 0) continue;
        out += text(out.empty() ? "" : ", ", haptics::safety_cause_names[i], " ", report.causes[i]);
    }
    return out.empty() ? "nothing held back" : text("held back in ticks: ", out);
}

void tell(const input::ArmPlayback& hand, const input::OpenArm& arm) {
    const auto report = hand.report();
    std::printf("%s s felt, at most %s N; %s; %llu ticks without a force\narm: %s\n",
                fixed(seconds(report.played), 2).c_str(), fixed(report.strongest, 2).c_str(),
                held_back(report).c_str(), static_cast<unsigned long long>(report.starved),
                told(arm.times()).c_str());
}

/// Plays until all forces were felt, or until playing must end early. Returns the reason for an early end.
std::optional<std::string> play(RecordedForces& forces, input::ArmPlayback& hand, const input::OpenArm& arm) {
    const StopWatch watch;
    std::int64_t until = 0;  // end of the fade after the last force (ns); 0: more forces will come
    bool more = true;
    while (until == 0 || monotonic_ns() < until) {
        if (more) more = forces.fill(hand, look_ns);
        if (!more) hand.end();
        if (watch.asked()) return "ended by hand: no force any more";
        if (const auto status = arm.status(); status.state != input::ArmPresence::present) return status.text;
        if (!more && hand.waiting() == 0 && until == 0) until = monotonic_ns() + fade_ns;
        // Computing ahead has priority over sleeping: a thread that slept each time as long as it computes
        // would fall behind.
        if (!more || hand.waiting() >= ahead) sleep_until_ns(monotonic_ns() + look_ns);
    }
    return {};
}

}  // namespace

int feel(Playback playback, const FeelPlan& plan) {
    const double share = wished_share();
    if (!(share > 0)) return refuse({"--feel: your settings say that you want no forces (force: off)"});
    auto arm = open_named_arm("--feel", plan.device);
    if (!arm) return refuse(arm.error());
    const auto& spec = (*arm)->facts().spec;
    input::ArmPlayback hand(haptics::servo_of(spec, share));
    RecordedForces forces(std::move(playback), plan.player);
    if (!forces.fill(hand) && hand.waiting() == 0) {
        if (!forces.divergence())
            return refuse({"--feel: the log has no tick of play after --at; choose an earlier second"});
        print_line(described(*forces.divergence()));
        return does_not_hold;
    }
    print_line(text("player ", plan.player + 1, "'s forces on ", input::name_of((*arm)->facts()),
                    ", at most ", fixed(share * spec.peak_force, 2), " of ", fixed(spec.peak_force, 1),
                    " N: any key or Ctrl-C ends them"));
    std::fflush(stdout);
    if (const auto started = (*arm)->start(hand.tick()); !started) return refuse(started.error());
    const auto why = play(forces, hand, **arm);
    const bool fault = (*arm)->status().state != input::ArmPresence::present;
    hand.stop();
    tell(hand, **arm);
    arm->reset();  // stops the arm's thread, which uses `hand`, before `hand` is destroyed
    if (why) print_line(*why);
    if (forces.divergence()) print_line(described(*forces.divergence()));
    return fault || forces.divergence() ? does_not_hold : done;
}

}  // namespace thaum::game::inline app
