// field/detail/sample_decoder.h: puts stored samples into a volume, piece by piece as a file is read.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/bytes.h"
#include "field/volume.h"

namespace thaum::field {

/// Positions of a volume's samples in a file, counted in samples. The axes are nested: between two neighbours
/// along one axis lie all samples of the axes that run faster.
struct StoredOrder {
    std::ptrdiff_t first{};  ///< index of component 0 of sample (0, 0, 0)
    /// Distance in the file to the next sample along each axis of the volume; negative if the file runs the
    /// other way.
    std::array<std::ptrdiff_t, 3> stride{};
    std::ptrdiff_t component_stride{1};
};

/// The order in which Volume::samples holds samples.
StoredOrder plain_order(const std::array<int, 3>& count, int components);

/// Whether the samples are plausible in the byte order in which they are read.
enum class ByteOrder : std::uint8_t {
    plausible,
    doubtful,  ///< every sample is an integer multiple of 256
    /// Many floats are too large or too small for any physical quantity. With the other byte order, no float
    /// would be.
    wrong,
};

/// Finds out what is lost when samples are rounded to float. T is the widest number type of the samples'
/// kind: double, or integers of 64 bits with or without a sign.
template <class T>
class RoundingWatch {
public:
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

/// Puts the samples of a file into a volume. The pieces come in the order of the file, so that neither the
/// file nor its unpacked bytes are ever in memory as a whole.
class SampleDecoder {
public:
    /// `volume` has its count and components; its samples are filled. Of the `stored` samples times
    /// components in the file, those that `order` does not name are left out.
    SampleDecoder(SampleType type, bool big_endian, const StoredOrder& order, std::size_t stored,
                  Volume& volume);

    /// Takes the next bytes of the file, which hold whole samples.
    void take(std::span<const std::byte> bytes);
    /// Judges by samples from the whole file whether it was read in the right byte order.
    ByteOrder byte_order() const;
    /// After the last sample, records in volume.rounding what rounding to float has changed.
    void finish();

private:
    /// An axis of the samples that are read: their number, and the distances between neighbours.
    struct Axis {
        std::ptrdiff_t count{1};
        std::ptrdiff_t stride{1};  ///< distance in the file, > 0 (samples)
        std::ptrdiff_t step{1};    ///< distance in Volume::samples
    };

    void join_axes();
    template <class T>
    std::vector<HeldAs<T>>& samples_to(std::ptrdiff_t last);
    template <class T>
    void convert(const std::byte* from, std::ptrdiff_t count);
    void next_run();
    void look(std::span<const std::byte> bytes);

    Volume& volume_;
    SampleType type_;
    bool big_endian_;
    std::ptrdiff_t size_;         ///< size of a sample in the file (bytes)
    std::array<Axis, 4> axes_{};  ///< axes from the fastest one in the file to the slowest
    std::size_t axis_count_ = 0;
    std::array<std::ptrdiff_t, 4> at_{};  ///< index of the next sample along each axis
    std::ptrdiff_t from_ = 0, to_ = 0;    ///< index of the next sample in the file, and in the volume
    std::ptrdiff_t position_ = 0;         ///< number of samples that were taken
    bool has_all_ = false;
    Bytes looked_at_;  ///< samples by which the byte order is judged
    std::ptrdiff_t look_step_, next_look_ = 0;
    std::tuple<RoundingWatch<std::int64_t>, RoundingWatch<std::uint64_t>, RoundingWatch<double>> watches_;
};

}  // namespace thaum::field
