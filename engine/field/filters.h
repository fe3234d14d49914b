// field/filters.h: filters between the data and whoever reads them, such as forces on a hand or a picture.
//
//     source --> magnitude --> smooth --> clamp --> field
//
//     filter        of            gives     value
//     magnitude     vector        scalar    length
//     gradient      scalar        vector    gradient (1/m)
//     curl          vector        vector    curl (1/m)
//     divergence    vector        scalar    divergence (1/m)
//     scale         either        same      a x + b; of a vector, b is 0
//     clamp         scalar        scalar    at least a, at most b
//     smooth        either        same      Gaussian average, a = standard deviation in samples (0 to 16)
//
// All filters but `smooth` are computed at the place that is read and need no memory. `smooth` averages
// samples of its input once, and again only if its input or its parameter has changed.
//
// Derivatives of the results are exact for magnitude, scale and clamp, by the chain rule. Those of gradient,
// curl and divergence are second derivatives of the source. They are central differences over one sample to
// each side: of order h^2 with the cubic kernel, h with the linear one. The second derivatives of the kernels
// themselves would be worse: of order h and with jumps between cells, and none at all for the linear kernel.
// A difference takes 7 reads of the input; `FilteredField::quick` leaves it out where only the value is
// wanted.
//
// Results are in the frame of the source, whatever the scale in which it is shown. The output of the filters
// gradient, curl and divergence is therefore per metre of the data: a curl of 2 /s is that of the measured
// flow. Where forces use the gradient of a field directly, without a filter, it is per metre in the frame in
// which the field is placed (field/placement.h), because the hand moves in that frame. Reading does not
// allocate.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "field/field.h"
#include "field/placement.h"
#include "field/volume.h"

namespace thaum::field {

/// Result that a filter computes: the length of a vector, derivatives, a x + b, limits, or a Gaussian
/// average.
enum class FilterKind : std::uint8_t { magnitude, gradient, curl, divergence, scale, clamp, smooth };

/// Names of all kinds, in their order.
std::span<const std::string_view> filter_names();

/// One step from a field to another.
struct Filter {
    FilterKind kind{};
    double a{}, b{};  ///< parameters a and b of the kind, such as the limits of `clamp`; others are ignored
    bool operator==(const Filter&) const = default;
};

inline constexpr std::size_t max_filters = 8;
inline constexpr double max_smoothing = 16;  ///< largest standard deviation (samples)

/// A scalar or a vector field.
struct AnyField {
    ScalarField scalar{};
    VectorField vector{};
    const Placement*
        placement{};  ///< placement of the field in the frame of the caller; null: the field is in that frame

    /// Whether the field has three components.
    bool is_vector() const { return vector.read != nullptr; }
};

/// Data to be filtered: a field, and the grid on which it is smoothed and differentiated. Both are centred on
/// the origin, as in a Volume.
struct FilterSource {
    AnyField field{};
    std::array<int, 3> count{};
    vec3 spacing{1};                     ///< distance between samples along each axis (m)
    std::uint64_t version{};             ///< version of the data: changes whenever they change
    Kernel kernel{Kernel::catmull_rom};  ///< kernel that interpolates between smoothed samples
};

/// A scalar or vector field that lies, moved and turned, in another frame, and is read in that frame. `field`
/// refers to the other members, so this object must not be moved.
struct PlacedField {
    Placed<Scalar> scalar{};
    Placed<Vector> vector{};
    AnyField field{};

    PlacedField() = default;
    PlacedField(const PlacedField&) = delete;
    PlacedField& operator=(const PlacedField&) = delete;
};

/// Makes `out` a field that reads `own` through this placement, in the frame in which `own` is placed.
void place(PlacedField& out, const AnyField& own, const Placement& placement);

/// One filter with its input, as a part of a FilteredField.
struct FilterStage {
    Filter filter{};
    AnyField input{}, quick_input{};
    vec3 step{}, reach{};      ///< distance between the samples, and half of their extent (m)
    StaggeredGrid smoothed{};  ///< smoothed samples as grids; a scalar field uses the first
};

/// Samples that a filter has smoothed.
struct SmoothedSamples {
    std::uint64_t key{};  ///< hash of everything that the samples depend on
    Volume volume{};
};

/// A field with a chain of filters behind it. Fields refer to this object, so it must not be moved.
struct FilteredField {
    AnyField field{};  ///< the output, with value and gradient
    /// Output with the same value in less time; gradients that would have to be computed by differences are
    /// 0.
    AnyField quick{};
    std::array<FilterStage, max_filters> stages{};
    std::vector<std::unique_ptr<SmoothedSamples>> smoothed{};
    std::uint64_t smoothings{};  ///< number of times that samples have been smoothed so far

    FilteredField() = default;
    FilteredField(const FilteredField&) = delete;
    FilteredField& operator=(const FilteredField&) = delete;
};

/// Checks that each filter accepts the output of the previous one. Returns whether the last output is a
/// vector. The error names the filter.
Expected<bool> checked_filters(std::span<const Filter> filters, bool source_is_vector);

/// Makes `out` the result of applying these filters to `source`. Takes almost no time unless something must
/// be smoothed. The error is that of `checked_filters`; `out` is then unchanged.
Expected<void> set_filters(FilteredField& out, const FilterSource& source, std::span<const Filter> filters);

/// Averages samples with Gaussian weights along each axis, up to 4 standard deviations (in samples) away.
/// Outside the grid the outermost samples are repeated. A NaN spreads to all samples within that distance.
void smooth(Volume& volume, double deviation);

}  // namespace thaum::field
