#include "game/app/live.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

#include "core/random.h"
#include "core/text.h"
#include "core/threads.h"
#include "game/app/arguments.h"
#include "game/app/command.h"
#include "game/app/end_watch.h"
#include "game/app/live_session.h"
#include "game/bots/bot.h"
#include "game/match/record.h"

namespace thaum::app {

using input::DeviceKind;

// Shared ----------------------------------------------------------------------------------------------------

void Staller::pass(Stall::Thread thread) {
    if (stall.thread != thread) return;
    const auto now = monotonic_ns();
    if (next_ns == 0) next_ns = now + stall.every_ms * std::int64_t{1'000'000};
    if (now < next_ns) return;
    sleep_until_ns(now + stall.ms * std::int64_t{1'000'000});
    next_ns = monotonic_ns() + stall.every_ms * std::int64_t{1'000'000};
}

double Timings::at(double share) {
    if (values_.empty()) return 0;
    std::sort(values_.begin(), values_.end());
    return values_[static_cast<std::size_t>(share * static_cast<double>(values_.size() - 1))];
}

// Seats -----------------------------------------------------------------------------------------------------

Expected<Seat> hand_named(std::string_view word) {
    constexpr std::string_view numbered_arm = "arm:";
    constexpr std::uint64_t most_number = 1000;
    if (word == "mouse") return Seat{.kind = SeatKind::keyboard_mouse};
    if (word == "half") return Seat{.kind = SeatKind::keyboard_half};
    if (word == "pad") return Seat{.kind = SeatKind::pad};
    if (word == "arm") return Seat{.kind = SeatKind::keyboard_mouse, .arm = ArmWish{}};
    if (word.starts_with(numbered_arm)) {
        const auto number = parse_whole(word.substr(numbered_arm.size()), "--hands arm:", 0, most_number);
        if (!number) return tl::unexpected(number.error());
        return Seat{.kind = SeatKind::keyboard_mouse, .arm = ArmWish{*number}};
    }
    return fail(text("--hands '", word, "': must be mouse, half, pad or arm, or arm:0, arm:1, ..."));
}

Expected<std::vector<Seat>> hands_named(std::string_view words) {
    std::vector<Seat> hands;
    for (;;) {
        const auto comma = std::min(words.find(','), words.size());
        const auto hand = hand_named(words.substr(0, comma));
        if (!hand) return tl::unexpected(hand.error());
        hands.push_back(*hand);
        if (comma == words.size()) break;
        words.remove_prefix(comma + 1);
    }
    if (hands.size() > game::players) return fail("--hands takes one or two devices, one a player");
    if (hands.size() < 2 || hands[0].kind != hands[1].kind || hands[0].kind == SeatKind::pad) return hands;
    // Only one player has the mouse: the first, unless the second asks for the mouse alone.
    auto* gives_way = hands[1].arm ? &hands[1] : hands[0].arm ? hands.data() : nullptr;
    const bool same_arm = hands[0].arm && hands[1].arm && hands[0].arm->number && hands[1].arm->number &&
                          *hands[0].arm->number == *hands[1].arm->number;
    if (gives_way == nullptr || same_arm)
        return fail(
            "--hands takes one or two devices, and both of one kind only if they are pads or two arms");
    gives_way->kind = SeatKind::pad_or_half;
    return hands;
}

std::vector<input::DeviceSpec> arms_of(const LiveShared& shared) {
    std::vector<input::DeviceSpec> arms;
    each_held_arm(shared, [&](const LiveArm& held, std::size_t) {
        input::DeviceSpec arm;
        arm.player = held.player;
        arm.kind = DeviceKind::arm;
        arm.name = input::name_of(held.keeper->facts());
        arm.box_um = input::box_um(held.keeper->facts());
        arms.push_back(std::move(arm));
    });
    return arms;
}

std::vector<input::DeviceSpec> devices_of(const LiveShared& shared) {
    std::vector<input::DeviceSpec> devices;
    for (const auto& seat : shared.seats) devices.push_back(seat.spec);
    for (auto& arm : arms_of(shared)) devices.push_back(std::move(arm));
    return devices;
}

namespace {

DeviceKind device_kind(SeatKind kind) {
    switch (kind) {
        case SeatKind::keyboard_mouse: return DeviceKind::keyboard_mouse;
        case SeatKind::keyboard_half: return DeviceKind::keyboard_half;
        case SeatKind::bot:
        case SeatKind::dummy: return DeviceKind::bot;
        default: return DeviceKind::pad;
    }
}

std::string device_name(const Seat& seat) {
    switch (seat.kind) {
        case SeatKind::keyboard_mouse: return "mouse and keyboard";
        case SeatKind::keyboard_half: return "half of the keyboard";
        default: return text("pad ", seat.pad + 1);
    }
}

TakenSeat take_seat(const Settings& settings, Seat seat, std::uint32_t player) {
    if (seat.kind == SeatKind::bot) return {seat, game::bot_device(player, seat.level), nullptr};
    if (seat.kind == SeatKind::dummy) return {seat, game::dummy_device(), nullptr};
    input::DeviceSpec spec;
    spec.player = player;
    spec.kind = device_kind(seat.kind);
    spec.name = device_name(seat);
    spec.look_rad_per_count *= settings.sensitivity;
    spec.turn_rad_per_s = settings.turn_deg_per_s * radians_per_degree;
    if (settings.invert_y) spec.flags |= input::DeviceSpec::invert_y;
    if (const auto percent = force_choices[settings.force[player]].percent) spec.set_force_percent(*percent);
    const auto percent_of = [](double share) { return static_cast<std::uint32_t>(std::lround(100 * share)); };
    spec.set_carried_percent(percent_of(settings.carried_weight), percent_of(settings.carried_blows));
    ask_for(settings.cauldron[player], spec);
    return {seat, spec, std::make_unique<input::HandsCollector>(settings.bindings_of(spec.kind))};
}

Seat seat_of(const Device& device) {
    switch (device.kind) {
        case DeviceKind::keyboard_mouse: return {.kind = SeatKind::keyboard_mouse};
        case DeviceKind::keyboard_half: return {.kind = SeatKind::keyboard_half};
        default: return {.kind = SeatKind::pad, .pad = device.pad};
    }
}

std::array<Seat, game::players> joined_seats(const LiveSession& session) {
    std::array<Seat, game::players> seats;
    for (std::size_t p = 0; p < seats.size(); ++p) {
        const auto& device = session.menu.seats[p];
        seats[p] =
            device ? seat_of(*device)
                   : Seat{.kind = SeatKind::bot, .level = session.menu_context.levels[session.menu.level]};
    }
    if (session.range) seats[game::dummys] = {.kind = SeatKind::dummy};
    return seats;
}

/// Seats of the plan; each pad goes to the first seat that wants one.
std::array<Seat, game::players> planned_seats(LiveSession& session) {
    auto seats = session.plan.seats;
    const auto pads = session.shared.window.pads();
    int free_pad = 0;
    for (auto& seat : seats) {
        if (seat.kind == SeatKind::pad_or_half) {
            const bool there = pads[static_cast<std::size_t>(free_pad)].present;
            seat.kind = there ? SeatKind::pad : SeatKind::keyboard_half;
        }
        if (seat.kind == SeatKind::pad) seat.pad = free_pad++;
    }
    return seats;
}

// Matches ---------------------------------------------------------------------------------------------------

/// Path with a number before the extension: "match.thaumlog" -> "match-2.thaumlog".
std::filesystem::path numbered(const std::filesystem::path& path, std::uint64_t number) {
    auto next = path;
    return next.replace_filename(text(path.stem().string(), "-", number, path.extension().string()));
}

/// Creates the log under `path` or, if that name is taken, with the next free number. Only creating a file
/// shows whether its name is free, because another program may look for a name at the same time.
Expected<input::LogWriter> create_beside(const std::filesystem::path& path, const input::LogHeader& header) {
    constexpr std::uint64_t last_try = 1000;
    auto log = input::LogWriter::create(path, header);
    auto taken = path;
    std::error_code error;
    for (std::uint64_t number = 2; !log && number < last_try && std::filesystem::exists(taken, error);
         ++number) {
        taken = numbered(path, number);
        log = input::LogWriter::create(taken, header);
    }
    return log;
}

/// Path of the next match's log; empty: the match is not recorded.
Expected<std::filesystem::path> log_path(const LiveSession& session) {
    const auto& plan = session.plan;
    if (!plan.log.empty()) return plan.log;
    if (plan.logs_folder.empty()) return std::filesystem::path();
    return new_match_log(plan.logs_folder, session.menu.settings.logs_kept);
}

Expected<std::optional<input::LogWriter>> open_log(const LiveSession& session, std::uint64_t seed,
                                                   std::uint64_t number) {
    const auto path = log_path(session);
    if (!path) return tl::unexpected(path.error());
    if (path->empty()) return std::nullopt;
    std::vector<std::string> names;
    for (const auto& seat : session.shared.seats)
        names.push_back(seat.seat.kind == SeatKind::bot ? text("bot ", seat.seat.level) : "human");
    const game::MatchSetup setup{seed, devices_of(session.shared)};
    const auto header = game::log_header(*session.data, setup, std::move(names));
    // A log that the user named gets this name, or opening it is an error.
    const bool named = !session.plan.log.empty() && number == 1;
    auto log = named ? input::LogWriter::create(*path, header) : create_beside(*path, header);
    if (!log) return tl::unexpected(log.error());
    return std::move(*log);
}

/// Record of the next match. The range's files belong to its only match, and no log is opened beside them.
Expected<Recording> recording_of(LiveSession& session, std::uint64_t seed, std::uint64_t number) {
    if (session.range) {
        Recording files(std::move(*session.range));
        session.range.reset();
        return files;
    }
    auto log = open_log(session, seed, number);
    if (!log) return tl::unexpected(log.error());
    if (!*log) return Recording();
    return Recording(std::move(**log));
}

/// Binds each real arm to its player for the next match. After the start screen the first arm goes to the
/// player with the mouse, and the second one to the other person.
void bind_arms(LiveSession& session) {
    auto& shared = session.shared;
    auto with_mouse = game::no_player, other = game::no_player;
    for (std::uint32_t p = 0; p < game::players; ++p) {
        const auto& seat = shared.seats[p];
        if (seat.hands) (seat.seat.kind == SeatKind::keyboard_mouse ? with_mouse : other) = p;
    }
    if (with_mouse == game::no_player) other = game::no_player;
    for (std::size_t i = 0; i < shared.arms.size(); ++i) {
        auto& arm = *shared.arms[i];
        arm.player = session.plan.start_screen ? (i == 0 ? with_mouse : other) : arm.seat;
    }
}

void take_seats(LiveSession& session) {
    if (session.plan.replay != nullptr) return;  // a replay has no players at the devices
    const auto seats = session.plan.start_screen ? joined_seats(session) : planned_seats(session);
    for (std::uint32_t p = 0; p < game::players; ++p)
        session.shared.seats[p] = take_seat(session.menu.settings, seats[p], p);
    bind_arms(session);
}

/// Plays one match. The error: the simulation thread could not be started.
Expected<void> play_match(LiveSession& session, MatchStart start) {
    auto& shared = session.shared;
    shared.ended = shared.end_match = shared.rematch = false;
    shared.going = PlayState::playing;
    shared.wants_pause = shared.wants_to_go_on = game::no_player;
    for (auto& lost : shared.pad_lost) lost = false;
    auto simulating = start_thread([&] { run_simulation(session.plan, shared, std::move(start)); });
    if (!simulating) return tl::unexpected(simulating.error());
    run_session(session);
    return {};
}

/// Plays one match after another until the players leave.
Expected<void> play_matches(LiveSession& session) {
    auto& shared = session.shared;
    auto seed = session.plan.seed;
    bool again = false;
    if (session.plan.practice) {
        if (auto opened = open_range(session); !opened) return opened;
    }
    for (std::uint64_t number = 1; !shared.stop; ++number) {
        if (session.plan.start_screen && !again && !run_start_screen(session)) break;
        take_seats(session);
        session.menu_context.practice = session.range.has_value();
        auto recording = recording_of(session, seed, number);
        // A log that the user named must be opened. If the default folder fails, the match is played without
        // a log.
        if (!recording && number == 1 && !session.plan.log.empty()) return tl::unexpected(recording.error());
        if (!recording)
            std::fprintf(stderr, "this match is not recorded: %s\n", recording.error().message.c_str());
        auto played =
            play_match(session, {session.data, seed, recording ? std::move(*recording) : Recording()});
        if (!played) return played;
        again = shared.rematch;
        if (!again && !session.plan.start_screen) break;
        Random next = random_stream(seed, number);
        seed = next.next() >> 1U;
    }
    return {};
}

// Arms ------------------------------------------------------------------------------------------------------

/// Opens the arms of the seats that want one. The arms give forces from the first match on.
Expected<void> open_arms(LiveShared& shared, const LivePlan& plan) {
    if (plan.replay != nullptr) return {};
    auto arms = open_arms(plan.seats, plan.data->device);
    if (!arms) return tl::unexpected(arms.error());
    shared.arms = std::move(*arms);
    return {};
}

/// Prints how an arm did, with its name if there are several.
void tell_arm(const LiveArm& arm, bool name_it) {
    const auto faults = arm.servo.faults();
    std::fprintf(stderr,
                 "arm%s: %s; poses: %llu repeated, %llu back in time, %llu no numbers; lost %d times; %llu "
                 "forces differ from the match's\n",
                 name_it ? text(" ", input::name_of(arm.keeper->facts())).c_str() : "",
                 told(arm.keeper->times()).c_str(), static_cast<unsigned long long>(faults.poses.repeated),
                 static_cast<unsigned long long>(faults.poses.backwards),
                 static_cast<unsigned long long>(faults.poses.unusable), arm.keeper->losses(),
                 static_cast<unsigned long long>(faults.differing));
}

void fill_report(LiveShared& shared, LiveReport& report) {
    report = shared.report;
    report.late_us_median = shared.late.at(0.5);
    report.late_us_p99 = shared.late.at(0.99);
    report.late_us_worst = shared.late.at(1);
    report.tick_us_median = shared.ticks.at(0.5);
    report.tick_us_p99 = shared.ticks.at(0.99);
}

}  // namespace

std::string told(const input::TickReport& arm) {
    return text(arm.ticks, " ticks, ", arm.missed, " missed; uneven by ", fixed(arm.jitter_median, 0),
                " us in the middle, ", fixed(arm.jitter_p99, 0), " us at 99 %, ", fixed(arm.jitter_worst, 0),
                " us at worst; from pose to force ", fixed(arm.answer_median, 0), " us, ",
                fixed(arm.answer_p99, 0), " us, ", fixed(arm.answer_worst, 0), " us");
}

int run_live(const LivePlan& plan) {
    // Nothing is open yet. So a signal before the window exists ends the program, even if OpenGL's library
    // hangs.
    auto window = render::Window::create({.fullscreen = plan.settings.fullscreen});
    if (!window) return refuse(window.error());
    const EndWatch watch;
    LiveShared shared(*window);
    if (const auto opened = open_arms(shared, plan); !opened) return refuse(opened.error());
    LiveSession session(shared, plan);
    auto drawing = start_thread([&] { run_render(plan, shared); });
    if (!drawing) return refuse(drawing.error());
    const auto played = play_matches(session);
    shared.stop = true;
    drawing->join();
    if (plan.report != nullptr) fill_report(shared, *plan.report);
    for (const auto& arm : shared.arms) tell_arm(*arm, shared.arms.size() > 1);
    if (!played) return refuse(played.error());
    if (shared.render_error) return refuse(*shared.render_error);
    if (shared.simulation_error) return refuse(*shared.simulation_error);
    if (EndWatch::asked()) std::fprintf(stderr, "ended by a signal\n");
    return done;
}

}  // namespace thaum::app
