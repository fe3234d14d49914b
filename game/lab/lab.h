// game/lab/lab.h: the brew alone, outside of a match, for experiments: `thaum lab --fluid`, with or without a
// window.
//
//     LabInput (ladle, pours, changed settings) -> step of 16 ms -> LabState, LabFigures
//
// A session is deterministic: the same inputs, from a person or a script, give the same bits. The lab stirs
// the match's own brew (game/brew/brew.h) with the same ladle; LabSettings adds more settings. Frame: the
// brew's, origin in the middle of the level surface. The fluid step and the surface step are independent, so
// they may run in parallel.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/jobs.h"
#include "game/brew/brew.h"

namespace thaum::game::inline lab {

inline constexpr double lab_dt = 0.016;  ///< duration of a step (s)
/// Numbers of cells from wall to wall among which a person can choose.
inline constexpr std::array lab_cells{15, 16, 24, 32, 48, 64};

/// Bowl of the lab, taken from data files or from a saved session.
struct LabBowl {
    BowlSize size{};
    double filled{};  ///< level of the brew, as a share of the bowl's height
    bool operator==(const LabBowl&) const = default;
};

/// Settings that can change during a session.
struct LabSettings {
    fluid::Solver solver = fluid::Solver::thaum;
    int cells = 32;  ///< number of cells from wall to wall, one of lab_cells
    int order = 4;   ///< order of the solver's accuracy, 2 or 4; with a solid bowl it is always 2
    /// false: a box around the bowl instead of the bowl; the solver `classic` supports only the box
    bool bowl = true;
    bool no_slip = true;    ///< true: the fluid sticks to the walls; the surface is always free
    double viscosity{};     ///< kinematic viscosity of the base fluid (m^2/s)
    double gravity = 9.81;  ///< downward acceleration (m/s^2)
    /// the ingredients that can be poured, at most fluid::max_substances
    std::vector<Ingredient> substances{};
    LabBowl room{};
};

/// Parts of the data files that the lab uses: the match's brew and its bowl.
struct LabData {
    CauldronRules rules;
    LabBowl room;
};

/// Reads assets/cauldron.toml and the arena's first bowl. The error names file, line and key.
Expected<LabData> load_lab_data(const std::filesystem::path& assets);

/// Settings with the match's first ingredients as substances, in the match's bowl.
LabSettings lab_settings(const LabData& data);

struct LabPour {
    std::size_t substance{};
    double amount{};  ///< volume poured (m^3)
    vec3 place{};     ///< centre of the poured cloud (m, brew's frame)
};

struct LabInput {
    /// Position of the ladle's end after this step (m, brew's frame); std::nullopt: the ladle is out of the
    /// brew.
    std::optional<vec3> ladle{};
    std::vector<LabPour> pours{};
    std::optional<LabSettings> change{};
    bool reset = false;  ///< true: starts again with a brew at rest without ingredients
};

struct LabState {
    CauldronRules rules;
    LabSettings settings{};
    Basin basin{};
    Brew brew{};                  ///< the fluid; its substances are those in `settings`
    std::int64_t steps{};         ///< number of steps since the start or the last reset
    std::optional<vec3> ladle{};  ///< end of the ladle after the last step (m, brew's frame)
    std::size_t last_poured{};    ///< index of the substance poured last
    double seconds() const { return lab_dt * static_cast<double>(steps); }
};

/// Results of one step.
struct LabFigures {
    fluid::StepReport fluid{};
    fluid::SpringSurfaceStep surface{};
    double cfl{};     ///< CFL number: number of cells that the fastest velocity component crosses in one step
    vec3 momentum{};  ///< volume integral of the velocity (m^4/s)
    /// Evenness of the substance that was poured last, 0 to 1: 1 minus standard deviation over mean of its
    /// density.
    double mixing{};
    std::array<double, fluid::max_substances> amounts{};  ///< amount of each substance (m^3)
    double fluid_us{}, surface_us{};  ///< computing times, which differ from run to run (us)
    double ladle_n{};                 ///< force of the brew on the ladle (N)
    std::string refused{};            ///< reason why a change of settings was rejected; empty: none
};

/// Makes a brew at rest without ingredients. The error says which setting is wrong.
Expected<LabState> make_lab(const CauldronRules& rules, const LabSettings& settings);

/// Changes the settings. The flow and the amount of each substance are carried over to the new grid and
/// solver. On error nothing changes, and the error says which setting is wrong.
Expected<void> change_lab(LabState& lab, const LabSettings& settings);

/// Computes one step of lab_dt. With `jobs` the fluid step may run on another thread, with the same result.
LabFigures step_lab(LabState& lab, const LabInput& input, Jobs& jobs);

/// Numbers about the present state of the brew. Numbers that only a step has, such as forces, are zero.
LabFigures figures_of(const LabState& lab);

}  // namespace thaum::game::inline lab
