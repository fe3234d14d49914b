// ecs/table.h: all entities with one set of data components, as plain arrays (an archetype).
//
// Measured (thaum bench ecs): arrays of one table iterate at the speed of raw arrays, sparse sets at a quarter of it and
// less. The price of tables is that adding a component moves the entity to another table; it is kept low by
// cached neighbours (`plus`, `minus`) and by copying rows without any call per component. Tags, which change most often, are
// columns of bits instead: they never move an entity, and a view over them walks 64 rows at a time.
//
// A row is removed by moving the last row into it, so the order of rows follows from the history of the world alone.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "ecs/component.h"
#include "ecs/entity.h"

namespace thaum::ecs {

inline constexpr std::uint32_t none = 0xffffffffU;

/// 64-byte aligned memory that is not initialised.
class RawArray {
public:
    std::byte* data() const { return bytes_.get(); }
    /// Keeps the first `keep` bytes.
    void grow(std::size_t bytes, std::size_t keep);

private:
    struct Free {
        void operator()(std::byte* p) const { ::operator delete (p, std::align_val_t{64}); }
    };
    std::unique_ptr<std::byte, Free> bytes_;
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
    std::uint32_t set_bits{};
    std::vector<std::uint64_t> words;

    bool test(std::uint32_t row) const { return ((words[row / 64] >> (row % 64)) & 1U) != 0; }
    void set(std::uint32_t row) { words[row / 64] |= std::uint64_t{1} << (row % 64); }
    void clear(std::uint32_t row) { words[row / 64] &= ~(std::uint64_t{1} << (row % 64)); }
};

struct Table {
    Mask mask;  ///< data components
    std::vector<Column> columns;
    std::vector<TagColumn> tags;  ///< only those that a row here has had
    RawArray entity_array;
    std::uint32_t rows = 0;
    std::uint32_t capacity = 0;

    std::array<std::uint32_t, max_components> column_of;  ///< index into columns or tags; none
    std::array<std::uint32_t, max_components> plus;  ///< table with this component more; none = not known yet
    std::array<std::uint32_t, max_components> minus;  ///< table with this component less

    Table() {
        column_of.fill(none);
        plus.fill(none);
        minus.fill(none);
    }

    Entity* entities() const { return reinterpret_cast<Entity*>(entity_array.data()); }
    std::byte* cell(std::uint32_t column, std::uint32_t row) const { return columns[column].cell(row); }
    void reserve(std::uint32_t rows_wanted);
    /// A new last row with uninitialised cells and no tags.
    std::uint32_t append(Entity entity) {
        if (rows == capacity) [[unlikely]] {
            reserve(capacity == 0 ? 16 : capacity * 2);
        }
        entities()[rows] = entity;
        return rows++;
    }
    /// The last row takes the place of `row`; returns the entity that moved (the removed one if it was the last).
    Entity remove(std::uint32_t row);
    /// The column of bits of a tag, made when it is first needed.
    TagColumn& tag_column(std::uint32_t component) {
        const auto at = column_of[component];
        if (at == none) [[unlikely]] {
            return new_tag_column(component);
        }
        return tags[at];
    }

    TagColumn& new_tag_column(std::uint32_t component);
    /// The tags of `row` as those of a fresh row of another table.
    void copy_tags(std::uint32_t row, Table& to, std::uint32_t to_row) const;
    /// The last row's tags take the place of those of `row`.
    void close_tags(std::uint32_t row);
};

/// memcpy whose common sizes are single moves instead of a call.
inline void copy_cell(std::byte* to, const std::byte* from, std::uint32_t size) {
    switch (size) {
        case 4: std::memcpy(to, from, 4); return;
        case 8: std::memcpy(to, from, 8); return;
        case 12: std::memcpy(to, from, 12); return;
        case 16: std::memcpy(to, from, 16); return;
        case 24: std::memcpy(to, from, 24); return;
        case 32: std::memcpy(to, from, 32); return;
        default: std::memcpy(to, from, size);
    }
}

inline Entity Table::remove(std::uint32_t row) {
    const std::uint32_t last = rows - 1;
    if (row != last) {
        for (const auto& column : columns) copy_cell(column.cell(row), column.cell(last), column.size);
    }
    if (!tags.empty()) close_tags(row);
    const Entity moved = entities()[last];
    entities()[row] = moved;
    rows = last;
    return moved;
}

/// Copies the cells and tags that both tables have. to_row must be fresh.
inline void copy_row(const Table& from, std::uint32_t row, Table& to, std::uint32_t to_row) {
    for (const auto& column : from.columns) {
        const auto target = to.column_of[column.component];
        if (target != none) copy_cell(to.cell(target, to_row), column.cell(row), column.size);
    }
    if (!from.tags.empty()) from.copy_tags(row, to, to_row);
}

}  // namespace thaum::ecs
