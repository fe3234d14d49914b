// game/cauldron/cauldron.h: the brew in the match. Its state stands in the World (Cauldron, BrewPage, SurfacePage); what computes
// it stands beside it, is made when the brew is first touched, and can be made anew from the World.
//
//     tick:   16 k                        16 (k + 1)
//     strokes ─┴─> a step of the fluid, a job ─┴─> pages, figures; the next step begins
//
// A step takes the strokes that were gathered before it began, and is taken exactly 16 ticks later, whatever thread it ran on. A brew
// at rest without strokes costs nothing.
#pragma once
#include <memory>

#include "core/jobs.h"
#include "game/cauldron/brew.h"
#include "game/components/cauldron.h"
#include "game/match/stage.h"

namespace thaum::game {

inline constexpr Tick fluid_period = 16;
inline constexpr Tick surface_period = 4;
inline constexpr double fluid_dt = seconds(fluid_period);
inline constexpr double surface_dt = seconds(surface_period);

/// Of a whole brew.
struct BrewFigures {
    double mixing{}, viscosity{1}, density{1}, speed{};  ///< as in Cauldron
};

/// What computes a match's brew.
struct BrewWork {
    Brew brew;
    Basin basin;
    std::vector<std::uint32_t> wet;  ///< cells in the basin, by Lattice::at
    fluid::StepReport report{};
    BrewFigures figures{};
    Jobs::Ticket step{};
};

/// The cauldron of a new round, at rest and pure; none where the match has none.
void spawn_cauldron(Stage& stage);
/// After a restore: what computes the brew, as the World says, and the step that was under way.
void rebuild_brew(Stage& stage);

/// Every tick: what moves in the surface, every 4; the fluid's steps, every 16.
void add_brew_systems(Stage& stage, ecs::Schedule& schedule);

/// Makes the brew if nobody has touched it yet. Null where the match has no cauldron. Not inside of a view.
BrewWork* touched_brew(Stage& stage);

/// Adds to what the next step of the fluid is given, to the same one's stroke where there is one; beyond what fits, momentum goes to the last place and ingredients are refused.
bool add_stroke(Cauldron& cauldron, const Stroke& stroke);
/// Gathers what a player's ladle does: places and impulses of one step become one.
void add_ladle_stroke(Cauldron& cauldron, std::uint32_t player, vec3 place, vec3 impulse, double radius);

/// m, world, of the surface at a place, where there is one; its level where it rests. Null: nobody has touched the brew.
double surface_at(const BrewWork* work, const Cauldron& cauldron, vec3 place);

/// How far from the newest state but one to the newest, 0 to 1: what is read goes from the one to the other within a step.
double share_of_step(const Cauldron& cauldron, Tick tick);

/// Velocity of the brew, m/s, world, at a tick of play; zero outside.
vec3 current_at(const ecs::World& world, const BrewWork* work, vec3 place, Tick tick);

}  // namespace thaum::game
