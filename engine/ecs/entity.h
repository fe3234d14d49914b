// ecs/entity.h: a handle to an entity in a World. It also holds a generation, which says how often the
// entity's number was used before. By this a handle of an entity that no longer exists is recognised.
#pragma once
#include <cstdint>

namespace thaum::ecs {

/// Handle of an entity: its number, and how often that number was used before.
struct Entity {
    std::uint32_t index = 0xffffffffU;
    std::uint32_t generation = 0;

    bool operator==(const Entity&) const = default;
    /// Returns false for the default value, which is not an entity.
    explicit operator bool() const { return index != 0xffffffffU; }
};

inline constexpr Entity no_entity{};

}  // namespace thaum::ecs
