// ecs/diff.h: what differs between two snapshots, in words: how every desync is found.
#pragma once
#include <string>
#include <vector>

#include "core/bytes.h"
#include "core/error.h"

namespace thaum::ecs {

struct Difference {
    std::string component;  ///< empty where the entity itself is on one side only
    std::uint32_t entity{};
    std::string field;  ///< "position.x"; empty where the component is on one side only
    std::string a, b;   ///< both values; "-" where there is none
};

/// At most `limit` differences, by entity, then component, then field. Entities and components are matched by number
/// and name. Where only the order of iteration or the free numbers differ, one Difference with field "order" says so.
/// The error says which snapshot cannot be read.
Expected<std::vector<Difference>> diff(std::span<const std::byte> a, std::span<const std::byte> b,
                                       std::size_t limit = 100);

}  // namespace thaum::ecs
