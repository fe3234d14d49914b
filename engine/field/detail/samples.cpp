#include "field/detail/samples.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstring>
#include <limits>

#include "core/assert.h"

namespace thaum::field {
namespace {

constexpr std::array<std::string_view, 10> type_names{"int8",   "uint8", "int16",  "uint16", "int32",
                                                      "uint32", "int64", "uint64", "float",  "double"};

/// Calls use(T{}) with the number type of a sample type.
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

template <class T>
float read_sample(const std::byte* from, bool big_endian) {
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), from, sizeof(T));
    if (big_endian) std::ranges::reverse(bytes);
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return static_cast<float>(value);
}

template <class T>
T stored_value(float sample) {
    if constexpr (std::floating_point<T>) {
        return static_cast<T>(sample);
    } else {
        // The largest integer of 32 or 64 bits, converted to a float, is rounded up to one that its type does not hold.
        constexpr auto low = static_cast<float>(std::numeric_limits<T>::min());
        constexpr auto high = static_cast<float>(std::numeric_limits<T>::max());
        if (std::isnan(sample)) return T{};
        if (sample >= high) return std::numeric_limits<T>::max();
        return static_cast<T>(std::max(std::round(sample), low));
    }
}

}  // namespace

std::pair<double, double> limits_of(SampleType type) {
    std::pair<double, double> limits;
    with_type(type, [&]<class T>(T) {
        limits = {static_cast<double>(std::numeric_limits<T>::lowest()),
                  static_cast<double>(std::numeric_limits<T>::max())};
    });
    return limits;
}

std::size_t size_of(SampleType type) {
    std::size_t size = 0;
    with_type(type, [&](auto sample) { size = sizeof(sample); });
    return size;
}

std::string_view name_of(SampleType type) { return type_names[static_cast<std::size_t>(type)]; }
std::span<const std::string_view> sample_type_names() { return type_names; }

StoredOrder plain_order(const std::array<int, 3>& count, int components) {
    const std::ptrdiff_t step = components, row = step * count[0];
    return {.stride = {step, row, row * count[1]}};
}

void decode(const StoredSamples& stored, const StoredOrder& order, Volume& volume) {
    const std::size_t size =
        static_cast<std::size_t>(volume.count[0]) * static_cast<std::size_t>(volume.count[1]) *
        static_cast<std::size_t>(volume.count[2]) * static_cast<std::size_t>(volume.components);
    THAUM_ASSERT(stored.bytes.size() >= size * size_of(stored.type), "fewer bytes than samples");
    volume.samples.resize(size);
    with_type(stored.type, [&]<class T>(T) {
        float* out = volume.samples.data();
        for (int k = 0; k < volume.count[2]; ++k) {
            for (int j = 0; j < volume.count[1]; ++j) {
                const std::ptrdiff_t row = order.first + k * order.stride[2] + j * order.stride[1];
                for (int i = 0; i < volume.count[0]; ++i) {
                    for (int c = 0; c < volume.components; ++c) {
                        const std::ptrdiff_t at = row + i * order.stride[0] + c * order.component_stride;
                        *out++ =
                            read_sample<T>(stored.bytes.data() + at * static_cast<std::ptrdiff_t>(sizeof(T)),
                                           stored.big_endian);
                    }
                }
            }
        }
    });
}

Bytes encode(const Volume& volume) {
    Bytes bytes(volume.samples.size() * size_of(volume.stored_as));
    with_type(volume.stored_as, [&]<class T>(T) {
        std::byte* out = bytes.data();
        for (const float sample : volume.samples) {
            const T value = stored_value<T>(sample);
            std::memcpy(out, &value, sizeof(T));
            out += sizeof(T);
        }
    });
    return bytes;
}

}  // namespace thaum::field
