#include "field/detail/sample_decoder.h"

#include <cstring>
#include <set>

#include "core/assert.h"
#include "core/large_pages.h"
#include "field/detail/samples.h"

namespace thaum::field {
namespace {

/// Largest number of samples by which the byte order is judged.
constexpr std::ptrdiff_t max_looked_at = 4096;

template <class T>
T read_sample(const std::byte* from, bool big_endian) {
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), from, sizeof(T));
    if (big_endian) std::ranges::reverse(bytes);
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
}

/// Whether a float may round a number of this type.
template <class T>
constexpr bool may_round = sizeof(T) > sizeof(float) || (sizeof(T) == 4 && std::integral<T>);

/// The widest number type of T's kind: floating point, or integers with or without a sign.
template <class T>
using Widest = std::conditional_t<std::floating_point<T>, double,
                                  std::conditional_t<std::signed_integral<T>, std::int64_t, std::uint64_t>>;

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

StoredOrder plain_order(const std::array<int, 3>& count, int components) {
    const std::ptrdiff_t step = components, row = step * count[0];
    return {.stride = {step, row, row * count[1]}};
}

SampleDecoder::SampleDecoder(SampleType type, bool big_endian, const StoredOrder& order, std::size_t stored,
                             Volume& volume)
    : volume_(volume),
      type_(type),
      big_endian_(big_endian),
      size_(static_cast<std::ptrdiff_t>(size_of(type))),
      from_(order.first),
      look_step_(static_cast<std::ptrdiff_t>(stored) / max_looked_at + 1) {
    const auto add = [&](std::ptrdiff_t count, std::ptrdiff_t stride, std::ptrdiff_t step) {
        if (count == 1) return;
        if (stride < 0) {
            from_ += (count - 1) * stride;
            to_ += (count - 1) * step;
            stride = -stride;
            step = -step;
        }
        axes_[axis_count_++] = {count, stride, step};
    };
    std::ptrdiff_t step = volume.components;
    add(step, order.component_stride, 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        add(volume.count[axis], order.stride[axis], step);
        step *= volume.count[axis];
    }
    join_axes();
}

