// Stress test of the tick: matches of the best bots for the requested number of ticks, then the same on two
// threads at the same time, one of them with sound and tactile output. All three runs must reach the same
// states, everything must stay finite and within bounds, and memory must not grow.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <thread>

#include "core/hash.h"
#include "core/text.h"
#include "game/bots/bot_file.h"
#include "game/bots/duel.h"
#include "game/senses/senses.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

constexpr Tick usual_ticks = 10'000'000;
constexpr Tick check_interval = 1000;
constexpr Tick hash_every = 1U << 14U;
constexpr double farthest_m = 200, fastest_m_s = 250, may_grow_mib = 8;

double rss_mib() {
    std::ifstream statm("/proc/self/statm");
    double size = 0, resident = 0;
    statm >> size >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1U << 20U);
}

/// First quantity of the match that is out of bounds; empty: none.
std::string disorder(const game::Simulation& match) {
    std::string wrong;
    const auto& world = match.world();
    world.view<const game::Motion>().each([&](ecs::Entity e, const game::Motion& m) {
        if (!is_finite(m.position) || !is_finite(m.velocity) || !is_finite(m.spin))
            wrong = text("entity ", e.index, " is not finite");
        else if (glm::length(m.position) > farthest_m || glm::length(m.velocity) > fastest_m_s)
            wrong = text("entity ", e.index, " has left the arena");
    });
    world.view<const game::Health, const game::Gaze>().each([&](const game::Health& h, const game::Gaze& g) {
        if (!(h.points >= -match.data().wizard.health_cap && h.points <= match.data().wizard.health_cap))
            wrong = text("health ", h.points);
        if (!(std::abs(g.yaw) <= pi && std::abs(g.pitch) <= pi / 2))
            wrong = text("gaze ", g.yaw, " ", g.pitch);
    });
    world.view<const game::WandBelt>().each([&](const game::WandBelt& belt) {
        for (const auto& wand : match.data().wands) {
            const double energy = belt.energy[wand.stats.slot];
            if (!(energy >= 0 && energy <= wand.stats.energy_cap)) wrong = text("energy ", energy);
        }
    });
    return wrong;
}

/// First value of the sound or tactile output that is out of bounds; empty: none.
std::string disorder(const game::Senses& senses) {
    for (const auto* list : {&senses.heard().begins, &senses.heard().lasts}) {
        if (list->left_out != 0) return "a voice was left out";
        for (const auto& voice : *list)
            if (!is_finite(voice.position) || !(voice.gain >= 0 && voice.gain <= 1))
                return text("sound ", voice.sound, " has no place, or the gain ", voice.gain);
    }
    for (std::uint32_t p = 0; p < game::players; ++p) {
        double sum = 0;
        for (const float amplitude : senses.felt(p, 0).amplitude) {
            if (!(amplitude >= 0 && amplitude <= 1)) return text("a cell has the strength ", amplitude);
            sum += static_cast<double>(amplitude) * static_cast<double>(amplitude);
        }
        if (sum > 1.5 + 1e-6) return text("all cells together have the strength ", sum);
        const auto& counts = senses.counts(p, 0);
        if (counts.started + counts.merged != counts.offered) return "an effect was lost";
    }
    return {};
}

struct Course {
    std::shared_ptr<const game::MatchData> data{};
    std::filesystem::path assets{};
    std::string bot{};  ///< name of the bots' file
    Tick ticks{};
    const char* name = nullptr;  ///< name of this run in the progress lines on the screen; null: no such
                                 ///< lines
    /// Sounds and effects; null: no sound and tactile output.
    std::shared_ptr<const game::SenseData> senses{};
};

struct Soaked {
    std::uint64_t hash = 0;  ///< hash of the states at every hash_every-th tick
    std::uint64_t matches = 0, kills = 0;
    /// Number of voices (playing sounds) that began, and largest number of captions at a time.
    std::uint64_t voices = 0, lines = 0;
    /// Memory in use after a tenth of the ticks, and largest memory in use after that (MiB).
    double first_mib = 0, max_mib = 0;
    std::string fault{};
};

void count_kills(const game::Simulation& match, Soaked& soaked) {
    match.world().view<const game::Score>().each(
        [&](const game::Score& s) { soaked.kills += static_cast<std::uint64_t>(s.deaths); });
}

void look_at_memory(const Course& course, Tick tick, Soaked& soaked) {
    const double current = rss_mib();
    if (tick <= course.ticks / 10) soaked.first_mib = current;
    soaked.max_mib = std::max(soaked.max_mib, current);
    if (course.name != nullptr) {
        std::fprintf(stderr, "soak %s: %llu of %llu ticks, %llu matches, %.1f MiB\n", course.name,
                     static_cast<unsigned long long>(tick), static_cast<unsigned long long>(course.ticks),
                     static_cast<unsigned long long>(soaked.matches), current);
    }
}

