// ecs/world.h: entities and their components. See ecs/table.h for how they lie in memory, and why.
//
//     World world;
//     world.declare<Pose>();  world.declare<Velocity>();          // once, in a fixed order
//     const Entity e = world.create(Pose{}, Velocity{{1, 0, 0}});
//     world.view<Pose, const Velocity>().each([](Pose& p, const Velocity& v) { p.position += v.linear; });
//
// All that happens is a function of the calls made: the order of iteration, the numbers of new entities, the bytes
// of a snapshot and the state hash follow from the history of this World alone, never from addresses or from other Worlds.
// Wrong use (a stale entity, a component added twice, a structural change inside a view) is an assertion that names the
// component. One thread at a time.
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "core/assert.h"
#include "core/bytes.h"
#include "core/text.h"
#include "ecs/commands.h"
#include "ecs/component.h"
#include "ecs/entity.h"
#include "ecs/table.h"

namespace thaum::ecs {

template <class... Terms>
class View;

/// Called with the component's bytes right after it was added, or right before it is removed (or its entity destroyed).
/// It may read the World and change components, but not add, remove, create or destroy.
struct Hook {
    void (*call)(void* context, Entity entity, const void* component) = nullptr;
    void* context = nullptr;
};

/// Which components a running system said it reads and writes.
struct Access {
    Mask reads;
    Mask writes;
    std::string_view system;
};

class World {
public:
    World() { tables_.emplace_back(); }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Declares a component; all are declared before the first entity. Their order is part of the state's format.
    template <Component C>
    void declare();
    /// Memory for that many entities and for that many rows of this set of components, so that the loop need not allocate.
    void reserve_entities(std::uint32_t count) { records_.reserve(count); }
    template <Component... Cs>
    void reserve(std::uint32_t rows) {
        tables_[table_of_pack<Cs...>()].reserve(rows);
    }

    template <Component... Cs>
    Entity create(const Cs&... components);
    void destroy(Entity entity);
    /// Every entity, in order of their numbers; hooks are called. The history goes on: numbers are not used anew.
    void clear();
    bool alive(Entity entity) const {
        return entity.index < records_.size() && records_[entity.index].generation == entity.generation &&
               records_[entity.index].table != none;
    }
    std::size_t size() const { return alive_; }

    template <Component C>
    void add(Entity entity, const C& component = {});
    template <Component C>
    void remove(Entity entity);
    template <Component C>
    bool has(Entity entity) const;
    template <Component C>
    C& get(Entity entity);
    template <Component C>
    const C& get(Entity entity) const;
    /// Null where the entity has none (or is no entity any more).
    template <Component C>
    C* find(Entity entity);
    template <Component C>
    const C* find(Entity entity) const;
    /// The component of which there is exactly one, such as the match.
    template <Component C>
    C& single();
    template <Component C>
    const C& single() const;

    /// How many entities have C.
    template <Component C>
    std::uint32_t count() const {
        return counts_[id<C>()];
    }

    /// Terms: `C` to write, `const C` to read, a tag to require, Maybe<C> for a pointer or null, Without<C>.
    template <class... Terms>
    View<Terms...> view();
    template <class... Terms>
    View<Terms...> view() const;

    template <Component C>
    void on_add(Hook hook) {
        added_[id<C>()] = hook;
    }
    template <Component C>
    void on_remove(Hook hook) {
        removed_[id<C>()] = hook;
    }

    /// Changes asked for during iteration; `apply_commands` makes them, in the order in which they were given.
    Commands& commands() { return commands_; }
    void apply_commands();

    // What the schedule, snapshots and tools need.
    template <Component C>
    std::uint32_t id() const;
    template <Component... Cs>
    Mask mask() const {
        Mask m;
        (m.set(id<Cs>()), ...);
        return m;
    }
    std::span<const ComponentInfo> components() const { return infos_; }
    std::span<const Table> tables() const { return tables_; }
    std::uint32_t count(std::uint32_t component) const { return counts_[component]; }
    /// While set, every access is checked against what the system declared; null turns the check off.
    void set_access(const Access* access) { access_ = access; }

private:
    template <class... Terms>
    friend class View;
    friend class Commands;
    friend struct SnapshotAccess;

    struct Record {
        std::uint32_t generation = 0;
        std::uint32_t table = none;  // none: free, and row is the next free one
        std::uint32_t row = none;
    };
    struct Query {
        bool prepared = false;
        Mask required, excluded;
        std::uint32_t tables_seen = 0;
        std::vector<std::uint32_t> tables;
    };

    const Record& record(Entity entity, std::uint32_t component) const {
        THAUM_ASSERT(alive(entity), stale_message(entity, component));
        return records_[entity.index];
    }
    void assert_unlocked(std::uint32_t component) const {
        THAUM_ASSERT(locks_ == 0, locked_message(component));
    }
    void check_read(std::uint32_t component) const {
        if (access_ != nullptr) [[unlikely]] {
            check_access(component, false);
        }
    }
    void check_write(std::uint32_t component) const {
        if (access_ != nullptr) [[unlikely]] {
            check_access(component, true);
        }
    }
    void check_access(std::uint32_t component, bool write) const;
    std::string stale_message(Entity entity, std::uint32_t component) const;
    std::string locked_message(std::uint32_t component) const;
    std::string component_message(std::string_view what, std::uint32_t component, Entity entity) const;

