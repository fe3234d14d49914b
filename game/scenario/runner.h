// game/scenario/runner.h: runs scenarios: Lua scripts that play a match through the players' own devices, faster than
// real time, and say what a player would notice.
//
// Each scenario runs twice, from scratch, in two matches of its own. The state hashes of both must agree every 128 ticks and
// at the end, and something must have happened: a match in which nobody has moved proves nothing. What a run leaves behind:
//
//     NAME.thaumlog   the match, for `thaum replay`; not where the script set the scene itself (place, spawn, push ...)
//     NAME.TRACE.csv  for each `trace`
//     NAME.forces.csv for a scenario with a trace of forces, from there on: as of `thaum replay --forces`
//     NAME.PICTURE.png  for each `picture`, and NAME.failed.png where it failed
//     NAME.json       the result, as of `thaum scenario --json`
//
// What hands felt in such a scenario is also compared with what was kept of it (game/scenario/force_trace.h), to the bit.
//
// The verbs of the scripts stand in game/scenario/verbs.h.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "game/match/simulation.h"
#include "game/scenario/sandbox.h"

namespace thaum::game {

enum class Split : std::uint32_t { side_by_side, top_bottom };

/// What a picture function gives: rows from the top, three bytes a pixel (red, green, blue).
struct Pixels {
    int width{};
    int height{};
    std::vector<std::uint8_t> rgb;
};

/// Draws both players' views of the match as it is, and writes them as PNG to `file` unless that is empty.
using TakePicture =
    std::function<Expected<Pixels>(const Simulation& match, Split split, const std::filesystem::path& file)>;

/// All words that stand over both players' views of the match as it is.
using ReadScreen = std::function<std::vector<std::string>(const Simulation& match)>;

struct ScenarioOptions {
    std::filesystem::path assets;
    std::filesystem::path out;      ///< where files go; made when needed; empty: no files
    std::filesystem::path scripts;  ///< where scenarios are found by name
    TakePicture take_picture;       ///< null: scenarios that need pictures fail, saying so
    ReadScreen read_screen;         ///< likewise
    /// Where force traces are written; empty: they are compared with those in ../replays/forces beside the script's folder, if
    /// there is such a folder.
    std::filesystem::path keep_forces{};
    bool once{};                   ///< the second run is left out: nothing is checked between the two
    Tick most_ticks = ticks(600);  ///< of one run
    SandboxLimits limits;
    /// For tests of the runner itself: called before every tick of each run (1, 2), and may spoil the match.
    std::function<void(Simulation& match, int run)> spoil;
};

struct ScenarioResult {
    std::string name;
    bool passed = false;
    bool no_picture = false;  ///< it failed only because there is no picture function
    Tick ticks{};
    std::uint64_t hash{};            ///< of the last state
    std::string message;             ///< one line: why it failed; of a passed one a remark, or nothing
    std::string output;              ///< what it printed
    std::vector<std::string> files;  ///< names in ScenarioOptions::out
};

/// One scenario from its file.
ScenarioResult run_scenario(const std::filesystem::path& script, const ScenarioOptions& options);
/// The same from a source in memory.
ScenarioResult run_scenario_source(std::string_view source, const std::string& name,
                                   const ScenarioOptions& options);

/// Names of files (with .lua) or of scenarios in ScenarioOptions::scripts; none: all of those, by name. The error says
/// which one does not exist.
Expected<std::vector<std::filesystem::path>> find_scenarios(const std::vector<std::string>& names,
                                                            const ScenarioOptions& options);
/// As find_scenarios, and runs them; `report` is called after each.
Expected<std::vector<ScenarioResult>> run_scenarios(
    const std::vector<std::string>& names, const ScenarioOptions& options,
    const std::function<void(const ScenarioResult&)>& report = nullptr);

/// The report of `thaum scenario --json`.
std::string scenario_report(const std::vector<ScenarioResult>& results);

/// Where scenarios lie that came with these assets.
std::filesystem::path scenarios_beside(const std::filesystem::path& assets);

}  // namespace thaum::game
