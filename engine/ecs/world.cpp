#include "ecs/world.h"

#include <algorithm>
#include <cstring>

namespace thaum::ecs {

void World::declare_info(ComponentInfo info, std::uint32_t type_number) {
    THAUM_ASSERT(records_.empty(), text("component ", info.name, " is declared after the first entity"));
    THAUM_ASSERT(infos_.size() < max_components, text("no room for component ", info.name));
    if (type_number >= id_of_type_.size()) id_of_type_.resize(type_number + 1, none);
    THAUM_ASSERT(id_of_type_[type_number] == none, text("component ", info.name, " is declared twice"));
    id_of_type_[type_number] = static_cast<std::uint32_t>(infos_.size());
    infos_.push_back(std::move(info));
    added_.emplace_back();
    removed_.emplace_back();
    counts_.push_back(0);
}

std::string World::component_message(std::string_view what, std::uint32_t component, Entity entity) const {
    const auto name = component < infos_.size() ? infos_[component].name : std::string_view("(none)");
    return text("entity ", entity.index, " (generation ", entity.generation, ") ", what, " ", name);
}

std::string World::stale_message(Entity entity, std::uint32_t component) const {
    return component_message("is stale, asked for component", component, entity);
}

std::string World::locked_message(std::uint32_t component) const {
    const auto name = component < infos_.size() ? infos_[component].name : std::string_view("(none)");
    return text("structural change inside a view or hook, component ", name, ": use commands()");
}

void World::check_access(std::uint32_t component, bool write) const {
    const bool allowed = access_->writes.test(component) || (!write && access_->reads.test(component));
    THAUM_ASSERT(allowed, text("system ", access_->system, write ? " writes " : " reads ",
                               infos_[component].name, " without having declared it"));
}

std::uint32_t World::table_with(const Mask& mask) {
    for (std::uint32_t t = 0; t < tables_.size(); ++t) {
        if (tables_[t].mask == mask) return t;
    }
    Table table;
    table.mask = mask;
    for (std::uint32_t c = 0; c < infos_.size(); ++c) {
        if (!mask.test(c)) continue;
        table.column_of[c] = static_cast<std::uint32_t>(table.columns.size());
        table.columns.push_back({c, infos_[c].size, {}});
    }
    tables_.push_back(std::move(table));
    return static_cast<std::uint32_t>(tables_.size() - 1);
}

std::uint32_t World::neighbour(std::uint32_t table, std::uint32_t component, bool plus) {
    auto& known = plus ? tables_[table].plus[component] : tables_[table].minus[component];
    if (known != none) return known;
    Mask mask = tables_[table].mask;
    plus ? mask.set(component) : mask.clear(component);
    const auto found = table_with(mask);  // may move tables_
    (plus ? tables_[table].plus[component] : tables_[table].minus[component]) = found;
    (plus ? tables_[found].minus[component] : tables_[found].plus[component]) = table;
    return found;
}

Entity World::new_entity(std::uint32_t table, std::uint32_t* row) {
    std::uint32_t index = free_;
    if (index == none) {
        index = static_cast<std::uint32_t>(records_.size());
        records_.emplace_back();
    } else {
        free_ = records_[index].row;
    }
    auto& record = records_[index];
    const Entity entity{index, record.generation};
    record.table = table;
    record.row = tables_[table].append(entity);
    *row = record.row;
    ++alive_;
    return entity;
}

void World::take_out(std::uint32_t table, std::uint32_t row) {
    const Entity moved = tables_[table].remove(row);
    records_[moved.index].row = row;
}

void World::added(std::uint32_t component, Entity entity) {
    const auto& hook = added_[component];
    if (hook.call == nullptr) return;
    ++locks_;
    hook.call(hook.context, entity, find_bytes(entity, component));
    --locks_;
}

void World::removing(std::uint32_t component, Entity entity) {
    const auto& hook = removed_[component];
    if (hook.call == nullptr) return;
    ++locks_;
    hook.call(hook.context, entity, find_bytes(entity, component));
    --locks_;
}

void World::destroy(Entity entity) {
    assert_unlocked(none);
    const auto& r = record(entity, none);
    auto& table = tables_[r.table];
    for (const auto& column : table.columns) removing(column.component, entity);
    for (const auto& tag : table.tags) {
        if (tag.test(r.row)) removing(tag.component, entity);
    }
    for (const auto& column : table.columns) --counts_[column.component];
    for (const auto& tag : table.tags) {
        if (tag.test(r.row)) --counts_[tag.component];
    }
    take_out(r.table, r.row);
    auto& freed = records_[entity.index];
    ++freed.generation;
    freed.table = none;
    freed.row = free_;
    free_ = entity.index;
    --alive_;
}

void World::clear() {
    for (std::uint32_t i = 0; i < records_.size(); ++i) {
        if (records_[i].table != none) destroy({i, records_[i].generation});
    }
}

void World::move(Entity entity, std::uint32_t to) {
    auto& r = records_[entity.index];
    const auto from = r.table;
    const auto row = r.row;
    const auto new_row = tables_[to].append(entity);
    copy_row(tables_[from], row, tables_[to], new_row);
    take_out(from, row);
    r.table = to;
    r.row = new_row;
}

void World::add_bytes(Entity entity, std::uint32_t component, const void* bytes) {
    THAUM_ASSERT(component < infos_.size(), "a component that was not declared in this World");
    assert_unlocked(component);
    const auto& r = record(entity, component);
    if (infos_[component].size == 0) {
        auto& tag = tables_[r.table].tag_column(component);
        THAUM_ASSERT(!tag.test(r.row), component_message("already has", component, entity));
        tag.set(r.row);
        ++tag.set_bits;
    } else {
        THAUM_ASSERT(tables_[r.table].column_of[component] == none,
                     component_message("already has", component, entity));
        move(entity, neighbour(r.table, component, true));
        const auto& table = tables_[r.table];
        std::memcpy(table.cell(table.column_of[component], r.row), bytes, infos_[component].size);
    }
    ++counts_[component];
    added(component, entity);
}

void World::remove_by_id(Entity entity, std::uint32_t component) {
    THAUM_ASSERT(component < infos_.size(), "a component that was not declared in this World");
    assert_unlocked(component);
    const auto& r = record(entity, component);
    auto& table = tables_[r.table];
    const auto column = table.column_of[component];
    const bool tag = infos_[component].size == 0;
    THAUM_ASSERT(column != none && (!tag || table.tags[column].test(r.row)),
                 component_message("has no", component, entity));
    removing(component, entity);
    if (tag) {
        table.tags[column].clear(r.row);
        --table.tags[column].set_bits;
    } else {
        move(entity, neighbour(r.table, component, false));
    }
    --counts_[component];
}

const void* World::find_bytes(Entity entity, std::uint32_t component) const {
    if (!alive(entity)) return nullptr;
    const auto& r = records_[entity.index];
    const auto& table = tables_[r.table];
    const auto column = table.column_of[component];
    if (column == none) return nullptr;
    return infos_[component].size == 0 ? nullptr : table.cell(column, r.row);
}

const void* World::single_bytes(std::uint32_t component) const {
    for (const auto& table : tables_) {
        const auto column = table.column_of[component];
        if (column != none && infos_[component].size != 0 && table.rows > 0) return table.cell(column, 0);
    }
    return nullptr;
}

void World::refresh(Query& query) const {
    for (; query.tables_seen < tables_.size(); ++query.tables_seen) {
        const auto& mask = tables_[query.tables_seen].mask;
        if (mask.contains(query.required) && !mask.intersects(query.excluded)) {
            query.tables.push_back(query.tables_seen);
        }
    }
}

void World::apply_commands() {
    if (!commands_.empty()) commands_.apply(*this);
}

}  // namespace thaum::ecs
