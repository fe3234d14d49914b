// Flows with known solutions for tests and benchmarks (fluid_bench.cpp) of the fluid.
//
// Boxes are cubes of edge length 1 m with n cells along each axis, unless a flow says otherwise.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/random.h"
#include "fluid/fluid.h"
#include "tests/scenes/ghia.h"

namespace thaum::fluid::flows {

/// Time step of the fluid in a match (s).
inline constexpr double step = 0.016;

/// A flow with a known solution.
struct Flow {
    std::string name;
    Settings settings{};  ///< all settings except solver, order, cells and h
    Cells fixed{};        ///< cells along each axis; 0: n cells, which fill 1 m
    double end{1};        ///< time of the comparison (s)
    vec3 mean{};          ///< mean velocity (m/s), not included in the norm by which errors are divided
    bool fades = false;  ///< true: the flow may decay to zero, so errors are relative to its initial velocity
    /// Exact velocity as a function of position and time (m/s)
    std::function<vec3(vec3, double)> velocity{};
};

struct Scheme {
    Solver solver = Solver::thaum;
    int order = 4;
};

inline Settings settings_of(const Flow& flow, const Scheme& scheme, int n) {
    Settings result = flow.settings;
    result.solver = scheme.solver;
    result.order = scheme.order;
    for (std::size_t axis = 0; axis < 3; ++axis)
        result.cells[axis] = flow.fixed[axis] != 0 ? flow.fixed[axis] : n;
    result.h = 1.0 / n;
    return result;
}

/// Makes the fluid at the start of the flow.
inline Expected<Fluid> start(const Flow& flow, const Scheme& scheme, int n) {
    auto fluid = make_fluid(settings_of(flow, scheme, n));
    if (fluid) set_velocity(*fluid, [&](vec3 place) { return flow.velocity(place, 0); });
    return fluid;
}

/// Calls `f` with component `axis` of each cell's velocity (m/s) and its position (m).
template <class F>
void each_component(const Fluid& fluid, std::size_t axis, F&& f) {
    const vec3 place = fluid.place(axis);
    const auto [nx, ny, nz] = fluid.lattice.cells;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                const auto at = static_cast<std::size_t>(fluid.lattice.at(i, j, k));
                f(double{fluid.state.velocity[axis][at]}, (vec3(i, j, k) + place) * fluid.lattice.h);
            }
        }
    }
}

/// Error of the velocities relative to `reference`, both in the L2 norm.
inline double relative_error(const Fluid& fluid, const std::function<vec3(vec3)>& exact,
                             const std::function<vec3(vec3)>& reference) {
    double off = 0, of = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        each_component(fluid, axis, [&](double found, vec3 place) {
            const double miss = found - exact(place)[a], against = reference(place)[a];
            off += miss * miss;
            of += against * against;
        });
    }
    return std::sqrt(off / of);
}

inline double error_at(const Flow& flow, const Fluid& fluid, double time) {
    return relative_error(
        fluid, [&](vec3 place) { return flow.velocity(place, time); },
        [&](vec3 place) { return flow.velocity(place, flow.fades ? 0 : time) - flow.mean; });
}

/// Lengths of the steps until `end` (s): whole steps, and a shorter last one if necessary.
inline std::vector<double> steps_until(double end, double dt = step) {
    std::vector<double> result(static_cast<std::size_t>(end / dt + 1e-9), dt);
    const double remaining = end - dt * static_cast<double>(result.size());
    if (remaining > 1e-9 * dt) result.push_back(remaining);
    return result;
}

// ---- vortices ---------------------------------------------------------------------------------------------

inline constexpr double vortex_viscosity = 1e-3;

/// The vortices of Taylor and Green as a sum of two plane waves of equal length: sin(k1 . x) along d1 and
/// sin(k2 . x) along d2. Any two such waves in one plane solve the momentum equation (eq. 1, FLUID.md)
/// exactly, because their vorticity is a function of their stream function. The waves decay as exp(-k^2 nu t)
/// and drift with a mean flow.
struct Waves {
    vec3 k1, k2;  ///< wave vectors (1/m)
    vec3 d1, d2;  ///< amplitudes, perpendicular to k1 and k2 in one plane (m/s)
};

