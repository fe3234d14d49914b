#include "field/detail/samples.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstring>
#include <limits>
#include <set>

#include "core/assert.h"
#include "core/text.h"

namespace thaum::field {
namespace {

constexpr std::array<std::string_view, 10> type_names{"int8",   "uint8", "int16",  "uint16", "int32",
                                                      "uint32", "int64", "uint64", "float",  "double"};

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

template <class T>
T read_sample(const std::byte* from, bool big_endian) {
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), from, sizeof(T));
    if (big_endian) std::ranges::reverse(bytes);
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
}

/// Records which samples change when they are rounded to float. Types that float holds exactly cost nothing.
template <class T>
class RoundingWatch {
public:
    static constexpr bool is_needed = sizeof(T) > sizeof(float) || (sizeof(T) == 4 && std::integral<T>);

    void add(T value) {
        if constexpr (std::floating_point<T>) {
            if (!std::isfinite(value)) return;
        }
        low_ = any_ ? std::min(low_, value) : value;
        high_ = any_ ? std::max(high_, value) : value;
        any_ = true;
        const auto number = static_cast<double>(value);
        const auto kept = static_cast<float>(number);
        if (!std::isfinite(kept)) ++beyond_;
        // Integers of this size and larger may have been rounded when they were converted to double.
        constexpr double exact_integers = 0x1p53;
        const bool by_double = std::integral<T> && std::abs(number) >= exact_integers;
        rounded_ = rounded_ || by_double || static_cast<double>(kept) != number;
    }

    Rounding result() const {
        Rounding r{.low = static_cast<double>(low_), .high = static_cast<double>(high_), .beyond = beyond_};
        if constexpr (std::integral<T>)
            r.width =
                static_cast<double>(static_cast<std::uint64_t>(high_) - static_cast<std::uint64_t>(low_));
        else
            r.width = r.high - r.low;
        constexpr float most = std::numeric_limits<float>::max();
        const auto size =
            static_cast<float>(std::min(std::max(std::abs(r.low), std::abs(r.high)), double{most}));
        if (rounded_)
            r.step = size < most ? std::nextafter(size, most) - size : size - std::nextafter(size, 0.0F);
        return r;
    }

private:
    T low_{}, high_{};
    std::size_t beyond_{};
    bool any_{}, rounded_{};
};

std::string three_digits(double number) {
    std::array<char, 32> out{};
    const auto end =
        std::to_chars(out.data(), out.data() + out.size(), number, std::chars_format::general, 3).ptr;
    return {out.data(), end};
}

template <class T>
T stored_value(float sample) {
    if constexpr (std::floating_point<T>) {
        return static_cast<T>(sample);
    } else {
        // The largest integer of 32 or 64 bits becomes a float that is too large for its type. So a sample
        // that reaches this float is not converted, but becomes the largest integer.
        constexpr auto low = static_cast<float>(std::numeric_limits<T>::min());
        constexpr auto high = static_cast<float>(std::numeric_limits<T>::max());
        if (std::isnan(sample)) return T{};
        if (sample >= high) return std::numeric_limits<T>::max();
        return static_cast<T>(std::max(std::round(sample), low));
    }
}

template <class T>
bool is_number(T value) {
    if constexpr (std::floating_point<T>) return !std::isnan(value);
    return true;
}

/// True for values that hardly any quantity has, but that appear when bytes are read in the wrong order:
/// floats of extreme size, and integers whose lowest byte is 0.
template <class T>
bool is_odd(T value) {
    if constexpr (std::floating_point<T>) {
        const double largest = sizeof(T) == sizeof(float) ? 1e30 : 1e100, size = std::abs(double{value});
        return !(size <= largest) || (size > 0 && size < 1 / largest);
    } else {
        return value % 256 == 0;
    }
}

}  // namespace

ByteOrder check_byte_order(const StoredSamples& stored) {
    constexpr std::size_t max_looked_at = 4096, share = 10;
    constexpr std::size_t fewest_values =
        16;  // least number of values to judge by; fewer may look right in both byte orders by chance
    ByteOrder result{};
    with_type(stored.type, [&]<class T>(T) {
        const std::size_t all = stored.bytes.size() / sizeof(T), step = all / max_looked_at + 1;
        std::size_t looked_at = 0, odd = 0, odd_in_other = 0;
        std::set<T> values;
        for (std::size_t i = 0; sizeof(T) > 1 && i < all; i += step) {
            const std::byte* from = stored.bytes.data() + i * sizeof(T);
            const T value = read_sample<T>(from, stored.big_endian);
            if (value == T{}) continue;
            ++looked_at;
            if (values.size() < fewest_values && is_number(value)) values.insert(value);
            odd += is_odd(value) ? 1 : 0;
            odd_in_other += is_odd(read_sample<T>(from, !stored.big_endian)) ? 1 : 0;
        }
        const bool enough = values.size() >= fewest_values && odd_in_other == 0;
        if (std::floating_point<T> && enough && odd * share >= looked_at) result = ByteOrder::wrong;
        if (std::integral<T> && enough && odd == looked_at) result = ByteOrder::doubtful;
    });
    return result;
}

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
        RoundingWatch<T> watch;
        for (int k = 0; k < volume.count[2]; ++k) {
            for (int j = 0; j < volume.count[1]; ++j) {
                const std::ptrdiff_t row = order.first + k * order.stride[2] + j * order.stride[1];
                for (int i = 0; i < volume.count[0]; ++i) {
                    for (int c = 0; c < volume.components; ++c) {
                        const std::ptrdiff_t at = row + i * order.stride[0] + c * order.component_stride;
                        const auto value =
                            read_sample<T>(stored.bytes.data() + at * static_cast<std::ptrdiff_t>(sizeof(T)),
                                           stored.big_endian);
                        if constexpr (RoundingWatch<T>::is_needed) watch.add(value);
                        *out++ = static_cast<float>(value);
                    }
                }
            }
        }
        volume.rounding = watch.result();
    });
}

Expected<void> check_rounding(Volume& volume) {
    constexpr double most = std::numeric_limits<float>::max();
    constexpr double fewest_steps = 8, fine_steps = 1000;
    const Rounding& r = volume.rounding;
    const auto width = three_digits(r.width), step = three_digits(r.step);
    if (r.beyond > 0)
        return fail(
            text("of its ", volume.samples.size(), " samples, ", r.beyond, r.beyond == 1 ? " is" : " are",
                 " beyond ", three_digits(most),
                 " in size, the most that is kept; check type, byte order and skipped bytes, or divide all "
                 "samples by one number"));
    const bool is_offset = std::max(std::abs(r.low), std::abs(r.high)) > 2 * r.width;
    const auto advice =
        is_offset ? text("subtract ", r.low, " from all samples") : "multiply all samples by one number";
    if (r.step > 0 && r.width > 0 && r.step * fewest_steps > r.width)
        return fail(text("its samples differ by ", width, " at most, from ", r.low,
                         " on, and are kept in steps of ", step, ", which is too coarse; ", advice));
    if (r.step > 0 && r.step * fine_steps > r.width && r.width > 0)
        volume.notes.push_back(text("the samples, which differ by ", width,
                                    " at most, are rounded to steps of ", step, "; to keep all of them, ",
                                    advice));
    else if (r.step > 0 && volume.stored_as < SampleType::float32)
        volume.notes.emplace_back("integers beyond 16,777,216 are rounded");
    return {};
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
