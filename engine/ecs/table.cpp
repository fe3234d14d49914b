#include "ecs/table.h"

#include <cstring>

namespace thaum::ecs {

void RawArray::grow(std::size_t bytes, std::size_t keep, TableMemory& memory) {
    constexpr std::size_t max_pooled = std::size_t{64} << 10U;
    RawArray larger;
    larger.allocated_ = bytes <= max_pooled ? 0 : bytes;
    auto* const made = larger.allocated_ == 0 ? memory.allocate(bytes, 64) : allocate_array(bytes);
    larger.bytes_ = static_cast<std::byte*>(made);
    if (keep > 0) std::memcpy(larger.bytes_, bytes_, keep);
    *this = std::move(larger);
}

void Table::add_column(std::uint32_t component, std::uint32_t size, bool stays_in_place) {
    columns.push_back({component, size, stays_in_place, {}});
}

void Table::reserve(std::uint32_t rows_wanted) {
    if (rows_wanted <= capacity) return;
    capacity = rows_wanted;
    entity_array.grow(std::size_t{capacity} * sizeof(Entity), std::size_t{rows} * sizeof(Entity), *memory);
    for (auto& column : columns) {
        if (column.stays_in_place) continue;
        column.array.grow(std::size_t{capacity} * column.size, std::size_t{rows} * column.size, *memory);
        cells[column.component] = column.array.data();
    }
    for (auto& tag : tags) tag.words.resize(words_for(capacity), 0);
    for (auto* edge : incident) edge->aim();
}

void TableEdge::aim() {
    for (auto& pair : pairs) {
        pair.from = from->cells[pair.component];
        pair.to = to->cells[pair.component];
    }
}

void Table::add_edge(std::uint32_t number, Table& other, std::uint32_t other_number,
                     std::uint32_t component) {
    auto edge = make_pooled<TableEdge>(*memory);
    edge->key = edge_key(number, component, !mask.test(component));
    edge->from = this;
    edge->to = &other;
    edge->to_number = other_number;
    for (const auto& column : columns) {
        if (column.component == component || column.stays_in_place) continue;
        edge->pairs.push_back({nullptr, nullptr, column.size, column.component});
    }
    edge->aim();
    incident.push_back(edge.get());
    other.incident.push_back(edge.get());
    edges[component] = std::move(edge);
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