inline vec3 waves_at(const Waves& waves, vec3 place, double viscosity, double time) {
    const double fade = det::exp(-glm::dot(waves.k1, waves.k1) * viscosity * time);
    return fade *
           (waves.d1 * det::sin(glm::dot(waves.k1, place)) + waves.d2 * det::sin(glm::dot(waves.k2, place)));
}

inline Flow drifting(std::string name, const Waves& waves) {
    Flow flow{.name = std::move(name), .mean = {1, 0.5, 0.25}};
    flow.settings.edges = {Edge::periodic, Edge::periodic, Edge::periodic};
    flow.settings.viscosity = vortex_viscosity;
    flow.velocity = [waves, mean = flow.mean](vec3 place, double time) {
        return mean + waves_at(waves, place - mean * time, vortex_viscosity, time);
    };
    return flow;
}

/// Taylor-Green vortices on a mean flow: u = sin 2 pi x cos 2 pi y, v = -cos 2 pi x sin 2 pi y.
inline Flow taylor_green_moving() {
    return drifting("taylor_green_moving", {.k1 = 2 * pi * vec3(1, 1, 0),
                                            .k2 = 2 * pi * vec3(1, -1, 0),
                                            .d1 = {0.5, -0.5, 0},
                                            .d2 = {0.5, 0.5, 0}});
}

/// Waves of the same length and speed in the plane perpendicular to (-1, 1, 1), so that all components and
/// directions of the grid take part. Waves at right angles would need a period of 3 m, or half the wavelength
/// in the same box, and would not be comparable. These waves cross at 60 degrees. For this pair, the mean
/// flow crosses the waves about as fast as the straight vortices (root mean square of k . mean / 2 pi: 1.08
/// and 1.12 per s).
inline Flow taylor_green_oblique() {
    const vec3 across = vec3(-1, 1, 1) / std::sqrt(3.0);
    const vec3 a(1, 1, 0), b(0, 1, -1);
    return drifting("taylor_green_oblique", {.k1 = 2 * pi * a,
                                             .k2 = 2 * pi * b,
                                             .d1 = 0.5 * glm::cross(across, a),
                                             .d2 = 0.5 * glm::cross(across, b)});
}

/// The vortex u = sin pi x cos pi y, v = -cos pi x sin pi y between free-slip walls, where x is the axis
/// `first` and y the next one.
inline Flow taylor_green_box(int first) {
    Flow flow{.name = "taylor_green_box"};
    flow.settings.viscosity = vortex_viscosity;
    flow.velocity = [first](vec3 place, double time) {
        const int a = first, b = (first + 1) % 3;
        const double fade = det::exp(-2 * pi * pi * vortex_viscosity * time);
        vec3 result{};
        result[a] = fade * det::sin(pi * place[a]) * det::cos(pi * place[b]);
        result[b] = -fade * det::cos(pi * place[a]) * det::sin(pi * place[b]);
        return result;
    };
    return flow;
}

// ---- flows with walls and viscosity -----------------------------------------------------------------------

/// Flow between two plates 1 m apart. The upper plate moves at 1 m/s from the start. Uniform along x
/// and z.
inline Flow couette_start() {
    Flow flow{.name = "couette_start", .fixed = {4, 0, 4}, .end = 0.32};
    flow.settings.edges = {Edge::periodic, Edge::no_slip, Edge::periodic};
    flow.settings.viscosity = 0.1;
    flow.settings.lid = 1;
    flow.velocity = [nu = flow.settings.viscosity](vec3 place, double time) {
        if (time <= 0) return vec3(0);
        double u = place.y;
        for (int m = 1; m <= 200; ++m) {
            const double fade = det::exp(-(m * pi) * (m * pi) * nu * time);
            if (fade < 1e-18) break;
            u += (m % 2 == 0 ? 2 : -2) / (m * pi) * fade * det::sin(m * pi * place.y);
        }
        return vec3(u, 0, 0);
    };
    return flow;
}

