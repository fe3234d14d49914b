// ecs/table.h: stores all entities that have the same set of data components as plain arrays (an archetype).
//
// Measured with `thaum bench ecs`: the arrays of one table iterate at the speed of raw arrays; sparse sets
// reach a quarter of that speed or less. The price is that adding a component moves the entity to another
// table. Five measures keep this cheap:
// - A table edge joins two tables that differ in one component. It lists the arrays between which a row
//   moves, so a row moves in one pass without any look-up.
// - Cells move through registers, in words of at most 32 bytes, without calls.
// - All arrays of a table share one capacity, so one comparison shows whether there is room.
// - Tags, which change most often, are columns of bits. They never move an entity, and a view reads 64 rows
//   of them at a time.
// - A large component may stay in place: its value lies in an array of the World, at the entity's number, and
//   is not copied when the entity moves. The table counts it among its components like any other, so order,
//   snapshots and hashes are the same. With the game's Motion in place, 100,000 loose objects get a Body in
//   16 ns each instead of 30, and lose it in 13 instead of 29 (rows add_1 and remove_1). The price: the array
//   has a cell for each entity number in use, and a view of a part of the entities reads cells that lie apart
//   (every second one of 100,000: 10 ns instead of 7; of 1,000: 2.5 instead of 2.3; row iterate_3_half).
//
// A row is removed by moving the last row into its place. The order of rows therefore depends only on the
// history of the World.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <memory_resource>
#include <new>
#include <utility>
#include <vector>

#include "core/memory.h"
#include "ecs/component.h"
#include "ecs/entity.h"

namespace thaum::ecs {

inline constexpr std::uint32_t none = 0xffffffffU;

/// Memory for tables (arrays of all entities that have the same components), for edges (links between two
/// tables) and for queries (the tables that match one kind of view). It is allocated in one piece and is
/// released with the World or by a restore. A table that first appears in the middle of a match, as when a
/// wizard dies holding a new wand, then needs no allocation, unless it is the first with a component
/// that stays in place.
using TableMemory = std::pmr::monotonic_buffer_resource;
inline constexpr std::size_t table_memory_bytes = std::size_t{4} << 20U;

/// Deleter for objects in TableMemory, which is released as a whole. It runs the destructor and does not free
/// the bytes.
struct DestroyOnly {
    template <class T>
    void operator()(T* object) const {
        object->~T();
    }
};
/// Owner of an object in TableMemory, which is released as a whole.
template <class T>
using Pooled = std::unique_ptr<T, DestroyOnly>;
/// Makes an object in `memory`. Its constructor gets `memory` too, for the arrays of the object.
template <class T>
Pooled<T> make_pooled(TableMemory& memory) {
    return Pooled<T>(new (memory.allocate(sizeof(T), alignof(T))) T(memory));
}

/// Uninitialised memory, aligned to 64 bytes. Small arrays are in TableMemory. Large arrays are allocated
/// from the system and freed when outgrown; in TableMemory their old copies would use up the space.
class RawArray {
public:
    RawArray() = default;
    RawArray(RawArray&& other) noexcept
        : bytes_(std::exchange(other.bytes_, nullptr)), allocated_(std::exchange(other.allocated_, 0)) {}
    RawArray& operator=(RawArray&& other) noexcept {
        std::swap(bytes_, other.bytes_);
        std::swap(allocated_, other.allocated_);
        return *this;
    }
    ~RawArray() {
        if (allocated_ > 0) free_array(bytes_, allocated_);
    }
    std::byte* data() const { return bytes_; }
    /// Enlarges the array and copies its first `keep` bytes.
    void grow(std::size_t bytes, std::size_t keep, TableMemory& memory);

private:
    std::byte* bytes_ = nullptr;
    std::size_t allocated_ = 0;  ///< size of an array from the system; 0: it is in TableMemory (bytes)
};

/// The array of one data component of a table (all entities with the same components).
struct Column {
    std::uint32_t component{};
    std::uint32_t size{};  ///< size of the component in one row (bytes)
    /// Whether the values lie by the numbers of their entities, outside the table. Then `array` is empty.
    bool stays_in_place{};
    RawArray array;

    /// Address of the component's bytes in this row.
    std::byte* cell(std::uint32_t row) const { return array.data() + std::size_t{row} * size; }
};

/// Number of 64-bit words for one bit per row, as a tag has it, in a table of `rows` rows.
constexpr std::size_t words_for(std::uint32_t rows) { return (std::size_t{rows} + 63) / 64; }

/// A tag of a table: one bit per row, set where the entity has the tag. Bits at and beyond `rows` are zero.
struct TagColumn {
    std::uint32_t component{};
    std::pmr::vector<std::uint64_t> words;

