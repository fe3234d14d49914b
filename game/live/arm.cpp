#include "game/live/arm.h"

#include <algorithm>
#include <chrono>

#include "core/tell_user.h"
#include "core/text.h"
#include "core/threads.h"
#include "game/live/end_watch.h"

namespace thaum::game::inline live {
namespace {

constexpr int look_ms = 50, try_again_ms = 1000;

Expected<std::unique_ptr<input::OpenArm>> opened(const input::ArmPlace& place, input::ArmServo& servo,
                                                 const haptics::DeviceSpec& wanted,
                                                 const std::atomic<bool>& enough) {
    auto arm = input::open_arm(place, {.enough = &enough});
    if (!arm) return arm;
    const auto& spec = (*arm)->facts().spec;
    if (spec.peak_force < wanted.peak_force) {
        return fail(text("this arm gives ", fixed(spec.peak_force, 1), " N, hands hold a ", wanted.name,
                         " of ", fixed(wanted.peak_force, 1),
                         " N: choose another with --set haptics.device=..."));
    }
    if (const auto started = (*arm)->start(servo.tick()); !started) return started.error();
    return arm;
}

}  // namespace

Expected<std::unique_ptr<ArmKeeper>> ArmKeeper::open(const input::ArmPlace& place, input::ArmServo& servo,
                                                     const haptics::DeviceSpec& wanted) {
    auto arm = opened(place, servo, wanted, EndWatch::asked());
    if (!arm) return arm.error();
    std::unique_ptr<ArmKeeper> keeper(new ArmKeeper(place, std::move(*arm), servo, wanted));
    auto watching = start_thread([&keeper = *keeper] { keeper.watch(); });
    if (!watching) return watching.error();
    keeper->thread_ = std::move(*watching);
    return keeper;
}

ArmKeeper::ArmKeeper(const input::ArmPlace& place, Arm arm, input::ArmServo& servo,
                     const haptics::DeviceSpec& wanted)
    : place_(place), servo_(servo), wanted_(wanted), facts_(arm->facts()), arm_(std::move(arm)) {}

ArmKeeper::~ArmKeeper() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    stopped_.notify_one();
}

input::ArmStatus ArmKeeper::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

input::TickReport ArmKeeper::times() const {
    const std::lock_guard lock(mutex_);
    return times_;
}

int ArmKeeper::losses() const {
    const std::lock_guard lock(mutex_);
    return losses_;
}

/// Waits `ms` milliseconds. Returns false, at once, if the session ends meanwhile.
bool ArmKeeper::wait_for(int ms) {
    std::unique_lock lock(mutex_);
    return !stopped_.wait_for(lock, std::chrono::milliseconds(ms), [this] { return stop_.load(); });
}

/// Stores the arm's status and timing. An arm that was opened again counts as present only once it has given
/// its first sample.
void ArmKeeper::note(const input::ArmStatus& status, const input::TickReport& times) {
    const bool lost = status.state != input::ArmPresence::present;
    const std::lock_guard lock(mutex_);
    times_ = times;
    if (lost && status_.state == input::ArmPresence::present) ++losses_;
    if (!lost && status.newest_ns == 0) return;
    status_ = status;
    lost_ = lost;
}

/// Watches the arm until the session ends. A lost arm is closed before it is opened again, so that its old
/// servo thread (which computes forces) has ended before a new one uses `servo_`.
void ArmKeeper::watch() {
    while (wait_for(arm_ ? look_ms : try_again_ms)) {
        if (!arm_) {
            auto again = opened(place_, servo_, wanted_, stop_);
            if (!again) {
                const std::lock_guard lock(mutex_);
                status_.text = again.error().message;  // the reason why the arm cannot be opened now
                continue;
            }
            arm_ = std::move(*again);
        }
        const auto status = arm_->status();
        const auto times = arm_->times();
        const bool lost = status.state != input::ArmPresence::present;
        note(status, times);
        if (lost) arm_.reset();
    }
    if (!arm_) return;
    const auto times = arm_->times();
    const std::lock_guard lock(mutex_);
    times_ = times;
}

// The list of arms ------------------------------------------------------------------------------------------

