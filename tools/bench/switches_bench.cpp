// Benchmarks the energy that switches create at the hand, in which a passive source of force begins, ends or
// jumps, for every device model and hand: the worst switch, the mean, and the largest change of force in the
// tick of a switch. A row above the bound of HAPTICS.md is a fault.
#include "core/file.h"
#include "core/text.h"
#include "game/hud/hud.h"
#include "tests/scenes/switches.h"
#include "tools/bench/areas.h"

namespace thaum::bench {
namespace {

// Largest energy (J) that one switch, at which a force begins, ends or jumps, may create; HAPTICS.md, "Energy
// and switches".
constexpr double max_per_switch = 0.02;
constexpr std::size_t max_file = 1U << 16U;
constexpr std::array device_files{"touch.toml", "omni.toml", "premium.toml", "falcon.toml", "omega3.toml"};

Expected<haptics::DeviceSpec> device_of(const char* file) {
    const auto path = game::find_assets() / "devices" / file;
    const auto source = read_text_file(path, max_file);
    if (!source) return source.error();
    const auto config = Config::parse(*source, path.string(), 1);
    if (!config) return config.error();
    return haptics::read_device(*config);
}

void add_row(const haptics::DeviceSpec& spec, const SwitchHand& hand, int switches, Report& report) {
    const SwitchRun run = random_switches(spec, hand, switches);
    const double full = spec.peak_force / spec.max_stiffness;
    double one = 0;
    for (const double stretch : {0.2 * full, full, 3 * full})
        one = worse(one, one_spring(spec, hand, stretch).most_created);
    report.rows.push_back({.area = "haptics",
                           .name = "switches",
                           .setting = {{"model", spec.name}, {"hand", std::string(hand.name)}},
                           .metrics = {{"switches", static_cast<double>(run.switches)},
                                       {"worst_j", run.most_created},
                                       {"mean_j", run.mean_created},
                                       {"one_spring_j", one},
                                       {"jump_n", run.max_jump}}});
    const double worst = worse(run.most_created, one);
    if (!(worst <= max_per_switch))
        report.faults.push_back(text("haptics switches, ", spec.name, ", hand ", hand.name,
                                     ": a switch created ", shown(worst), " J, more than ",
                                     shown(max_per_switch)));
}

}  // namespace

void switches(const Options& options, Report& report) {
    const int count = options.quick ? 100 : 500;
    for (const char* file : device_files) {
        const auto spec = device_of(file);
        if (!spec) {
            report.faults.push_back(text("haptics switches: ", spec.error().message));
            continue;
        }
        for (const SwitchHand& hand : switch_hands) add_row(*spec, hand, count, report);
    }
}

}  // namespace thaum::bench
