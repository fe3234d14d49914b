// Flows driven by heavy and light substances that fall, rise and slosh, with their energies. Used by
// the benchmark (fluid_bench.cpp) and by tests.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "tests/scenes/fluid_flows.h"
#include "tests/scenes/worse.h"

namespace thaum::fluid::flows {

// ---- heavy and light substances that fall and rise --------------------------------------------------------

/// A light lump near the floor, a heavy lump near the top, or a heavy layer with a tilted surface.
enum class Weighing : std::uint8_t { plume, settling, sloshing };
inline constexpr std::array weighings{Weighing::plume, Weighing::settling, Weighing::sloshing};
inline constexpr std::string_view name_of(Weighing weighing) {
    constexpr std::array<std::string_view, 3> names{"plume", "settling", "sloshing"};
    return names[static_cast<std::size_t>(weighing)];
}

/// How much denser the substance is than the base fluid, as a share of the base fluid's density.
inline constexpr double weighing_share = 0.3;

inline double weighing_density(Weighing weighing, vec3 place, double top) {
    if (weighing == Weighing::sloshing) return place.y < top * (0.5 + 0.4 * (place.x - 0.5)) ? 1 : 0;
    const vec3 off = place - vec3(0.52, (weighing == Weighing::plume ? 0.3 : 0.75) * top, 0.47);
    return det::exp(-glm::dot(off, off) / (2 * 0.1 * 0.1));
}

/// A fluid at rest, in a box or in the bowl, n cells across; n must be even.
inline Expected<Fluid> weighing_fluid(Weighing weighing, bool in_bowl, int n, double viscosity) {
    Settings settings = settings_of(Flow{}, {Solver::thaum, in_bowl ? 2 : 4}, n);
    settings.viscosity = viscosity;
    settings.substances = {
        Substance{.weight = weighing == Weighing::plume ? -weighing_share : weighing_share}};
    if (in_bowl) put_into_bowl(settings);
    auto fluid = make_fluid(settings);
    if (fluid)
        set_substance(*fluid, 0,
                      [&](vec3 place) { return weighing_density(weighing, place, in_bowl ? 0.5 : 1.0); });
    return fluid;
}

/// Kinetic energy (m^5/s^2), summed independently of the solver.
inline double kinetic_energy(const Fluid& fluid) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        each_component(fluid, axis, [&](double v, vec3) { sum += v * v; });
    const double h = fluid.lattice.h;
    return 0.5 * sum * h * h * h;
}

/// Potential energy relative to the origin (m^5/s^2), from the densities.
inline double potential_energy(const Fluid& fluid) {
    double sum = 0;
    const double h = fluid.lattice.h;
    each_cell(fluid.lattice, [&](int i, int j, int k, std::size_t at) {
        const double height = -glm::dot(fluid.settings.gravity, h * (vec3(i, j, k) + 0.5));
        for (std::size_t s = 0; s < fluid.state.substances.size(); ++s)
            sum += fluid.settings.substances[s].weight * height * double{fluid.state.substances[s][at]};
    });
    return sum * h * h * h;
}

/// Energy balance of a fluid that starts at rest and is driven only by differences of density.
struct EnergyBalance {
    double start{};     ///< initial potential energy (m^5/s^2)
    double released{};  ///< largest potential energy released so far (m^5/s^2)
    double excess{};    ///< largest excess of kinetic plus potential energy over the start (m^5/s^2)
    double rescaled{};  ///< kinetic energy removed by the solver in total (m^5/s^2)
};

inline EnergyBalance start_balance(const Fluid& fluid) { return {.start = potential_energy(fluid)}; }

inline void enter(const Fluid& fluid, const StepReport& report, EnergyBalance& balance) {
    const double potential = potential_energy(fluid);
    balance.released = bench::worse(balance.released, balance.start - potential);
    balance.excess = bench::worse(balance.excess, kinetic_energy(fluid) + potential - balance.start);
    balance.rescaled += report.rescaled;
}

// ---- layers of different viscosity ------------------------------------------------------------------------

/// A layer of a viscous substance below a thin one, between two plates 1 m apart. The upper plate moves at 1
/// m/s.
struct ThickLayer {
    double ratio{};      ///< ratio of the two viscosities
    double viscosity{};  ///< kinematic viscosity of the thin layer (m^2/s)

    static bool is_thick(vec3 place) { return place.y < 0.5; }
    /// Velocity of the steady flow (m/s). Both layers have the same shear stress.
    double speed(vec3 place) const {
        const double below = 1 / (1 + ratio);  // speed at the boundary of the layers (m/s)
        return is_thick(place) ? 2 * place.y * below : below + (2 * place.y - 1) * (1 - below);
    }
};