    /// Whether the row has the tag.
    bool test(std::uint32_t row) const { return ((words[row / 64] >> (row % 64)) & 1U) != 0; }
    /// Gives the tag to the row.
    void set(std::uint32_t row) { words[row / 64] |= std::uint64_t{1} << (row % 64); }
    void clear(std::uint32_t row) { words[row / 64] &= ~(std::uint64_t{1} << (row % 64)); }
};

/// Marks a tag that no row of the table has ever had.
inline constexpr std::uint8_t no_tag = 0xff;
static_assert(max_components < no_tag);

struct Table;

/// The arrays of one component in two tables. When an entity moves, its value moves from one to the other.
struct ColumnPair {
    std::byte* from;
    std::byte* to;
    std::uint32_t size;  ///< size of the component in one row (bytes)
    std::uint32_t component;
};

/// A link from one table to the table that has one component more, or one fewer. An entity follows it when
/// that component is added or removed.
struct TableEdge {
    /// The change of an entity that follows this edge, packed by edge_key. The default is no change's key.
    std::uint64_t key = ~std::uint64_t{0};
    Table* from = nullptr;
    Table* to = nullptr;
    std::uint32_t to_number = none;
    std::pmr::vector<ColumnPair> pairs;  ///< arrays of the components that both tables have

    explicit TableEdge(TableMemory& memory) : pairs(&memory) {}

    /// Reads the addresses of both tables' arrays again after one of them has moved.
    void aim();
};

/// Packs a change of one entity into one word: its table, the component, and whether the component is added.
constexpr std::uint64_t edge_key(std::uint32_t table, std::uint32_t component, bool more) {
    return (std::uint64_t{table} << 32U) | (component << 1U) | (more ? 1U : 0U);
}

/// All entities that have the same set of data components.
struct Table {
    Mask mask;  ///< set of data components
    TableMemory* memory;
    std::pmr::vector<Column> columns;  ///< arrays of the data components, sorted by number
    std::pmr::vector<TagColumn> tags;  ///< columns of those tags that some row of this table has ever had
    RawArray entity_array;
    std::uint32_t rows = 0;
    /// Number of rows for which every array has room; above 0 if the table has columns.
    std::uint32_t capacity = 0;

    /// Array of each data component; null: no such column. It has one cell for each row, or, of a component
    /// that stays in place, one for each entity number of the World.
    std::array<std::byte*, max_components> cells;
    std::array<std::uint8_t, max_components> tag_of;  ///< index of each tag in `tags`; no_tag: none
    /// Edge for each component. It leads to the table that has this component as well, or, if this table has
    /// the component, to the table that lacks only this one. Null: not known yet.
    std::array<Pooled<TableEdge>, max_components> edges;
    /// Edges (links between two tables) from or to this table, which hold the addresses of its arrays.
    std::pmr::vector<TableEdge*> incident;

    explicit Table(TableMemory& table_memory)
        : memory(&table_memory), columns(memory), tags(memory), incident(memory) {
        cells.fill(nullptr);
        tag_of.fill(no_tag);
    }

