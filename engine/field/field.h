// field/field.h: quantities that have a value at every place: how they are read by the hand and by pictures.
//
//     Grid, StaggeredGrid (samples, here) --.
//     a formula (anything that can be called) --+--> Field: place -> value and derivatives -> curl, divergence
//
// Between samples a kernel, the same along each axis, weights the nearest two or four. What it promises, along each axis:
//
//     kernel        exact for     error of value, gradient    gradient
//     linear        degree 1      h^2, h                      jumps between cells
//     catmull_rom   degree 2      h^3, h^2                    continuous
//
// (Keys 1981, "Cubic convolution interpolation", for the second. A cubic B-spline over the same four samples takes the same
// time; at 32 samples a wave its gradient was 7 times as wrong and its value 100 times, so there is none.)
//
// This holds up to the outermost samples: where the four lack one, the parabola through the nearest three stands for it.
// Beyond, all is as at the nearest place within, so a reader who crosses an edge never reads a jump to nothing. A grid without
// samples and a place that is not finite give zeros.
//
// Views: nothing here owns samples. Plain functions, no allocation. Lengths in m.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/maths.h"

namespace thaum::field {

/// Of a scalar at a place.
struct Scalar {
    double value{};
    vec3 gradient{};  ///< per m
};

/// Of a vector at a place.
struct Vector {
    vec3 value{};
    std::array<vec3, 3> gradient{};  ///< per m, of each component
};

inline double divergence(const Vector& v) { return v.gradient[0].x + v.gradient[1].y + v.gradient[2].z; }

inline vec3 curl(const Vector& v) {
    return {v.gradient[2].y - v.gradient[1].z, v.gradient[0].z - v.gradient[2].x,
            v.gradient[1].x - v.gradient[0].y};
}

/// Something to be read at a place: a sampled field or a formula, which must outlive this.
template <class Sample>
struct Field {
    const void* what{};
    Sample (*read)(const void* what, vec3 place){};

    Sample operator()(vec3 place) const { return read(what, place); }
};

using ScalarField = Field<Scalar>;
using VectorField = Field<Vector>;

/// Of anything that can be called with a place and gives a Sample.
template <class Sample, class Source>
Field<Sample> field_of(const Source& source) {
    return {&source, [](const void* what, vec3 place) -> Sample {
                return (*static_cast<const Source*>(what))(place);
            }};
}

enum class Kernel : std::uint8_t { linear, catmull_rom };

/// Samples in memory: sample (i, j, k) is first[i stride[0] + j stride[1] + k stride[2]] and stands at origin + spacing (i, j, k).
struct Grid {
    const float* first{};
    std::array<int, 3> count{};
    std::array<std::ptrdiff_t, 3> stride{};
    vec3 origin{};      ///< m
    double spacing{1};  ///< m, > 0
    Kernel kernel{Kernel::catmull_rom};

    Scalar operator()(vec3 place) const;
};

/// A vector whose components stand each in a grid of its own: on the faces of cells, as a flow's do, or all at the same places.
struct StaggeredGrid {
    std::array<Grid, 3> component{};

    Vector operator()(vec3 place) const;
};

}  // namespace thaum::field
