// Hostile input to a fluid and the properties that must still hold; used by tests and by `thaum bench fluid
// --stress`.
//
// Each step has three parts. First, a strike applies pushes of all sizes, some of which must be refused,
// moves a ladle to another position, changes the viscosity between 0 and its maximum, and pours in
// substances. Then the fluid advances one step. Last, the result is checked.
#pragma once
#include <cmath>
#include <limits>

#include "core/text.h"
#include "tests/scenes/fluid_flows.h"

namespace thaum::fluid {

struct AttackPlan {
    double speed = 1e4;  ///< largest speed that one push gives to a cell (m/s)
    bool jumps = true;   ///< true: the viscosity jumps to another value now and then
    bool bowl = false;   ///< true: the fluid is in a hemispherical bowl instead of a box
    bool slips = false;  ///< true: the fluid slips along the bowl's wall without friction
};

/// Bound on the divergence in a bowl, where the pressure is solved iteratively.
inline constexpr double bowl_divergence = 1e-6;

/// Bounds that must hold after each step under attack, that is with hostile input.
struct AttackBounds {
    double divergence = 1e-6;  ///< largest divergence times cell size h, relative to the speed after the step
    double energy_growth = 1e-5;  ///< relative growth of energy in a step without forces
    double amount_drift = 1e-5;   ///< relative change of a substance's amount in a step
};

struct Attack {
    Fluid fluid;
    AttackPlan plan{};
    Random random{};
    /// Upper bound on the energy after the pushes and other changes before a step (m^5/s^2)
    double energy{};
    /// Amount of each substance before a step, with what was poured in (m^3)
    std::array<double, max_substances> amounts{};
    int refused{};
    std::string fault{};  ///< first violation of a bound; empty: none
    double worst_divergence{}, worst_growth{}, worst_drift{};

    bool once_in(std::uint64_t n) { return random.below(n) == 0; }
    /// Random number between 10^low and 10^high, with uniform logarithm.
    double magnitude(double low, double high) { return det::exp(random.uniform(low, high) * det::log(10)); }
};

/// Makes an attack (hostile input to a fluid, see above) in a closed box or a hemispherical bowl. Substances
/// are as dense as the base fluid, so only the strikes (the pushes and other changes before a step) add
/// energy.
inline Expected<Attack> make_attack(const flows::Scheme& scheme, int n, std::uint64_t seed,
                                    const AttackPlan& plan = {}) {
    Settings settings = flows::settings_of(flows::Flow{}, scheme, n);
    settings.substances = {Substance{.viscosity = 1e-2}, Substance{.diffusion = 1e-4}};
    if (plan.bowl) flows::put_into_bowl(settings);
    settings.no_slip_at_solids = !plan.slips;
    auto fluid = make_fluid(settings);
    if (!fluid) return fluid.error();
    return Attack{.fluid = std::move(*fluid), .plan = plan, .random = random_stream(seed, 0)};
}

/// A random number that is NaN, infinite or absurdly large.
inline double absurd_number(Attack& attack) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr std::array numbers{std::numeric_limits<double>::quiet_NaN(), infinite, -infinite, 1e300,
                                 -1e300};
    return numbers[attack.random.below(numbers.size())];
}

/// A push on the fluid with one absurd number (NaN, infinite or huge) in its position, radius or impulse.
inline Push absurd_push(Attack& attack) {
    Push result = flows::random_push(attack.fluid.settings, 1, attack.random);
    const auto which = static_cast<int>(attack.random.below(7));
    const double number = absurd_number(attack);
    if (which < 3)
        result.place[which] = number;
    else if (which < 6)
        result.impulse[which - 3] = number;
    else
        result.radius = std::isfinite(number) ? std::numeric_limits<double>::quiet_NaN() : number;
    return result;
}

