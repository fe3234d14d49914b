// fluid/detail/momentum.h: rate of change of the velocity by advection, and by viscosity, on the staggered
// grid.
//
// Component q of the velocity is carried along the axis b by component T (advection). T is interpolated along
// the axis of q. q is the mean of two neighbours h apart (mean1), and of two neighbours 2 h apart (mean2):
//
//     d(T q)/db  ~  4/3 d1( (T + delta2(T) / 32) mean1 q ) - 1/3 d2( mean1(T) mean2 q )
//
// where d1, d2 and d3 are differences over h, 2 h and 3 h, and delta2 is the second difference along b. The
// error of a wave's speed is (k h)^4 / 30, that of the common form with neighbours 3 h apart (Morinishi,
// Lund, Vasilyev and Moin 1998) is 2.25 times as large. The share delta2 / 32 makes both terms fit each
// other: without it, mean1(T) would have an error of second order. With it, the factors of T are those of the
// divergence (pressure.h), 9/8 d1 - 1/8 d3.
//
// In the sum over b, the terms that multiply q itself therefore add up to half of the divergence. It is zero,
// so these terms are left out. The rest is skew-symmetric. It conserves energy whatever the divergence is
// (Verstappen and Veldman 2003), and momentum where the divergence is zero. Order 2 uses d1( T mean1 q ),
// which is the scheme of Harlow and Welch 1965.
#pragma once
#include <array>

#include "core/team.h"
#include "fluid/detail/solids.h"

namespace thaum::fluid {

/// One stage of a Runge-Kutta step, where rate(v) is the rate of change of a velocity v by advection,
/// viscosity and forces:
///
///     next = start + next_part * rate(from)
///     sum  = (first ? start : sum) + sum_part * rate(from)
struct RungeKuttaStage {
    /// Velocity at the start of this Runge-Kutta stage, with filled ghost cells.
    const std::array<Samples, 3>& from;
    const std::array<Samples, 3>& start;
    const std::array<Samples, 3>* force{};  ///< acceleration by forces; null: none (m/s^2)
    std::array<Samples, 3>* next{};         ///< velocity for the next stage; null in the last stage
    std::array<Samples, 3>& sum;
    float next_part{}, sum_part{};  ///< time by which the rate is multiplied (s)
    bool first{};
};

/// Computes the stages of Runge-Kutta steps. Made once for a lattice.
class Momentum {
public:
    /// `solids` may be null and must outlive this object.
    Momentum(const Lattice& lattice, int order, const Solids* solids);
    /// Computes one stage for the cells of `layers` that hold fluid; faces that a solid closes get 0. Not
    /// written are samples on the lattice's walls and ghosts of `sum` and `next`; fill_ghosts does that.
    /// `viscosity` is in m^2/s. Threads with different seats (numbers in a team, core/team.h) may compute
    /// different layers at the same time.
    void run_stage(const RungeKuttaStage& stage, double viscosity, Layers layers, unsigned seat);

private:
    /// Advecting velocity (which carries the momentum), interpolated; at order 4 only. One plane holds it
    /// along x, one along y, and a ring buffer of four holds it along z.
    using Planes = std::array<Samples, 6>;

    template <bool fourth, bool viscous>
    void components(const RungeKuttaStage& stage, float viscosity, Layers layers, Planes& planes);
    template <bool viscous, std::size_t axis>
    void component_of_fourth(const RungeKuttaStage& stage, float viscosity, Layers layers, Planes& planes);
    template <bool viscous, std::size_t axis>
    void component_of_second(const RungeKuttaStage& stage, float viscosity, Layers layers);
    void interpolate_between_layers(const Samples& velocity_z, std::ptrdiff_t step, int k, Planes& planes);
    void interpolate_in_layer(const std::array<Samples, 3>& velocity, std::ptrdiff_t step, int k,
                              Planes& planes);

    /// Rectangle of a layer that contains all its fluid: rows first to end - 1, `count` cells from `start`.
    struct LayerBounds {
        int first, end;
        std::ptrdiff_t start, count;
    };
    LayerBounds bounds_of_layer(int k) const;

    Lattice lattice_;
    int order_;
    const Solids* solids_;
    Rows rows_;
    std::vector<LayerBounds> layer_bounds_;         ///< the rectangle of each layer
    std::array<Planes, Team::max_threads> planes_;  ///< one for each thread, by its seat (number in the team)
};

}  // namespace thaum::fluid
