#include "ecs/table.h"

#include <cstring>
#include <new>

namespace thaum::ecs {

void RawArray::grow(std::size_t bytes, std::size_t keep, TableMemory& memory) {
    constexpr std::size_t pooled_most = std::size_t{64} << 10U;
    RawArray larger;
    larger.pooled_ = bytes <= pooled_most;
    auto* const made =
        larger.pooled_ ? memory.allocate(bytes, 64) : ::operator new (bytes, std::align_val_t{64});
    larger.bytes_ = static_cast<std::byte*>(made);
    if (keep > 0) std::memcpy(larger.bytes_, bytes_, keep);
    *this = std::move(larger);
}

void Table::add_column(std::uint32_t component, std::uint32_t size) {
    columns.push_back({component, size, {}});
}

void Table::reserve(std::uint32_t rows_wanted) {
    if (rows_wanted <= capacity) return;
    capacity = rows_wanted;
    entity_array.grow(std::size_t{capacity} * sizeof(Entity), std::size_t{rows} * sizeof(Entity), *memory);
    for (auto& column : columns) {
        column.array.grow(std::size_t{capacity} * column.size, std::size_t{rows} * column.size, *memory);
        cells[column.component] = column.array.data();
    }
    for (auto& tag : tags) tag.words.resize(words_for(capacity), 0);
    for (auto* edge : incident) edge->aim();
}

void TableEdge::aim() {
    for (auto* list : {&pairs, &more_pairs, &odd_pairs}) {
        for (auto& pair : *list) {
            pair.from = from->cells[pair.component];
            pair.to = to->cells[pair.component];
        }
    }
}

void Table::join(std::uint32_t number, Table& other, std::uint32_t other_number, std::uint32_t component) {
    auto edge = make_pooled<TableEdge>(*memory);
    edge->key = edge_key(number, component, !mask.test(component));
    edge->from = this;
    edge->to = &other;
    edge->to_number = other_number;
    for (const auto& column : columns) {
        if (column.component == component) continue;
        auto& list = column.size == pair_size         ? edge->pairs
                     : through_registers(column.size) ? edge->more_pairs
                                                      : edge->odd_pairs;
        list.push_back({nullptr, nullptr, column.size, column.component});
    }
    edge->only_pairs = edge->more_pairs.empty() && edge->odd_pairs.empty();
    edge->aim();
    incident.push_back(edge.get());
    other.incident.push_back(edge.get());
    edges[component] = std::move(edge);
}

// Compares sizes instead of using a jump table, since every address would have to wait for the jump.
void Table::move_other_cells(const TableEdge& edge, std::uint32_t row, std::uint32_t last,
                             std::uint32_t to_row) {
    for (const auto& pair : edge.more_pairs) {
        if (pair.size == 24) {
            move_cell<24>(pair, row, last, to_row);
        } else if (pair.size == 8) {
            move_cell<8>(pair, row, last, to_row);
        } else if (pair.size == 4) {
            move_cell<4>(pair, row, last, to_row);
        } else if (pair.size == 16) {
            move_cell<16>(pair, row, last, to_row);
        } else {
            move_cell<32>(pair, row, last, to_row);
        }
    }
    move_odd_cells(edge.odd_pairs, row, last, to_row);
}

void Table::move_odd_cells(std::span<const ColumnPair> pairs, std::uint32_t row, std::uint32_t last,
                           std::uint32_t to_row) {
    for (const auto& pair : pairs) {
        const std::size_t size = pair.size;
        auto* hole = pair.from + row * size;
        copy_cell(pair.to + to_row * size, hole, size);
        copy_cell(hole, pair.from + last * size, size);
    }
}

TagColumn& Table::new_tag_column(std::uint32_t component) {
    tag_of[component] = static_cast<std::uint8_t>(tags.size());
    tags.push_back({component, std::pmr::vector<std::uint64_t>(words_for(capacity), 0, memory)});
    return tags.back();
}

/// Copies the tags of `row` to a fresh row of another table. The last row's tags take their place.
void Table::move_tags(std::uint32_t row, Table& to, std::uint32_t to_row) {
    for (const auto& tag : tags) {
        if (tag.test(row)) to.tag_column(tag.component).set(to_row);
    }
    close_tags(row);
}

/// Replaces the tags of `row` by those of the last row.
void Table::close_tags(std::uint32_t row) {
    const std::uint32_t last = rows - 1;
    for (auto& tag : tags) {
        if (tag.test(last)) {
            tag.set(row);
        } else {
            tag.clear(row);
        }
        tag.clear(last);
    }
}

}  // namespace thaum::ecs
