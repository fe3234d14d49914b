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
};

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
    std::byte* cell(std::uint32_t column, std::uint32_t row) const {
        const auto& c = columns[column];
        return c.array.data() + std::size_t{row} * c.size;
    }
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
    TagColumn& tag_column(std::uint32_t component);
};

/// Copies the cells and tags that both tables have. dst_row must be fresh.
void copy_row(const Table& from, std::uint32_t row, Table& to, std::uint32_t dst_row);

}  // namespace thaum::ecs