namespace {

using Keeper = std::unique_ptr<ArmKeeper>;

/// Indices in input::arm_places() of the arms that --hands names by number (arm:NUMBER), and of arms that are
/// open.
using TakenNumbers = std::vector<std::size_t>;

Expected<Keeper> open_numbered(const std::vector<input::ArmPlace>& places, std::size_t number,
                               input::ArmServo& servo, const haptics::DeviceSpec& wanted) {
    if (number < places.size()) return ArmKeeper::open(places[number], servo, wanted);
    return fail(text("--hands arm:", number, ": there are ", places.size(),
                     " arms, numbered from 0; `thaum doctor` lists them"));
}

/// Opens the first arm that is not in `taken`, and adds its index there. If none opens, returns the error of
/// the first one that was tried.
Expected<Keeper> open_next(const std::vector<input::ArmPlace>& places, TakenNumbers& taken,
                           input::ArmServo& servo, const haptics::DeviceSpec& wanted) {
    std::optional<Error> first;
    for (std::size_t n = 0; n < places.size(); ++n) {
        if (std::find(taken.begin(), taken.end(), n) != taken.end()) continue;
        auto keeper = ArmKeeper::open(places[n], servo, wanted);
        if (!keeper && !first) first = keeper.error();
        if (!keeper) continue;
        taken.push_back(n);
        return keeper;
    }
    if (first) return *first;
    return fail("--hands arm: every arm is taken already; `thaum doctor` lists the arms");
}

}  // namespace

Expected<LiveArms> open_arms(std::span<const Seat> seats, const haptics::DeviceSpec& wanted) {
    LiveArms arms;
    TakenNumbers taken;
    for (const auto& seat : seats)
        if (seat.arm && seat.arm->number) taken.push_back(*seat.arm->number);
    const bool wanted_any = std::any_of(seats.begin(), seats.end(), [](const Seat& s) { return s.arm; });
    const auto places = wanted_any ? input::arm_places() : std::vector<input::ArmPlace>();
    for (std::uint32_t i = 0; i < seats.size(); ++i) {
        if (!seats[i].arm) continue;
        auto arm = std::make_unique<LiveArm>();
        arm->seat = i;
        const auto number = seats[i].arm->number;
        auto keeper = number ? open_numbered(places, *number, arm->servo, wanted)
                             : open_next(places, taken, arm->servo, wanted);
        if (!keeper) return keeper.error();
        arm->keeper = std::move(*keeper);
        arms.push_back(std::move(arm));
    }
    return arms;
}

void bind_arms(LiveArms& arms, const TakenSeats& seats, bool start_screen) {
    auto with_mouse = no_player, other = no_player;
    for (std::uint32_t p = 0; p < players; ++p) {
        if (seats[p].hands) (seats[p].seat.kind == SeatKind::keyboard_mouse ? with_mouse : other) = p;
    }
    if (with_mouse == no_player) other = no_player;
    for (std::size_t i = 0; i < arms.size(); ++i)
        arms[i]->player = start_screen ? (i == 0 ? with_mouse : other) : arms[i]->seat;
}

std::vector<input::DeviceSpec> arms_of(const LiveArms& arms) {
    std::vector<input::DeviceSpec> specs;
    each_held_arm(arms, [&](const LiveArm& held, std::size_t) {
        input::DeviceSpec arm;
        arm.player = held.player;
        arm.kind = input::DeviceKind::arm;
        arm.name = input::name_of(held.keeper->facts());
        arm.box_um = input::box_um(held.keeper->facts());
        specs.push_back(std::move(arm));
    });
    return specs;
}

std::vector<input::DeviceSpec> devices_of(const TakenSeats& seats, const LiveArms& arms) {
    std::vector<input::DeviceSpec> devices;
    for (const auto& seat : seats) devices.push_back(seat.spec);
    for (auto& arm : arms_of(arms)) devices.push_back(std::move(arm));
    return devices;
}

// Notices ---------------------------------------------------------------------------------------------------

std::optional<std::string> update(ArmNotice& notice, const std::string& name,
                                  const input::ArmStatus& status) {
    const bool lost = status.state != input::ArmPresence::present, first = notice.label.empty();
    const auto label = text(name, lost ? " (gone)" : "");
    const bool changes = label != notice.label;
    notice = {label, input::caption_of(status)};
    if (!changes || (first && !lost)) return {};
    return lost ? status.text : "the arm is back";
}

void follow_arms(LiveArms& arms) {
    for (auto& arm : arms) {
        const auto name = input::name_of(arm->keeper->facts());
        const auto line = update(arm->notice, name, arm->keeper->status());
        const auto head = arms.size() > 1 ? text(name, ": ") : std::string();
        if (line) tell_user(text(head, *line));
    }
}

}  // namespace thaum::game::inline live