/// Computes sound and tactile output of the tick; does nothing if `senses` is null. Notes the largest
/// numbers.
void follow(const game::Simulation& match, game::Senses* senses, Soaked& soaked) {
    if (senses == nullptr) return;
    senses->follow(match);
    if (match.now() % audio::frame_ticks != 0) return;
    soaked.voices += senses->heard().begins.count;
    soaked.lines = std::max<std::uint64_t>(soaked.lines, senses->lines(0).size());
    soaked.fault = disorder(*senses);
}

/// Begins the next match of the run; returns a text if that fails.
std::string begin_match(const Course& course, Soaked& soaked, std::optional<game::BotDuel>& duel,
                        std::unique_ptr<game::Senses>& senses) {
    duel.reset();
    auto made = game::make_bot_duel(course.assets, course.data, {course.bot, course.bot}, ++soaked.matches);
    if (!made) return made.error().message;
    duel.emplace(std::move(*made));
    if (!course.senses) return {};
    senses = game::Senses::create(course.senses, *course.data->presentation);
    return {};
}

Soaked soak_once(const Course& course) {
    Soaked soaked;
    std::optional<game::BotDuel> duel;
    std::unique_ptr<game::Senses> senses;
    const auto look_every = std::max<Tick>(course.ticks / 20, 1);
    for (Tick t = 0; t < course.ticks && soaked.fault.empty(); ++t) {
        if (!duel || duel->match->match().phase == game::Phase::over) {
            if (duel) count_kills(*duel->match, soaked);
            soaked.fault = begin_match(course, soaked, duel, senses);
            if (!soaked.fault.empty()) return soaked;
        }
        duel->run(1);
        follow(*duel->match, senses.get(), soaked);
        if (soaked.fault.empty() && t % check_interval == 0) soaked.fault = disorder(*duel->match);
        if (!soaked.fault.empty()) soaked.fault += text(" at tick ", t, " of match ", soaked.matches);
        if (t % hash_every == 0) soaked.hash = hash_combine(soaked.hash, duel->match->state_hash());
        if ((t + 1) % look_every == 0) look_at_memory(course, t + 1, soaked);
    }
    if (duel) {
        count_kills(*duel->match, soaked);
        soaked.hash = hash_combine(soaked.hash, duel->match->state_hash());
    }
    return soaked;
}

void add_row(const Course& course, std::int64_t threads, const Soaked& soaked, double took_s,
             Report& report) {
    report.rows.push_back({.area = "tick",
                           .name = "soak",
                           .setting = {{"threads", threads}, {"bot", course.bot}},
                           .metrics = {{"ticks", static_cast<double>(course.ticks)},
                                       {"matches", static_cast<double>(soaked.matches)},
                                       {"kills", static_cast<double>(soaked.kills)},
                                       {"voices", static_cast<double>(soaked.voices)},
                                       {"most_lines", static_cast<double>(soaked.lines)},
                                       {"us_per_tick", took_s * 1e6 / static_cast<double>(course.ticks)},
                                       {"memory_after_a_tenth_mib", soaked.first_mib},
                                       {"memory_growth_mib", soaked.max_mib - soaked.first_mib}},
                           .hash = hex(soaked.hash)});
    if (!soaked.fault.empty()) report.faults.push_back(text("soak: ", soaked.fault));
}

}  // namespace

void soak(const Options& options, Report& report) {
    Course course{
        .assets = game::find_assets(), .ticks = options.ticks.value_or(usual_ticks), .name = "alone"};
    auto data = game::load_match_data(course.assets, {});
    if (!data) return report.faults.push_back(text("soak: ", data.error().message));
    course.data = std::make_shared<const game::MatchData>(std::move(*data));
    const auto best = game::strongest_bot(course.assets);
    if (!best) return report.faults.push_back(text("soak: ", best.error().message));
    course.bot = *best;

    const auto senses = game::SenseData::load(course.assets, audio::WithSamples::no);
    if (!senses) return report.faults.push_back(text("soak: ", senses.error().message));

    Soaked alone;
    const double alone_s = 1e-6 * us_of([&] { alone = soak_once(course); });
    add_row(course, 1, alone, alone_s, report);
    if (alone.max_mib - alone.first_mib > may_grow_mib)
        report.faults.push_back(
            text("soak: memory grew by ", fixed(alone.max_mib - alone.first_mib, 1), " MiB"));

    std::array<Soaked, 2> beside;
    const double beside_s = 1e-6 * us_of([&] {
                                course.name = "one of two";
                                auto silent = course;
                                silent.name = nullptr;
                                course.senses = *senses;
                                std::jthread other([&] { beside[1] = soak_once(silent); });
                                beside[0] = soak_once(course);
                            });
    for (const auto& soaked : beside) {
        add_row(course, 2, soaked, beside_s, report);
        if (soaked.hash != alone.hash)
            report.faults.push_back("soak: two threads reached another state than one thread");
    }
}

}  // namespace thaum::bench
