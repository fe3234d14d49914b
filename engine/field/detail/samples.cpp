#include "field/detail/samples.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstring>
#include <limits>

#include "core/text.h"

namespace thaum::field {
namespace {

constexpr std::array<std::string_view, 10> type_names{"int8",   "uint8", "int16",  "uint16", "int32",
                                                      "uint32", "int64", "uint64", "float",  "double"};

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
        volume.samples.visit([&](const auto& samples) {
            for (const auto sample : samples) {
                const T value = stored_value<T>(static_cast<float>(sample));
                std::memcpy(out, &value, sizeof(T));
                out += sizeof(T);
            }
        });
    });
    return bytes;
}

}  // namespace thaum::field
