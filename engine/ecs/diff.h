// ecs/diff.h: lists the differences between two snapshots in words. Every desync is found this way.
#pragma once
#include <string>
#include <vector>

#include "core/bytes.h"
#include "core/error.h"

namespace thaum::ecs {

struct Difference {
    std::string component;  ///< empty if the entity exists on one side only
    std::uint32_t entity{};
    std::string field;  ///< such as "position.x"; empty if the component exists on one side only
    std::string a, b;   ///< both values; "-" if there is none
};

/// Returns at most `limit` differences, sorted by entity, then component, then field. Entities are matched by
/// number and components by name. If only the order of iteration or the free list differs, one Difference has
/// the field "order". The error says which snapshot cannot be read.
Expected<std::vector<Difference>> diff(std::span<const std::byte> a, std::span<const std::byte> b,
                                       std::size_t limit = 100);

}  // namespace thaum::ecs
