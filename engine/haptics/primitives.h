// haptics/primitives.h: forces on a proxy that a spring ties to the probe (Lundin, Cooper, Persson, Evestedt, Ynnerman
// 2007, "Enabling design and interactive selection of haptic modes", section 2.3).
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/error.h"
#include "core/maths.h"

namespace thaum::haptics {

/// As wide as a double, so that a Primitive has no padding.
enum class PrimitiveKind : std::uint64_t { directed, point, line, plane };

/// One force on the proxy x; world frame.
///
///     directed   s q                                                    eq. 4
///     point      s (p - x) / |p - x|                                    eq. 5
///     line       s m / |m|, m from x to the nearest point of the line   eq. 6
///     plane      s q where (x - p).q < 0, none elsewhere                eq. 7
///
/// On the kink itself the force is what balance asks for, up to s.
struct Primitive {
    PrimitiveKind kind{};
    vec3 position{};   ///< p, m; directed ignores it
    vec3 direction{};  ///< q, unit; point ignores it
    double
        strength{};  ///< s, N, >= 0: a repelling force is no gradient of a convex function; below 1e-300 it counts as 0
};
static_assert(sizeof(Primitive) == sizeof(PrimitiveKind) + 2 * sizeof(vec3) + sizeof(double), "no padding");

inline constexpr std::size_t primitive_capacity = 16;

/// Of |position|, m, |centre|, m, and strength, N: far beyond any device, and no product of them overflows.
inline constexpr double primitive_limit = 1e6;

enum class PrimitiveFault : std::uint8_t { none, full, not_finite, out_of_range, negative, not_unit };

/// What is wrong with a primitive. Fields that its kind ignores may be anything.
PrimitiveFault fault_of(const Primitive& primitive) noexcept;

/// Checked primitives. Trivially copyable, no allocation, so that a servo loop can hold and fill it.
class PrimitiveSet {
public:
    /// Takes a primitive that has no fault, and otherwise leaves the set as it was. A direction within 1e-6 of unit length
    /// is made unit; strength zero counts.
    PrimitiveFault add(const Primitive& primitive) noexcept;

    void clear() noexcept { count_ = 0; }
    std::span<const Primitive> items() const noexcept { return {items_.data(), count_}; }

private:
    std::array<Primitive, primitive_capacity> items_{};
    std::size_t count_{};
};
static_assert(sizeof(PrimitiveSet) == primitive_capacity * sizeof(Primitive) + sizeof(std::size_t),
              "no padding");

/// The whole list or none of it. The error names the index and the fault.
Expected<PrimitiveSet> checked(std::span<const Primitive> primitives);

}  // namespace thaum::haptics
