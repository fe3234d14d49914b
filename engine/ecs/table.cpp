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

void Edge::aim() {
    for (auto* list : {&lanes, &more_lanes, &odd_lanes}) {
        for (auto& lane : *list) {
            lane.from = from->cells[lane.component];
            lane.to = to->cells[lane.component];
        }
    }
}

void Table::join(std::uint32_t number, Table& other, std::uint32_t other_number, std::uint32_t component) {
    auto edge = make_pooled<Edge>(*memory);
    edge->key = edge_key(number, component, !mask.test(component));
    edge->from = this;
    edge->to = &other;
    edge->to_number = other_number;
    for (const auto& column : columns) {
        if (column.component == component) continue;
        auto& list = column.size == lane_size         ? edge->lanes
                     : through_registers(column.size) ? edge->more_lanes
                                                      : edge->odd_lanes;
        list.push_back({nullptr, nullptr, column.size, column.component});
    }
    edge->only_lanes = edge->more_lanes.empty() && edge->odd_lanes.empty();
    edge->aim();
    incident.push_back(edge.get());
    other.incident.push_back(edge.get());
    edges[component] = std::move(edge);
}

// Comparisons instead of a jump table, which makes every address wait for the jump.
void Table::move_other_cells(const Edge& edge, std::uint32_t row, std::uint32_t last, std::uint32_t to_row) {
    for (const auto& lane : edge.more_lanes) {
        if (lane.size == 24) {
            move_cell<24>(lane, row, last, to_row);
        } else if (lane.size == 8) {
            move_cell<8>(lane, row, last, to_row);
        } else if (lane.size == 4) {
            move_cell<4>(lane, row, last, to_row);
        } else if (lane.size == 16) {
            move_cell<16>(lane, row, last, to_row);
        } else {
            move_cell<32>(lane, row, last, to_row);
        }
    }
    move_odd_cells(edge.odd_lanes, row, last, to_row);
}

void Table::move_odd_cells(std::span<const Lane> lanes, std::uint32_t row, std::uint32_t last,
                           std::uint32_t to_row) {
    for (const auto& lane : lanes) {
        const std::size_t size = lane.size;
        auto* hole = lane.from + row * size;
        copy_cell(lane.to + to_row * size, hole, size);
        copy_cell(hole, lane.from + last * size, size);
    }
}

TagColumn& Table::new_tag_column(std::uint32_t component) {
    tag_of[component] = static_cast<std::uint8_t>(tags.size());
    tags.push_back({component, std::pmr::vector<std::uint64_t>(words_for(capacity), 0, memory)});
    return tags.back();
}

/// The tags of `row` become those of a fresh row of another table; the last row's tags take their place.
void Table::move_tags(std::uint32_t row, Table& to, std::uint32_t to_row) {
    for (const auto& tag : tags) {
        if (tag.test(row)) to.tag_column(tag.component).set(to_row);
    }
    close_tags(row);
}

/// The last row's tags take the place of those of `row`.
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