    /// Entity of each row.
    Entity* entities() const { return reinterpret_cast<Entity*>(entity_array.data()); }
    /// Array of a data component; null if the table has no such column.
    template <class C>
    C* cells_of(std::uint32_t component) const {
        return reinterpret_cast<C*>(cells[component]);
    }
    /// Adds the array of a data component, which the table does not have yet. The table must have no rows.
    void add_column(std::uint32_t component, std::uint32_t size, bool stays_in_place);
    /// Makes room for this many rows in total in every array.
    void reserve(std::uint32_t rows_wanted);
    void grow() { reserve(capacity == 0 ? 16 : capacity * 2); }
    /// Appends a row for the entity, with uninitialised components and no tags.
    std::uint32_t append(Entity entity) {
        if (rows == capacity) [[unlikely]] {
            grow();
        }
        const auto row = rows;
        entities()[row] = entity;
        rows = row + 1;
        return row;
    }
    /// Moves the last row into the place of `row`. Returns the entity that moved, or the removed entity if
    /// `row` was the last.
    Entity remove(std::uint32_t row);
    /// What `move` has changed: the rows, and the entity that took the place of the moved one.
    struct Moved {
        /// `to_row`: new row in the other table. `last`: row of this table that no longer exists.
        std::uint32_t to_row{}, last{};
        Entity filler;  ///< entity that is now in the row that the moved entity has left
    };
    /// Moves the entity's row to the end of the table to which `edge` (a link between two tables) leads. The
    /// last row of this table takes its place. `move_cells` moves the cells afterwards.
    Moved move(std::uint32_t row, Entity entity, const TableEdge& edge);
    /// Moves the cells (values) of those components that both tables of the edge have. If the table `to` has
    /// one component less, the moved row leaves a free cell in that component's array. The caller fills it,
    /// since only the caller may know its type.
    static void move_cells(const TableEdge& edge, std::uint32_t row, std::uint32_t last,
                           std::uint32_t to_row);
    /// Creates the edge (a link between two tables) to `other`, which differs from this table in `component`
    /// only. Called once for each pair of tables and direction.
    void add_edge(std::uint32_t number, Table& other, std::uint32_t other_number, std::uint32_t component);
    /// Returns the column of a tag, with one bit per row, and creates it on first use.
    TagColumn& tag_column(std::uint32_t component) {
        const auto at = tag_of[component];
        if (at == no_tag) [[unlikely]] {
            return new_tag_column(component);
        }
        return tags[at];
    }

private:
    TagColumn& new_tag_column(std::uint32_t component);
    void move_tags(std::uint32_t row, Table& to, std::uint32_t to_row);
    void close_tags(std::uint32_t row);
    Entity close(std::uint32_t row) {
        const std::uint32_t last = rows - 1;
        rows = last;
        return entities()[row] = entities()[last];
    }
};

/// @{
/// Words of 16 and 32 bytes. They go through vector registers.
using Word16 = std::uint64_t __attribute__((vector_size(16)));
using Word32 = std::uint64_t __attribute__((vector_size(32)));
/// @}

/// Reads a word from bytes of any alignment.
template <class Word>
[[gnu::always_inline]] inline Word load(const std::byte* from) {
    Word word;
    std::memcpy(&word, from, sizeof word);
    return word;
}

/// Writes a word to bytes of any alignment.
template <class Word>
[[gnu::always_inline]] inline void store(std::byte* to, const Word& word) {
    std::memcpy(to, &word, sizeof word);
}

/// Calls f(word) with the largest type of word that is not larger than a cell of `size` bytes.
template <class F>
[[gnu::always_inline]] inline void with_word(std::size_t size, F&& f) {
    if (size >= sizeof(Word32)) {
        f(Word32{});
    } else if (size >= sizeof(Word16)) {
        f(Word16{});
    } else if (size >= sizeof(std::uint64_t)) {
        f(std::uint64_t{});
    } else if (size >= sizeof(std::uint32_t)) {
        f(std::uint32_t{});
    } else {
        f(std::byte{});
    }
}

/// Copies the cell (one component of one entity) at `hole` to `to`, then the cell at `filler` into the hole.
/// Words are copied from the start of the cell on, but the last one ends where the cell ends. It may overlap
/// the word before it, so a cell may have any size. For that reason the last words are read before the first
/// is written.
[[gnu::always_inline]] inline void move_cell(std::byte* to, std::byte* hole, const std::byte* filler,
                                             std::size_t size) {
    with_word(size, [&]<class Word>(Word) {
        const std::size_t end = size - sizeof(Word);
        const auto moved_end = load<Word>(hole + end), filler_end = load<Word>(filler + end);
        for (std::size_t i = 0; i < end; i += sizeof(Word)) {
            const auto moved = load<Word>(hole + i), filling = load<Word>(filler + i);
            store(to + i, moved);
            store(hole + i, filling);
        }
        store(to + end, moved_end);
        store(hole + end, filler_end);
    });
}

/// Copies a cell (one component of one entity). `to` and `from` may be the same cell.
[[gnu::always_inline]] inline void copy_cell(std::byte* to, const std::byte* from, std::size_t size) {
    with_word(size, [&]<class Word>(Word) {
        const std::size_t end = size - sizeof(Word);
        for (std::size_t i = 0; i < end; i += sizeof(Word)) store(to + i, load<Word>(from + i));
        store(to + end, load<Word>(from + end));
    });
}

[[gnu::always_inline]] inline Entity Table::remove(std::uint32_t row) {
    const std::uint32_t last = rows - 1;
    if (row != last) {
        for (const auto& column : columns) {
            if (column.stays_in_place) continue;
            copy_cell(column.cell(row), column.cell(last), column.size);
        }
    }
    if (!tags.empty()) close_tags(row);
    return close(row);
}

[[gnu::always_inline]] inline Table::Moved Table::move(std::uint32_t row, Entity entity,
                                                       const TableEdge& edge) {
    auto& to = *edge.to;
    if (to.rows == to.capacity) [[unlikely]] {
        to.grow();
    }
    const std::uint32_t last = rows - 1, to_row = to.rows;
    if (!tags.empty()) [[unlikely]] {
        move_tags(row, to, to_row);
    }
    auto* const here = entities();
    const Entity filler = here[last];
    to.rows = to_row + 1;
    rows = last;
    to.entities()[to_row] = entity;
    here[row] = filler;
    return {to_row, last, filler};
}

[[gnu::always_inline]] inline void Table::move_cells(const TableEdge& edge, std::uint32_t row,
                                                     std::uint32_t last, std::uint32_t to_row) {
    for (const auto& pair : edge.pairs) {
        const std::size_t size = pair.size;
        move_cell(pair.to + to_row * size, pair.from + row * size, pair.from + last * size, size);
    }
}

}  // namespace thaum::ecs
