// Flows between curved walls with known solutions, and their errors. The velocity on a cut face is the
// mean over its open part (fluid/detail/cuts.h), so it is compared with that mean.
#pragma once
#include "tests/scenes/fluid_flows.h"

namespace thaum::fluid::flows {

using Inside = std::function<bool(vec3)>;
using Exact = std::function<vec3(vec3)>;

/// The open share of a face perpendicular to an axis, and the mean of a velocity component over the open
/// part, computed from the open ones of `places` x `places` points.
struct FaceMean {
    double share{}, mean{};
};

inline FaceMean face_mean(const Inside& inside, const Exact& exact, vec3 middle, int axis, double h,
                          int places) {
    const auto at = [&](double a, double b) {
        vec3 place = middle;
        place[(axis + 1) % 3] += a * h;
        place[(axis + 2) % 3] += b * h;
        return place;
    };
    int corners = 0;
    for (const double a : {-0.5, 0.0, 0.5})
        for (const double b : {-0.5, 0.0, 0.5}) corners += inside(at(a, b)) ? 1 : 0;
    if (corners == 0) return {};
    if (corners == 9) return {1, exact(middle)[axis]};
    FaceMean result;
    for (int i = 0; i < places; ++i) {
        for (int j = 0; j < places; ++j) {
            const vec3 place = at((i + 0.5) / places - 0.5, (j + 0.5) / places - 0.5);
            if (!inside(place)) continue;
            result.share += 1;
            result.mean += exact(place)[axis];
        }
    }
    if (result.share > 0) result.mean /= result.share;
    result.share /= places * places;
    return result;
}

/// Relative L2 error of the velocities on all open faces, weighted by open area. If the mean over a face came
/// from only 8 x 8 points, it would be so inaccurate on faces with a small open part that it would cause more
/// error than the flow.
inline double faces_error(const Fluid& fluid, const Inside& inside, const Exact& exact) {
    double off = 0, of = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        each_component(fluid, axis, [&](double found, vec3 place) {
            const FaceMean face =
                face_mean(inside, exact, place, static_cast<int>(axis), fluid.lattice.h, 16);
            off += face.share * (found - face.mean) * (found - face.mean);
            of += face.share * face.mean * face.mean;
        });
    }
    return std::sqrt(off / of);
}

/// A steady flow between walls at rest, driven by a force.
struct WalledFlow {
    std::string name;
    Cells divided{1, 1, 1};  ///< divisor of n along each axis, giving the number of cells
    double viscosity{};      ///< kinematic viscosity (m^2/s)
    double end{};            ///< time of the comparison (s)
    Inside inside;
    Exact velocity;       ///< exact velocity as a function of position (m/s)
    Exact force;          ///< driving force per mass as a function of position (m/s^2)
    bool starts = false;  ///< true: starts with the exact velocity; false: at rest
};

inline Expected<Fluid> start(const WalledFlow& flow, const Scheme& scheme, int n) {
    Settings settings = settings_of(Flow{}, scheme, n);
    for (std::size_t axis = 0; axis < 3; ++axis) settings.cells[axis] = std::max(4, n / flow.divided[axis]);
    settings.viscosity = flow.viscosity;
    settings.solid = [inside = flow.inside](vec3 place) { return inside(place) ? 0.0 : 1.0; };
    auto fluid = make_fluid(settings);
    if (fluid && flow.starts)
        set_velocity(*fluid, [&](vec3 p) { return flow.inside(p) ? flow.velocity(p) : vec3(0); });
    return fluid;
}

/// Acceleration of the fluid by the driving force, on each face (m/s^2).
inline std::array<Samples, 3> forces_of(const WalledFlow& flow, const Fluid& fluid) {
    std::array<Samples, 3> result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        result[axis] = make_samples(fluid.lattice);
        each_cell(fluid.lattice, [&](int i, int j, int k, std::size_t at) {
            const vec3 place = fluid.lattice.h * (vec3(i, j, k) + fluid.place(axis));
            const int a = static_cast<int>(axis);
            const FaceMean face = face_mean(flow.inside, flow.force, place, a, fluid.lattice.h, 8);
            result[axis][at] = static_cast<float>(face.mean);
        });
    }
    return result;
}

