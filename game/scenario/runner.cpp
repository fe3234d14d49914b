#include "game/scenario/runner.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/file.h"
#include "core/hash.h"
#include "core/json.h"
#include "core/text.h"
#include "ecs/diff.h"
#include "game/match/playback.h"
#include "game/scenario/play.h"
#include "game/scenario/verbs.h"

namespace thaum::game::inline scenario {
namespace {

constexpr std::size_t max_source = 1U << 20U;
/// Changes below this limit happen in an arena even without any action, so they prove nothing (HP, m, rad and
/// so on).
constexpr double noticeable = 0.02;

/// Result of one run.
struct Outcome {
    bool ended = false;   ///< true if the script ran to its end
    std::string message;  ///< reason why the script did not end
    bool no_picture = false;
    bool changed = false;  ///< true if a player's action changed the match
    bool scene_set = false;
    Tick ticks{};
    std::uint64_t hash{};
    std::vector<std::uint64_t> hashes;
    std::string output;
    std::vector<std::string> files;
    Bytes saved;                        ///< saved state of the match at the requested tick
    std::optional<std::string> forces;  ///< force trace; std::nullopt for a scenario that has none
};

struct RunOptions {
    int run = 1;
    bool keeps_files = false;
    std::optional<Tick> save_at{};
};

bool is_number(const std::string& text, double& value) {
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    return end.ec == std::errc{} && end.ptr == text.data() + text.size();
}

/// True for a field that changes in every match, even without any action.
bool passes_anyway(const ecs::Difference& d) {
    if (d.component == "Match") return d.field == "played";
    // The event log changes even without any action, when players are shown recipes. It need not be compared,
    // because each action changes another component, too.
    if (d.component == "EventLog") return true;
    if (d.component == "Stance" || d.component == "Controls") return true;
    if (d.component == "HandState") return !d.field.starts_with("device") && !d.field.starts_with("kick");
    if (d.component == "Motion") return !d.field.starts_with("position");
    return false;
}

bool is_deed(const ecs::Difference& d) {
    if (passes_anyway(d)) return false;
    double a = 0;
    double b = 0;
    if (!is_number(d.a, a) || !is_number(d.b, b)) return true;
    return !(std::abs(a - b) < noticeable);
}

bool has_changed(const Play& play) {
    Bytes current;
    save_state(play, current);
    const auto found = ecs::diff(play.begun, current, 100000);
    return found && std::any_of(found->begin(), found->end(), is_deed);
}

/// Plays ticks until the script's wait is over.
Expected<void> play_on(Play& play) {
    if (!play.waits) return fail("coroutine.yield outside of a coroutine: tick() waits");
    play.waits = false;
    while (now_of(play) < play.wait_until) {
        if (now_of(play) >= play.options->max_ticks) {
            return fail(text("it takes more than ", seconds(play.options->max_ticks), " s"));
        }
        tick(play);
    }
    return {};
}

Expected<void> run_script(Sandbox& sandbox, Play& play, std::string_view source) {
    if (auto added = add_verbs(sandbox, play); !added) return added;
    if (auto started = sandbox.start(source, play.name + ".lua"); !started) return started;
    for (;;) {
        const auto progress = sandbox.resume();
        if (!progress) return progress.error();
        if (*progress == Sandbox::Progress::done) return {};
        if (auto waited = play_on(play); !waited) return waited;
    }
}

void keep_failure_picture(Play& play) {
    if (!play.keeps_files || play.options->out.empty() || !play.options->take_picture || !play.match) return;
    const auto file = play.name + ".failed.png";
    if (play.options->take_picture(*play.match, Split::side_by_side, play.options->out / file)) {
        play.files.push_back(file);
    }
}

Outcome run_once(std::string_view source, const std::string& name, const ScenarioOptions& options,
                 const RunOptions& wanted) {
    Play play;
    play.options = &options;
    play.name = name;
    play.run = wanted.run;
    play.keeps_files = wanted.keeps_files;
    play.save_at = wanted.save_at;
    Outcome outcome;
    Sandbox sandbox(options.limits);
    auto done = run_script(sandbox, play, source);
    if (done && differing_forces(play) != 0)
        done = fail("the match has computed other forces than an arm's thread had");
    outcome.ended = done.has_value();
    outcome.output = sandbox.output();
    outcome.no_picture = play.no_picture;
    outcome.scene_set = play.scene_set;
    if (play.match) {
        outcome.ticks = now_of(play);
        outcome.hash = state_hash_of(play);
        outcome.changed = has_changed(play);
        outcome.forces = force_trace_of(play);
        if (!done) keep_failure_picture(play);
        end_match(play);
        if (done && !play.write_fault.empty()) done = fail(play.write_fault);
        outcome.ended = done.has_value();
    }
    if (!done) {
        outcome.message = done.error().message;
        if (play.match) outcome.message += text(" (tick ", outcome.ticks, ")");
    }
    outcome.hashes = std::move(play.hashes);
    outcome.files = std::move(play.files);
    outcome.saved = std::move(play.saved);
    return outcome;
}

/// Returns the first tick with a state hash at which the two runs differ.
std::optional<Tick> first_difference(const Outcome& a, const Outcome& b) {
    for (std::size_t i = 0; i < std::min(a.hashes.size(), b.hashes.size()); ++i) {
        if (a.hashes[i] != b.hashes[i]) return (i + 1) * hash_interval;
    }
    if (a.ticks != b.ticks || a.hash != b.hash) return std::min(a.ticks, b.ticks);
    return std::nullopt;
}

/// Runs the scenario twice more up to this tick, and reports the field that differs.
std::string describe_difference(std::string_view source, const std::string& name,
                                const ScenarioOptions& options, Tick tick) {
    const auto one = run_once(source, name, options, {.run = 1, .save_at = tick});
    const auto two = run_once(source, name, options, {.run = 2, .save_at = tick});
    const auto found = ecs::diff(one.saved, two.saved, 1);
    if (!found || found->empty()) return {};
    const auto& d = found->front();
    return text(": ", d.component, " of entity ", d.entity, ", ", d.field, ": ", d.a, " and ", d.b);
}

std::string fault_of(const Outcome& one, const Outcome& two) {
    if (!one.ended) return one.message;
    if (one.ticks == 0) return "it has played no match";
    if (!one.changed) return "nothing has changed: nobody has moved, hit or done anything";
    if (!two.ended) return text("the second run fails, the first did not: ", two.message);
    return {};
}

/// Replays the log of a run. Returns an empty string, or the fault.
std::string fault_of_replay(const std::filesystem::path& log, const ScenarioOptions& options) {
    auto playback = Playback::open(log, options.assets);
    if (!playback) return playback.error().message;
    while (!playback->divergence() && playback->step()) {}
    if (const auto& divergence = playback->divergence())
        return text("the replay of its log differs: ", described(*divergence));
    return playback->missing_hashes();
}

/// Checks that the scenario gives the same match again. Returns an empty string, or the fault of the run or
/// of this check.
std::string fault_of_repeat(std::string_view source, const std::string& name, const ScenarioOptions& options,
                            const Outcome& one) {
    const auto log = options.out / (name + ".thaumlog");
    const bool has_log = one.ended && !one.scene_set && !options.out.empty() && std::filesystem::exists(log);
    const bool replays = options.same_again == SameAgain::by_replay && has_log;
    const bool twice = one.ended && !replays && options.same_again != SameAgain::unchecked;
    const auto two = twice ? run_once(source, name, options, {.run = 2}) : Outcome{};
    if (auto fault = fault_of(one, twice ? two : one); !fault.empty()) return fault;
    if (replays) return fault_of_replay(log, options);
    const auto differs = twice ? first_difference(one, two) : std::nullopt;
    if (!differs) return {};
    return text("tick ", *differs, ": the two runs have different states",
                describe_difference(source, name, options, *differs));
}

constexpr std::size_t max_force_trace = 1U << 20U;

/// Writes the force trace (a table of the forces on both hands), or compares it with the stored one. Returns
/// an empty string, or the fault.
std::string check_forces(const std::string& forces, const std::string& name,
                         const std::filesystem::path& folder, bool keep) {
    const auto file = folder / (name + ".csv");
    if (keep) {
        const auto written = write_text_file(file, forces);
        return written ? std::string() : written.error().message;
    }
    const auto kept = read_text_file(file, max_force_trace);
    if (!kept)
        return text("no force trace is kept: THAUM_KEEP_FORCES=", folder.string(), " thaum scenario ", name);
    const auto found = difference_of_forces(*kept, forces);
    return found.empty() ? found : text(found, " (", file.string(), ")");
}

void write_result(const ScenarioOptions& options, ScenarioResult& result) {
    if (options.out.empty()) return;
    const auto file = result.name + ".json";
    result.files.push_back(file);
    const auto written = write_text_file(options.out / file, scenario_report({result}));
    if (written) return;
    result.files.pop_back();
    // If the scenario has failed, its own message matters more than the failure to write files.
    if (result.passed) result.message = written.error().message;
    result.passed = false;
}

/// Runs a scenario from its source. `kept`: folder of the stored force traces; empty: no comparison.
ScenarioResult run_source(std::string_view source, const std::string& name, const ScenarioOptions& options,
                          const std::filesystem::path& kept) {
    std::error_code ignored;
    if (!options.out.empty()) std::filesystem::create_directories(options.out, ignored);
    auto one = run_once(source, name, options, {.run = 1, .keeps_files = true});
    ScenarioResult result{.name = name,
                          .no_picture = one.no_picture,
                          .ticks = one.ticks,
                          .hash = one.hash,
                          .message = {},
                          .output = std::move(one.output),
                          .files = std::move(one.files)};
    result.message = fault_of_repeat(source, name, options, one);
    if (result.message.empty() && one.forces && !kept.empty())
        result.message = check_forces(*one.forces, name, kept, !options.keep_forces.empty());
    result.passed = result.message.empty();
    if (result.passed && one.scene_set) result.message = "no log: the scenario has set the scene itself";
    write_result(options, result);
    return result;
}

}  // namespace

ScenarioResult run_scenario_source(std::string_view source, const std::string& name,
                                   const ScenarioOptions& options) {
    return run_source(source, name, options, {});
}

std::filesystem::path forces_folder(const std::filesystem::path& script, const ScenarioOptions& options) {
    if (!options.keep_forces.empty()) return options.keep_forces;
    const auto beside = (script.parent_path() / "../replays/forces").lexically_normal();
    std::error_code ignored;
    return std::filesystem::is_directory(beside, ignored) ? beside : std::filesystem::path();
}

ScenarioResult run_scenario(const std::filesystem::path& script, const ScenarioOptions& options) {
    const auto name = script.stem().string();
    const auto source = read_text_file(script, max_source);
    if (!source) return {.name = name, .message = source.error().message, .output = {}, .files = {}};
    return run_source(*source, name, options, forces_folder(script, options));
}

Expected<std::vector<std::filesystem::path>> find_scenarios(const std::vector<std::string>& names,
                                                            const ScenarioOptions& options) {
    namespace fs = std::filesystem;
    std::vector<fs::path> found;
    std::error_code error;
    if (names.empty()) {
        auto scripts = files_in(options.scripts, ".lua");
        if (!scripts) return scripts;
        found = std::move(*scripts);
        if (found.empty()) return fail(text("no scenarios in ", options.scripts.string()));
    }
    for (const auto& name : names) {
        const fs::path path = name.ends_with(".lua") ? fs::path(name) : options.scripts / (name + ".lua");
        if (!fs::exists(path, error)) {
            return fail(text("there is no scenario '", name, "' (", path.string(), ")",
                             near_file(name, options.scripts, ".lua")));
        }
        found.push_back(path);
    }
    return found;
}

Expected<std::vector<ScenarioResult>> run_scenarios(
    const std::vector<std::string>& names, const ScenarioOptions& options,
    const std::function<void(const ScenarioResult&)>& report) {
    const auto found = find_scenarios(names, options);
    if (!found) return found.error();
    std::vector<ScenarioResult> results;
    for (const auto& script : *found) {
        results.push_back(run_scenario(script, options));
        if (report) report(results.back());
    }
    return results;
}

std::string scenario_report(const std::vector<ScenarioResult>& results) {
    auto list = Json::array();
    for (const auto& result : results) {
        list.push_back({{"name", result.name},
                        {"passed", result.passed},
                        {"ticks", result.ticks},
                        {"hash", hex(result.hash)},
                        {"message", result.message},
                        {"files", result.files}});
    }
    const Json report{{"scenarios", list}};
    return dump(report, 1) + "\n";
}

std::filesystem::path scenarios_beside(const std::filesystem::path& assets) {
    std::error_code ignored;
    auto in_the_sources = (assets / "../tests/scenarios").lexically_normal();
    if (std::filesystem::exists(in_the_sources, ignored)) return in_the_sources;
    return assets / "scenarios";
}

}  // namespace thaum::game::inline scenario
