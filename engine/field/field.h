// field/field.h: quantities that have a value at every place, as forces and pictures read them.
//
//     Grid, StaggeredGrid (samples, here) ------.
//     a formula (anything that can be called) --+--> Field: place -> value, derivatives -> curl, divergence
//
// Between samples a kernel weights the nearest two or four, in the same way along each axis. The table has
// the polynomials that it reproduces, and its errors as orders of the distance h between samples:
//
//     kernel        exact for     error of value, gradient    gradient
//     linear        degree 1      h^2, h                      jumps between cells
//     catmull_rom   degree 2      h^3, h^2                    continuous
//
// The kernel catmull_rom is from Keys 1981, "Cubic convolution interpolation". A cubic B-spline over the same
// four samples takes the same time. At 32 samples a wave, the error of its gradient was 7 times and that of
// its value 100 times as large, so it is not offered.
//
// The orders hold up to the outermost samples. If one of the four samples is missing there, the parabola
// through the nearest three replaces it. Outside the samples the value is that of the nearest place inside,
// so it does not jump at the edge. A grid without samples and a place that is not finite give zeros.
//
// All types are views: none owns samples. Functions are plain and do not allocate. Lengths are in m.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/maths.h"
#include "field/volume_samples.h"

namespace thaum::field {

/// Value and gradient of a scalar quantity at one place.
struct Scalar {
    double value{};
    vec3 gradient{};  ///< derivative along x, y and z (1/m)
};

/// Value and gradient of a vector quantity at one place.
struct Vector {
    vec3 value{};
    std::array<vec3, 3> gradient{};  ///< gradient of each component (1/m)
};

/// Divergence at a place.
inline double divergence(const Vector& v) { return v.gradient[0].x + v.gradient[1].y + v.gradient[2].z; }

/// Curl at a place.
inline vec3 curl(const Vector& v) {
    return {v.gradient[2].y - v.gradient[1].z, v.gradient[0].z - v.gradient[2].x,
            v.gradient[1].x - v.gradient[0].y};
}

struct SampleBox;  // defined in field/placement.h

/// A quantity that can be read at any place. Refers to a sampled field or a formula, which must outlive it.
template <class Sample>
struct Field {
    const void* what{};
    Sample (*read)(const void* what, vec3 place){};
    /// Gives the box in which the field has samples, in the frame of the caller. Null: the field has no
    /// boundary, such as a formula.
    SampleBox (*box)(const void* what){};

    Sample operator()(vec3 place) const { return read(what, place); }
};

/// A field that has one number at each place.
using ScalarField = Field<Scalar>;
/// A field that has a vector at each place.
using VectorField = Field<Vector>;

/// Makes a field from any object that maps a place to a Sample when called. If the object has a member
/// function sample_box(), the box that it returns bounds the field.
template <class Sample, class Source>
Field<Sample> field_of(const Source& source) {
    Field<Sample> field{&source, [](const void* what, vec3 place) -> Sample {
                            return (*static_cast<const Source*>(what))(place);
                        }};
    if constexpr (requires { &Source::sample_box; })
        field.box = [](const void* what) { return static_cast<const Source*>(what)->sample_box(); };
    return field;
}

/// Kernel that interpolates between samples.
enum class Kernel : std::uint8_t { linear, catmull_rom };

/// Samples in memory. Sample (i, j, k) is first[i stride[0] + j stride[1] + k stride[2]]. Its place is origin
/// + spacing (i, j, k), axis by axis.
struct Grid {
    FirstSample first{};
    std::array<int, 3> count{};
    std::array<std::ptrdiff_t, 3> stride{};
    vec3 origin{};    ///< place of the first sample (m)
    vec3 spacing{1};  ///< distance between samples along each axis, > 0 (m)
    Kernel kernel{Kernel::catmull_rom};

    /// Returns use(first), where `first` is the pointer to samples of one type.
    template <class Use>
    decltype(auto) with_samples(Use use) const {
        return std::visit(use, first);
    }
    /// Whether there is a sample to read.
    bool has_samples() const {
        return with_samples([](const auto* samples) { return samples != nullptr; }) && count[0] >= 1 &&
               count[1] >= 1 && count[2] >= 1;
    }
    // The place is passed on component by component, so in registers. Otherwise clang loads two numbers at
    // once. If the caller has just written the place to memory, the processor must then wait until both are
    // stored, which takes half of the time of an evaluation.
    Scalar operator()(vec3 place) const { return scalar_at(place.x, place.y, place.z); }
    /// The same value as operator(), to the last bit, without the gradient and in less time.
    double value(vec3 place) const { return value_at(place.x, place.y, place.z); }
    /// Value at a place counted in samples from the first one, linear between samples. Beyond them it is the
    /// value of the nearest place inside. Needs two samples along each axis and numbers that are finite.
    double linear_value(double x, double y, double z) const;

private:
    Scalar scalar_at(double x, double y, double z) const;
    double value_at(double x, double y, double z) const;
};

/// A vector field with one grid per component. The grids may be staggered on cell faces, as in a flow, or
/// coincide.
struct StaggeredGrid {
    std::array<Grid, 3> component{};

    Vector operator()(vec3 place) const;
    /// The same value as operator(), without the gradient.
    vec3 value(vec3 place) const {
        return {component[0].value(place), component[1].value(place), component[2].value(place)};
    }
};

}  // namespace thaum::field
