// ecs/table.h: all entities with one set of data components, as plain arrays (an archetype).
//
// Measured (thaum bench ecs): arrays of one table iterate at the speed of raw arrays, sparse sets at a quarter of it and
// less. The price of tables is that adding a component moves the entity to another table. What keeps it low lies
// beside the arrays and not in them, so that iteration knows nothing of it: an edge joins two tables that differ in one
// component and knows the arrays between which a row moves, so that it moves in one pass without any look-up; cells of
// common sizes move through registers; and one capacity for all arrays makes "is there room" one question. Tags, which
// change most often, are columns of bits: they never move an entity, and a view over them walks 64 rows at a time.
//
// A row is removed by moving the last row into it, so the order of rows follows from the history of the world alone.
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

/// Memory for tables and edges, taken from the system in one piece and given back with the World or by a restore. A table
/// that first appears in the middle of a match, when somebody dies with a new wand in hand, then costs no allocation.
using TableMemory = std::pmr::monotonic_buffer_resource;
inline constexpr std::size_t table_memory_bytes = std::size_t{4} << 20U;

/// Destroys what lies in TableMemory, whose bytes stay there.
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

/// 64-byte aligned memory that is not initialised. Small arrays lie in TableMemory; large ones would fill it with the
/// arrays that they have outgrown, and are given back to the system.
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
    /// Keeps the first `keep` bytes.
    void grow(std::size_t bytes, std::size_t keep, TableMemory& memory);

private:
    std::byte* bytes_ = nullptr;
    bool pooled_ = true;
};

struct Column {
    std::uint32_t component{};
    std::uint32_t size{};  ///< bytes per row
    RawArray array;

    std::byte* cell(std::uint32_t row) const { return array.data() + std::size_t{row} * size; }
};

/// Words of a bit column with that many rows.
constexpr std::size_t words_for(std::uint32_t rows) { return (std::size_t{rows} + 63) / 64; }

/// One bit a row; bits at and beyond `rows` are zero.
struct TagColumn {
    std::uint32_t component{};
    std::pmr::vector<std::uint64_t> words;

    bool test(std::uint32_t row) const { return ((words[row / 64] >> (row % 64)) & 1U) != 0; }
    void set(std::uint32_t row) { words[row / 64] |= std::uint64_t{1} << (row % 64); }
    void clear(std::uint32_t row) { words[row / 64] &= ~(std::uint64_t{1} << (row % 64)); }
};

/// A table's number for a tag that no row of it has had.
inline constexpr std::uint8_t no_tag = 0xff;
static_assert(max_components < no_tag);

struct Table;

/// Whether cells of so many bytes are copied by a few moves instead of a call.
constexpr bool through_registers(std::uint32_t size) {
    return size == 4 || size == 8 || size == 12 || size == 16 || size == 24 || size == 32;
}

/// bytes: three floats, of which most of what is added and removed while a game runs is made.
inline constexpr std::uint32_t lane_size = 12;

/// Two arrays of one component, between which its cells move.
struct Lane {
    std::byte* from;
    std::byte* to;
    std::uint32_t size;  ///< of a cell, bytes
    std::uint32_t component;
};

/// From one table to that with one component more, or less.
struct Edge {
    std::uint64_t key = ~std::uint64_t{0};  ///< edge_key; no table has the number in this one
    Table* from = nullptr;
    Table* to = nullptr;
    std::uint32_t to_number = none;
    std::pmr::vector<Lane> lanes;       ///< of what both have; those of `lane_size` bytes
    std::pmr::vector<Lane> more_lanes;  ///< those of other sizes whose cells go through registers
    std::pmr::vector<Lane> odd_lanes;   ///< and the others
    bool only_lanes = true;             ///< there are no more and no odd ones

    explicit Edge(TableMemory& memory) : lanes(&memory), more_lanes(&memory), odd_lanes(&memory) {}

    /// Finds the arrays anew.
    void aim();
};

/// What a change of one entity asks for, in one word: from which table, which component, more or less of it.
constexpr std::uint64_t edge_key(std::uint32_t table, std::uint32_t component, bool more) {
    return (std::uint64_t{table} << 32U) | (component << 1U) | (more ? 1U : 0U);
}

