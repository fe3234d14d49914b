// field/volume_samples.h: the samples of a volume in memory, in the type of the file that they come from.
//
// Integers of 8 bits without a sign and of 16 bits stay as they are and take 1 or 2 bytes each; all other
// types become floats. Readers get either as the number that it is, so a float of the same number gives the
// same result to the last bit.
#pragma once
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace thaum::field {

/// The first of some samples in memory, in one of the types in which VolumeSamples holds them.
using FirstSample =
    std::variant<const float*, const std::uint8_t*, const std::int16_t*, const std::uint16_t*>;

/// Samples of one type.
struct VolumeSamples {
    /// The samples themselves, in one of the types.
    std::variant<std::vector<float>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>>
        values{};

    /// @{
    /// No samples, or those of a list or of a vector of one of the types.
    VolumeSamples() = default;
    VolumeSamples(std::initializer_list<float> floats) : values(std::vector<float>(floats)) {}
    template <class T>
    VolumeSamples(std::vector<T> of_one_type) : values(std::move(of_one_type)) {}
    /// @}

    /// Returns use(values), where `values` is a constant std::vector of one of the types.
    template <class Use>
    decltype(auto) visit(Use use) const {
        return std::visit(use, values);
    }
    /// Number of samples.
    std::size_t size() const {
        return visit([](const auto& all) { return all.size(); });
    }
    /// Whether there are no samples.
    bool empty() const { return size() == 0; }
    /// Sample number i. It costs a look at the type; visit() looks once for all samples.
    float operator[](std::size_t i) const {
        return visit([i](const auto& all) { return static_cast<float>(all[i]); });
    }
    /// Sample number i, and those after it.
    FirstSample from(std::size_t i) const {
        return visit([i](const auto& all) { return FirstSample(all.data() + i); });
    }
    /// The samples as floats, to change them. If they are integers, all of them become floats first.
    std::vector<float>& floats();
    /// A copy of the samples as floats.
    std::vector<float> as_floats() const;

    /// Whether the samples are the same numbers; they may be of different types.
    bool operator==(const VolumeSamples& other) const;
};

/// The type in which VolumeSamples holds numbers that a file stores as T.
template <class T>
using HeldAs = std::conditional_t<std::is_same_v<T, std::uint8_t> || std::is_same_v<T, std::int16_t> ||
                                      std::is_same_v<T, std::uint16_t>,
                                  T, float>;

}  // namespace thaum::field
