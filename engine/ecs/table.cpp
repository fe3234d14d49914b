#include "ecs/table.h"

#include <cstring>
#include <new>

namespace thaum::ecs {
void RawArray::grow(std::size_t bytes, std::size_t keep) {
    std::unique_ptr<std::byte, Free> larger(
        static_cast<std::byte*>(::operator new (bytes, std::align_val_t{64})));
    if (keep > 0) std::memcpy(larger.get(), bytes_.get(), keep);
    bytes_ = std::move(larger);
}

void Table::add_column(std::uint32_t component, std::uint32_t size) {
    columns.push_back({component, size, {}});
}

void Table::reserve(std::uint32_t rows_wanted) {
    if (rows_wanted <= capacity) return;
    capacity = rows_wanted;
    entity_array.grow(std::size_t{capacity} * sizeof(Entity), std::size_t{rows} * sizeof(Entity));
    for (auto& column : columns) {
        column.array.grow(std::size_t{capacity} * column.size, std::size_t{rows} * column.size);
        cells[column.component] = column.array.data();
    }
    for (auto& tag : tags) tag.words.resize(words_for(capacity), 0);
}

TagColumn& Table::new_tag_column(std::uint32_t component) {
    tag_of[component] = static_cast<std::uint8_t>(tags.size());
    tags.push_back({component, std::vector<std::uint64_t>(words_for(capacity), 0)});
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
