// ecs/table.h: stores all entities that have the same set of data components as plain arrays (an archetype).
//
// Measured with `thaum bench ecs`: the arrays of one table iterate at the speed of raw arrays; sparse sets
// reach a quarter of that speed or less. The price is that adding a component moves the entity to another
// table. Four measures keep this cheap, and iteration over the arrays is unaffected by them:
// - A table edge joins two tables that differ in one component. It lists the arrays between which a row
//   moves, so a row moves in one pass without any look-up.
// - Cells of common sizes move through registers.
// - All arrays of a table share one capacity, so one comparison shows whether there is room.
// - Tags, which change most often, are columns of bits. They never move an entity, and a view reads 64 rows
//   of them at a time.
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
#include <span>
#include <utility>
#include <vector>

#include "ecs/component.h"
#include "ecs/entity.h"

namespace thaum::ecs {

inline constexpr std::uint32_t none = 0xffffffffU;

/// Memory for tables and table edges. It comes from the system in one piece and is released with the World or
/// by a restore. A table that first appears in the middle of a match, as when a wizard dies holding a new
/// wand, then needs no allocation.
using TableMemory = std::pmr::monotonic_buffer_resource;
inline constexpr std::size_t table_memory_bytes = std::size_t{4} << 20U;

/// Deleter for objects in TableMemory. It runs the destructor and does not free the bytes.
struct DestroyOnly {
    template <class T>
    void operator()(T* object) const {
        object->~T();
    }
};
template <class T>
using Pooled = std::unique_ptr<T, DestroyOnly>;
template <class T>
Pooled<T> make_pooled(TableMemory& memory) {
    return Pooled<T>(new (memory.allocate(sizeof(T), alignof(T))) T(memory));
}

/// Uninitialised memory, aligned to 64 bytes. Small arrays are in TableMemory. Large arrays come from the
/// system and are freed when outgrown; in TableMemory their old copies would use up the space.
class RawArray {
public:
    RawArray() = default;
    RawArray(RawArray&& other) noexcept
        : bytes_(std::exchange(other.bytes_, nullptr)), pooled_(other.pooled_) {}
    RawArray& operator=(RawArray&& other) noexcept {
        std::swap(bytes_, other.bytes_);
        std::swap(pooled_, other.pooled_);
        return *this;
    }
    ~RawArray() {
        if (!pooled_) ::operator delete (bytes_, std::align_val_t{64});
    }
    std::byte* data() const { return bytes_; }
    /// Enlarges the array and copies its first `keep` bytes.
    void grow(std::size_t bytes, std::size_t keep, TableMemory& memory);

private:
    std::byte* bytes_ = nullptr;
    bool pooled_ = true;
};

struct Column {
    std::uint32_t component{};
    std::uint32_t size{};  ///< size of one row (bytes)
    RawArray array;

    std::byte* cell(std::uint32_t row) const { return array.data() + std::size_t{row} * size; }
};

/// Number of 64-bit words that a bit column of `rows` rows needs.
constexpr std::size_t words_for(std::uint32_t rows) { return (std::size_t{rows} + 63) / 64; }

/// One bit per row. Bits at and beyond `rows` are zero.
struct TagColumn {
    std::uint32_t component{};
    std::pmr::vector<std::uint64_t> words;