/// Lets the driving force act on the fluid for a step of dt (s).
inline void drive(Fluid& fluid, const std::array<Samples, 3>& force, double dt) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        std::ranges::transform(force[axis], fluid.state.push[axis].begin(),
                               [dt](float f) { return static_cast<float>(dt) * f; });
    fluid.state.pushed = true;
    fluid.state.asleep = false;
}

// ---- a flow between two cylinders -------------------------------------------------------------------------

inline constexpr double couette_inner = 0.17, couette_outer = 0.43;  ///< radii of the cylinders (m)
inline constexpr double couette_viscosity = 0.01, couette_swirl = 0.01;

/// Speed around an axis along y (m/s): A r + B / r is the general steady circular flow, and a force of
/// couette_swirl / r adds a third term. The walls are at rest, so A and B are chosen to make the speed 0 on
/// both.
inline double couette_speed(double radius) {
    const auto driven = [](double r) { return -couette_swirl / (2 * couette_viscosity) * r * det::log(r); };
    const double a = couette_inner, b = couette_outer;
    const double rate = (driven(a) * a - driven(b) * b) / (b * b - a * a);
    const double constant = -driven(a) * a - rate * a * a;
    return rate * radius + constant / radius + driven(radius);
}

/// Taylor-Couette flow in a layer of 4 cells.
inline WalledFlow taylor_couette() {
    const auto off_axis = [](vec3 place) { return vec3(place.x - 0.5, 0, place.z - 0.5); };
    const auto round = [off_axis](vec3 place) {
        const vec3 off = off_axis(place);
        return vec3(-off.z, 0, off.x) / glm::length(off);
    };
    return {
        .name = "taylor_couette",
        .divided = {1, max_cells, 1},
        .viscosity = couette_viscosity,
        .end = 4,
        .inside =
            [=](vec3 place) {
                const double r = glm::length(off_axis(place));
                return r > couette_inner && r < couette_outer;
            },
        .velocity = [=](vec3 place) { return couette_speed(glm::length(off_axis(place))) * round(place); },
        .force = [=](vec3 place) { return couette_swirl / glm::length(off_axis(place)) * round(place); }};
}

// ---- a vortex beside the axis of a bowl -------------------------------------------------------------------

/// Velocity of an off-axis vortex in a bowl, 0 on the wall (m/s). In each horizontal plane it is the curl
/// along y of (1 - r^2 / R^2)^2 (1 + 1.5 x / R), scaled to a speed of about 0.2 m/s.
inline vec3 bowl_vortex_velocity(vec3 place) {
    const vec3 off = (place - bowl_centre) / bowl_radius;
    const double room = 1 - glm::dot(off, off), lean = 1 + 1.5 * off.x;
    const double by_x = -4 * off.x * room * lean + 1.5 * room * room, by_z = -4 * off.z * room * lean;
    return 0.15 * vec3(-by_z, 0, by_x);
}

/// Force that keeps the bowl's vortex steady: its own advection minus viscosity, computed by differences
/// (m/s^2).
inline vec3 bowl_vortex_force(vec3 place) {
    constexpr double d = 1e-4;
    const vec3 here = bowl_vortex_velocity(place);
    vec3 result(0);
    for (int axis = 0; axis < 3; ++axis) {
        vec3 step(0);
        step[axis] = d;
        const vec3 up = bowl_vortex_velocity(place + step), down = bowl_vortex_velocity(place - step);
        result += here[axis] * (up - down) / (2 * d) - bowl_viscosity * (up + down - 2.0 * here) / (d * d);
    }
    return result;
}

inline WalledFlow bowl_vortex() {
    return {.name = "bowl_vortex",
            .divided = {1, 2, 1},
            .viscosity = bowl_viscosity,
            .end = 1,
            .inside = [](vec3 place) { return in_bowl(place); },
            .velocity = bowl_vortex_velocity,
            .force = bowl_vortex_force,
            .starts = true};
}

// ---- a bowl along which the fluid slips -------------------------------------------------------------------

inline constexpr double slipping_turn = 1;  ///< angular speed of the fluid that slips along the bowl (rad/s)

