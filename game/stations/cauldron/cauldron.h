// game/stations/cauldron/cauldron.h: the brew in the match. Its state is in the World: Cauldron, BrewSamples,
// SurfaceSamples. The solver's memory is outside the World. It is made when the brew is first touched, and
// can be rebuilt from the World.
//
//     tick:   16 k                        16 (k + 1)
//     strokes ─┴─> fluid step as a job ─────┴─> samples and figures; the next step begins
//
// A step uses the strokes (pushes of the brew, and ingredients) that were queued before it began. Its result
// is the samples of the fluid and averages over them (figures). It is read exactly 16 ticks later, whichever
// threads computed it: another job thread shares the step's loops if it is free, and so does the match's own
// thread if it comes to the result too early. A brew at rest without strokes costs nothing.
#pragma once
#include <memory>

#include "core/jobs.h"
#include "core/team.h"
#include "game/brew/brew.h"
#include "game/components/cauldron.h"
#include "game/context/match_context.h"

namespace thaum::game::inline stations {

inline constexpr Tick fluid_period = 16;
inline constexpr Tick surface_period = 4;
inline constexpr double fluid_dt = seconds(fluid_period);
inline constexpr double surface_dt = seconds(surface_period);

/// Averages over the whole brew, which the component Cauldron also has.
struct BrewFigures {
    /// Evenness of the newest ingredient, share of the brew that it has reached, mean viscosity and density
    /// relative to pure brew, and mean speed of the flow (m/s).
    double mixing{}, reached{}, viscosity{1}, density{1}, speed{};
};

/// Memory of a brew's solver: fluid, surface and basin, and the results of the newest step.
struct BrewWork {
    Brew brew;
    Basin basin;
    std::vector<std::uint32_t> wet;  ///< indices of the cells inside the basin, from Lattice::at
    /// Viscosity that the rules give the pure brew, without a potion's change (m^2/s). Factor by which a
    /// potion changes the pure brew's density. Both are for this step.
    double viscosity{}, density{1};
    fluid::StepReport report{};
    BrewFigures figures{};
    Team team{};          ///< threads that share the loops of the fluid step
    Jobs::Ticket step{};  ///< the fluid step, prepared once and submitted for each step
    Jobs::Ticket help{};  ///< help of another job thread with the step
};

/// Solver of a match's brew. The simulation owns it.
struct BrewSolver {
    Jobs& jobs;                        ///< thread pool that runs the fluid steps
    std::unique_ptr<BrewWork> work{};  ///< null until a player or a thing touches the brew
    std::uint64_t bursts_seen{};  ///< number of the first event not yet searched for bursts over the brew
};

}  // namespace thaum::game::inline stations

namespace thaum::game::resource {

struct Brew {
    using Value = BrewSolver;
    static constexpr std::string_view name = "brew solver";
};

}  // namespace thaum::game::resource

namespace thaum::game::inline stations {

using BrewResource = ecs::Resource<resource::Brew>;

/// Creates the cauldron of a new round, at rest and without ingredients. Does nothing if the match has no
/// cauldron.
void spawn_cauldron(MatchContext& context, BrewSolver& solver);
/// Rebuilds the solver's memory from the World after a restore, and restarts the step that was running.
void rebuild_brew(MatchContext& context, BrewSolver& solver);

/// Adds the system for the surface (every 4 ticks) and the one for the fluid (every 16 ticks).
void add_brew_systems(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule);

/// Creates the solver's memory if there is none and the match has a cauldron. Must not be called while
/// iterating over a view of the World. Writes BrewSamples and SurfaceSamples.
void touch_brew(MatchContext& context, BrewSolver& solver);

/// Queues a stroke (a push of the brew, or an ingredient) for the next fluid step. A stroke is merged with an
/// earlier one that has the same non-zero source `by`. If the queue is full, momentum is added to the last
/// stroke, but an ingredient is rejected and the result is false.
bool add_stroke(Cauldron& cauldron, const Stroke& stroke);
/// Adds a ladle's impulse to the push that is queued for its player and the next fluid step. The whole push
/// acts at the place of the latest impulse.
void add_ladle_stroke(Cauldron& cauldron, std::uint32_t player, vec3 place, vec3 impulse, double radius);

/// Height of the brew's surface at a place (m, world). Returns the level at rest if `work` is null.
double surface_at(const BrewWork* work, const Cauldron& cauldron, vec3 place);

/// Share of the newer of the two newest fluid states in an interpolation between them. It is 0 when the newer
/// state was stored, and 1 one fluid step later.
double share_of_step(const Cauldron& cauldron, Tick tick);

/// Factors by which a potion changes the pure brew in the present fluid step.
const ChangedBrew& changes_of(const MatchData& data, const Cauldron& cauldron);

/// Velocity of the brew at a place and tick (m/s, world). Zero outside the brew.
vec3 current_at(const ecs::World& world, const BrewWork* work, vec3 place, Tick tick);

}  // namespace thaum::game::inline stations