/// A push on the fluid, of any size, anywhere in the box or beside it: as if by a ladle that jumps from place
/// to place.
inline Push teleported_ladle(Attack& attack) {
    const double h = attack.fluid.lattice.h;
    Push result{.radius = attack.random.uniform(0, 0.5)};
    for (int axis = 0; axis < 3; ++axis) {
        result.place[axis] = attack.random.uniform(-0.2, 1.2);
        result.impulse[axis] = attack.random.uniform(-1, 1);
    }
    result.impulse *= attack.plan.speed * h * h * h;
    return result;
}

inline void note(Attack& attack, std::string_view fault) {
    if (attack.fault.empty()) attack.fault = fault;
}

inline void push_absurdly(Attack& attack) {
    const double before = flows::energy_given(attack.fluid);
    if (push(attack.fluid, absurd_push(attack))) note(attack, "took an absurd push");
    if (flows::energy_given(attack.fluid) != before) note(attack, "an absurd push changed something");
    ++attack.refused;
}

inline void pour_something(Attack& attack) {
    const auto substance = static_cast<std::size_t>(attack.random.below(2));
    const vec3 place(attack.random.uniform(), attack.random.uniform(), attack.random.uniform());
    pour(attack.fluid, substance, place, attack.random.uniform(0, 0.3), attack.magnitude(-6, -2));
    const double before = amount(attack.fluid, substance);
    if (pour(attack.fluid, substance, place, 0.1, absurd_number(attack)) ||
        amount(attack.fluid, substance) != before)
        note(attack, "took an absurd amount");
}

inline void strike(Attack& attack) {
    auto& settings = attack.fluid.settings;
    for (auto pushes = attack.random.below(4); pushes > 0; --pushes) {
        const double speed = attack.plan.speed * attack.magnitude(-6, 0);
        push(attack.fluid, flows::random_push(settings, speed, attack.random));
    }
    if (attack.once_in(3)) push(attack.fluid, teleported_ladle(attack));
    if (attack.once_in(5)) push_absurdly(attack);
    if (attack.once_in(20)) pour_something(attack);
    if (attack.plan.jumps && attack.once_in(50))
        settings.viscosity = attack.once_in(3) ? 0 : max_viscosity * attack.magnitude(-12, 0);
    attack.energy = flows::energy_given(attack.fluid);
    for (std::size_t s = 0; s < settings.substances.size(); ++s) attack.amounts[s] = amount(attack.fluid, s);
}

inline bool all_finite(const Fluid& fluid) {
    bool result = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
        flows::each_component(fluid, axis, [&](double v, vec3) { result = result && std::isfinite(v); });
    return result;
}

inline double min_density(const Fluid& fluid, std::size_t substance) {
    return flows::densities_of(fluid, substance, [](vec3) { return 1.0; }).least;
}

inline void judge(Attack& attack, const StepReport& report, const AttackBounds& bounds) {
    const Fluid& fluid = attack.fluid;
    const auto [nx, ny, nz] = fluid.lattice.cells;
    const double growth = attack.energy > 0 ? energy(fluid) / attack.energy - 1 : 0;
    attack.worst_divergence = std::max(attack.worst_divergence, report.divergence);
    attack.worst_growth = std::max(attack.worst_growth, growth);
    if (!all_finite(fluid)) note(attack, "not finite");
    if (!(report.divergence <= bounds.divergence)) note(attack, text("divergence ", report.divergence));
    if (!(growth <= bounds.energy_growth)) note(attack, text("energy grew by ", growth));
    if (report.substeps + (report.fell_back ? 1 : 0) > max_substeps)
        note(attack, text("sub-steps ", report.substeps));
    if (report.cells > std::int64_t{nx} * ny * nz * max_substeps) note(attack, text("cells ", report.cells));
    for (std::size_t s = 0; s < fluid.settings.substances.size(); ++s) {
        const double drift = attack.amounts[s] > 0 ? std::abs(amount(fluid, s) / attack.amounts[s] - 1) : 0;
        attack.worst_drift = std::max(attack.worst_drift, drift);
        if (!(drift <= bounds.amount_drift)) note(attack, text("amount changed by ", drift));
        if (!(min_density(fluid, s) >= 0)) note(attack, "a density below zero");
    }
}

}  // namespace thaum::fluid
