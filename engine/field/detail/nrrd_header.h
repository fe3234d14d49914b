// field/detail/nrrd_header.h: what an NRRD header says of its samples and of space.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "field/nrrd.h"

namespace thaum::field {

/// A header whose values agree with each other. Lengths are in m; the frame of space is right-handed.
struct NrrdHeader {
    SampleType type{};
    bool big_endian{};
    Packing packing{};
    std::array<int, 3> sizes{};              ///< samples along each axis of space, in the file's order
    std::array<std::ptrdiff_t, 3> stride{};  ///< steps along these axes, in samples
    int components{1};
    std::ptrdiff_t component_stride{1};
    std::array<vec3, 3> direction{};  ///< from one sample to the next along these axes (m)
    std::optional<vec3> first{};      ///< place of the first sample (m)
    mat3 of_values{1.0};              ///< from the frame of values to that of space; 0: values do not turn
    bool is_in_space{};               ///< the header has a frame of space
    bool is_of_patient{};             ///< the frame of space is left-posterior-superior
    std::string name, units, save_name;
    std::string data_file;  ///< empty: the samples follow the header
    std::size_t data_at{};  ///< position of the samples behind the header
    long skip{};            ///< bytes to skip before the samples; -1: they end the file
};

/// Parses the header at the start of a file. The error is one line with `name`, which is the path, and the
/// line of the header.
Expected<NrrdHeader> parse_nrrd_header(std::string_view file, const std::string& name, std::size_t limit);

}  // namespace thaum::field
