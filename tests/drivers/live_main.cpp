// A live session with a short command line, for tests of drivers and of timing:
//
//     live_session LOG SECONDS [SEAT SEAT [STALLED_THREAD EVERY_MS MS]]
//
// SEAT: mouse, half (of a keyboard), pad, arm (with the mouse), bot, or probe (a mouse that moves by itself).
// The program prints how well the session kept time.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "game/live/live.h"

using namespace thaum;
using namespace thaum::game;

namespace {

live::Seat seat_of(std::string_view word) {
    if (word == "mouse" || word == "probe") return {.kind = SeatKind::keyboard_mouse};
    if (word == "arm") return {.kind = SeatKind::keyboard_mouse, .arm = ArmWish{}};
    if (word == "half") return {.kind = SeatKind::keyboard_half};
    if (word == "pad") return {.kind = SeatKind::pad};
    return {.kind = SeatKind::bot, .bot = "1"};
}

Stall::Thread thread_of(std::string_view word) {
    if (word == "main") return Stall::Thread::main;
    if (word == "simulation") return Stall::Thread::simulation;
    return word == "render" ? Stall::Thread::render : Stall::Thread::none;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const auto assets = game::find_assets();
    auto data = game::load_match_data(assets, {});
    if (!data) return std::fprintf(stderr, "%s\n", data.error().message.c_str()), 1;
    LiveReport report;
    LivePlan plan{.data = std::make_shared<const game::MatchData>(std::move(*data)),
                  .log = argv[1],
                  .assets = assets,
                  .seconds = std::atof(argv[2]),
                  .report = &report};
    // Draws few pictures, because drawing without a graphics card would take every core.
    plan.settings.frames_per_second = 20;
    plan.seats = {seat_of(argc > 4 ? argv[3] : "bot"), seat_of(argc > 4 ? argv[4] : "bot")};
    plan.probe = argc > 4 && std::string_view(argv[3]) == "probe";
    if (argc > 7) plan.stall = {thread_of(argv[5]), std::atoi(argv[6]), std::atoi(argv[7])};
    const auto played = run_live(plan);
    if (!played) std::fprintf(stderr, "%s\n", played.error().message.c_str());
    std::printf(
        "ticks %llu, skipped %llu, frames %llu, matches %llu\n",
        static_cast<unsigned long long>(report.ticks), static_cast<unsigned long long>(report.skipped),
        static_cast<unsigned long long>(report.frames), static_cast<unsigned long long>(report.matches));
    std::printf(
        "late us: median %.0f, p99 %.0f, worst %.0f; tick us: median %.1f, p99 %.1f; frame ms: median %.1f, "
        "p99 %.1f at quality %s\n",
        report.late_us_median, report.late_us_p99, report.late_us_worst, report.tick_us_median,
        report.tick_us_p99, report.frame_ms_median, report.frame_ms_p99,
        std::string(render::quality_names[static_cast<std::size_t>(report.quality)]).c_str());
    std::printf("input ms: median %.1f, p99 %.1f of %llu\n", report.input_ms_median, report.input_ms_p99,
                static_cast<unsigned long long>(report.inputs));
    return played ? 0 : 2;
}