/// Sorts the axes, and joins two axes whose samples form one row both in the file and in the volume.
void SampleDecoder::join_axes() {
    std::sort(axes_.begin(), axes_.begin() + static_cast<std::ptrdiff_t>(axis_count_),
              [](const Axis& a, const Axis& b) { return a.stride < b.stride; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < axis_count_; ++i) {
        const Axis& next = axes_[i];
        Axis& inner = axes_[last];
        if (next.stride == inner.count * inner.stride && next.step == inner.count * inner.step)
            inner.count *= next.count;
        else
            axes_[++last] = next;
    }
    axis_count_ = last + 1;
}

/// Keeps some of the samples, evenly spaced over the file, to judge the byte order.
void SampleDecoder::look(std::span<const std::byte> bytes) {
    const std::ptrdiff_t end = position_ + static_cast<std::ptrdiff_t>(bytes.size()) / size_;
    for (; next_look_ < end; next_look_ += look_step_) {
        const std::byte* sample = bytes.data() + (next_look_ - position_) * size_;
        looked_at_.insert(looked_at_.end(), sample, sample + size_);
    }
}

void SampleDecoder::take(std::span<const std::byte> bytes) {
    THAUM_ASSERT(static_cast<std::ptrdiff_t>(bytes.size()) % size_ == 0, "a part of a sample");
    look(bytes);
    const std::ptrdiff_t end = position_ + static_cast<std::ptrdiff_t>(bytes.size()) / size_;
    while (!has_all_ && from_ < end) {
        const Axis& row = axes_[0];
        const std::ptrdiff_t here = std::min(row.count - at_[0], (end - from_ + row.stride - 1) / row.stride);
        with_type(type_, [&]<class T>(T) { convert<T>(bytes.data() + (from_ - position_) * size_, here); });
        from_ += here * row.stride;
        to_ += here * row.step;
        at_[0] += here;
        if (at_[0] == row.count) next_run();
    }
    position_ = end;
}

/// Goes on to the next row of samples.
void SampleDecoder::next_run() {
    for (std::size_t i = 0; i < axis_count_ && at_[i] == axes_[i].count; ++i) {
        from_ -= axes_[i].count * axes_[i].stride;
        to_ -= axes_[i].count * axes_[i].step;
        at_[i] = 0;
        has_all_ = i + 1 == axis_count_;
        if (has_all_) return;
        ++at_[i + 1];
        from_ += axes_[i + 1].stride;
        to_ += axes_[i + 1].step;
    }
}

/// The volume's samples, which reach to sample `last` or beyond. The vector grows only as far as they are
/// read, so that the memory that it fills with zeros is still in the cache when they are written.
template <class T>
std::vector<HeldAs<T>>& SampleDecoder::samples_to(std::ptrdiff_t last) {
    using Held = std::vector<HeldAs<T>>;
    if (volume_.samples.empty()) {
        std::size_t all = static_cast<std::size_t>(volume_.components);
        for (const int n : volume_.count) all *= static_cast<std::size_t>(n);
        auto& samples = volume_.samples.values.emplace<Held>();
        samples.reserve(all);
        ask_for_large_pages(samples.data(), all * sizeof(HeldAs<T>));
    }
    auto& samples = std::get<Held>(volume_.samples.values);
    const auto wanted = static_cast<std::size_t>(last) + 1;
    if (samples.size() < wanted) samples.resize(wanted);
    return samples;
}

/// Puts `count` samples of a row into the volume.
template <class T>
void SampleDecoder::convert(const std::byte* from, std::ptrdiff_t count) {
    const Axis row = axes_[0];
    auto* const to = samples_to<T>(std::max(to_, to_ + (count - 1) * row.step)).data() + to_;
    const auto put = [&](std::ptrdiff_t i, bool big_endian, std::ptrdiff_t apart, std::ptrdiff_t to_apart) {
        const auto value =
            read_sample<T>(from + i * apart * static_cast<std::ptrdiff_t>(sizeof(T)), big_endian);
        if constexpr (may_round<T>) std::get<RoundingWatch<Widest<T>>>(watches_).add(value);
        to[i * to_apart] = static_cast<HeldAs<T>>(value);
    };
    // The usual case has a loop of its own, which the compiler vectorises.
    if (row.stride == 1 && row.step == 1 && !big_endian_) {
        for (std::ptrdiff_t i = 0; i < count; ++i) put(i, false, 1, 1);
    } else {
        for (std::ptrdiff_t i = 0; i < count; ++i) put(i, big_endian_, row.stride, row.step);
    }
}

ByteOrder SampleDecoder::byte_order() const {
    constexpr std::size_t share = 10;
    // Least number of different values to judge by; fewer may look right in both byte orders by chance.
    constexpr std::size_t fewest_values = 16;
    ByteOrder result{};
    with_type(type_, [&]<class T>(T) {
        if (sizeof(T) == 1) return;
        std::size_t looked_at = 0, odd = 0, odd_in_other = 0;
        std::set<T> values;
        for (std::size_t at = 0; at < looked_at_.size(); at += sizeof(T)) {
            const std::byte* from = looked_at_.data() + at;
            const T value = read_sample<T>(from, big_endian_);
            if (value == T{}) continue;
            ++looked_at;
            if (values.size() < fewest_values && is_number(value)) values.insert(value);
            odd += is_odd(value) ? 1 : 0;
            odd_in_other += is_odd(read_sample<T>(from, !big_endian_)) ? 1 : 0;
        }
        const bool enough = values.size() >= fewest_values && odd_in_other == 0;
        if (std::floating_point<T> && enough && odd * share >= looked_at) result = ByteOrder::wrong;
        if (std::integral<T> && enough && odd == looked_at) result = ByteOrder::doubtful;
    });
    return result;
}

void SampleDecoder::finish() {
    THAUM_ASSERT(has_all_, "fewer samples than the volume has");
    volume_.rounding = {};
    with_type(type_, [&]<class T>(T) {
        if constexpr (may_round<T>) volume_.rounding = std::get<RoundingWatch<Widest<T>>>(watches_).result();
    });
}

}  // namespace thaum::field