inline constexpr double thick_layer_end = 20;  ///< time of the comparison with the steady flow (s)

/// A fluid with two layers of different viscosity, initially at rest between two plates, uniform along x and
/// z; n must be even.
inline Expected<Fluid> layered_couette(const ThickLayer& layer, int n) {
    Flow flow{.fixed = {8, 0, 8}};
    flow.settings.edges = {Edge::periodic, Edge::no_slip, Edge::periodic};
    flow.settings.viscosity = layer.viscosity;
    flow.settings.lid = 1;
    flow.settings.substances = {Substance{.viscosity = (layer.ratio - 1) * layer.viscosity}};
    auto fluid = make_fluid(settings_of(flow, {Solver::thaum, 2}, n));
    if (fluid) set_substance(*fluid, 0, [](vec3 place) { return ThickLayer::is_thick(place) ? 1.0 : 0.0; });
    return fluid;
}

/// Relative L2 error of the velocity of two layers between plates, compared with the steady flow.
inline double layers_error(const Fluid& fluid, const ThickLayer& layer) {
    const auto exact = [&](vec3 place) { return vec3(layer.speed(place), 0, 0); };
    return relative_error(fluid, exact, exact);
}

/// Share of the viscous substance that has left its layer, where a perfect solver would keep all of it.
inline double crept_out(const Fluid& fluid) {
    double out = 0, all = 0;
    each_cell(fluid.lattice, [&](int, int j, int, std::size_t at) {
        const double density{fluid.state.substances[0][at]};
        all += density;
        if (!ThickLayer::is_thick(vec3(0, (j + 0.5) * fluid.lattice.h, 0))) out += density;
    });
    return out / all;
}

// ---- a flow that deforms its contents and back again ------------------------------------------------------

/// LeVeque's flow (1996): it stretches its contents into layers thinner than a cell and back again within
/// `deformation_end`.
inline constexpr double deformation_end = 3;  ///< time after which the flow has returned its contents (s)

/// Velocity of LeVeque's flow (m/s). It crosses no wall and is free of divergence on a staggered grid.
inline vec3 deformation(vec3 place, double time) {
    const vec3 once(det::sin(pi * place.x), det::sin(pi * place.y), det::sin(pi * place.z));
    const vec3 twice(det::sin(2 * pi * place.x), det::sin(2 * pi * place.y), det::sin(2 * pi * place.z));
    return det::cos(pi * time / deformation_end) * vec3(2 * once.x * once.x * twice.y * twice.z,
                                                        -twice.x * once.y * once.y * twice.z,
                                                        -twice.x * twice.y * once.z * once.z);
}

inline constexpr vec3 deformed_centre(0.35);

inline double deformed_gaussian(vec3 place) {
    const vec3 off = place - deformed_centre;
    return det::exp(-glm::dot(off, off) / (2 * 0.08 * 0.08));
}

inline double deformed_sphere(vec3 place) {
    const vec3 off = place - deformed_centre;
    return glm::dot(off, off) < 0.15 * 0.15 ? 1 : 0;
}

inline Settings deformation_settings(const Scheme& scheme, int n) {
    Settings result = settings_of(Flow{}, scheme, n);
    result.substances = {Substance{}};
    return result;
}

/// Number of steps in which the fastest component crosses at most `cfl` cells per step.
inline int steps_of_deformation(int n, double cfl) {
    return static_cast<int>(std::ceil(2 * deformation_end * n / cfl));
}

/// Sets the velocity at the middle of step `i` of `steps`.
inline void set_deformation(Fluid& fluid, int i, int steps) {
    const double time = (i + 0.5) * deformation_end / steps;
    set_velocity(fluid, [&](vec3 place) { return deformation(place, time); });
}

/// Sum of the absolute errors of the densities, divided by the sum of the exact densities (relative
/// L1).
inline double absolute_error(const Fluid& fluid, const std::function<double(vec3)>& exact) {
    double off = 0, of = 0;
    each_cell(fluid.lattice, [&](int i, int j, int k, std::size_t at) {
        const double expected = exact(fluid.lattice.h * (vec3(i, j, k) + 0.5));
        off += std::abs(double{fluid.state.substances[0][at]} - expected);
        of += expected;
    });
    return off / of;
}

/// Lowest and highest density of the first substance.
inline std::pair<double, double> range_of(const Fluid& fluid) {
    double least = 1e300, most = -1e300;
    each_cell(fluid.lattice, [&](int, int, int, std::size_t at) {
        least = std::min(least, double{fluid.state.substances[0][at]});
        most = std::max(most, double{fluid.state.substances[0][at]});
    });
    return {least, most};
}

}  // namespace thaum::fluid::flows
