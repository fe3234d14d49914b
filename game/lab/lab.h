// game/lab/lab.h: the brew alone, to be explored: `thaum lab --fluid`, in a window and without.
//
//     LabInput (ladle, what is poured, what is changed) -> step of 16 ms -> LabState, LabFigures
//
// A pure session: the same inputs give the same bits, whoever gives them. It stirs the match's own brew (game/cauldron/brew.h), by
// the same ladle; what can be set beyond that stands in LabSettings. Frame: the brew's. The fluid's and the surface's step do not
// look at each other, so they may run side by side.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/jobs.h"
#include "game/cauldron/brew.h"

namespace thaum::game {

inline constexpr double lab_dt = 0.016;  ///< s
/// Cells from wall to wall that can be chosen.
inline constexpr std::array lab_cells{15, 16, 24, 32, 48, 64};

/// What stands in the room: from the data files, or a saved one.
struct LabBowl {
    BowlSize size{};
    double filled{};  ///< of its height
    bool operator==(const LabBowl&) const = default;
};

/// What can be changed while it goes on.
struct LabSettings {
    fluid::Solver solver = fluid::Solver::thaum;
    int cells = 32;                        ///< one of lab_cells
    int order = 4;                         ///< 2 or 4; where a bowl is solid the solver takes 2
    bool bowl = true;                      ///< false: the box round it. `classic` knows the box alone
    bool no_slip = true;                   ///< at the walls; the surface never holds
    double viscosity{};                    ///< m^2/s, of the base fluid
    double gravity = 9.81;                 ///< m/s^2, down
    std::vector<Ingredient> substances{};  ///< up to fluid::substances_most
    LabBowl room{};
};

/// What the lab takes from the data files: the match's brew, and the bowl it stands in.
struct LabData {
    CauldronRules rules;
    LabBowl room;
};

/// assets/cauldron.toml and the arena's first bowl. The error names file, line and key.
Expected<LabData> load_lab_data(const std::filesystem::path& assets);

/// The first ingredients in the match's bowl.
LabSettings lab_settings(const LabData& data);

struct LabPour {
    std::size_t substance{};
    double amount{};  ///< m^3
    vec3 place{};     ///< m
};

struct LabInput {
    std::optional<vec3> ladle{};  ///< m, where its end is after this step; none: out of the brew
    std::vector<LabPour> pours{};
    std::optional<LabSettings> change{};
    bool reset = false;  ///< at rest and pure again
};

struct LabState {
    CauldronRules rules;
    LabSettings settings{};
    Basin basin{};
    Brew brew{};                  ///< its `what` counts settings.substances
    std::int64_t steps{};         ///< since the beginning, or the reset
    std::optional<vec3> ladle{};  ///< where it was after the last step
    std::size_t last_poured{};    ///< substance
    double seconds() const { return lab_dt * static_cast<double>(steps); }
};

/// What a step did.
struct LabFigures {
    fluid::StepReport fluid{};
    fluid::SheetStep surface{};
    double cfl{};     ///< cells by which the fastest component went in the whole step
    vec3 momentum{};  ///< m^4/s
    double mixing{};  ///< of the substance last poured
    std::array<double, fluid::substances_most> amounts{};  ///< m^3
    double fluid_us{}, surface_us{};                       ///< of the clock: not the same in every run
    double ladle_n{};                                      ///< N, of the brew on the ladle
    std::string refused{};                                 ///< why a change was not taken; empty: it was
};

/// At rest and pure. The error says which setting is wrong.
Expected<LabState> make_lab(const CauldronRules& rules, const LabSettings& settings);

/// The flow goes on as it was, in the new grid, by the new solver, with each substance's amount. The error says which setting is
/// wrong; then nothing changes.
Expected<void> change_lab(LabState& lab, const LabSettings& settings);

/// A step of lab_dt. With jobs the fluid's step may run on another thread, with the same result.
LabFigures step_lab(LabState& lab, const LabInput& input, Jobs& jobs);

/// The state as figures: what is not of a step is zero.
LabFigures figures_of(const LabState& lab);

}  // namespace thaum::game
