// field/volume.h: samples of a quantity in memory, as files and generators give them, and views of them as
// fields.
//
//     file (field/volume_file.h) --.
//     formula (sampled, here) -----+--> Volume --> grid(), vector_grid() --> Placed --> field in the world
//     generator (make_volume) -----'
//
// Volume's frame: its origin is the middle of the box that the samples span, and its axes are those of the
// samples. The placement takes it to the frame of the file or of the world. Samples keep the type of the file
// if they are integers of 16 bits, or of 8 bits without a sign. All others become floats, which round a
// double and integers from 16,777,216 on.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "field/field.h"
#include "field/placement.h"
#include "field/volume_samples.h"

namespace thaum::field {

/// Type of a sample in a file.
enum class SampleType : std::uint8_t {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
};

/// Largest number of samples times components of a volume that is read or made: 512 along each axis.
inline constexpr std::size_t max_samples = std::size_t{1} << 27U;

/// Vectors of the file that a volume was read from, for the axes of the volume (m, frame of the file). A
/// writer writes these again if the volume was not moved, because vectors computed from spacing and turn
/// would contain rounding errors.
struct FileAxes {
    std::array<vec3, 3> direction{};  ///< vector from one sample to the next along each axis
    std::optional<vec3> first{};      ///< place of sample (0, 0, 0)
    /// Place of the volume's middle. Without an origin in the file, the first sample of a file with a frame
    /// of space is at 0, as other programs assume. std::nullopt: the file has no frame.
    std::optional<vec3> middle{};
    vec3 spacing{};  ///< the volume's spacing and placement, computed from `direction` and `first`
    Placement placement{};
};

/// Measures of what was lost when the samples of a file were converted to float.
struct Rounding {
    double low{}, high{};  ///< smallest and largest finite sample of the file
    double width{};        ///< high - low, computed in the file's number type
    /// Distance between neighbouring floats at the sample of largest magnitude; 0: no sample was rounded.
    double step{};
    std::size_t beyond{};  ///< number of finite samples that are too large for a float
};

/// Samples in three dimensions, as a file holds them.
struct Volume {
    std::array<int, 3> count{};                 ///< samples along each axis
    vec3 spacing{1e-3};                         ///< distance between samples along each axis, > 0 (m)
    Placement placement{};                      ///< placement of the volume in its parent's frame
    int components{1};                          ///< components of a sample. 1: scalar; 3: vector, or colour
    bool is_colour{false};                      ///< true: the components are red, green and blue
    SampleType stored_as{SampleType::float32};  ///< type in which a file stores the samples
    /// Component c of sample (i, j, k) is samples[c + components (i + count[0] (j + count[1] k))].
    VolumeSamples samples{};
    std::string name{};   ///< name of what the volume shows, for lists; may be empty
    std::string units{};  ///< unit of the samples, such as "HU"; may be empty
    /// True: the axes of the parent frame point to a patient's left, back and head, as a medical file says.
    bool is_of_patient{false};
    /// True: the file says where the samples are. If false, only the spacings and the turn mean something.
    bool has_place{false};
    std::optional<FileAxes> file_axes{};
    /// Name that this file shares with the files of the other properties of one saved body; may be empty.
    std::string save_name{};
    std::vector<std::filesystem::path> files{};  ///< files that the volume was read from
    Rounding rounding{};                         ///< how reading has rounded the samples
    /// Number of moments of time in the file, of which one was read.
    int frames{1};
    std::vector<std::string> notes{};  ///< messages of the file's reader for the user, one line each

    /// View of one component as a field in the volume's frame. Valid while `samples` is neither resized nor
    /// converted.
    Grid grid(Kernel kernel = Kernel::catmull_rom, int component = 0) const;
    /// View of a vector volume as a field in the volume's frame. A scalar volume gives zeros.
    StaggeredGrid vector_grid(Kernel kernel = Kernel::catmull_rom) const;
    /// Distance between the outermost samples along each axis (m).
    vec3 extent() const { return spacing * (vec3(count[0], count[1], count[2]) - vec3(1)); }
    /// Place of sample (i, j, k) in the volume's frame (m).
    vec3 place(int i, int j, int k) const { return spacing * vec3(i, j, k) - 0.5 * extent(); }
};

/// Gives `volume` the placement, frame and file vectors of another volume with the same number of samples. A
/// file written from it then has the same place to the last bit.
void lie_as(Volume& volume, const Volume& other);

/// Smallest and largest finite sample of a volume; (0, 0) if there is none.
struct SampleRange {
    float low{}, high{};
};
/// Least and greatest finite sample.
SampleRange range_of(const Volume& volume);

/// Number of samples that are not finite: NaN, or too large for a float.
std::size_t not_finite(const Volume& volume);

/// Level that separates the samples best into two classes, such as air and tissue (N. Otsu, A threshold
/// selection method from gray-level histograms, 1979): of 255 levels, the middle of those that separate at
/// most 0.1 % worse than the best. For vectors, it is the level of their lengths. The middle of the range if
/// all samples are equal.
double usual_level(const Volume& volume);

/// Samples a field at count[0] x count[1] x count[2] places, centred on the field's origin.
Volume sampled(const ScalarField& field, std::array<int, 3> count, vec3 spacing);
Volume sampled(const VectorField& field, std::array<int, 3> count, vec3 spacing);

/// Samples a body as a scanner does, in 8 bits: each sample is 255 times the share of the box around it in
/// which `depth` (m) is above 0. The share is counted at 4 x 4 x 4 places. `depth` must not change faster
/// than 1 m per m.
Volume scanned(const ScalarField& depth, std::array<int, 3> count, vec3 spacing);

/// Length of the longest side of a volume that `make_volume` makes (m).
inline constexpr double made_extent = 0.2;

/// Names of all volumes that `make_volume` can make.
std::span<const std::string_view> volume_names();

/// Makes a volume of `count` samples along each axis, 2 to 512. Names:
///     sphere     scalar: a ball of 0.4 extents, as a scanner sees it, 0 to 255
///     gyroid     scalar: two periods of a gyroid, placed by the seed, -1.5 to 1.5
///     vortices   vector: three vortices and noise, from the seed (m/s)
///     beltrami   vector: a flow along its own curl, one period (m/s)
/// The error names a name or a count that is wrong.
Expected<Volume> make_volume(std::string_view name, int count, std::uint64_t seed);

}  // namespace thaum::field
