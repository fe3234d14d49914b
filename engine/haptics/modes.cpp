#include "haptics/modes.h"

#include <algorithm>
#include <cmath>

namespace thaum::haptics {

std::vector<const Mode*> modes_for(FieldKind kind) {
    std::vector<const Mode*> result;
    for (const Mode& mode : modes()) {
        if (mode.reads == kind) result.push_back(&mode);
    }
    return result;
}

std::vector<ModeOffer> mode_offers(FieldKind kind) {
    using enum field::FilterKind;
    std::vector<ModeOffer> offers;
    const auto offer = [&](FieldKind read, std::optional<field::FilterKind> through) {
        for (const Mode* mode : modes_for(read)) offers.push_back({mode, through});
    };
    offer(kind, std::nullopt);
    if (kind == FieldKind::scalar) {
        offer(FieldKind::vector, gradient);
    } else {
        offer(FieldKind::scalar, magnitude);
        offer(FieldKind::scalar, divergence);
        offer(FieldKind::vector, curl);
    }
    return offers;
}

const field::AnyField& field_for(const Mode& mode, const field::FilteredField& filtered) {
    return mode.derivatives ? filtered.field : filtered.quick;
}

std::size_t add_modes(std::span<const ModeUse> uses, const ModeInput& input, PrimitiveSet& set) noexcept {
    std::size_t left_out = 0;
    set.set_by_proxy();
    for (const ModeUse& use : uses) {
        const bool readable =
            use.mode != nullptr && (use.mode->reads == FieldKind::vector ? use.field.vector.read != nullptr
                                                                         : use.field.scalar.read != nullptr);
        if (readable && set.items().size() + use.mode->primitives <= primitive_capacity)
            use.mode->add(use.field, use.settings, input, set);
        else
            ++left_out;
    }
    return left_out;
}

Direction direction_of(vec3 v) noexcept {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 1e-300) || !is_finite(v)) return {};
    const vec3 scaled = v / largest;  // the squares of its components cannot overflow
    const double length = glm::length(scaled);
    return {scaled / length, std::min(length * largest, 1e300)};
}

Direction towards_core(const field::Vector& here) noexcept {
    return direction_of(glm::cross(curl(here), here.value));
}

double strength_at(const field::TransferFunction& strength, double x) noexcept {
    const double found = std::isfinite(x) ? strength(x) : 0;
    return std::isfinite(found) ? std::clamp(found, -primitive_limit, primitive_limit) : 0;
}

vec3 held_back(const ModeInput& input, vec3 normal, double friction) noexcept {
    const vec3 pull = input.pull(), along = pull - glm::dot(pull, normal) * normal;
    const double length = glm::length(along);
    if (!(length > 0) || !(friction > 0)) return input.next_tip();
    return input.next_tip() + std::min(1.0, friction / length) / input.stiffness * along;
}

void add_or_rest(PrimitiveSet& set, const Primitive& primitive) noexcept {
    if (set.add(primitive) != PrimitiveFault::none) set.add({.kind = PrimitiveKind::point});
}

void add_turned(PrimitiveSet& set, Primitive primitive) noexcept {
    if (primitive.strength < 0) {
        primitive.strength = -primitive.strength;
        primitive.direction = -primitive.direction;
    }
    add_or_rest(set, primitive);
}

}  // namespace thaum::haptics
