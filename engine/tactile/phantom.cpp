#include "tactile/phantom.h"

#include <algorithm>

namespace thaum::tactile {
namespace {

// Smallest width of the Gaussian (cells, the distances between neighbouring actuators).
constexpr double min_sigma = 0.2;
// Smallest share of the energy that an actuator keeps, relative to the largest share.
constexpr double kept_share = 0.01;
// Smallest share of the energy, relative to the largest one, that an actuator keeps if the place cannot be
// rendered otherwise.
constexpr double min_share = 1e-4;
// Largest error of the felt place that is accepted when actuators are left out (cells, the distances between
// neighbours).
constexpr double tolerated = 0.01;
// Error of the felt place at which the search stops (cells); far below what skin resolves.
constexpr double solved = 1e-4;
// Largest change of l in one step of Newton's method, for each cell, so that it does not overshoot. The
// vector l tilts the weights of the actuators towards the wanted place (tactile/phantom.h).
constexpr double longest_step = 4;
// Added to the curvature of the minimised function, so that its minimum l stays finite if the place is on the
// edge of all actuators. This causes an error of about 0.001 cells.
constexpr double stiffening = 1e-4;

/// Positions of the participating actuators relative to the wanted place, in cells (distances between
/// neighbours).
struct Cells {
    std::array<std::uint8_t, max_actuators> number{};
    std::array<vec2, max_actuators> offset{};
    std::array<double, max_actuators> log_prior{};
    std::array<double, max_actuators> share{};
    std::size_t count{};
};

/// Moves a place into the bounding box of all actuators of its region, in which places can be rendered.
vec2 reachable(const Layout& layout, const ChartPlace& place) {
    vec2 low(1e9), high(-1e9);
    for (const auto i : layout.group(place.region)) {
        const vec2 way = layout.between(place.region, place.at, layout.chart_of(place.region, i));
        low = glm::min(low, way);
        high = glm::max(high, way);
    }
    return place.at + glm::clamp(vec2(0), low, high);
}

/// Value at l of log Z, the function whose minimum gives the actuators' shares of the energy
/// (tactile/phantom.h), and the mean of the actuators' positions there, weighted by the shares.
struct Potential {
    double value{};
    vec2 centroid{};
};

Potential set_shares(Cells& cells, vec2 l) {
    double largest = -1e300;
    for (std::size_t i = 0; i < cells.count; ++i) {
        cells.share[i] = cells.log_prior[i] + glm::dot(l, cells.offset[i]);
        largest = std::max(largest, cells.share[i]);
    }
    double sum = 0;
    vec2 centroid(0);
    for (std::size_t i = 0; i < cells.count; ++i) {
        cells.share[i] = det::exp(cells.share[i] - largest);
        sum += cells.share[i];
        centroid += cells.share[i] * cells.offset[i];
    }
    for (std::size_t i = 0; i < cells.count; ++i) cells.share[i] /= sum;
    return {largest + det::log(sum) + stiffening / 2 * glm::dot(l, l), centroid / sum};
}

/// Newton's step towards the minimum of log Z, the function whose minimum gives the actuators' shares of the
/// energy. Its second derivatives are the covariance of the actuators' positions, weighted by the shares.
vec2 newton_step(const Cells& cells, vec2 centroid, vec2 slope) {
    double a = stiffening, b = 0, c = stiffening;
    for (std::size_t i = 0; i < cells.count; ++i) {
        const vec2 off = cells.offset[i] - centroid;
        a += cells.share[i] * off.x * off.x;
        b += cells.share[i] * off.x * off.y;
        c += cells.share[i] * off.y * off.y;
    }
    const double det = std::max(a * c - b * b, stiffening * stiffening / 4);
    const vec2 step = -vec2(c * slope.x - b * slope.y, a * slope.y - b * slope.x) / det;
    const double length = glm::length(step);
    return length > longest_step ? step * (longest_step / length) : step;
}

/// Finds the shares of the actuators in the energy whose centroid is the wanted place. A step that does not
/// lower the potential (the minimised function) enough is halved. If one cell has nearly all of the energy,
/// the curvature is so small that full steps would oscillate.
void balance(Cells& cells) {
    vec2 l(0);
    auto here = set_shares(cells, l);
    for (int round = 0; round < 40; ++round) {
        const vec2 slope = here.centroid + stiffening * l;
        if (glm::length(slope) < solved) return;
        vec2 step = newton_step(cells, here.centroid, slope);
        auto next = set_shares(cells, l + step);
        for (int half = 0; half < 12 && next.value > here.value + 0.01 * glm::dot(slope, step); ++half) {
            step /= 2;
            next = set_shares(cells, l + step);
        }
        l += step;
        here = next;
    }
}

/// Removes actuators whose share of the energy is less than `share` times the largest one, then balances the
/// others. Returns false if the others cannot render the place.
bool drop_below(Cells& cells, double share) {
    const auto end = cells.share.begin() + static_cast<std::ptrdiff_t>(cells.count);
    const double least = share * *std::max_element(cells.share.begin(), end);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cells.count; ++i) {
        if (cells.share[i] < least) continue;
        cells.number[kept] = cells.number[i];
        cells.offset[kept] = cells.offset[i];
        cells.log_prior[kept] = cells.log_prior[i];
        cells.share[kept++] = cells.share[i];
    }
    if (kept < cells.count) {
        cells.count = kept;
        balance(cells);
    }
    vec2 centroid(0);
    for (std::size_t i = 0; i < cells.count; ++i) centroid += cells.share[i] * cells.offset[i];
    return glm::length(centroid) < tolerated;
}

/// The far side of the torso must stay silent, so its actuators are used only for effects that are wider than
/// one side.
bool is_far_side(const Layout& layout, std::size_t actuator, vec3 place) {
    const vec3 at = layout.actuators[actuator].place.at;
    return at.x * place.x + at.z * place.z < 0;
}

/// Actuators of a region, relative to the place that is to be felt. `near_side`: leave out those on the far
/// side of the torso.
Cells cells_about(const Layout& layout, const ChartPlace& target, vec2 sigma, bool near_side) {
    Cells cells;
    const vec3 place = near_side ? layout.torso.point(target.at) : vec3(0);
    for (const auto i : layout.group(target.region)) {
        if (near_side && is_far_side(layout, i, place)) continue;
        const vec2 way = layout.between(target.region, target.at, layout.chart_of(target.region, i));
        const vec2 off = way / layout.pitch(target.region), scaled = off / sigma;
        cells.number[cells.count] = i;
        cells.offset[cells.count] = off;
        cells.log_prior[cells.count++] = -0.5 * glm::dot(scaled, scaled);
    }
    return cells;
}

}  // namespace

