// haptics/volume/smooth_grid.h: a sampled field as a hand should feel it, smoothed over about one sample.
//
// A scanner's edge is one or two samples wide. A kernel that passes through the samples shows the
// steps between them. Along each axis, this kernel is a cubic B-spline over samples that are averaged
// 1 : 4 : 6 : 4 : 1. Its standard deviation is 1.15 samples. Value and gradient are continuous, and
// so are the gradient's derivatives.
//
// The table has the errors of the force's direction (largest, median) on a sphere with a radius of 40
// samples. Each sample is an 8-bit density in proportion to the part of its box that lies in the sphere,
// which is the hardest edge. Noise: that of the force on a tip that slides on the flat face of such a block
// with 1 N. Time: that of one read of the field.
//
//     kernel                                    largest    median    noise     time
//     this one                                  0.8 deg    0.09 deg   0.6 %    0.19 us
//     the same, averaged 1 : 2 : 1              1.5        0.2        1.5      0.12
//     cubic B-spline alone                      6.0        1.9
//     quintic B-spline                          3.0        0.6
//     spherical contact (mean over 8 places     6.3        1.4        0.8      0.25
//     on a ball of 0.87 samples), linear
//     linear                                    11         4.6        10
//     Catmull-Rom                               13         5.3        11       0.10
//
// Near the border of the samples, a value takes the border sample for those beyond it. A gradient of such
// values is too flat towards the border, so that the direction of a plane is up to 8 degrees off. So each
// gradient beyond the border counts as that at its mirror image inside. The result is a mean of gradients
// inside with the same weights for all three components, and a plane's direction stays within 0.7 degrees.
// There the gradient is not exactly the derivative of the value, and a read takes up to twice the time.
//
// The price is detail. A sheet one sample thick keeps a third of its height, and one of three samples four
// fifths. The surface of a body of radius r lies 1.3 h^2 / r too deep, for samples h apart.
#pragma once
#include "field/placement.h"

namespace thaum::haptics {

/// A view of a grid's samples. The smoothing kernel above replaces the grid's. Outside the samples the value
/// is that of the nearest place inside. A grid without samples and a place that is not finite give zeros.
/// Near a sample that is not finite, all samples are replaced by the values with which a picture shows them.
struct SmoothGrid {
    field::Grid grid{};
    /// Averages of blocks of the grid's samples (field/block_averages.h), for sample_box(); may be empty.
    field::Grid averages{};
    field::ShownRange shown{};  ///< range of the finite samples; decides how other samples are shown
    bool coarse_steps{};        ///< as in field::BlockAverages, for sample_box()

    field::Scalar operator()(vec3 place) const;
    /// Value and gradient at a place, as by operator(). But near the border, the gradient takes the border
    /// sample for samples beyond it, as the value does.
    field::Scalar ending_level(vec3 place) const;
    /// The box of the samples. A picture shows them, linear between them.
    field::SampleBox sample_box() const;
};

}  // namespace thaum::haptics
