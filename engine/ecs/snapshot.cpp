#include "ecs/snapshot.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/hash.h"

namespace thaum::ecs {
namespace {

constexpr std::uint32_t max_rows = 1U << 28U;
constexpr std::uint64_t max_blob_bytes = std::uint64_t{1} << 32U;

template <class T>
std::span<const std::byte> raw(const T* data, std::size_t count) {
    return std::as_bytes(std::span(data, count));
}

/// Calls f(bytes) for pieces that together are the values of a column in the order of the rows. A component
/// that stays in place has a piece for each run of entities with consecutive numbers.
template <class F>
void for_each_piece(const Table& table, const Column& column, F&& f) {
    const std::size_t size = column.size;
    if (!column.stays_in_place) {
        f(std::span<const std::byte>(column.array.data(), table.rows * size));
        return;
    }
    const auto* entities = table.entities();
    for (std::uint32_t row = 0; row < table.rows;) {
        const auto first = entities[row].index;
        std::uint32_t count = 1;
        while (row + count < table.rows && entities[row + count].index == first + count) ++count;
        f(std::span<const std::byte>(table.cells[column.component] + first * size, count * size));
        row += count;
    }
}

std::uint64_t hash_of(const Table& table, const Column& column) {
    HashOfPieces hash;
    for_each_piece(table, column, [&](auto bytes) { hash.add(bytes); });
    return hash.value();
}

void put_components(ByteWriter& out, const World& world) {
    out.put_bytes(raw(snapshot_magic.data(), snapshot_magic.size()));
    out.put(snapshot_format);
    out.put(static_cast<std::uint32_t>(world.components().size()));
    for (const auto& info : world.components()) {
        out.put_string(info.name);
        out.put(info.size);
        out.put(static_cast<std::uint8_t>(info.is_blob));
        out.put(static_cast<std::uint32_t>(info.fields.size()));
        for (const auto& field : info.fields) {
            out.put_string(field.name);
            out.put(field.offset);
            out.put(field.scalar);
        }
    }
}

}  // namespace

/// Functions with access to the private parts of a World. Only snapshots use them.
struct SnapshotAccess {
    static std::size_t size_of_state(const World& world) {
        std::size_t bytes = world.records_.size() * sizeof(World::Record) + 64;
        for (const auto& table : world.tables_) {
            bytes += 64 + std::size_t{table->rows} * sizeof(Entity);
            for (const auto& column : table->columns) bytes += std::size_t{table->rows} * column.size;
            bytes += table->tags.size() * (4 + words_for(table->rows) * 8);
        }
        for (const auto& blob : world.blobs_) bytes += 8 + blob.size();
        return bytes;
    }

    static void save(const World& world, Bytes& out) {
        Bytes head;
        ByteWriter writer(head);
        put_components(writer, world);
        out.clear();
        out.reserve(head.size() + size_of_state(world));
        ByteWriter body(out);
        body.put_bytes(head);
        body.put(static_cast<std::uint32_t>(world.records_.size()));
        body.put_bytes(raw(world.records_.data(), world.records_.size()));
        body.put(world.free_);
        body.put(static_cast<std::uint32_t>(world.tables_.size()));
        for (const auto& table : world.tables_) put_table(body, *table);
        for (std::size_t c = 0; c < world.infos_.size(); ++c) {
            if (!world.infos_[c].is_blob) continue;
            body.put(std::uint64_t{world.blobs_[c].size() / world.infos_[c].size});
            body.put_bytes(world.blobs_[c]);
        }
    }

    static void put_table(ByteWriter& out, const Table& table) {
        for (const auto word : table.mask.words) out.put(word);
        out.put(table.rows);
        out.put_bytes(raw(table.entities(), table.rows));
        for (const auto& column : table.columns) {
            for_each_piece(table, column, [&](auto bytes) { out.put_bytes(bytes); });
        }
        out.put(static_cast<std::uint32_t>(table.tags.size()));
        for (const auto& tag : table.tags) {
            out.put(tag.component);
            out.put_bytes(raw(tag.words.data(), words_for(table.rows)));
        }
    }