/// The vortex in the box, in a fluid so viscous that one step may stop it completely: nu dt / h^2 = `ratio`.
inline Flow high_viscosity(double ratio, int n) {
    Flow flow = taylor_green_box(0);
    flow.name = "high_viscosity";
    flow.end = 8 * step;
    flow.fades = true;
    flow.settings.viscosity = ratio / (step * n * n);
    flow.velocity = [nu = flow.settings.viscosity](vec3 place, double time) {
        const double fade = det::exp(std::max(-2 * pi * pi * nu * time, -700.0));
        return fade * vec3(det::sin(pi * place.x) * det::cos(pi * place.y),
                           -det::cos(pi * place.x) * det::sin(pi * place.y), 0);
    };
    return flow;
}

// ---- the double shear layer -------------------------------------------------------------------------------

/// Two thin layers between streams in opposite directions, which roll up (Minion and Brown 1997). The box is
/// one cell deep. Only the velocity at the start is known.
inline Flow double_shear() {
    Flow flow{.name = "double_shear", .fixed = {0, 0, 1}};
    flow.settings.edges = {Edge::periodic, Edge::periodic, Edge::periodic};
    flow.settings.viscosity = 1e-4;
    flow.velocity = [](vec3 place, double) {
        const double from_layer = place.y <= 0.5 ? place.y - 0.25 : 0.75 - place.y;
        const double growth = det::exp(60 * from_layer);
        return vec3((growth - 1) / (growth + 1), 0.05 * det::sin(2 * pi * place.x), 0);
    };
    return flow;
}

/// The end of double_shear on a grid three times as fine as n, so that each coarse face coincides with a fine
/// one. With the full time step, the fine grid would need more sub-steps than allowed.
inline Expected<Fluid> finer_double_shear(int n) {
    const Flow flow = double_shear();
    auto fluid = start(flow, {Solver::thaum, 4}, 3 * n);
    if (fluid)
        for (const double dt : steps_until(flow.end, step / 2)) advance(*fluid, dt);
    return fluid;
}

/// Relative L2 error of a double shear layer at its end, compared with the same flow on a finer grid
/// (finer_double_shear).
inline double shear_error(const Fluid& fluid, const Fluid& finer) {
    const auto reference = [&](std::size_t axis, vec3 place) {
        const vec3 cell = place / finer.lattice.h - finer.place(axis);
        const auto at =
            finer.lattice.at(static_cast<int>(std::lround(cell.x)), static_cast<int>(std::lround(cell.y)), 0);
        return double{finer.state.velocity[axis][static_cast<std::size_t>(at)]};
    };
    double off = 0, of = 0;
    for (std::size_t axis = 0; axis < 2; ++axis)
        each_component(fluid, axis, [&](double found, vec3 place) {
            const double exact = reference(axis, place), miss = found - exact;
            off += miss * miss;
            of += exact * exact;
        });
    return std::sqrt(off / of);
}

// ---- the cavity with a moving lid -------------------------------------------------------------------------

/// Reynolds numbers of ghia.h for a square cavity of 1 m, one cell deep, with a lid that moves at 1
/// m/s.
inline constexpr std::array<double, 3> cavity_reynolds{100, 400, 1000};
inline Flow cavity_2d(std::size_t which) {
    Flow flow{.name = "cavity_2d", .fixed = {0, 0, 1}};
    flow.settings.edges = {Edge::no_slip, Edge::no_slip, Edge::periodic};
    flow.settings.viscosity = 1 / cavity_reynolds[which];
    flow.settings.lid = 1;
    flow.velocity = [](vec3, double) { return vec3(0); };
    return flow;
}

/// Cubic interpolation through the four nearest values. `places` (positions) must be increasing.
inline double cubic_between(const std::vector<double>& places, const std::vector<double>& values,
                            double place) {
    const auto above = std::ranges::upper_bound(places, place) - places.begin();
    const auto most = std::max<std::ptrdiff_t>(std::ssize(places) - 4, 0);
    const auto low = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 2, 0, most));
    const auto end = std::min(low + 4, places.size());
    double result = 0;
    for (auto i = low; i < end; ++i) {
        double weight = 1;
        for (auto j = low; j < end; ++j) {
            if (j != i) weight *= (place - places[j]) / (places[i] - places[j]);
        }
        result += weight * values[i];
    }
    return result;
}

