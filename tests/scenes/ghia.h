// Reference velocities of the lid-driven cavity on the lines through its centre. Source: Ghia, Ghia and Shin,
// "High-Re solutions for incompressible flow using the Navier-Stokes equations and a multigrid method", J.
// Comput. Phys. 48 (1982), tables I and II, for Reynolds numbers 100, 400 and 1000. The values at the walls
// are left out.
#pragma once
#include <array>

namespace thaum::fluid::flows {

struct GhiaPoint {
    double coordinate;               ///< position on the line, 0 to 1
    std::array<double, 3> velocity;  ///< velocity at Re 100, 400, 1000; the lid has speed 1 along x at y = 1
};

/// Velocity u on the line x = 0.5, as a function of y.
inline constexpr std::array ghia_u{
    GhiaPoint{0.9766, {0.84123, 0.75837, 0.65928}},    GhiaPoint{0.9688, {0.78871, 0.68439, 0.57492}},
    GhiaPoint{0.9609, {0.73722, 0.61756, 0.51117}},    GhiaPoint{0.9531, {0.68717, 0.55892, 0.46604}},
    GhiaPoint{0.8516, {0.23151, 0.29093, 0.33304}},    GhiaPoint{0.7344, {0.00332, 0.16256, 0.18719}},
    GhiaPoint{0.6172, {-0.13641, 0.02135, 0.05702}},   GhiaPoint{0.5000, {-0.20581, -0.11477, -0.06080}},
    GhiaPoint{0.4531, {-0.21090, -0.17119, -0.10648}}, GhiaPoint{0.2813, {-0.15662, -0.32726, -0.27805}},
    GhiaPoint{0.1719, {-0.10150, -0.24299, -0.38289}}, GhiaPoint{0.1016, {-0.06434, -0.14612, -0.29730}},
    GhiaPoint{0.0703, {-0.04775, -0.10338, -0.22220}}, GhiaPoint{0.0625, {-0.04192, -0.09266, -0.20196}},
    GhiaPoint{0.0547, {-0.03717, -0.08186, -0.18109}},
};

/// Velocity v on the line y = 0.5, as a function of x. At 0.9063 and Re 400 the printed value is wrong
/// (ghia_misprint).
inline constexpr std::array ghia_v{
    GhiaPoint{0.9688, {-0.05906, -0.12146, -0.21388}}, GhiaPoint{0.9609, {-0.07391, -0.15663, -0.27669}},
    GhiaPoint{0.9531, {-0.08864, -0.19254, -0.33714}}, GhiaPoint{0.9453, {-0.10313, -0.22847, -0.39188}},
    GhiaPoint{0.9063, {-0.16914, -0.23827, -0.51550}}, GhiaPoint{0.8594, {-0.22445, -0.44993, -0.42665}},
    GhiaPoint{0.8047, {-0.24533, -0.38598, -0.31966}}, GhiaPoint{0.5000, {0.05454, 0.05186, 0.02526}},
    GhiaPoint{0.2344, {0.17527, 0.30174, 0.32235}},    GhiaPoint{0.2266, {0.17507, 0.30203, 0.33075}},
    GhiaPoint{0.1563, {0.16077, 0.28124, 0.37095}},    GhiaPoint{0.0938, {0.12317, 0.22965, 0.32627}},
    GhiaPoint{0.0781, {0.10890, 0.20920, 0.30353}},    GhiaPoint{0.0703, {0.10091, 0.19713, 0.29012}},
    GhiaPoint{0.0625, {0.09233, 0.18360, 0.27485}},
};

inline constexpr double ghia_misprint = 0.9063;

}  // namespace thaum::fluid::flows
