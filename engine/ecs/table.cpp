#include "ecs/table.h"

#include <cstring>
#include <new>

namespace thaum::ecs {
namespace {

/// memcpy whose common sizes are single moves instead of a call.
void copy_cell(std::byte* to, const std::byte* from, std::uint32_t size) {
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

std::size_t words_for(std::uint32_t rows) { return (std::size_t{rows} + 63) / 64; }

}  // namespace

void RawArray::grow(std::size_t bytes, std::size_t keep) {
    std::unique_ptr<std::byte, Free> larger(
        static_cast<std::byte*>(::operator new (bytes, std::align_val_t{64})));
    if (keep > 0) std::memcpy(larger.get(), bytes_.get(), keep);
    bytes_ = std::move(larger);
}

void Table::reserve(std::uint32_t rows_wanted) {
    if (rows_wanted <= capacity) return;
    capacity = rows_wanted;
    entity_array.grow(std::size_t{capacity} * sizeof(Entity), std::size_t{rows} * sizeof(Entity));
    for (auto& column : columns) {
        column.array.grow(std::size_t{capacity} * column.size, std::size_t{rows} * column.size);
    }
    for (auto& tag : tags) tag.words.resize(words_for(capacity), 0);
}

Entity Table::remove(std::uint32_t row) {
    const std::uint32_t last = rows - 1;
    for (auto& tag : tags) {
        tag.set_bits -= tag.test(row) ? 1U : 0U;
        if (tag.test(last)) {
            tag.set(row);
        } else {
            tag.clear(row);
        }
        tag.clear(last);
    }
    for (const auto& column : columns) {
        auto* base = column.array.data();
        if (row != last) {
            copy_cell(base + std::size_t{row} * column.size, base + std::size_t{last} * column.size,
                      column.size);
        }
    }
    const Entity moved = entities()[last];
    entities()[row] = moved;
    rows = last;
    return moved;
}

TagColumn& Table::tag_column(std::uint32_t component) {
    auto& at = column_of[component];
    if (at == none) {
        at = static_cast<std::uint32_t>(tags.size());
        tags.push_back({component, 0, std::vector<std::uint64_t>(words_for(capacity), 0)});
    }
    return tags[at];
}

void copy_row(const Table& from, std::uint32_t row, Table& to, std::uint32_t dst_row) {
    for (const auto& column : to.columns) {
        const auto source = from.column_of[column.component];
        if (source == none) continue;
        copy_cell(column.array.data() + std::size_t{dst_row} * column.size, from.cell(source, row),
                  column.size);
    }
    for (const auto& tag : from.tags) {
        if (!tag.test(row)) continue;
        auto& target = to.tag_column(tag.component);
        target.set(dst_row);
        ++target.set_bits;
    }
}

}  // namespace thaum::ecs
