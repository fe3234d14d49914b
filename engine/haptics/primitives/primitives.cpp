#include "haptics/primitives/primitives.h"

#include <cmath>
#include <string>

namespace thaum::haptics {

PrimitiveFault fault_of(const Primitive& primitive) noexcept {
    const bool has_position = primitive.kind != PrimitiveKind::directed;
    const bool has_direction = primitive.kind != PrimitiveKind::point;
    if (!std::isfinite(primitive.strength) || (has_position && !is_finite(primitive.position)) ||
        (has_direction && !is_finite(primitive.direction)))
        return PrimitiveFault::not_finite;
    if (primitive.strength < 0) return PrimitiveFault::negative;
    if (primitive.strength > primitive_limit) return PrimitiveFault::out_of_range;
    if (has_position && glm::length(primitive.position) > primitive_limit)
        return PrimitiveFault::out_of_range;
    if (has_direction && std::abs(glm::length(primitive.direction) - 1) > 1e-6)
        return PrimitiveFault::not_unit;
    return PrimitiveFault::none;
}

PrimitiveFault PrimitiveSet::add(const Primitive& primitive) noexcept {
    if (count_ == items_.size()) return PrimitiveFault::full;
    const auto fault = fault_of(primitive);
    if (fault != PrimitiveFault::none) return fault;
    Primitive& taken = items_[count_++] = primitive;
    if (taken.kind != PrimitiveKind::point) taken.direction = glm::normalize(taken.direction);
    return fault;
}

Expected<PrimitiveSet> checked(std::span<const Primitive> primitives) {
    static constexpr std::array words{"",
                                      "the set is full: give at most 16 primitives",
                                      "a field is not finite: give finite numbers",
                                      "position or strength is above 1e6: give smaller values",
                                      "strength is negative: give 0 or more",
                                      "the direction is not a unit vector: normalise it"};
    PrimitiveSet set;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const auto fault = set.add(primitives[i]);
        if (fault != PrimitiveFault::none)
            return fail("primitive " + std::to_string(i) + ": " + words[static_cast<std::size_t>(fault)]);
    }
    return set;
}

}  // namespace thaum::haptics
