// field/detail/samples.h: samples as files store them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "core/bytes.h"
#include "core/error.h"
#include "field/volume.h"

namespace thaum::field {

/// Calls use(T{}), where T is the C++ type of a sample type.
template <class Use>
void with_type(SampleType type, Use use) {
    switch (type) {
        case SampleType::int8: return use(std::int8_t{});
        case SampleType::uint8: return use(std::uint8_t{});
        case SampleType::int16: return use(std::int16_t{});
        case SampleType::uint16: return use(std::uint16_t{});
        case SampleType::int32: return use(std::int32_t{});
        case SampleType::uint32: return use(std::uint32_t{});
        case SampleType::int64: return use(std::int64_t{});
        case SampleType::uint64: return use(std::uint64_t{});
        case SampleType::float32: return use(float{});
        case SampleType::float64: return use(double{});
    }
}

/// Number of bytes of a sample in a file.
std::size_t size_of(SampleType type);

/// Name of a type in our files: "int8", "uint8", "int16" to "uint64", "float", "double".
std::string_view name_of(SampleType type);
/// Smallest and largest number that a type of samples can hold.
std::pair<double, double> limits_of(SampleType type);
std::span<const std::string_view> sample_type_names();  ///< Names of all types, in the order of SampleType.

/// Checks that rounding to float has not made different samples equal, and adds a note if it has changed
/// some. The error says what to do with the samples.
Expected<void> check_rounding(Volume& volume);

/// Samples as little-endian bytes of the type volume.stored_as. Integers are rounded and limited to the range
/// of the type; NaN becomes 0.
Bytes encode(const Volume& volume);

}  // namespace thaum::field
