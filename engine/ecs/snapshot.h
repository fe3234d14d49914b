// ecs/snapshot.h: the whole World as bytes, back again, and its 64-bit hash.
//
// Layout, little-endian: "THAUMECS", format u32; components: count u32, each name, size u32, fields (count u32, each name, offset u32,
// scalar u8); entity records (count u32, then generation, table, row u32 each), first free u32; tables: count u32, each
// mask 2 x u64, rows u32, entities, then each column's cells, then tags: count u32, each component u32 and words.
// A string is its length u32 and its characters. A snapshot explains itself, so two of them can be compared without the program that made them (ecs/diff.h).
#pragma once
#include <cstdint>
#include <span>

#include "core/bytes.h"
#include "core/error.h"
#include "ecs/world.h"

namespace thaum::ecs {

/// Writes over `out`; reusing it avoids allocation.
void save(const World& world, Bytes& out);

/// The World becomes what was saved: it must have declared the same components. Hooks are not called: whoever keeps
/// something beside the World rebuilds it. On an error the World is empty.
Expected<void> restore(World& world, std::span<const std::byte> snapshot);

/// Equal where the Worlds will behave equally from here on: components, entities, order of iteration, free numbers.
std::uint64_t state_hash(const World& world);

}  // namespace thaum::ecs