PhantomResult phantom(const Layout& layout, const ChartPlace& place, vec2 sigma_cells) {
    const double pitch = layout.pitch(place.region);
    const vec2 sigma = glm::max(sigma_cells, vec2(min_sigma));
    const vec2 target = reachable(layout, place);
    const bool narrow = place.region == Region::torso && sigma.x * pitch < layout.torso.round() / 4;
    Cells cells = cells_about(layout, {place.region, target}, sigma, narrow);
    if (cells.count == 0) cells = cells_about(layout, {place.region, target}, sigma, false);
    balance(cells);
    const Cells all = cells;
    if (!drop_below(cells, kept_share)) {
        cells = all;
        drop_below(cells, min_share);
    }
    PhantomResult result;
    vec2 felt(0);
    double largest = -1;
    for (std::size_t i = 0; i < cells.count; ++i) {
        result.shares[cells.number[i]] = static_cast<float>(cells.share[i]);
        felt += cells.share[i] * cells.offset[i];
        if (cells.share[i] > largest) result.strongest = cells.number[i];
        largest = std::max(largest, cells.share[i]);
    }
    result.error = glm::length(felt * pitch + layout.between(place.region, place.at, target));
    return result;
}

vec2 felt_offset(const Layout& layout, Region region, vec2 about, std::span<const double> amplitudes) {
    vec2 sum(0);
    double energy = 0;
    for (const auto i : layout.group(region)) {
        const double e = amplitudes[i] * amplitudes[i];
        sum += e * layout.between(region, about, layout.chart_of(region, i));
        energy += e;
    }
    return energy > 0 ? sum / energy : vec2(0);
}

}  // namespace thaum::tactile
