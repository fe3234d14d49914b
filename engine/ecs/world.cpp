#include "ecs/world.h"

#include <algorithm>
#include <cstring>

namespace thaum::ecs {

World::World() {
    detail::type_numbers().closed = true;
    const auto types = detail::type_numbers().count;
    id_of_type_.resize(types, none);
    queries_.resize(types);
    packs_.resize(types);
    tables_.reserve(usual_tables);
    tables_.push_back(make_pooled<Table>(memory_));
}

void World::declare_info(ComponentInfo info, std::uint32_t type_number) {
    THAUM_ASSERT(records_.empty(), text("component ", info.name, " is declared after the first entity"));
    THAUM_ASSERT(infos_.size() + resources_.size() < max_components,
                 text("no room for component ", info.name));
    THAUM_ASSERT(id_of_type_[type_number] == none, text("component ", info.name, " is declared twice"));
    id_of_type_[type_number] = static_cast<std::uint32_t>(infos_.size());
    infos_.push_back(std::move(info));
    blobs_.emplace_back();
}

std::uint32_t World::declare_resource(std::string_view name, std::uint32_t type_number) {
    THAUM_ASSERT(infos_.size() + resources_.size() < max_components, text("no room for resource ", name));
    THAUM_ASSERT(id_of_type_[type_number] == none, text("resource ", name, " is declared twice"));
    resources_.push_back(name);
    const auto number = static_cast<std::uint32_t>(max_components - resources_.size());
    counts_[number] = 1;
    id_of_type_[type_number] = number;
    return number;
}

std::string_view World::name_of(std::uint32_t number) const {
    if (number < infos_.size()) return infos_[number].name;
    if (number < max_components && number >= max_components - resources_.size())
        return resources_[max_components - 1 - number];
    return "(none)";
}

void World::resize_blob(std::uint32_t component, std::size_t bytes) {
    blobs_[component].assign(bytes, std::byte{});
    counts_[component] = bytes > 0 ? 1 : 0;
}

std::string World::component_message(std::string_view what, std::uint32_t component, Entity entity) const {
    return text("entity ", entity.index, " (generation ", entity.generation, ") ", what, " ",
                name_of(component));
}

void World::fail(const char* what, std::uint32_t component, Entity entity) const {
    assertion_failed(__FILE__, __LINE__, component_message(what, component, entity));
}

void World::fail_stale(std::uint32_t index, std::uint32_t generation, std::uint32_t component) const {
    fail("is stale, asked for component", component, {index, generation});
}

void World::fail_locked(std::uint32_t component) const {
    assertion_failed(
        __FILE__, __LINE__,
        text("structural change inside a view or hook, component ", name_of(component), ": use commands()"));
}

void World::fail_undeclared(std::string_view name) const {
    assertion_failed(__FILE__, __LINE__, text(name, " was not declared in this World"));
}

void World::fail_access(std::uint32_t number, bool write) const {
    assertion_failed(__FILE__, __LINE__,
                     text("system ", access_->system, write ? " writes " : " reads ", name_of(number),
                          " without having declared it"));
}

namespace {

/// Index of a component's value in Table::cells, as World::place_of() for a type that is known.
std::uint32_t place_in_cells(const ComponentInfo& info, Entity entity, std::uint32_t row) {
    return info.stays_in_place ? entity.index : row;
}

/// Number of rows for which a new table (of entities with the same components) has room. Few entities have a
/// large component, such as the points of a stroke, so a table with one begins small. It then needs no memory
/// beyond TableMemory, which is allocated at the start.
std::uint32_t first_rows(const Table& table) {
    constexpr std::uint32_t usual_bytes = 16U << 10U, most = 16, least = 2;
    std::uint32_t largest = 1;
    for (const auto& column : table.columns) {
        if (!column.stays_in_place) largest = std::max(largest, column.size);
    }
    return std::clamp(usual_bytes / largest, least, most);
}

}  // namespace

std::uint32_t World::table_with(const Mask& mask) {
    for (std::uint32_t t = 0; t < tables_.size(); ++t) {
        if (tables_[t]->mask == mask) return t;
    }
    auto made = make_pooled<Table>(memory_);
    auto& table = *made;
    table.mask = mask;
    for (std::uint32_t c = 0; c < infos_.size(); ++c) {
        if (mask.test(c)) table.add_column(c, infos_[c].size, infos_[c].stays_in_place);
    }
    table.reserve(first_rows(table));
    aim_at_places(table);
    tables_.push_back(std::move(made));
    return static_cast<std::uint32_t>(tables_.size() - 1);
}

const TableEdge& World::find_edge(std::uint32_t table, std::uint32_t component, bool more, Entity entity) {
    auto& from = *tables_[table];
    if (from.mask.test(component) == more) fail(more ? "already has" : "has no component", component, entity);
    if (from.edges[component] == nullptr) {
        Mask mask = from.mask;
        more ? mask.set(component) : mask.clear(component);
        const auto number = table_with(mask);
        auto& other = *tables_[number];
        from.add_edge(table, other, number, component);
        other.add_edge(number, from, table, component);
    }
    last_edge_ = from.edges[component].get();
    return *last_edge_;
}

void World::aim_at_places(Table& table) {
    for (const auto& column : table.columns) {
        if (!column.stays_in_place) continue;
        auto& array = places_[column.component];
        if (array.data() == nullptr) array.grow(std::size_t{place_count_} * column.size, 0, memory_);
        table.cells[column.component] = array.data();
    }
}

void World::make_places(std::uint32_t count) {
    if (count <= place_count_) return;
    for (std::uint32_t c = 0; c < infos_.size(); ++c) {
        const std::size_t size = infos_[c].size;
        if (places_[c].data() != nullptr) places_[c].grow(count * size, place_count_ * size, memory_);
    }
    place_count_ = count;
    for (auto& table : tables_) aim_at_places(*table);
}

std::uint32_t World::new_number() {
    records_.emplace_back();
    if (records_.size() > place_count_) make_places(2 * place_count_);
    return static_cast<std::uint32_t>(records_.size() - 1);
}

void World::note_pack(std::uint32_t type, std::span<const std::uint32_t> components) {
    Mask data;
    for (const auto c : components) {
        if (infos_[c].size != 0) data.set(c);
    }
    Pack pack;
    pack.table = table_with(data);
    for (std::size_t i = 0; i < components.size(); ++i) {
        const auto c = components[i];
        pack.components[i] = static_cast<std::uint8_t>(c);
        pack.hooked |= added_[c].call != nullptr;
    }
    packs_[type] = pack;
}

void World::forget_packs() { packs_.assign(packs_.size(), {}); }

std::size_t World::size() const {
    std::size_t rows = 0;
    for (const auto& table : tables_) rows += table->rows;
    return rows;
}

void World::call(const Hook& hook, std::uint32_t component, Entity entity) {
    ++locks_;
    hook.call(hook.context, entity, find_bytes(entity, component));
    --locks_;
}

void World::destroy(Entity entity) {
    assert_unlocked(none);
    const auto row = record(entity, none).row;
    auto& table = *tables_[records_[entity.index].table];
    if (has_remove_hooks_) [[unlikely]] {
        removing_all(table, row);
    }
    for (const auto& column : table.columns) --counts_[column.component];
    for (const auto& tag : table.tags) {
        if (tag.test(row)) --counts_[tag.component];
    }
    records_[table.remove(row).index].row = row;
    auto& freed = records_[entity.index];
    ++freed.generation;
    freed.table = none;
    freed.row = free_;
    free_ = entity.index;
}

void World::removing_all(const Table& table, std::uint32_t row) {
    const Entity entity = table.entities()[row];
    for (const auto& column : table.columns) removing(column.component, entity);
    for (const auto& tag : table.tags) {
        if (tag.test(row)) removing(tag.component, entity);
    }
}

void World::clear() {
    for (std::uint32_t i = 0; i < records_.size(); ++i) {
        if (records_[i].table != none) destroy({i, records_[i].generation});
    }
    for (std::uint32_t c = 0; c < infos_.size(); ++c) {
        if (infos_[c].is_blob) resize_blob(c, 0);
    }
}

void World::add_bytes(Entity entity, std::uint32_t component, const void* bytes) {
    THAUM_ASSERT(component < infos_.size(), "a component that was not declared in this World");
    if (infos_[component].size == 0) {
        mark(entity, component);
    } else {
        const auto size = infos_[component].size;
        const auto [array, row] = extend(entity, component);
        const auto place = place_in_cells(infos_[component], entity, row);
        std::memcpy(array + std::size_t{place} * size, bytes, size);
    }
    ++counts_[component];
    added(component, entity);
}

void World::remove_by_id(Entity entity, std::uint32_t component) {
    THAUM_ASSERT(component < infos_.size(), "a component that was not declared in this World");
    if (infos_[component].size == 0) {
        unmark(entity, component);
    } else {
        const auto size = infos_[component].size;
        const auto [array, row, filler] = narrow(entity, component);
        if (!infos_[component].stays_in_place) {
            std::memmove(array + std::size_t{row} * size, array + std::size_t{filler} * size, size);
        }
    }
    --counts_[component];
}

const void* World::find_bytes(Entity entity, std::uint32_t component) const {
    if (!alive(entity)) return nullptr;
    const auto& r = records_[entity.index];
    const auto* cells = tables_[r.table]->cells[component];
    const auto place = place_in_cells(infos_[component], entity, r.row);
    return cells == nullptr ? nullptr : cells + std::size_t{place} * infos_[component].size;
}

const void* World::single_bytes(std::uint32_t component) const {
    for (const auto& table : tables_) {
        if (table->cells[component] != nullptr && table->rows > 0) {
            return find_bytes(table->entities()[0], component);
        }
    }
    return nullptr;
}

void World::refresh(Query& query) const {
    for (; query.tables_seen < tables_.size(); ++query.tables_seen) {
        const auto& mask = tables_[query.tables_seen]->mask;
        if (mask.contains(query.required) && !mask.intersects(query.excluded)) {
            query.tables.push_back(query.tables_seen);
        }
    }
}

void World::apply_commands() {
    if (!commands_.empty()) commands_.apply(*this);
}

}  // namespace thaum::ecs
