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
    std::string component;   ///< component or blob; empty if the entity exists on one side only
    std::uint32_t entity{};  ///< number of the entity; `none` for a blob
    /// Name of the field, such as "position.x", or the index "[7]" in a blob. Empty if the component exists
    /// on one side only, or if the blob has another size there.
    std::string field;
    std::string a, b;  ///< both values as text; "-" where there is none
};

/// Returns at most `limit` differences, sorted by entity, then component, then field, blobs last. Entities
/// are matched by number and components by name. If only the order of iteration or the free list differs, one
/// Difference has the field "order". The error says which snapshot cannot be read.
Expected<std::vector<Difference>> diff(std::span<const std::byte> a, std::span<const std::byte> b,
                                       std::size_t limit = 100);

}  // namespace thaum::ecs