/// Component `axis` of a cavity's velocity on a line along axis `along` (both 0 or 1) at the position
/// `across` on the other axis, including the walls.
struct Profile {
    std::vector<double> places, values;
};

/// Adds the values at the two walls. If the values lie on faces, the first one already is at the lower wall.
inline Profile with_walls(const Profile& row, double low, double high) {
    Profile result = row;
    if (result.places.front() > 1e-9) {
        result.places.insert(result.places.begin(), 0.0);
        result.values.insert(result.values.begin(), low);
    }
    result.places.push_back(1);
    result.values.push_back(high);
    return result;
}

inline Profile cavity_profile(const Fluid& fluid, std::size_t axis, std::size_t along, double across) {
    const std::size_t other = 1 - along;
    const vec3 stands = fluid.place(axis);
    const auto lid = [&](std::size_t through) {
        return axis == 0 && through == 1 ? fluid.settings.lid : 0.0;
    };
    Profile result;
    for (int i = 0; i < fluid.lattice.cells[along]; ++i) {
        Profile row;
        for (int j = 0; j < fluid.lattice.cells[other]; ++j) {
            Cells cell{};
            cell[along] = i;
            cell[other] = j;
            const auto at = static_cast<std::size_t>(fluid.lattice.at(cell[0], cell[1], 0));
            row.places.push_back((j + stands[static_cast<int>(other)]) * fluid.lattice.h);
            row.values.push_back(double{fluid.state.velocity[axis][at]});
        }
        row = with_walls(row, 0, lid(other));
        result.places.push_back((i + stands[static_cast<int>(along)]) * fluid.lattice.h);
        result.values.push_back(cubic_between(row.places, row.values, across));
    }
    return with_walls(result, 0, lid(along));
}

/// Root mean square error of a cavity's velocity against Ghia's tables (m/s).
inline double cavity_error(const Fluid& fluid, std::size_t which) {
    const Profile u = cavity_profile(fluid, 0, 1, 0.5), v = cavity_profile(fluid, 1, 0, 0.5);
    double squares = 0;
    int points = 0;
    const auto add = [&](const Profile& profile, const GhiaPoint& point) {
        const double off =
            cubic_between(profile.places, profile.values, point.coordinate) - point.velocity[which];
        squares += off * off;
        ++points;
    };
    for (const GhiaPoint& point : ghia_u) add(u, point);
    for (const GhiaPoint& point : ghia_v) {
        if (cavity_reynolds[which] != 400 || point.coordinate != ghia_misprint) add(v, point);
    }
    return std::sqrt(squares / points);
}

// ---- transport of substances by a rotation ----------------------------------------------------------------

/// Velocity of a rotation in 1 s about the axis (0.5, 0.5, z). The box is periodic, so that each row carries
/// as much out as in. Each component is constant along its own direction, so the divergence is zero on any
/// grid.
inline vec3 turning(vec3 place) { return 2 * pi * vec3(0.5 - place.y, place.x - 0.5, 0); }
/// Radius around the axis within which everything stays in the box as it rotates (m).
inline constexpr double turn_radius = 0.5;
/// Radius within which nothing was ever near the edge of the box (m). At the edge the tail of the Gaussian,
/// 0.04 high, is cut off, and any scheme spreads this cut over a few cells.
inline constexpr double inner_radius = 0.4;

inline Settings turning_settings(const Scheme& scheme, int n) {
    Settings result;
    result.solver = scheme.solver;
    result.order = scheme.order;
    result.cells = {n, n, n};
    result.h = 1.0 / n;
    result.edges = {Edge::periodic, Edge::periodic, Edge::periodic};
    result.substances = {Substance{}};
    return result;
}

/// Number of steps of one revolution in which the fastest component, at the edge of the box, crosses at most
/// `cfl` cells per step.
inline int steps_of_turn(int n, double cfl) { return static_cast<int>(std::ceil(pi * n / cfl)); }

inline double gaussian(vec3 place) {
    const vec3 off = place - vec3(0.5, 0.75, 0.5);
    return det::exp(-glm::dot(off, off) / (2 * 0.1 * 0.1));
}

