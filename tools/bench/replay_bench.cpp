// Benchmarks replays: the speed of verifying a log, and the time to jump to a tick in a long one.
#include <algorithm>

#include "core/random.h"
#include "core/text.h"
#include "game/match/replay_index.h"
#include "tools/bench/areas.h"
#include "tools/bench/match_scene.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

/// The log file of a recorded duel. The destructor removes the file.
struct RecordedDuel {
    std::filesystem::path file = std::filesystem::temp_directory_path() /
                                 text("thaum-bench-", static_cast<long>(now_us()), ".thaumlog");
    double ticking_us = 0;  ///< time that the ticks took when the duel was played, including the bots (us)

    RecordedDuel() = default;
    RecordedDuel(const RecordedDuel&) = delete;
    RecordedDuel& operator=(const RecordedDuel&) = delete;
    ~RecordedDuel() {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
    }
};

Expected<void> record(Tick length, RecordedDuel& duel) {
    auto scene = heaviest_duel();
    if (!scene) return scene.error();
    auto& match = *scene->match;
    auto log = input::LogWriter::create(
        duel.file, game::log_header(match.data(), match.setup(), {"bot", "bot"}), input::WhenBehind::wait);
    if (!log) return log.error();
    for (Tick t = 0; t < length; ++t) {
        const double start = now_us();
        const auto frame = scene->next_frame();
        match.tick(frame);
        duel.ticking_us += now_us() - start;
        game::record_tick(match, frame, *log);
    }
    return game::close_log(*log, match);
}

struct Verified {
    double took_us{};  ///< time to open, replay and compare the log (us)
    double real_time_factor{};
    double ratio_to_tick{};  ///< time of the live ticks, including the bots, divided by the time of verifying
    std::size_t compared{}, mismatches{};  ///< number of hashes in the log, and number of those that differ
    double log_bytes_per_minute{};
    std::string hash;
};

/// Records a duel in a log, then verifies the log.
Expected<Verified> record_and_verify(Tick length) {
    RecordedDuel duel;
    if (auto recorded = record(length, duel); !recorded) return recorded.error();
    Verified result;
    std::error_code ignored;
    result.log_bytes_per_minute =
        static_cast<double>(std::filesystem::file_size(duel.file, ignored)) / (seconds(length) / 60.0);
    const double start = now_us();
    auto playback = game::Playback::open(duel.file, game::find_assets());
    while (playback && playback->step()) {
        if (!playback->log().hash_at(playback->match().now())) continue;
        ++result.compared;
        result.mismatches += playback->mismatch() ? 1U : 0U;
    }
    result.took_us = now_us() - start;
    if (!playback) return playback.error();
    result.real_time_factor = seconds(length) * 1e6 / result.took_us;
    result.ratio_to_tick = duel.ticking_us / result.took_us;
    result.hash = hex(playback->match().state_hash());
    return result;
}

void replay_verify(const Options& options, Report& report) {
    std::vector<double> took, factors, ratios;
    Verified last;
    std::size_t mismatches = 0;
    // Recording and verifying alternate, so that both are measured under the same load of the machine.
    for (int round = 0; round < 5; ++round) {
        auto verified = record_and_verify(options.quick ? 10'000 : 40'000);
        if (!there(verified, "replay")) return;
        mismatches += verified->mismatches;
        last = std::move(*verified);
        took.push_back(last.took_us);
        factors.push_back(last.real_time_factor);
        ratios.push_back(last.ratio_to_tick);
    }
    report.rows.push_back({.area = "replay",
                           .name = "verify",
                           .setting = {{"scene", std::string("duel")}},
                           .time_us = times(took),
                           .is_default = true,
                           .metrics = {{"real_time_factor", median(factors)},
                                       {"ratio_to_tick", median(ratios)},
                                       {"compared", static_cast<double>(last.compared)},
                                       {"mismatches", static_cast<double>(mismatches)},
                                       {"log_bytes_per_minute", last.log_bytes_per_minute}},
                           .hash = last.hash});
}

/// Jumps to ticks all over the log, forwards and backwards. Each of them has a hash in the log. Returns the
/// number of hashes that differ, or the error of a jump.
Expected<std::size_t> jump_about(game::Playback& playback, const game::ReplayIndex& index,
                                 std::vector<double>& took_us) {
    const std::atomic<bool> never{false};
    std::size_t mismatches = 0;
    Random random{1};
    for (auto& took : took_us) {
        const Tick target = hash_interval * random.below(playback.log().ticks() / hash_interval);
        const double start = now_us();
        if (auto there = game::seek(playback, index, target, never); !there) return there.error();
        took = now_us() - start;
        const auto recorded = playback.log().hash_at(target);
        const bool same = target == 0 || (recorded && recorded->state == playback.match().state_hash());
        mismatches += playback.match().now() == target && same ? 0U : 1U;
    }
    return mismatches;
}

void replay_seek(const Options& options, Report& report) {
    RecordedDuel duel;
    const Tick length = ticks(options.quick ? 30.0 : 600.0);
    if (!there(record(length, duel), "replay seek")) return;
    auto playback = game::Playback::open(duel.file, game::find_assets());
    if (!there(playback, "replay seek")) return;
    auto again = playback->open_again();
    if (!there(again, "replay seek")) return;
    const std::atomic<bool> never{false};
    game::ReplayIndex index(*playback);
    const double start = now_us();
    index.fill(std::move(*again), never);
    const double filled_us = now_us() - start;
    std::vector<double> took_us(options.quick ? 20 : 200);
    const auto mismatches = jump_about(*playback, index, took_us);
    if (!there(mismatches, "replay seek")) return;
    report.rows.push_back({.area = "replay",
                           .name = "seek",
                           .setting = {{"seconds", static_cast<std::int64_t>(seconds(length))}},
                           .time_us = times(took_us),
                           .is_default = true,
                           .metrics = {{"longest_us", *std::max_element(took_us.begin(), took_us.end())},
                                       {"index_s", 1e-6 * filled_us},
                                       {"index_mib", static_cast<double>(index.bytes()) / (1 << 20)},
                                       {"index_spacing_ticks", static_cast<double>(index.spacing())},
                                       {"compared", static_cast<double>(took_us.size())},
                                       {"mismatches", static_cast<double>(*mismatches)}},
                           .hash = hex(playback->match().state_hash())});
}

}  // namespace

void replay(const Options& options, Report& report) {
    replay_verify(options, report);
    replay_seek(options, report);
}

}  // namespace thaum::bench
