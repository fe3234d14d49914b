// fluid/momentum.h: how fast a flow carries its own momentum, and how viscosity spreads it, on the staggered grid.
//
// Component a, carried along b: the carrying velocity T is interpolated along a, the carried one is the plain mean of two
// neighbours h apart and of two 3 h apart (Morinishi, Lund, Vasilyev and Moin 1998),
//
//     d(T q)/db  ~  9/8 d1( T mean1 q ) - 1/8 d3( T mean3 q )
//
// Of the sum over b, what multiplies q itself is half of the divergence (pressure.h), which is zero: it is left out. What remains
// is skew-symmetric, so it conserves energy whatever the divergence is (Verstappen and Veldman 2003), and momentum where that is
// zero. Order 2 has the first term alone, and is the scheme of Harlow and Welch 1965.
#pragma once
#include <array>

#include "fluid/solids.h"

namespace thaum::fluid {

/// One stage of a Runge-Kutta step:  next = start + next_part * rate(from),  sum = (first ? start : sum) + sum_part * rate(from).
struct RungeKuttaStage {
    const std::array<Samples, 3>& from;  ///< ghosts filled
    const std::array<Samples, 3>& start;
    const std::array<Samples, 3>* force{};  ///< m/s^2; null: none
    std::array<Samples, 3>* next{};         ///< null: the last stage needs none
    std::array<Samples, 3>& sum;
    float next_part{}, sum_part{};  ///< s
    bool first{};
};

/// What a stage is computed by, made once.
class Momentum {
public:
    /// solids: null: none; must outlive this.
    Momentum(const Lattice& lattice, int order, const Solids* solids);
    /// Of all cells that hold fluid, 0 on closed faces; what stands on the lattice's walls, and in the ghosts of sum and next, is left
    /// to fill_ghosts. viscosity in m^2/s.
    void run_stage(const RungeKuttaStage& stage, double viscosity);

private:
    template <bool fourth, bool viscous>
    void components(const RungeKuttaStage& stage, float viscosity);
    template <bool fourth, bool viscous, std::size_t axis>
    void component(const RungeKuttaStage& stage, float viscosity);

    /// What holds all rows of a layer that hold fluid: rows first to end - 1, `count` cells from `start` on.
    struct LayerBounds {
        int first, end;
        std::ptrdiff_t start, count;
    };
    LayerBounds bounds_of_layer(int k) const;

    Lattice lattice_;
    int order_;
    const Solids* solids_;
    Rows rows_;
    std::vector<LayerBounds> layer_bounds_;  ///< of each layer
    std::array<Samples, 6> planes_;  ///< of the carrying velocity: along x, y, and a ring of four along z
};

}  // namespace thaum::fluid
