#include "input/stick.h"

#include <algorithm>
#include <cmath>

namespace thaum::input {
namespace {

constexpr double max_dead_zone = 0.9;
/// The turn rate at a deflection t, as a share of the full rate, is linear_part t + cubic_part t^3.
constexpr double linear_part = 0.3, cubic_part = 0.7;
constexpr double usual_curve = StickResponse{}.curve;
static_assert(usual_curve == cubic_part && turn_share(1) == 1 && turn_share(-1) == -1);

/// The deflection that gives a share of the full turn rate. A cubic t^3 + p t = q with p > 0 has one real
/// root, and its form with the hyperbolic sine loses no digits near 0 (Numerical Recipes, 5.6).
double inverse_of_turn_share(double share) {
    constexpr double p = linear_part / cubic_part;
    const double q = share / cubic_part, root = std::sqrt(p / 3);
    return 2 * root * std::sinh(std::asinh(q / (2 * root * root * root)) / 3);
}

}  // namespace

StickResponse StickResponse::checked() const {
    const StickResponse usual;
    return {std::isfinite(dead_zone) ? std::clamp(dead_zone, 0.0, max_dead_zone) : usual.dead_zone,
            std::isfinite(curve) ? std::clamp(curve, 0.0, 1.0) : usual.curve};
}

double checked_push(double push) { return std::isfinite(push) ? std::clamp(push, -1.0, 1.0) : 0.0; }

StickPosition without_dead_zone(StickPosition raw, double dead_zone) {
    const double x = checked_push(raw.x), y = checked_push(raw.y);
    const double length = std::hypot(x, y);
    if (length <= dead_zone) return {0, 0};
    const double scale = std::min((length - dead_zone) / (1 - dead_zone), 1.0) / length;
    return {x * scale, y * scale};
}

double deflection_for(double push, double curve) {
    if (curve == usual_curve) return push;
    const double x = checked_push(push);
    return std::clamp(inverse_of_turn_share(x * (1 - curve + curve * x * x)), -1.0, 1.0);
}

}  // namespace thaum::input
