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
std::span<const std::string_view> sample_type_names();  ///< Names of all types, in the order of SampleType.

/// Positions of a volume's samples in a file, counted in samples.
struct StoredOrder {
    std::ptrdiff_t first{};  ///< index of component 0 of sample (0, 0, 0)
    /// Distance in the file to the next sample along each axis of the volume; negative if the file runs the
    /// other way.
    std::array<std::ptrdiff_t, 3> stride{};
    std::ptrdiff_t component_stride{1};
};

/// The order in which Volume::samples holds samples.
StoredOrder plain_order(const std::array<int, 3>& count, int components);

/// Samples as bytes of a file, with their type and byte order.
struct StoredSamples {
    std::span<const std::byte> bytes;
    SampleType type{};
    bool big_endian{};
};

/// Whether the samples are plausible in the byte order in which they are read.
enum class ByteOrder : std::uint8_t {
    plausible,
    doubtful,  ///< every sample is an integer multiple of 256
    /// Many floats are too large or too small for any physical quantity. With the other byte order, no float
    /// would be.
    wrong,
};
ByteOrder check_byte_order(const StoredSamples& stored);

/// Fills volume.samples and volume.rounding from stored samples; every index that the order gives must exist.
void decode(const StoredSamples& stored, const StoredOrder& order, Volume& volume);

/// Checks that rounding to float has not made different samples equal, and adds a note if it has changed
/// some. The error says what to do with the samples.
Expected<void> check_rounding(Volume& volume);

/// Samples as little-endian bytes of the type volume.stored_as. Integers are rounded and limited to the range
/// of the type; NaN becomes 0.
Bytes encode(const Volume& volume);

}  // namespace thaum::field