    bool test(std::uint32_t row) const { return ((words[row / 64] >> (row % 64)) & 1U) != 0; }
    void set(std::uint32_t row) { words[row / 64] |= std::uint64_t{1} << (row % 64); }
    void clear(std::uint32_t row) { words[row / 64] &= ~(std::uint64_t{1} << (row % 64)); }
};

/// Marks a tag that no row of the table has ever had.
inline constexpr std::uint8_t no_tag = 0xff;
static_assert(max_components < no_tag);

struct Table;

/// Returns true if cells of this size are copied by a few moves instead of a call (bytes).
constexpr bool through_registers(std::uint32_t size) {
    return size == 4 || size == 8 || size == 12 || size == 16 || size == 24 || size == 32;
}

/// Cell size with a loop of its own in `move_cells` (bytes): three floats, the most common size of moved
/// cells.
inline constexpr std::uint32_t pair_size = 12;

/// The arrays of one component in two tables, between which its cells move.
struct ColumnPair {
    std::byte* from;
    std::byte* to;
    std::uint32_t size;  ///< size of a cell (bytes)
    std::uint32_t component;
};

/// Leads from one table to the table with one component more or less.
struct TableEdge {
    std::uint64_t key = ~std::uint64_t{0};  ///< result of edge_key; the default matches no table
    Table* from = nullptr;
    Table* to = nullptr;
    std::uint32_t to_number = none;
    std::pmr::vector<ColumnPair> pairs;  ///< columns of both tables with cells of `pair_size` bytes
    /// Columns of both tables with other cells that go through registers.
    std::pmr::vector<ColumnPair> more_pairs;
    std::pmr::vector<ColumnPair> odd_pairs;  ///< all other columns of both tables
    bool only_pairs = true;                  ///< more_pairs and odd_pairs are empty

    explicit TableEdge(TableMemory& memory) : pairs(&memory), more_pairs(&memory), odd_pairs(&memory) {}

    /// Refreshes the array pointers after a reallocation.
    void aim();
};

/// Packs a change of one entity into one word: its table, the component, and whether the component is added.
constexpr std::uint64_t edge_key(std::uint32_t table, std::uint32_t component, bool more) {
    return (std::uint64_t{table} << 32U) | (component << 1U) | (more ? 1U : 0U);
}

struct Table {
    Mask mask;  ///< set of data components
    TableMemory* memory;
    std::pmr::vector<Column> columns;  ///< sorted by component
    std::pmr::vector<TagColumn> tags;  ///< only tags that a row of this table has ever had
    RawArray entity_array;
    std::uint32_t rows = 0;
    /// Capacity of every array; above 0 if there are columns (rows).
    std::uint32_t capacity = 0;

    std::array<std::byte*, max_components> cells;     ///< array of each data component; null: no such column
    std::array<std::uint8_t, max_components> tag_of;  ///< index of each tag in `tags`; no_tag: none
    /// Edge to the table with this component more or less. Null: not known yet.
    std::array<Pooled<TableEdge>, max_components> edges;
    /// Edges from or to this table, which hold the addresses of its arrays.
    std::pmr::vector<TableEdge*> incident;

    explicit Table(TableMemory& table_memory)
        : memory(&table_memory), columns(memory), tags(memory), incident(memory) {
        cells.fill(nullptr);
        tag_of.fill(no_tag);
    }

