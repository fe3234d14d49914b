// ecs/diff.h: lists the differences between two snapshots in words, to find where two runs of a match
// diverge.
#pragma once
#include <string>
#include <vector>

#include "core/bytes.h"
#include "core/error.h"

namespace thaum::ecs {

/// One value, component or entity in which two snapshots differ.
struct Difference {
    /// Component or blob (array without an entity); empty if one snapshot lacks the entity.
    std::string component;
    std::uint32_t entity{};  ///< number of the entity; `none` for a blob
    /// Name of the field, such as "position.x", or the index "[7]" in a blob (an array that no entity owns).
    /// Empty if the component exists in one snapshot only, or if the sizes of the blobs differ.
    std::string field;
    std::string a, b;  ///< values in the two snapshots as text; "-" where a snapshot has none
};

/// Returns at most `limit` differences, sorted by entity, then component, then field, blobs last. Entities
/// are matched by number and components by name. If only the order of iteration or the list of free entity
/// numbers differs, one Difference has the field "order". The error says which snapshot cannot be read.
Expected<std::vector<Difference>> diff(std::span<const std::byte> a, std::span<const std::byte> b,
                                       std::size_t limit = 100);

}  // namespace thaum::ecs
