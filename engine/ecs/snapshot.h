// ecs/snapshot.h: saves the whole World as bytes, restores it, and computes its 64-bit hash.
//
// Layout, little-endian:
//     "THAUMECS", format u32
//     components and blobs: count u32, then for each name, size u32, whether it is a blob u8, fields (count
//         u32, then for each name, offset u32, scalar u8)
//     entity records: count u32, then for each generation, table, row u32; first free record u32
//     tables: count u32, then for each its set of components 2 x u64, rows u32, entities, the array of values
//         of each component, tags (count u32, then for each component u32 and one bit per row in words)
//     for each blob, in the order of declaration: elements u64, their values
//
// A string is its length u32 followed by its characters. A snapshot describes itself, so ecs/diff.h can
// compare two snapshots without the program that wrote them.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "core/bytes.h"
#include "core/error.h"
#include "ecs/world.h"

namespace thaum::ecs {

inline constexpr std::string_view snapshot_magic = "THAUMECS";
inline constexpr std::uint32_t snapshot_format = 2;

/// Saves the World in `out`, whose contents are replaced. Reusing the same `out` avoids allocation.
void save(const World& world, Bytes& out);

/// Restores a saved World. The World must have declared the same components. Hooks (functions called when a
/// component is added or removed) are not called, so the owner of any data derived from the World must
/// rebuild that data. On an error the World is empty.
Expected<void> restore(World& world, std::span<const std::byte> snapshot);

/// Hash of everything that decides how the World behaves from here on: components, entities, blobs,
/// order of iteration and free entity numbers.
std::uint64_t state_hash(const World& world);

}  // namespace thaum::ecs
