// tests/scenes/scanned_volumes.h: volumes as a scanner would give them, and a tip that touches them, for
// benchmarks and tests.
//
// A sample is the share of its voxel that the object covers, in 255 steps. So edges are as sharp as such
// samples allow. A real scanner blurs them further, which makes rendering easier.
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "haptics/modes.h"
#include "haptics/primitives/balance.h"
#include "haptics/volume/implicit.h"
#include "haptics/volume/smooth_grid.h"

namespace thaum::bench {

/// A cube of samples in the middle of the device's workspace.
struct ScannedVolume {
    int n{};           ///< number of samples along each edge
    double spacing{};  ///< distance between samples (m)
    std::vector<float> samples{};

    /// Position of the first sample (m). The middle of the cube is slightly off the origin, so that nothing
    /// is symmetrical.
    vec3 origin() const { return vec3(-spacing * (n - 1) / 2) + spacing * vec3(0.21, 0.37, -0.13); }
    field::Grid grid(field::Kernel kernel) const {
        const std::ptrdiff_t row = n;
        return {samples.data(), {n, n, n}, {1, row, row * row}, origin(), vec3(spacing), kernel};
    }
    haptics::SmoothGrid smooth() const { return {grid(field::Kernel::catmull_rom)}; }
};

/// Share of the voxel at a position that lies in the object, from 8 x 8 x 8 points. The absolute value of the
/// object's potential must not exceed the distance to the surface.
template <class Object>
double covered_share(const Object& object, vec3 place, double spacing) {
    const double here = object(place).value;
    if (std::abs(here) > 0.9 * spacing) return here < 0 ? 1 : 0;
    constexpr int parts = 8;
    int inside = 0;
    for (int k = 0; k < parts; ++k) {
        for (int j = 0; j < parts; ++j) {
            for (int i = 0; i < parts; ++i) {
                const vec3 at = place + spacing * ((vec3(i, j, k) + vec3(0.5)) / double{parts} - vec3(0.5));
                inside += object(at).value < 0 ? 1 : 0;
            }
        }
    }
    return inside / double{parts * parts * parts};
}

/// Scans an object given by a potential that is negative inside and, in absolute value, at most the distance
/// to the surface.
template <class Object>
ScannedVolume scanned(const Object& object, int n, double spacing) {
    ScannedVolume volume{n, spacing, {}};
    volume.samples.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n) *
                           static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const double share =
                    covered_share(object, volume.origin() + spacing * vec3(i, j, k), spacing);
                volume.samples.push_back(static_cast<float>(std::round(255 * share)));
            }
        }
    }
    return volume;
}

/// A block rotated relative to the axes.
struct TurnedBlock {
    haptics::Block block{};
    mat3 turn{1.0};  ///< rotation from the block's frame to the device frame

    field::Scalar operator()(vec3 place) const {
        field::Scalar here = block(place * turn);
        here.gradient = turn * here.gradient;
        return here;
    }
};

/// A tip that a benchmark or test moves, with the modes that act on it. As in a match, the modes use the
/// state of the previous tick.
struct TouchedModes {
    std::vector<haptics::ModeUse> uses{};
    double stiffness{300};  ///< stiffness between tip and proxy (N/m)
    vec3 proxy{}, tip{}, before{};

    void start(vec3 place) { proxy = tip = before = place; }
    haptics::ModeInput input() const { return {proxy, tip, tip - before, stiffness, tip - before}; }

    /// Moves the tip and returns the force on the hand (N).
    vec3 move(vec3 to) {
        haptics::PrimitiveSet set;
        haptics::add_modes(uses, input(), set);
        return settle(set, to);
    }
    vec3 settle(const haptics::PrimitiveSet& set, vec3 to) {
        before = tip;
        tip = to;
        const haptics::Balance found = haptics::balance(set, {tip, stiffness});
        proxy = found.proxy;
        return stiffness * (proxy - tip);
    }
};

/// Direction i of n directions that cover the sphere evenly (unit).
inline vec3 even_direction(int i, int n) {
    const double y = 1 - (2 * i + 1.0) / n, turn = i * pi * (3 - std::sqrt(5.0));
    const double across = std::sqrt(1 - y * y);
    return {across * det::cos(turn), y, across * det::sin(turn)};
}

}  // namespace thaum::bench
