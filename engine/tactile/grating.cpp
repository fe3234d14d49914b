#include "tactile/grating.h"

#include <algorithm>

namespace thaum::tactile {

double height(const Grating& grating, double x) {
    return grating.amplitude * det::sin(2 * pi * x / grating.wavelength) + grating.amplitude;
}

double slope(const Grating& grating, double x) {
    return 2 * pi * grating.amplitude / grating.wavelength * det::cos(2 * pi * x / grating.wavelength);
}

vec2 normal(const Grating& grating, double x) {
    const vec2 upwards(-slope(grating, x), 1);
    return upwards / std::sqrt(glm::dot(upwards, upwards));
}

double impact_depth(const Grating& grating, vec2 p) { return p.y > 0 ? 0 : height(grating, p.x) - p.y; }

double vibration_depth(const Grating& grating, vec2 p) { return std::max(0.0, height(grating, p.x) - p.y); }

double reaction(double stiffness, double damping, double depth, double deepening) {
    if (!(depth > 0)) return 0;
    return stiffness * depth + damping * std::max(0.0, deepening);
}

}  // namespace thaum::tactile
