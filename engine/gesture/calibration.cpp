#include "gesture/calibration.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/maths.h"

namespace thaum::gesture {
namespace {

constexpr double min_distance = 1e-4;
constexpr double max_margin = 2;
constexpr std::size_t unknowns = 4;
constexpr int newton_steps = 30;
/// Factor of the penalty on the squared weights of the logistic function. Without it, samples that a plane
/// separates (strokes that were meant on one side, all others on the other side) would give infinite weights.
constexpr double ridge = 0.05;

// Constants of probability_on_purpose. Of all values that were tried on a grid, these give the least mean
// error on four data sets: letters of one writer, mouse gestures of ten users, and flat shapes and spells of
// generated users. None of the sets becomes worse by more than chance.
/// Weight, in the log odds, of the logarithm of the ratio of a stroke's distances from the second nearest and
/// from the nearest gesture.
constexpr double margin_weight = 17;
/// Distance that two strokes of the same gesture often have. It is added to the distances from both gestures
/// before their ratio is taken, because the ratio of smaller distances tells little.
constexpr double common_distance = 0.15;
/// Share of the strokes drawn on purpose that are meant as no gesture.
constexpr double meant_nothing = 0.006;
/// Share of the strokes that resemble no gesture but are meant as one, by users who draw the gesture
/// differently from its templates.
constexpr double drawn_otherwise = 0.3;

using Vector = std::array<double, unknowns>;
using Matrix = std::array<Vector, unknowns>;

Vector terms_of(const Evidence& e) { return {1, e.distance, e.margin, e.usual}; }

double logistic(double x) { return 1 / (1 + det::exp(-std::clamp(x, -40.0, 40.0))); }

double product(const Vector& a, const Vector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < unknowns; ++i) sum += a[i] * b[i];
    return sum;
}

/// Solves a symmetric positive definite system by elimination without pivoting.
Vector solved(Matrix m, Vector right) {
    for (std::size_t i = 0; i < unknowns; ++i) {
        for (std::size_t k = i + 1; k < unknowns; ++k) {
            const double factor = m[k][i] / m[i][i];
            for (std::size_t c = i; c < unknowns; ++c) m[k][c] -= factor * m[i][c];
            right[k] -= factor * right[i];
        }
    }
    for (std::size_t i = unknowns; i-- > 0;) {
        for (std::size_t c = i + 1; c < unknowns; ++c) right[i] -= m[i][c] * right[c];
        right[i] /= m[i][i];
    }
    return right;
}

/// Step by which Newton's method changes the weights towards the largest penalised likelihood.
Vector step_of(std::span<const LabelledEvidence> samples, const Vector& weights) {
    Matrix curvature{};
    Vector slope{};
    for (std::size_t i = 0; i < unknowns; ++i) {
        const double penalty = i == 0 ? 1e-6 : ridge;
        curvature[i][i] = penalty;
        slope[i] = -penalty * weights[i];
    }
    for (const auto& s : samples) {
        const auto x = terms_of(s.evidence);
        const double p = logistic(product(weights, x));
        const double error = s.weight * ((s.meant ? 1.0 : 0.0) - p), width = s.weight * (p * (1 - p) + 1e-9);
        for (std::size_t i = 0; i < unknowns; ++i) {
            slope[i] += error * x[i];
            for (std::size_t k = 0; k < unknowns; ++k) curvature[i][k] += width * x[i] * x[k];
        }
    }
    return solved(curvature, slope);
}

}  // namespace

Evidence evidence_of(float distance, float runner_up, float usual) {
    const double near = std::max(static_cast<double>(distance), min_distance);
    const double other = std::max(static_cast<double>(runner_up), near);
    return {det::log(near), std::min(det::log(other / near), max_margin),
            det::log(std::max(static_cast<double>(usual), min_distance))};
}

double Calibration::probability(const Evidence& evidence) const {
    return logistic(product(weights, terms_of(evidence)));
}

double probability_on_purpose(float distance, float runner_up, double even) {
    const double near = static_cast<double>(distance), other = std::max(static_cast<double>(runner_up), near);
    const double margin = det::log((other + common_distance) / (near + common_distance));
    // The odds are squared. Strokes of a real user scatter less than the synthetic strokes to which `even`
    // was fitted, so for them the odds that `even` gives are too close to 1.
    const double meant = even * even, nothing = meant_nothing * (1 - even);
    const double usual = meant / (meant + nothing * nothing);
    return (drawn_otherwise + (1 - drawn_otherwise) * usual) * logistic(margin_weight * margin);
}

std::array<double, 4> fit_weights(std::span<const LabelledEvidence> samples) {
    Vector weights{};
    for (int i = 0; i < newton_steps; ++i) {
        auto step = step_of(samples, weights);
        double size = 0;
        for (const double s : step) size = std::max(size, std::abs(s));
        const double by = size > 4 ? 4 / size : 1;  // below 1 for the first steps, which would overshoot
        for (std::size_t k = 0; k < unknowns; ++k) weights[k] += by * step[k];
    }
    return weights;
}

}  // namespace thaum::gesture
