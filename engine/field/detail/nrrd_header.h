// field/detail/nrrd_header.h: the values of an NRRD header about its samples and about space.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "field/nrrd.h"

namespace thaum::field {

enum class NrrdEncoding : std::uint8_t { raw, gzip, ascii };

/// Meaning of the components of a sample, which decides what a volume keeps of them.
enum class NrrdColour : std::uint8_t { none, red_green_blue, value_last, luminance_second };

/// A file of samples that a header names.
struct NrrdDataFile {
    std::string name;
    std::size_t line{};  ///< line of the header that names the file
};

/// The values of an NRRD header, checked so that they agree with each other. Lengths are in m; the frame of
/// space is right-handed.
struct NrrdHeader {
    std::string path;                                       ///< path of the header, for messages
    std::map<std::string, std::size_t, std::less<>> lines;  ///< line of each field, by its name
    SampleType type{};
    bool big_endian{};
    NrrdEncoding encoding{};
    std::array<int, 3> sizes{};  ///< samples along each axis of space, in the file's order
    /// Distance in memory to the next sample along each axis of space (samples).
    std::array<std::ptrdiff_t, 3> stride{};
    int components{1};  ///< number of components read of each sample: 1 or 3
    std::ptrdiff_t component_stride{1};
    NrrdColour colour{};
    bool is_colour_by_guess{};  ///< true: colours were assumed, since the header does not say so
    int frames{1};              ///< number of moments of time in the file
    std::ptrdiff_t frame_stride{};
    std::size_t stored{1};            ///< number of samples times components in the file, for all moments
    std::array<vec3, 3> direction{};  ///< vector from one sample to the next along each axis of space (m)
    std::optional<vec3> first{};      ///< place of the first sample (m)
    /// Matrix that turns vector values from their own frame to the frame of space; 0: values are not turned.
    mat3 of_values{1.0};
    bool is_in_space{};    ///< true: the header has a frame of space
    bool is_of_patient{};  ///< true: the frame of space is left-posterior-superior
    std::string name, units, save_name;
    std::vector<NrrdDataFile> data_files;  ///< files of samples; empty: the samples follow the header
    /// Position in the file at which samples after the header begin (bytes).
    std::size_t data_at{};
    std::size_t skipped_lines{};  ///< number of lines to skip in each file before the samples
    /// Number of bytes to skip after the skipped lines; -1: the samples are at the end of the file.
    long skipped_bytes{};
    std::vector<std::string> notes;  ///< messages for the user, one line each
};

/// Parses the header at the start of a file. The error is one line with `name`, which is the path, and the
/// line of the header.
Expected<NrrdHeader> parse_nrrd_header(std::string_view file, const std::string& name, std::size_t limit);

/// Makes an error about a field of the header, for faults that show only when the samples are read. Path,
/// line and field precede the message.
Error fail_field(const NrrdHeader& header, std::string_view field, std::string_view message);

}  // namespace thaum::field