    static std::uint64_t hash(const World& world) {
        auto h = hash_bytes(raw(world.records_.data(), world.records_.size()), world.free_);
        for (const auto& table : world.tables_) {
            h = hash_combine(h, table->mask.words[0]);
            h = hash_combine(h, table->mask.words[1] ^ table->rows);
            h = hash_combine(h, hash_bytes(raw(table->entities(), table->rows)));
            for (const auto& column : table->columns) h = hash_combine(h, hash_of(*table, column));
            for (const auto& tag : table->tags) {
                h = hash_combine(h, hash_bytes(raw(tag.words.data(), words_for(table->rows)), tag.component));
            }
        }
        for (std::size_t c = 0; c < world.blobs_.size(); ++c) {
            if (!world.blobs_[c].empty()) h = hash_combine(h, hash_bytes(world.blobs_[c], c));
        }
        return h;
    }

    static void reset(World& world) {
        world.records_.clear();
        world.last_edge_ = &world.no_edge_;
        world.tables_.clear();
        for (auto& query : world.queries_) query.reset();
        world.places_ = {};
        world.memory_.release();
        world.tables_.push_back(make_pooled<Table>(world.memory_));
        world.free_ = none;
        // Sets the counts (numbers of entities) of components to 0, but keeps the counts of resources, which
        // come after them in the array.
        std::fill_n(world.counts_.begin(), world.infos_.size(), 0);
        for (auto& blob : world.blobs_) blob.clear();
        world.forget_packs();
    }

    static bool same_components(ByteReader& in, const World& world) {
        const auto name = in.get_bytes(snapshot_magic.size());
        if (!in.ok() || std::memcmp(name.data(), snapshot_magic.data(), name.size()) != 0) return false;
        if (in.get<std::uint32_t>() != snapshot_format) return false;
        Bytes head;
        ByteWriter writer(head);
        put_components(writer, world);
        const std::size_t remaining = head.size() - snapshot_magic.size() - 4;
        const auto theirs = in.get_bytes(remaining);
        return in.ok() && std::memcmp(theirs.data(), head.data() + (head.size() - remaining), remaining) == 0;
    }

    /// Reads the saved state into the World. Returns false if the bytes are cut off or contradict each other.
    static bool get_state(ByteReader& in, World& world) {
        const auto records = in.get<std::uint32_t>();
        const auto bytes = in.get_bytes(std::size_t{records} * sizeof(World::Record));
        if (!in.ok()) return false;
        world.records_.resize(records);
        if (records > 0) std::memcpy(world.records_.data(), bytes.data(), bytes.size());
        world.make_places(records);
        world.free_ = in.get<std::uint32_t>();
        const auto tables = in.get<std::uint32_t>();
        for (std::uint32_t t = 0; t < tables; ++t) {
            if (!get_table(in, world, t)) return false;
        }
        if (!get_blobs(in, world)) return false;
        return in.ok() && in.left() == 0 && tables > 0 && consistent(world);
    }

    static bool get_blobs(ByteReader& in, World& world) {
        for (std::uint32_t c = 0; c < world.infos_.size(); ++c) {
            const auto& info = world.infos_[c];
            if (!info.is_blob) continue;
            const auto elements = in.get<std::uint64_t>();
            if (!in.ok() || elements > max_blob_bytes / info.size || elements * info.size > in.left())
                return false;
            world.resize_blob(c, elements * info.size);
            if (!copy(in, world.blobs_[c].data(), world.blobs_[c].size())) return false;
        }
        return true;
    }

    static bool get_table(ByteReader& in, World& world, std::uint32_t number) {
        Mask mask;
        for (auto& word : mask.words) word = in.get<std::uint64_t>();
        const auto rows = in.get<std::uint32_t>();
        if (!in.ok() || rows > max_rows) return false;
        for (std::uint32_t c = 0; c < max_components; ++c) {
            if (mask.test(c) && (c >= world.infos_.size() || !has_cells(world.infos_[c]))) return false;
        }
        // A table holds the entities that have the same components, and the first table those that have none.
        // Refuses a second table with the same components, and a first table that has components.
        if (world.table_with(mask) != number) return false;
        auto& table = *world.tables_[number];
        if (in.left() < std::size_t{rows} * sizeof(Entity)) return false;
        table.reserve(rows);
        table.rows = rows;
        if (!copy(in, reinterpret_cast<std::byte*>(table.entities()), std::size_t{rows} * sizeof(Entity)))
            return false;
        for (auto& column : table.columns) {
            if (!get_column(in, world, table, column)) return false;
            world.counts_[column.component] += rows;
        }
        return get_tags(in, world, table);
    }

