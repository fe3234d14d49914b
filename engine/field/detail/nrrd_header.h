// field/detail/nrrd_header.h: what an NRRD header says of its samples and of space.
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

/// How the components of a sample become what a volume keeps.
enum class NrrdColour : std::uint8_t { none, red_green_blue, value_last, luminance_second };

/// A file of samples that a header names.
struct NrrdDataFile {
    std::string name;
    std::size_t line{};  ///< line of the header that names it
};

/// A header whose values agree with each other. Lengths are in m; the frame of space is right-handed.
struct NrrdHeader {
    std::string path;                                       ///< for messages
    std::map<std::string, std::size_t, std::less<>> lines;  ///< lines of the fields, by their names
    SampleType type{};
    bool big_endian{};
    NrrdEncoding encoding{};
    std::array<int, 3> sizes{};              ///< samples along each axis of space, in the file's order
    std::array<std::ptrdiff_t, 3> stride{};  ///< steps along these axes, in samples
    int components{1};                       ///< that are read of each sample: 1 or 3
    std::ptrdiff_t component_stride{1};
    NrrdColour colour{};
    bool is_colour_by_guess{};  ///< the header does not tell that the components are colours
    int frames{1};              ///< moments of time
    std::ptrdiff_t frame_stride{};
    std::size_t stored{1};            ///< samples times components in the file
    std::array<vec3, 3> direction{};  ///< from one sample to the next along these axes (m)
    std::optional<vec3> first{};      ///< place of the first sample (m)
    mat3 of_values{1.0};              ///< from the frame of values to that of space; 0: values do not turn
    bool is_in_space{};               ///< the header has a frame of space
    bool is_of_patient{};             ///< the frame of space is left-posterior-superior
    std::string name, units, save_name;
    std::vector<NrrdDataFile> data_files;  ///< empty: the samples follow the header
    std::size_t data_at{};                 ///< position of the samples behind the header
    std::size_t skipped_lines{};           ///< lines of each file before the samples
    long skipped_bytes{};  ///< bytes before the samples and behind these lines; -1: the samples end the file
    std::vector<std::string> notes;  ///< messages for the user, one line each
};

/// Parses the header at the start of a file. The error is one line with `name`, which is the path, and the
/// line of the header.
Expected<NrrdHeader> parse_nrrd_header(std::string_view file, const std::string& name, std::size_t limit);

/// A fault of a field that shows only with the samples: path, line and field before the message.
Error fail_field(const NrrdHeader& header, std::string_view field, std::string_view message);

}  // namespace thaum::field