/// Sphere of radius 0.15 m with a slot 0.05 m wide, cut 0.25 m deep from the side that faces the axis
/// (Enright, Fedkiw, Ferziger and Mitchell 2002, scaled).
inline double slotted_sphere(vec3 place) {
    const vec3 off = place - vec3(0.5, 0.75, 0.5);
    const bool slot = std::abs(off.x) < 0.025 && off.y < 0.1;
    return glm::dot(off, off) < 0.15 * 0.15 && !slot ? 1 : 0;
}

struct Densities {
    double error{};  ///< relative L2 error within a given radius of the axis
    double least{}, most{};
};

inline Densities densities_of(const Fluid& fluid, std::size_t substance,
                              const std::function<double(vec3)>& exact, double radius = turn_radius) {
    Densities result{.least = 1e300, .most = -1e300};
    double off = 0, of = 0;
    const auto [nx, ny, nz] = fluid.lattice.cells;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                const double found = double{
                    fluid.state.substances[substance][static_cast<std::size_t>(fluid.lattice.at(i, j, k))]};
                const vec3 place = (vec3(i, j, k) + 0.5) * fluid.lattice.h;
                result.least = std::min(result.least, found);
                result.most = std::max(result.most, found);
                if (std::hypot(place.x - 0.5, place.y - 0.5) > radius) continue;
                const double expected = exact(place);
                off += (found - expected) * (found - expected);
                of += expected * expected;
            }
        }
    }
    result.error = std::sqrt(off / of);
    return result;
}

// ---- a rotation that a bowl's wall slows down -------------------------------------------------------------

/// Radius of the bowl: half a ball, open at the top along y, in a box half as high as wide.
inline constexpr double bowl_radius = 0.46;  ///< radius of the bowl (m)
inline constexpr double bowl_viscosity = 0.01, bowl_end = 1;
/// Initial angular speed (rad/s), so small that advection is negligible. The fluid rotates, and the wall
/// slows it down.
inline constexpr double bowl_turn = 0.005;
inline const vec3 bowl_centre(0.5);

inline bool in_bowl(vec3 place, double part = 1) {
    return glm::length(place - bowl_centre) < part * bowl_radius;
}

inline double solid_beyond_bowl(vec3 place) { return in_bowl(place) ? 0 : 1; }

/// Halves the height of a box of n x n x n cells, n even, and makes everything outside of the bowl solid.
inline void put_into_bowl(Settings& settings) {
    settings.cells[1] /= 2;
    settings.solid = solid_beyond_bowl;
}

/// A fluid in a bowl that initially rotates as a rigid body, with a no-slip wall; n must be even.
inline Expected<Fluid> turning_bowl(const Scheme& scheme, int n) {
    Settings settings = settings_of(Flow{}, scheme, n);
    put_into_bowl(settings);
    settings.viscosity = bowl_viscosity;
    auto fluid = make_fluid(settings);
    if (fluid)
        set_velocity(*fluid, [](vec3 p) { return glm::cross(vec3(0, bowl_turn, 0), p - bowl_centre); });
    return fluid;
}

/// The first positive solutions of tan x = x.
inline std::array<double, 40> roots_of_tan() {
    std::array<double, 40> result{};
    for (std::size_t m = 0; m < result.size(); ++m) {
        const double turns = static_cast<double>(m + 1) * pi;
        result[m] = turns + 0.5 * pi;
        for (int i = 0; i < 30; ++i) result[m] = turns + det::atan2(result[m], 1);
    }
    return result;
}

/// Velocity of the spin-down (m/s). The same as in a ball, of which the bowl is half: a sum over spherical
/// Bessel functions j1 that are zero on the wall.
inline vec3 bowl_spin_down(vec3 place, double time) {
    const vec3 off = place - bowl_centre;
    const double part = glm::length(off) / bowl_radius;
    static const std::array<double, 40> roots = roots_of_tan();
    double speed = 0;  // speed divided by the distance from the axis (1/s)
    for (const double root : roots) {
        const double fade = det::exp(-root * root * bowl_viscosity * time / (bowl_radius * bowl_radius));
        const double x = std::max(root * part, 1e-3);
        const double bessel = det::sin(x) / (x * x) - det::cos(x) / x;
        speed -= 2 / det::sin(root) * bessel * fade / (x / root);
    }
    return glm::cross(vec3(0, bowl_turn * speed, 0), off);
}

