// haptics/primitives/primitives.h: haptic primitives, forces on a proxy that a spring ties to the
// probe (Lundin, Cooper, Persson, Evestedt, Ynnerman 2007, "Enabling design and interactive
// selection of haptic modes", section 2.3).
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/error.h"
#include "core/maths.h"

namespace thaum::haptics {

/// Kind of a primitive (see Primitive). As wide as a double, so that a Primitive has no padding.
enum class PrimitiveKind : std::uint64_t { directed, point, line, plane };

/// One force on the proxy x (world frame), by the equations of Lundin and others 2007.
///
///     directed   s q                                                    eq. 4
///     point      s (p - x) / |p - x|                                    eq. 5
///     line       s m / |m|, m from x to the nearest point of the line   eq. 6
///     plane      s q where (x - p).q < 0, none elsewhere                eq. 7
///
/// The point, the line or the plane is a kink of the potential. On the kink the force is the one that
/// balances the others, up to s.
struct Primitive {
    PrimitiveKind kind{};
    vec3 position{};   ///< position p (m); not used by directed
    vec3 direction{};  ///< direction q (unit); not used by point
    /// Strength s (N), >= 0 because a repelling force is not minus the gradient of a convex function. Below
    /// 1e-300 it counts as 0.
    double strength{};
};
static_assert(sizeof(Primitive) == sizeof(PrimitiveKind) + 2 * sizeof(vec3) + sizeof(double), "no padding");

inline constexpr std::size_t primitive_capacity = 16;

/// Limit of a primitive's |position| (m) and strength (N), and of each coordinate of a spring's centre (m):
/// far beyond any device, and no product of them overflows.
inline constexpr double primitive_limit = 1e6;

/// Reason why a primitive was refused. `full`: the set has no room for it.
enum class PrimitiveFault : std::uint8_t { none, full, not_finite, out_of_range, negative, not_unit };

/// Returns the fault of a primitive. Fields that its kind does not use may have any value.
PrimitiveFault fault_of(const Primitive& primitive) noexcept;

/// Checked primitives. Trivially copyable and without allocation, so a servo loop can hold and fill it.
class PrimitiveSet {
public:
    /// Adds a primitive if it has no fault; otherwise leaves the set unchanged and returns the fault. A
    /// direction within 1e-6 of unit length is normalised. A primitive of strength zero takes a place too.
    PrimitiveFault add(const Primitive& primitive) noexcept;

    void clear() noexcept { count_ = by_proxy_ = 0; }
    /// Multiplies the strengths of the primitives from index `first` on by a share from 0 to 1, to fade them.
    void weaken(std::size_t first, double share) noexcept {
        for (std::size_t i = first; i < count_; ++i) items_[i].strength *= share;
    }
    /// The primitives in the order of their addition.
    std::span<const Primitive> items() const noexcept { return {items_.data(), count_}; }

    /// Whether some primitives depend on the place of the proxy in the last tick, as those of modes do. The
    /// servo then limits the proxy's motion in a tick (haptics/primitives/settling.h).
    bool by_proxy() const noexcept { return by_proxy_ != 0; }
    /// Marks the set as one whose primitives depend on the place of the proxy in the last tick.
    void set_by_proxy() noexcept { by_proxy_ = 1; }

private:
    std::array<Primitive, primitive_capacity> items_{};
    std::uint32_t count_{}, by_proxy_{};
};
static_assert(sizeof(PrimitiveSet) == primitive_capacity * sizeof(Primitive) + 2 * sizeof(std::uint32_t),
              "no padding");

/// Checks the primitives of a list and returns them as a set. The error names the index and the fault of the
/// first bad primitive.
Expected<PrimitiveSet> checked(std::span<const Primitive> primitives);

/// Whether the set is a passive source: it has no directed force. A directed force may push the hand for
/// ever, because its energy has no minimum.
inline bool conservative(const PrimitiveSet& set) {
    const auto items = set.items();
    return std::none_of(items.begin(), items.end(),
                        [](const Primitive& p) { return p.kind == PrimitiveKind::directed; });
}

}  // namespace thaum::haptics