    Entity new_entity(std::uint32_t table, std::uint32_t* row);
    std::uint32_t table_with(const Mask& mask);
    std::uint32_t neighbour(std::uint32_t table, std::uint32_t component, bool plus);
    void move(Entity entity, std::uint32_t to);
    void take_out(std::uint32_t table, std::uint32_t row);
    void added(std::uint32_t component, Entity entity);
    void removing(std::uint32_t component, Entity entity);
    /// By number, with the component's bytes: what commands and the typed calls share.
    void add_bytes(Entity entity, std::uint32_t component, const void* bytes);
    void remove_by_id(Entity entity, std::uint32_t component);
    const void* find_bytes(Entity entity, std::uint32_t component) const;
    const void* single_bytes(std::uint32_t component) const;
    void refresh(Query& query) const;
    void declare_info(ComponentInfo info, std::uint32_t type_number);
    template <class... Cs>
    std::uint32_t table_of_pack();

    std::vector<ComponentInfo> infos_;
    std::vector<std::uint32_t> id_of_type_;  // type number of this process -> component of this World
    std::vector<Hook> added_, removed_;
    std::vector<std::uint32_t> counts_;
    std::vector<Table> tables_;  // the first one has no components
    std::vector<Record> records_;
    std::uint32_t free_ = none;
    std::size_t alive_ = 0;
    Commands commands_;
    mutable std::vector<Query> queries_;        // cache, by type number of the view
    std::vector<std::uint32_t> table_of_type_;  // cache, by type number of a pack of components
    mutable std::uint32_t locks_ = 0;
    const Access* access_ = nullptr;
};

// ---------------------------------------------------------------------------------------------------------------------

namespace detail {
template <class... Cs>
struct Pack {};
}  // namespace detail

template <Component C>
void World::declare() {
    declare_info(component_info<C>(), detail::type_number<C>);
}

template <Component C>
std::uint32_t World::id() const {
    const auto type = detail::type_number<C>;
    THAUM_ASSERT(type < id_of_type_.size() && id_of_type_[type] != none,
                 text("component ", C::name, " was not declared in this World"));
    return id_of_type_[type];
}

template <class... Cs>
std::uint32_t World::table_of_pack() {
    const auto type = detail::type_number<detail::Pack<Cs...>>;
    if (type >= table_of_type_.size()) table_of_type_.resize(type + 1, none);
    if (table_of_type_[type] == none) {
        Mask m;
        ((Tag<Cs> ? void() : m.set(id<Cs>())), ...);
        table_of_type_[type] = table_with(m);
    }
    return table_of_type_[type];
}

template <Component... Cs>
Entity World::create(const Cs&... components) {
    if constexpr (sizeof...(Cs) > 0) {
        assert_unlocked(id<std::tuple_element_t<0, std::tuple<Cs...>>>());
    } else {
        assert_unlocked(none);
    }
    const auto t = table_of_pack<Cs...>();
    std::uint32_t row = 0;
    const Entity entity = new_entity(t, &row);
    auto& table = tables_[t];
    [[maybe_unused]] const auto put = [&]<class C>(const C& component) {
        const auto c = id<C>();
        if constexpr (Tag<C>) {
            auto& tag = table.tag_column(c);
            tag.set(row);
            ++tag.set_bits;
        } else {
            reinterpret_cast<C*>(table.columns[table.column_of[c]].array.data())[row] = component;
        }
        ++counts_[c];
    };
    (put(components), ...);
    (added(id<Cs>(), entity), ...);
    return entity;
}

template <Component C>
void World::add(Entity entity, const C& component) {
    const auto c = id<C>();
    check_write(c);
    add_bytes(entity, c, &component);
}

template <Component C>
void World::remove(Entity entity) {
    const auto c = id<C>();
    check_write(c);
    remove_by_id(entity, c);
}

template <Component C>
bool World::has(Entity entity) const {
    const auto c = id<C>();
    check_read(c);
    const auto& r = record(entity, c);
    const auto& table = tables_[r.table];
    const auto column = table.column_of[c];
    if constexpr (Tag<C>) {
        return column != none && table.tags[column].test(r.row);
    } else {
        return column != none;
    }
}

template <Component C>
const C& World::get(Entity entity) const {
    static_assert(!Tag<C>, "a tag has no value");
    const auto c = id<C>();
    check_read(c);
    const auto& r = record(entity, c);
    const auto& table = tables_[r.table];
    const auto column = table.column_of[c];
    THAUM_ASSERT(column != none, component_message("has no component", c, entity));
    return reinterpret_cast<const C*>(table.columns[column].array.data())[r.row];
}

template <Component C>
C& World::get(Entity entity) {
    check_write(id<C>());
    return const_cast<C&>(std::as_const(*this).template get<C>(entity));
}

template <Component C>
const C* World::find(Entity entity) const {
    static_assert(!Tag<C>, "a tag has no value");
    const auto c = id<C>();
    check_read(c);
    return static_cast<const C*>(find_bytes(entity, c));
}

template <Component C>
C* World::find(Entity entity) {
    check_write(id<C>());
    return const_cast<C*>(std::as_const(*this).template find<C>(entity));
}

template <Component C>
const C& World::single() const {
    const auto c = id<C>();
    check_read(c);
    THAUM_ASSERT(counts_[c] == 1, text("there are ", counts_[c], " of ", C::name, ", not one"));
    return *static_cast<const C*>(single_bytes(c));
}

template <Component C>
C& World::single() {
    check_write(id<C>());
    return const_cast<C&>(std::as_const(*this).template single<C>());
}

}  // namespace thaum::ecs

#include "ecs/view.h"