// ---- a cauldron with three substances ---------------------------------------------------------------------

/// 1 in the solid part of the cauldron, 0 elsewhere: a hemisphere below a cylinder that is open at the top,
/// in the unit box.
inline double cauldron(vec3 place) {
    vec3 apart = place - vec3(0.5);
    if (place.y > 0.5) apart.y = 0;
    return glm::length(apart) > 0.49 ? 1 : 0;
}

/// A cauldron with three substances, the first a hundred times as viscous as the base fluid; or a box
/// without substances for comparison.
inline Expected<Fluid> brew(int n, bool in_cauldron = true) {
    Settings settings{.cells = {n, n, n},
                      .h = 1.0 / n,
                      .edges = {Edge::no_slip, Edge::free_slip, Edge::no_slip},
                      .viscosity = 1e-3};
    if (in_cauldron) {
        settings.substances = {Substance{.viscosity = 0.1, .weight = 0.02}, Substance{.weight = -0.02},
                               Substance{.viscosity = 1e-3, .weight = 0.01}};
        settings.solid = cauldron;
    }
    auto fluid = make_fluid(settings);
    if (fluid && in_cauldron)
        for (std::size_t s = 0; s < 3; ++s)
            pour(*fluid, s, {0.3 + 0.2 * static_cast<double>(s), 0.4, 0.5}, 0.2, 0.01);
    return fluid;
}

/// Pushes by two ladles on opposite sides, each making a third of a revolution in a second.
inline void stir(Fluid& fluid, int steps_before) {
    const double angle = 2 * pi / 3 * step * steps_before;
    const vec3 out(det::cos(angle), 0, det::sin(angle)), along(-out.z, 0, out.x);
    for (const double side : {1.0, -1.0})
        push(fluid, {vec3(0.5) + 0.25 * side * out, 0.1, 1e-4 * side * along});
}

// ---- layers at rest, and random pushes --------------------------------------------------------------------

/// Three substances in layers, heavier ones below, which must stay at rest.
inline Expected<Fluid> resting(const Scheme& scheme, int n) {
    Settings settings = settings_of(Flow{}, scheme, n);
    settings.viscosity = 1e-3;
    settings.substances = {Substance{.viscosity = 1e-2, .weight = 0.5}, Substance{.weight = -0.3},
                           Substance{.viscosity = 1e-3, .weight = 0.1}};
    auto fluid = make_fluid(settings);
    if (!fluid) return fluid;
    set_substance(*fluid, 0, [](vec3 place) { return det::exp(-4 * place.y); });
    set_substance(*fluid, 1, [](vec3 place) { return place.y * place.y; });
    set_substance(*fluid, 2, [](vec3 place) { return 1 - place.y; });
    return fluid;
}

/// Upper bound on the energy after a step, from the current velocity and the queued pushes (m^5/s^2). Assumes
/// that speeds add up.
inline double energy_given(const Fluid& fluid) {
    double pushes = 0;
    for (const Samples& push : fluid.state.push) {
        for (const float p : push) pushes += double{p} * double{p};
    }
    const double h = fluid.lattice.h;
    const double root = std::sqrt(energy(fluid)) + std::sqrt(0.5 * pushes * h * h * h);
    return root * root;
}

/// A push in a random direction that gives a cell up to `speed` (m/s).
inline Push random_push(const Settings& settings, double speed, Random& random) {
    Push result{.radius = settings.h};
    for (int axis = 0; axis < 3; ++axis) {
        const auto n = static_cast<std::uint64_t>(settings.cells[static_cast<std::size_t>(axis)]);
        result.place[axis] = (static_cast<double>(random.below(n)) + 0.5) * settings.h;
        result.impulse[axis] = random.uniform(-1, 1);
    }
    result.impulse = limited(result.impulse, 1) * (speed * settings.h * settings.h * settings.h);
    return result;
}

}  // namespace thaum::fluid::flows
