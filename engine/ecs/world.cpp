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

std::string World::undeclared_message(std::string_view name) const {
    return text("component ", name, " was not declared in this World");
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

std::uint32_t World::new_number() {
    records_.emplace_back();
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
        const auto column = infos_[c].size != 0 ? tables_[pack.table].column_of[c] : 0;
        pack.mask.set(c);
        pack.places[i] = {static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(column)};
    }
    if (type >= packs_.size()) packs_.resize(type + 1);
    packs_[type] = pack;
}

std::size_t World::size() const {
    std::size_t rows = 0;
    for (const auto& table : tables_) rows += table.rows;
    return rows;
}

void World::call(const Hook& hook, std::uint32_t component, Entity entity) {
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
    const auto row = r.row;
    records_[table.remove(row).index].row = row;
    auto& freed = records_[entity.index];
    ++freed.generation;
    freed.table = none;
    freed.row = free_;
    free_ = entity.index;
}

void World::clear() {
    for (std::uint32_t i = 0; i < records_.size(); ++i) {
        if (records_[i].table != none) destroy({i, records_[i].generation});
    }
}

// Called from two places only, and hot in both.
[[gnu::always_inline]] inline void World::move(Entity entity, std::uint32_t to) {
    auto& r = records_[entity.index];
    const auto row = r.row;
    auto& from = tables_[r.table];
    auto& target = tables_[to];
    const auto new_row = target.append(entity);
    copy_row(from, row, target, new_row);
    records_[from.remove(row).index].row = row;
    r.table = to;  // after the line above: the entity may itself have been the last
    r.row = new_row;
}

std::byte* World::extend(Entity entity, std::uint32_t component) {
    assert_unlocked(component);
    const auto& r = record(entity, component);
    THAUM_ASSERT(tables_[r.table].column_of[component] == none,
                 component_message("already has", component, entity));
    const auto known = tables_[r.table].plus[component];
    move(entity, known != none ? known : neighbour(r.table, component, true));
    const auto& table = tables_[r.table];
    return table.cell(table.column_of[component], r.row);
}

void World::narrow(Entity entity, std::uint32_t component) {
    assert_unlocked(component);
    const auto& r = record(entity, component);
    THAUM_ASSERT(tables_[r.table].column_of[component] != none,
                 component_message("has no", component, entity));
    removing(component, entity);
    const auto known = tables_[r.table].minus[component];
    move(entity, known != none ? known : neighbour(r.table, component, false));
}

void World::add_bytes(Entity entity, std::uint32_t component, const void* bytes) {
    THAUM_ASSERT(component < infos_.size(), "a component that was not declared in this World");
    if (infos_[component].size == 0) {
        mark(entity, component);
    } else {
        std::memcpy(extend(entity, component), bytes, infos_[component].size);
    }
    ++counts_[component];
    added(component, entity);
}

void World::remove_by_id(Entity entity, std::uint32_t component) {
    THAUM_ASSERT(component < infos_.size(), "a component that was not declared in this World");
    if (infos_[component].size == 0) {
        unmark(entity, component);
    } else {
        narrow(entity, component);
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
