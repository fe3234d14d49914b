// game/scenario/runner.h: runs scenarios. A scenario is a Lua script that plays a match through the players'
// own devices, faster than real time, and checks what a player would notice.
//
// After a scenario its log is replayed. The hashes of state and forces in run and replay must agree every 128
// ticks and at the end. A scenario without a log runs twice from scratch instead. A scenario also
// fails if no action of it changed the match, because such a run proves nothing. A run leaves these files:
//
//     NAME.thaumlog     the match, for `thaum replay`; absent if the script set the scene
//     NAME.TRACE.csv    one for each `trace`
//     NAME.forces.csv   forces from the start of a force trace, in the format of `thaum replay --forces`
//     NAME.PICTURE.png  one for each `picture`; NAME.failed.png after a failure
//     NAME.json         the result, in the format of `thaum scenario --json`
//
// The forces of a scenario with a force trace are also compared exactly with the stored trace
// (game/scenario/force_trace.h).
//
// game/scenario/verbs.h lists the verbs of the scripts.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/units.h"
#include "game/scenario/sandbox.h"

namespace thaum::game::inline match {
class Simulation;
}

namespace thaum::game::inline scenario {

enum class Split : std::uint32_t { side_by_side, top_bottom };

/// A drawn picture: rows from the top, three bytes for each pixel (red, green, blue).
struct Pixels {
    int width{};
    int height{};
    std::vector<std::uint8_t> rgb;
};

/// Draws both players' views of the match's present state. Writes them as PNG to `file` unless the path is
/// empty.
using TakePicture =
    std::function<Expected<Pixels>(const Simulation& match, Split split, const std::filesystem::path& file)>;

/// Returns all words over both players' views of the match's present state.
using ReadScreen = std::function<std::vector<std::string>(const Simulation& match)>;

/// How a scenario is checked to give the same match again.
enum class SameAgain : std::uint8_t {
    unchecked,
    by_replay,      ///< the log of its match is replayed; if it has none, the script runs twice
    by_second_run,  ///< the script runs twice, bots included
};

struct ScenarioOptions {
    std::filesystem::path assets;
    std::filesystem::path out;      ///< folder for output, created when needed; empty: no files
    std::filesystem::path scripts;  ///< folder in which scenarios are found by name
    TakePicture take_picture;       ///< null: scenarios that take pictures fail with a message
    ReadScreen read_screen;         ///< null: scenarios that read the screen fail with a message
    /// Folder for writing force traces (tables of the forces on both hands). If it is empty, traces are
    /// compared with those in ../replays/forces beside the script's folder, if that folder exists.
    std::filesystem::path keep_forces{};
    SameAgain same_again = SameAgain::by_replay;
    Tick max_ticks = ticks(660);  ///< longest duration of one run
    SandboxLimits limits;
    /// Hook for tests of the runner: called before every tick of each run (1, 2). It may corrupt the match.
    std::function<void(Simulation& match, int run)> spoil;
};

struct ScenarioResult {
    std::string name;
    bool passed = false;
    bool no_picture = false;  ///< true: the only fault is that no picture function was given
    Tick ticks{};
    std::uint64_t hash{};  ///< hash of the last state of the match
    std::string message;   ///< one line: why the scenario failed, or a remark on a passed one; may be empty
    std::string output;    ///< text printed by the script
    std::vector<std::string> files;  ///< file names inside ScenarioOptions::out
};

/// Folder of the force traces (tables of the forces on both hands) to compare with or to write; empty: none.
std::filesystem::path forces_folder(const std::filesystem::path& script, const ScenarioOptions& options);

/// Runs one scenario from its file.
ScenarioResult run_scenario(const std::filesystem::path& script, const ScenarioOptions& options);
/// Runs one scenario from source text in memory.
ScenarioResult run_scenario_source(std::string_view source, const std::string& name,
                                   const ScenarioOptions& options);

/// Finds scenarios by path (ending in .lua) or by name in ScenarioOptions::scripts. An empty list selects all
/// of them, sorted by name. The error names the scenario that does not exist.
Expected<std::vector<std::filesystem::path>> find_scenarios(const std::vector<std::string>& names,
                                                            const ScenarioOptions& options);
/// Finds scenarios like find_scenarios and runs them. `report` is called after each one.
Expected<std::vector<ScenarioResult>> run_scenarios(
    const std::vector<std::string>& names, const ScenarioOptions& options,
    const std::function<void(const ScenarioResult&)>& report = nullptr);

/// Text that `thaum scenario --json` prints.
std::string scenario_report(const std::vector<ScenarioResult>& results);

/// Folder of the scenarios that belong to these assets.
std::filesystem::path scenarios_beside(const std::filesystem::path& assets);

}  // namespace thaum::game::inline scenario