    Entity* entities() const { return reinterpret_cast<Entity*>(entity_array.data()); }
    template <class C>
    C* cells_of(std::uint32_t component) const {
        return reinterpret_cast<C*>(cells[component]);
    }
    /// Adds a column, once per component, to a table without rows.
    void add_column(std::uint32_t component, std::uint32_t size);
    void reserve(std::uint32_t rows_wanted);
    void grow() { reserve(capacity == 0 ? 16 : capacity * 2); }
    /// Appends a row with uninitialised cells and no tags.
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
    /// Moves the entity's row to the end of the table at the other end of `edge`. The last row of this table
    /// takes its place. The cells are left to `move_cells`.
    struct Moved {
        /// the new row in the other table; the row of this table that no longer exists
        std::uint32_t to_row{}, last{};
        Entity filler;  ///< entity that is in the old row now
    };
    Moved move(std::uint32_t row, Entity entity, const TableEdge& edge);
    /// Moves only the cells that both tables have. If `to` has one column less, the caller fills the hole in
    /// that column, since only the caller may know its type.
    static void move_cells(const TableEdge& edge, std::uint32_t row, std::uint32_t last,
                           std::uint32_t to_row);
    /// Creates the edge to `other`, which differs from this table in `component` only. Called once per pair
    /// and direction.
    void join(std::uint32_t number, Table& other, std::uint32_t other_number, std::uint32_t component);
    /// Returns the bit column of a tag and creates it on first use.
    TagColumn& tag_column(std::uint32_t component) {
        const auto at = tag_of[component];
        if (at == no_tag) [[unlikely]] {
            return new_tag_column(component);
        }
        return tags[at];
    }

private:
    TagColumn& new_tag_column(std::uint32_t component);
    static void move_other_cells(const TableEdge& edge, std::uint32_t row, std::uint32_t last,
                                 std::uint32_t to_row);
    static void move_odd_cells(std::span<const ColumnPair> pairs, std::uint32_t row, std::uint32_t last,
                               std::uint32_t to_row);
    void move_tags(std::uint32_t row, Table& to, std::uint32_t to_row);
    void close_tags(std::uint32_t row);
    Entity close(std::uint32_t row) {
        const std::uint32_t last = rows - 1;
        rows = last;
        return entities()[row] = entities()[last];
    }
};

/// Calls f(size). The size is a compile-time constant if cells of that size go through registers.
template <class F>
[[gnu::always_inline]] inline void with_size(std::uint32_t size, F&& f) {
    switch (size) {
        case 4: return f(std::integral_constant<std::size_t, 4>{});
        case 8: return f(std::integral_constant<std::size_t, 8>{});
        case 12: return f(std::integral_constant<std::size_t, 12>{});
        case 16: return f(std::integral_constant<std::size_t, 16>{});
        case 24: return f(std::integral_constant<std::size_t, 24>{});
        case 32: return f(std::integral_constant<std::size_t, 32>{});
        default: return f(std::size_t{size});
    }
}

template <class Word>
[[gnu::always_inline]] inline void copy_word(std::byte* to, const std::byte* from) {
    Word word;
    std::memcpy(&word, from, sizeof word);
    std::memcpy(to, &word, sizeof word);
}

/// Copies word by word, so that `from` may equal `to`.
template <std::size_t size>
[[gnu::always_inline]] inline void copy_cell(std::byte* to, const std::byte* from,
                                             std::integral_constant<std::size_t, size>) {
    constexpr std::size_t whole = size / 8 * 8;
#pragma GCC unroll 4
    for (std::size_t i = 0; i < whole; i += 8) copy_word<std::uint64_t>(to + i, from + i);
    if constexpr (whole < size) copy_word<std::uint32_t>(to + whole, from + whole);
}
inline void copy_cell(std::byte* to, const std::byte* from, std::size_t size) {
    std::memmove(to, from, size);
}

[[gnu::always_inline]] inline Entity Table::remove(std::uint32_t row) {
    const std::uint32_t last = rows - 1;
    if (row != last) {
        for (const auto& column : columns) {
            auto* hole = column.cell(row);
            const auto* filler = column.cell(last);
            with_size(column.size, [&](auto size) { copy_cell(hole, filler, size); });
        }
    }
    if (!tags.empty()) close_tags(row);
    return close(row);
}

/// Copies the cell of `row` to `to_row` of the other table, then the cell of `last` into the hole.
template <std::size_t size>
[[gnu::always_inline]] inline void move_cell(const ColumnPair& pair, std::size_t row, std::size_t last,
                                             std::size_t to_row) {
    constexpr std::integral_constant<std::size_t, size> constant{};
    auto* hole = pair.from + row * size;
    copy_cell(pair.to + to_row * size, hole, constant);
    copy_cell(hole, pair.from + last * size, constant);
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

// The loop handles one cell size only. With several sizes the compiler would compute the addresses for each
// of them before the loop and keep them on the stack.
[[gnu::always_inline]] inline void Table::move_cells(const TableEdge& edge, std::uint32_t row,
                                                     std::uint32_t last, std::uint32_t to_row) {
    for (const auto *pair = edge.pairs.data(), *end = pair + edge.pairs.size(); pair != end; ++pair)
        move_cell<pair_size>(*pair, row, last, to_row);
    if (!edge.only_pairs) [[unlikely]] {
        move_other_cells(edge, row, last, to_row);
    }
}

}  // namespace thaum::ecs
