// Benchmark of haptic modes under hostile input (tests/scenes/hostile_modes.h): they must stay within the
// force limits, finite and passive. Runs briefly as a part of the benchmark, and for a million ticks as its
// stress test.
#include "core/text.h"
#include "tests/scenes/hostile_modes.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

constexpr std::uint64_t switch_every = 2000;  // ticks after which other haptic modes take over
constexpr std::array feel_names{"modes_hostile", "modes_passive", "volume_hostile"};

Row attack(HostileFeel feel, std::uint64_t ticks, std::uint32_t faults_every, std::uint64_t seed) {
    HostileFields fields(seed, faults_every);
    HostileHand hand(fields, seed, feel);
    HostileResult result;
    const double us = us_of([&] {
        while (result.ticks < ticks) {
            hand.run(std::min(switch_every, ticks - result.ticks), result);
            if (feel == HostileFeel::all) hand.choose_modes();
        }
    });
    const double mean = us / static_cast<double>(ticks);
    return {.area = "haptics",
            .name = feel_names[static_cast<std::size_t>(feel)],
            .setting = {{"faulty_samples", text(faults_every == 0 ? "none" : "one in ",
                                                faults_every == 0 ? "" : text(faults_every))},
                        {"seed", static_cast<std::int64_t>(seed)}},
            .time_us = Times{mean, mean, mean},
            .metrics = {{"ticks", static_cast<double>(result.ticks)},
                        {"not_finite", static_cast<double>(result.not_finite)},
                        {"largest_of_cap", result.largest / hand.cap()},
                        {"felt_share", result.felt / static_cast<double>(result.ticks)},
                        {"created_j", result.most_created},
                        {"observed_j", result.observed},
                        {"given_j", result.max_given},
                        {"left_out", static_cast<double>(result.left_out)}}};
}

void attack_all(std::uint64_t ticks, Report& report) {
    for (const std::uint32_t faults_every : {0U, 200U}) {
        for (const std::uint64_t seed : {1U, 2U}) {
            for (const HostileFeel feel : {HostileFeel::all, HostileFeel::passive, HostileFeel::volume})
                report.rows.push_back(attack(feel, ticks, faults_every, seed));
        }
    }
}

}  // namespace

void modes_hostile(const Options& options, Report& report) {
    attack_all(options.quick ? 5'000 : 50'000, report);
}

void haptics_stress(const Options& options, Report& report) {
    attack_all(options.ticks.value_or(1'000'000), report);
}

}  // namespace thaum::bench
