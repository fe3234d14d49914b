// field/placement.h: where a volume lies in its parent frame, the box in which it has samples, and fields
// read through a placement.
//
//     place in the parent = origin + turn * (scale * place in the volume)
//
// A volume, its feel and its picture use one placement, so all three move, turn and grow together. The same
// point has the same value in both frames. Derivatives are in the frame of the reader: a volume of twice the
// size has half the gradient. A vector value turns with the volume but does not grow with it, because a
// velocity in m/s is no length.
//
// Functions are plain and do not allocate. Lengths are in m.
#pragma once
#include <algorithm>
#include <cmath>

#include "field/field.h"

namespace thaum::field {

/// Rigid motion and uniform scale of a frame.
struct Placement {
    vec3 origin{};      ///< place of the volume's origin (m, parent frame)
    mat3 turn{1.0};     ///< rotation from the volume's frame to the parent's; orthonormal
    double scale{1.0};  ///< length in the parent's frame per length in the volume's frame, > 0
};

inline vec3 to_parent(const Placement& p, vec3 place) { return p.origin + p.turn * (p.scale * place); }

/// Inverse of `to_parent`: a place in the volume's own frame.
inline vec3 to_own(const Placement& p, vec3 place) { return ((place - p.origin) * p.turn) / p.scale; }

/// Placement of a part in the outer frame, if the part lies at `inner` in a frame that itself lies at
/// `outer`.
inline Placement combined(const Placement& outer, const Placement& inner) {
    return {to_parent(outer, inner.origin), outer.turn * inner.turn, outer.scale * inner.scale};
}

/// Expresses a sample taken in the volume's frame in the parent's frame.
inline Scalar to_parent(const Placement& p, const Scalar& own) {
    return {own.value, p.turn * own.gradient / p.scale};
}

inline Vector to_parent(const Placement& p, const Vector& own) {
    Vector result{p.turn * own.value, {}};
    for (int row = 0; row < 3; ++row) {
        vec3 sum(0);
        for (int a = 0; a < 3; ++a) sum += p.turn[a][row] * own.gradient[static_cast<std::size_t>(a)];
        result.gradient[static_cast<std::size_t>(row)] = p.turn * sum / p.scale;
    }
    return result;
}

/// Range to which pictures limit samples. A NaN is shown as the lowest value. The default changes nothing.
struct ShownRange {
    float low = -HUGE_VALF, high = HUGE_VALF;

    float operator()(float sample) const { return sample > low ? std::min(sample, high) : low; }
};

/// Box that the samples behind a field span. Pictures show nothing of a volume outside the box, and a cut
/// face where the body reaches the box.
struct SampleBox {
    bool bounded{};  ///< false: the field has no end, and the other members mean nothing
    /// Samples that a picture shows, with linear interpolation. Empty: the field's values are not simply
    /// samples.
    Grid drawn{};
    /// Averages of blocks of samples. Surface directions that are computed from them show fewer steps
    /// (field/block_averages.h). May be empty.
    Grid averages{};
    bool coarse_steps{};    ///< true: only averages show directions of surfaces (BlockAverages::coarse_steps)
    ShownRange shown{};     ///< range of shown values, used for samples that are not finite
    vec3 middle{}, half{};  ///< middle of the box and half of its extent (m, frame of the samples)
    vec3 spacing{1};        ///< distance between samples along each axis (m, frame of the samples)
    Placement placement{};  ///< placement of the samples' frame in the reader's frame
};

/// The box of a field's samples, in the frame of the caller.
template <class Sample>
SampleBox sample_box_of(const Field<Sample>& field) {
    return field.box == nullptr ? SampleBox{} : field.box(field.what);
}

/// A field read in the parent's frame. It can be called, so `field_of<Sample>(placed)` makes a field from it.
template <class Sample>
struct Placed {
    Field<Sample> field{};  ///< field in the volume's frame
    Placement placement{};

    /// Value in the parent's frame; zeros if the scale is not above 0 or no field is set.
    Sample operator()(vec3 place) const {
        if (field.read == nullptr || !(placement.scale > 0)) return {};
        return to_parent(placement, field(to_own(placement, place)));
    }
    /// Box of the field's samples, placed in the parent's frame.
    SampleBox sample_box() const {
        SampleBox box = sample_box_of(field);
        box.placement = combined(placement, box.placement);
        box.bounded = box.bounded && placement.scale > 0;
        return box;
    }
};

}  // namespace thaum::field
