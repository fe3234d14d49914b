// field/detail/samples.h: samples as files store them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include "core/bytes.h"
#include "core/error.h"
#include "field/volume.h"

namespace thaum::field {

/// Number of bytes of a sample in a file.
std::size_t size_of(SampleType type);

/// Name of a type in our files: "int8", "uint8", "int16" to "uint64", "float", "double".
std::string_view name_of(SampleType type);
/// Smallest and largest number of a type.
std::pair<double, double> limits_of(SampleType type);
std::span<const std::string_view> sample_type_names();  ///< in the order of SampleType

/// Order of stored samples: where the samples of a volume lie in a file, counted in samples.
struct StoredOrder {
    std::ptrdiff_t first{};                  ///< component 0 of sample (0, 0, 0)
    std::array<std::ptrdiff_t, 3> stride{};  ///< step along each axis; below 0 if the file runs the other way
    std::ptrdiff_t component_stride{1};
};

/// The order of Volume::samples.
StoredOrder plain_order(const std::array<int, 3>& count, int components);

/// Bytes of samples.
struct StoredSamples {
    std::span<const std::byte> bytes;
    SampleType type{};
    bool big_endian{};
};

/// Whether samples make sense in the byte order in which they are read.
enum class ByteOrder : std::uint8_t {
    plausible,
    doubtful,  ///< every integer is a multiple of 256
    wrong,     ///< many floats are beyond or below all quantities, and none is in the other byte order
};
ByteOrder check_byte_order(const StoredSamples& stored);

/// Fills volume.samples and volume.rounding from stored samples, which must be all that the order names.
void decode(const StoredSamples& stored, const StoredOrder& order, Volume& volume);

/// Checks that rounding has left the samples of a volume apart, and adds a note if it has moved them. The error says
/// what to do with the samples.
Expected<void> check_rounding(Volume& volume);

/// Samples as little-endian bytes of the type volume.stored_as. Integers are rounded and limited to the range
/// of the type; NaN becomes 0.
Bytes encode(const Volume& volume);

}  // namespace thaum::field
