// field/detail/samples.h: samples as files store them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/bytes.h"
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

/// Fills volume.samples from stored ones, which must be all that the order names.
void decode(const StoredSamples& stored, const StoredOrder& order, Volume& volume);

/// Samples as little-endian bytes of the type volume.stored_as. Integers are rounded and limited to the range
/// of the type; NaN becomes 0.
Bytes encode(const Volume& volume);

}  // namespace thaum::field