struct Table {
    Mask mask;  ///< data components
    TableMemory* memory;
    std::pmr::vector<Column> columns;  ///< in the order of their components
    std::pmr::vector<TagColumn> tags;  ///< only those that a row here has had
    RawArray entity_array;
    std::uint32_t rows = 0;
    std::uint32_t capacity = 0;  ///< of every array; above 0 where there are columns

    std::array<std::byte*, max_components> cells;     ///< a data component's array; null: no such column
    std::array<std::uint8_t, max_components> tag_of;  ///< a tag's index into tags; no_tag
    /// The way to the table with this component more, or less; null: not known yet.
    std::array<Pooled<Edge>, max_components> edges;
    std::pmr::vector<Edge*>
        incident;  ///< from here or to here: they hold the addresses of this table's arrays

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
    /// Once, for a table without rows.
    void add_column(std::uint32_t component, std::uint32_t size);
    void reserve(std::uint32_t rows_wanted);
    void grow() { reserve(capacity == 0 ? 16 : capacity * 2); }
    /// A new last row with uninitialised cells and no tags.
    std::uint32_t append(Entity entity) {
        if (rows == capacity) [[unlikely]] {
            grow();
        }
        const auto row = rows;
        entities()[row] = entity;
        rows = row + 1;
        return row;
    }
    /// The last row takes the place of `row`; returns the entity that moved (the removed one if it was the last).
    Entity remove(std::uint32_t row);
    /// The entity's row becomes a new last row of the neighbour at the end of one of this table's edges, and the last row here
    /// takes its place; but for the cells, which `move_cells` moves.
    struct Moved {
        std::uint32_t to_row{}, last{};  ///< over there; here, which is no row any more
        Entity filler;                   ///< that is in the old row now
    };
    Moved move(std::uint32_t row, Entity entity, const Edge& edge);
    /// Only cells that both have are touched: where `to` has one column less, the caller fills the hole in it, whose type he may
    /// know.
    static void move_cells(const Edge& edge, std::uint32_t row, std::uint32_t last, std::uint32_t to_row);
    /// Once, for two tables that differ in this component.
    void join(std::uint32_t number, Table& other, std::uint32_t other_number, std::uint32_t component);
    /// The column of bits of a tag, made when it is first needed.
    TagColumn& tag_column(std::uint32_t component) {
        const auto at = tag_of[component];
        if (at == no_tag) [[unlikely]] {
            return new_tag_column(component);
        }
        return tags[at];
    }

private:
    TagColumn& new_tag_column(std::uint32_t component);
    static void move_other_cells(const Edge& edge, std::uint32_t row, std::uint32_t last,
                                 std::uint32_t to_row);
    static void move_odd_cells(std::span<const Lane> lanes, std::uint32_t row, std::uint32_t last,
                               std::uint32_t to_row);
    void move_tags(std::uint32_t row, Table& to, std::uint32_t to_row);
    void close_tags(std::uint32_t row);
    Entity close(std::uint32_t row) {
        const std::uint32_t last = rows - 1;
        rows = last;
        return entities()[row] = entities()[last];
    }
};

/// Calls f(size), with a constant where cells of that size go through registers.
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

/// Word by word, so that `from` may be `to`.
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

/// The cell of `row` goes to `to_row` over there, the last into the hole.
template <std::size_t size>
[[gnu::always_inline]] inline void move_cell(const Lane& lane, std::size_t row, std::size_t last,
                                             std::size_t to_row) {
    constexpr std::integral_constant<std::size_t, size> constant{};
    auto* hole = lane.from + row * size;
    copy_cell(lane.to + to_row * size, hole, constant);
    copy_cell(hole, lane.from + last * size, constant);
}

[[gnu::always_inline]] inline Table::Moved Table::move(std::uint32_t row, Entity entity, const Edge& edge) {
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

// One size of cells in the loop, since the places in arrays of every size would be worked out before it and kept on the stack.
[[gnu::always_inline]] inline void Table::move_cells(const Edge& edge, std::uint32_t row, std::uint32_t last,
                                                     std::uint32_t to_row) {
    for (const auto *lane = edge.lanes.data(), *end = lane + edge.lanes.size(); lane != end; ++lane)
        move_cell<lane_size>(*lane, row, last, to_row);
    if (!edge.only_lanes) [[unlikely]] {
        move_other_cells(edge, row, last, to_row);
    }
}

}  // namespace thaum::ecs
