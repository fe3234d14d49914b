// fluid/detail/staggered.h: the solver `thaum`. One sub-step is:
//
//     four Runge-Kutta stages of momentum, forces and pressure
//       -> implicit viscosity, unless the stages include viscosity
//       -> substances
//
// Without solids, each stage ends with a direct pressure solve and is free of divergence. With solids,
// the stages use the pressure of the previous step, and only the last stage is projected (Le and Moin
// 1991). This is one iterative solve for each sub-step.
#pragma once
#include <memory>
#include <optional>

#include "fluid/detail/continuation.h"
#include "fluid/detail/momentum.h"
#include "fluid/detail/separable.h"
#include "fluid/detail/solids.h"
#include "fluid/detail/split.h"
#include "fluid/detail/sums.h"
#include "fluid/detail/transport.h"
#include "fluid/detail/viscosity.h"
#include "fluid/fluid.h"

namespace thaum::fluid {

/// Tables and scratch memory, made once for a Fluid; holds no state.
class StaggeredSolver {
public:
    StaggeredSolver(const Settings& settings, const Lattice& lattice);

    /// Advances the fluid by dt (s). `team`: threads that share the loops; null: none.
    StepReport step(const Settings& settings, State& state, double dt, Team* team);
    /// Advances only the substances by dt (s), carried by the current velocity.
    void carry_substances(const Settings& settings, State& state, double dt);
    /// Null if there are no solids inside the box.
    const Solids* solids() const { return solids_.get(); }
    /// Weights of the faces in the energy: their open shares (parts that no solid covers) if the fluid slips
    /// along solids. Null: all faces have the same weight.
    const std::array<Samples, 3>* energy_shares() const { return continuation_ ? &solids_->open() : nullptr; }
    /// Writes the ghost cells, and zeros on walls and in solids.
    void fill(const Settings& settings, std::array<Samples, 3>& velocity) const;

private:
    using Velocity = std::array<Samples, 3>;

    Split layers() const { return {*team_, lattice_.cells[2]}; }
    void fill_sides(const Settings& settings, Velocity& velocity, int depth = ghosts) const;
    void fill_sides_of(Layers layers, Velocity& velocity, int depth) const;
    void fill_lid(const Settings& settings, Velocity& velocity) const;
    bool viscosity_varies(const Settings& settings) const;
    static bool has_weight(const Settings& settings);
    double substeps_wanted(const Settings& settings, const Velocity& velocity, double dt) const;
    double plan_substeps(const Settings& settings, State& state, double left, double whole, int allowed);
    void come_to_rest(const Settings& settings, State& state, double dt, double speed) const;
    void gather_forces(const Settings& settings, const State& state, double share);
    void mix_property(const Settings& settings, const State& state, double base, double Substance::*part);
    void add_buoyancy(const Settings& settings, const State& state);
    void predict_buoyancy(const Settings& settings, const State& state, double dt);
    void add_gravity(const Settings& settings);
    void substep(const Settings& settings, State& state, double dt, double whole, StepReport& report);
    void project(Velocity& velocity);
    void solve_pressure(const Velocity& velocity);
    void end_stage(const Settings& settings, Velocity& velocity);
    void run_stage(const RungeKuttaStage& stage, double viscosity);
    const Velocity& carrying_velocity(const Settings& settings, const Velocity& velocity);
    double largest_divergence(const Velocity& velocity);
    void clear_divergence(const Settings& settings, State& state, StepReport& report);
    void end_step(const Settings& settings, State& state, double dt, StepReport& report);
    void find_pushed_rows(const State& state);
    void clear_pushes(State& state) const;
    double work_of_pushes(const State& state, const Velocity& velocity) const;
    void limit_energy(const Settings& settings, State& state, double share, double sunk, StepReport& report);
    void diffuse_velocity(const Settings& settings, const State& state, double dt);
    double transport_after_substep(const Settings& settings, State& state, double dt,
                                   int max_substeps = TransportSettings{}.max_substeps);
    double transport_substances(const Velocity& before, const Velocity& after, const Settings& settings,
                                State& state, double dt, int max_substeps = TransportSettings{}.max_substeps);
    void semi_lagrangian(const Settings& settings, State& state, double dt, double whole, StepReport& report);

    Team alone_;            ///< a team of the leader alone
    Team* team_ = &alone_;  ///< threads that share the loops of the present step
    Lattice lattice_;
    int order_;
    std::unique_ptr<Solids> solids_;
    Rows rows_;  ///< cells that hold fluid
    PressureSolver pressure_;
    /// Extends the velocity into solids for advection to read; only where the fluid slips along solids.
    std::optional<Continuation> continuation_;
    Momentum momentum_;
    Viscosity viscosity_;
    Diffusion diffusion_;
    FaceApertures face_apertures_;  ///< shares of the faces that no solid covers
    FaceFlow face_flow_;
    TransportScratch transport_;
    /// Rows in which this step's pushes (velocities to be added) are not 0.
    std::array<Rows, 3> pushed_rows_;
    VelocityNorms start_norms_{};  ///< largest values and energy of the velocity before a sub-step
    /// Largest values and energy of the current velocity, if known.
    std::optional<VelocityNorms> current_norms_;
    Velocity force_, stage_, second_stage_, sum_;
    bool has_force_ = false;            ///< true: force_ is not all zero
    bool viscosity_in_stages_ = false;  ///< true: this step's Runge-Kutta stages include viscosity
    Samples potential_, mixed_property_;
    std::vector<float> packed_;
};

}  // namespace thaum::fluid