    static bool get_column(ByteReader& in, const World& world, const Table& table, const Column& column) {
        const std::size_t size = column.size;
        if (!column.stays_in_place) return copy(in, column.array.data(), table.rows * size);
        for (std::uint32_t row = 0; row < table.rows; ++row) {
            const auto index = table.entities()[row].index;
            if (index >= world.records_.size()) return false;
            if (!copy(in, table.cells[column.component] + index * size, size)) return false;
        }
        return true;
    }

    /// Whether this is a component with data. Only such a component has a column of values in each table;
    /// tags and blobs have none.
    static bool has_cells(const ComponentInfo& info) { return info.size != 0 && !info.is_blob; }

    static bool get_tags(ByteReader& in, World& world, Table& table) {
        const auto tags = in.get<std::uint32_t>();
        for (std::uint32_t i = 0; i < tags; ++i) {
            const auto component = in.get<std::uint32_t>();
            if (!in.ok() || component >= world.infos_.size() || world.infos_[component].size != 0)
                return false;
            if (table.tag_of[component] != no_tag) return false;
            auto& tag = table.tag_column(component);
            const auto words = words_for(table.rows);
            if (!copy(in, reinterpret_cast<std::byte*>(tag.words.data()), words * 8)) return false;
            if (table.rows % 64 != 0 && (tag.words[words - 1] >> (table.rows % 64)) != 0) return false;
            for (std::size_t w = 0; w < words; ++w) {
                world.counts_[component] += static_cast<std::uint32_t>(std::popcount(tag.words[w]));
            }
        }
        return in.ok();
    }

    static bool copy(ByteReader& in, std::byte* to, std::size_t n) {
        const auto from = in.get_bytes(n);
        if (in.ok() && n > 0) std::memcpy(to, from.data(), n);
        return in.ok();
    }

    /// Returns true if the tables and the records agree. A record says in which table and row the entity with
    /// one number is. The entity of every row must point back to its row, every living record must have a
    /// row, and the list of free records must consist of all others.
    static bool consistent(World& world) {
        std::size_t rows = 0;
        for (std::uint32_t t = 0; t < world.tables_.size(); ++t) {
            const auto& table = *world.tables_[t];
            rows += table.rows;
            for (std::uint32_t row = 0; row < table.rows; ++row) {
                const Entity e = table.entities()[row];
                if (!world.alive(e)) return false;
                const auto& record = world.records_[e.index];
                if (record.table != t || record.row != row) return false;
            }
        }
        std::size_t living = 0;
        for (const auto& record : world.records_) living += record.table != none ? 1U : 0U;
        std::size_t free = 0;
        for (auto i = world.free_; i != none; i = world.records_[i].row, ++free) {
            if (i >= world.records_.size() || world.records_[i].table != none ||
                free > world.records_.size()) {
                return false;
            }
        }
        return living == rows && living + free == world.records_.size();
    }
};

void save(const World& world, Bytes& out) { SnapshotAccess::save(world, out); }

Expected<void> restore(World& world, std::span<const std::byte> snapshot) {
    SnapshotAccess::reset(world);
    ByteReader in(snapshot);
    if (!SnapshotAccess::same_components(in, world)) {
        return fail("snapshot: not one of this program's (its components differ)");
    }
    if (!SnapshotAccess::get_state(in, world)) {
        SnapshotAccess::reset(world);
        return fail("snapshot: cut off or damaged");
    }
    return {};
}

std::uint64_t state_hash(const World& world) { return SnapshotAccess::hash(world); }

}  // namespace thaum::ecs