/// Velocity of a fluid that rotates as a rigid body (m/s). Without viscosity it does so forever.
inline vec3 rigid_turn(vec3 place) { return glm::cross(vec3(0, slipping_turn, 0), place - bowl_centre); }

/// A fluid without viscosity in a bowl with a free-slip wall, which starts with rigid_turn; n must be even.
inline Expected<Fluid> slipping_bowl(int n) {
    Settings settings = settings_of(Flow{}, {Solver::thaum, 2}, n);
    put_into_bowl(settings);
    settings.no_slip_at_solids = false;
    auto fluid = make_fluid(settings);
    if (fluid) set_velocity(*fluid, rigid_turn);
    return fluid;
}

inline double turn_error(const Fluid& fluid) {
    return faces_error(
        fluid, [](vec3 place) { return in_bowl(place); }, rigid_turn);
}

// ---- the slowest swirl in a ball --------------------------------------------------------------------------

inline constexpr double swirl_radius = 0.45;  ///< radius of the ball (m)
inline constexpr double swirl_viscosity = 0.01, swirl_end = 0.5;
/// Angular speed at the centre (rad/s). So small that advection is negligible: at a hundred times this speed,
/// advection causes a cross flow of 0.0017 of the whole, which does not become smaller on finer grids.
inline constexpr double swirl_turn = 3e-5;

inline bool in_ball(vec3 place) { return glm::length(place - vec3(0.5)) < swirl_radius; }

/// Velocity of the swirl (m/s): j1(k r) sin(theta) around the y axis, with the spherical Bessel function j1
/// and the wave number k. It is 0 on the wall and decays as exp(-nu k^2 t).
inline vec3 ball_swirl(vec3 place, double time) {
    static const double wave = roots_of_tan()[0] / swirl_radius;
    const vec3 off = place - vec3(0.5);
    const double x = std::max(wave * glm::length(off), 1e-3);
    const double bessel = det::sin(x) / (x * x) - det::cos(x) / x;
    const double fade = det::exp(-swirl_viscosity * wave * wave * time);
    return glm::cross(vec3(0, 3 * swirl_turn * fade * bessel / x, 0), off);
}

/// A ball with a no-slip wall that starts with ball_swirl.
inline Expected<Fluid> swirling_ball(int n) {
    Settings settings = settings_of(Flow{}, {Solver::thaum, 2}, n);
    settings.viscosity = swirl_viscosity;
    settings.solid = [](vec3 place) { return in_ball(place) ? 0.0 : 1.0; };
    auto fluid = make_fluid(settings);
    if (fluid) set_velocity(*fluid, [](vec3 place) { return ball_swirl(place, 0); });
    return fluid;
}

/// Relative L2 error of the velocity of the swirl in a ball, at the time swirl_end.
inline double swirl_error(const Fluid& fluid) {
    return faces_error(fluid, in_ball, [](vec3 place) { return ball_swirl(place, swirl_end); });
}

// ---- errors of a flow in a bowl ---------------------------------------------------------------------------

inline double bowl_error(const Fluid& fluid, double time) {
    return faces_error(
        fluid, [](vec3 place) { return in_bowl(place); },
        [time](vec3 place) { return bowl_spin_down(place, time); });
}

/// Positions in the bowl, at least 5 % of its radius from the wall.
inline std::vector<vec3> bowl_places() {
    std::vector<vec3> result;
    Random random = random_stream(1, 0);
    while (result.size() < 128) {
        const vec3 place(random.uniform(), 0.5 * random.uniform(), random.uniform());
        if (in_bowl(place, 0.95)) result.push_back(place);
    }
    return result;
}

/// Relative L2 error at bowl_places, with linear interpolation between faces. Interpolation alone causes an
/// error of 0.036 / 0.0087 / 0.0020 at n = 16 / 32 / 64.
inline double bowl_error_between(const Fluid& fluid, double time) {
    double off = 0, of = 0;
    for (const vec3 place : bowl_places()) {
        const vec3 expected = bowl_spin_down(place, time), miss = velocity_at(fluid, place) - expected;
        off += glm::dot(miss, miss);
        of += glm::dot(expected, expected);
    }
    return std::sqrt(off / of);
}

}  // namespace thaum::fluid::flows
