// ecs/world.h: entities and their components. ecs/table.h describes their layout in memory and the reasons
// for it.
//
//     World world;
//     world.declare<Pose>();  world.declare<Velocity>();          // once, in a fixed order
//     const Entity e = world.create(Pose{}, Velocity{{1, 0, 0}});
//     world.view<Pose, const Velocity>().each([](Pose& p, const Velocity& v) { p.position += v.linear; });
//
// All results are a function of the calls made. The order of iteration, the numbers of new entities, the
// bytes of a snapshot and the state hash depend only on the history of this World, never on addresses or
// other Worlds. Wrong use fails an assertion that names the component: a stale entity, a component added
// twice, a structural change inside a view. Only one thread may use a World at a time.
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

/// Iterates over entities (ecs/view.h).
template <class... Terms>
class View;
/// Holds a value that systems share and that is no part of the World's state (ecs/resource.h).
template <ResourceType R>
class Resource;

/// Number of tables (one for each set of components) for which a World reserves room at the start.
inline constexpr std::size_t usual_tables = 256;

/// Holds entities, their components, and blobs (arrays of numbers that no entity owns).
class World {
public:
    World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Declares a component or a blob (an array that no entity owns). All are declared before the first
    /// entity, in an order that is part of the snapshot format.
    template <Declarable C>
    void declare();
    /// Reserves memory for `count` entities. The main loop then need not allocate.
    void reserve_entities(std::uint32_t count) {
        assert_unlocked(none);
        records_.reserve(count);
        make_places(count);
    }
    /// Reserves memory for `elements` elements of a blob (an array of numbers that no entity owns).
    template <Blob B>
    void reserve_blob(std::size_t elements) {
        blobs_[id<B>()].reserve(elements * sizeof(typename B::Element));
    }
    /// Reserves memory for `rows` entities that have exactly this set of components.
    template <Component... Cs>
    void reserve(std::uint32_t rows) {
        tables_[pack_of<Cs...>().table]->reserve(rows);
    }

    /// Creates an entity with these components.
    template <Component... Cs>
    Entity create(Cs... components);
    /// Destroys a living entity.
    void destroy(Entity entity);
    /// Destroys every entity in the order of their numbers, calls the hooks, and empties every blob. Free
    /// entity numbers, and how often each was used, are kept: old handles are still recognised as such.
    void clear();
    /// Whether the entity exists and was not destroyed since the handle was taken.
    bool alive(Entity entity) const {
        // Compares bytes, since counting the records would need a division by their size.
        const auto bytes = records_.size() * sizeof(Record);
        return std::size_t{entity.index} * sizeof(Record) < bytes &&
               records_[entity.index].generation == entity.generation && records_[entity.index].table != none;
    }
    /// Number of living entities.
    std::size_t size() const;
    /// Returns the living entity with this number, or `no_entity` if there is none.
    Entity entity(std::uint32_t index) const {
        const bool lives = index < records_.size() && records_[index].table != none;
        return lives ? Entity{index, records_[index].generation} : no_entity;
    }

    /// Adds a component that the entity lacks.
    template <Component C>
    void add(Entity entity, const C& component = {});
    /// Removes a component that the entity has.
    template <Component C>
    void remove(Entity entity);
    /// Whether a living entity has the component.
    template <Component C>
    bool has(Entity entity) const;
    /// A component that a living entity has.
    template <Component C>
    C& get(Entity entity);
    template <Component C>
    const C& get(Entity entity) const;
    /// The component of an entity; null if the entity lacks it or no longer exists.
    template <Component C>
    C* find(Entity entity);
    template <Component C>
    const C* find(Entity entity) const;
    /// Returns a component that exactly one entity has, such as the state of the match.
    template <Component C>
    C& single();
    template <Component C>
    const C& single() const;

    /// Number of entities that have C. For a blob (an array that no entity owns): 1 if it has elements,
    /// otherwise 0.
    template <Declarable C>
    std::uint32_t count() const {
        return counts_[id<C>()];
    }

    /// Gives a blob (an array of numbers that no entity owns) `elements` elements, all 0. Spans of it that
    /// were taken before are invalid afterwards.
    template <Blob B>
    void resize(std::size_t elements);
    /// Elements of a blob (an array of numbers that no entity owns). The span is valid until the blob is
    /// resized, the World cleared or restored.
    template <Blob B>
    std::span<typename B::Element> blob();
    template <Blob B>
    std::span<const typename B::Element> blob() const;

    /// Entities that match all terms: `C` to write, `const C` to read, a tag to require, Maybe<C> for a
    /// pointer that may be null, Without<C> to exclude.
    template <class... Terms>
    View<Terms...> view();
    template <class... Terms>
    View<Terms...> view() const;

    /// Sets the hook (a function of the caller) that is called after a component of this type was added. A
    /// Hook whose `call` is null removes it.
    template <Component C>
    void on_add(Hook hook) {
        added_[id<C>()] = hook;
        forget_packs();  // what `create` keeps in its cache includes whether there is a hook
    }
    /// Sets the hook (a function of the caller) that is called before a component of this type is removed. A
    /// Hook whose `call` is null removes it.
    template <Component C>
    void on_remove(Hook hook) {
        removed_[id<C>()] = hook;
        has_remove_hooks_ |= hook.call != nullptr;
    }

    /// Changes requested during iteration. `apply_commands` makes them, in the order of the requests.
    Commands& commands() { return commands_; }
    /// Makes the changes that were requested with commands(), in the order of the requests.
    void apply_commands();

    // Access by numbers instead of types, for the schedule, snapshots and tools.
    /// Number of a component, blob or resource in this World.
    template <Accessible A>
    std::uint32_t id() const;
    /// Set of the numbers of these components, blobs and resources.
    template <Accessible... As>
    Mask mask() const {
        Mask m;
        (m.set(id<As>()), ...);
        return m;
    }
    /// Descriptions of components and blobs, by their numbers.
    std::span<const ComponentInfo> components() const { return infos_; }
    /// All tables (one for each set of components), in the order of their creation.
    std::span<const Pooled<Table>> tables() const { return tables_; }
    /// Number of entities that have a component. A resource is always there and counts as 1.
    std::uint32_t count(std::uint32_t number) const { return counts_[number]; }
    /// Checks every later access against what the running system declared. Null turns the check off.
    void set_access(const Access* access) { access_ = access; }

private:
    template <class... Terms>
    friend class View;
    template <ResourceType R>
    friend class Resource;
    friend class Commands;
    friend struct SnapshotAccess;

    struct Record {
        std::uint32_t generation = 0;
        // Table of the entity. None: this record is free, and `row` is the number of the next free record.
        std::uint32_t table = none;
        std::uint32_t row = none;
    };
    /// Cached data for one list of components passed to `create`. It fills half a cache line.
    struct Pack {
        std::uint32_t table = none;  // table of the new entity; none: not known yet
        bool hooked = false;  // true: one of the components has a function that is called when it is added
        std::array<std::uint8_t, 27> components{};
    };
    static_assert(max_components <= 256 && sizeof(Pack) == 32);
    struct Cell {
        std::byte* array;
        std::uint32_t row;
    };
    /// A cell of a component that its entity has left. The cell of row `filler` must be moved into it.
    struct Hole {
        std::byte* array;
        std::uint32_t row, filler;
    };
    /// The tables that match one kind of view, updated when new tables appear; kept in TableMemory.
    struct Query {
        Mask required, excluded;
        std::uint32_t tables_seen = 0;
        std::pmr::vector<std::uint32_t> tables;

        explicit Query(TableMemory& memory) : tables(&memory) {}
    };

    const Record& record(Entity entity, std::uint32_t component) const {
        if (!alive(entity)) [[unlikely]] {
            fail_stale(entity.index, entity.generation, component);
        }
        return records_[entity.index];
    }
    Record& record(Entity entity, std::uint32_t component) {
        return const_cast<Record&>(std::as_const(*this).record(entity, component));
    }
    void assert_unlocked(std::uint32_t component) const {
        if (locks_ != 0) [[unlikely]] {
            fail_locked(component);
        }
    }
    // The next three functions assert that the running system may use this component or resource.
    void check_read(std::uint32_t number) const { check_access(number, false); }
    void check_write(std::uint32_t number) const { check_access(number, true); }
    void check_access(std::uint32_t number, bool write) const {
        if (access_ != nullptr && !access_->allows(number, write)) [[unlikely]] {
            fail_access(number, write);
        }
    }
    std::string_view name_of(std::uint32_t number) const;
    // Assertions of the most frequent calls. They are separate functions because building a message in place
    // costs registers on the normal path.
    [[noreturn, gnu::cold]] void fail_stale(std::uint32_t index, std::uint32_t generation,
                                            std::uint32_t component) const;
    [[noreturn, gnu::cold]] void fail_locked(std::uint32_t component) const;
    [[noreturn, gnu::cold]] void fail_access(std::uint32_t number, bool write) const;
    [[noreturn, gnu::cold]] void fail_undeclared(std::string_view name) const;
    [[noreturn, gnu::cold]] void fail(const char* what, std::uint32_t component, Entity entity) const;
    std::string component_message(std::string_view what, std::uint32_t component, Entity entity) const;

    /// Number of a component in this World. Unlike id(), it does not test whether the component was declared.
    template <Component C>
    std::uint32_t known_id() const {
        return id_of_type_[detail::type_number<C>];
    }
    std::uint32_t take_number() {
        const auto index = free_;
        if (index == none) return new_number();
        free_ = records_[index].row;
        return index;
    }
    std::uint32_t new_number();
    /// Index of a component's value in Table::cells.
    template <Component C>
    static std::uint32_t place_of(Entity entity, std::uint32_t row) {
        return StaysInPlace<C> ? entity.index : row;
    }
    /// Makes room for the values of this many entities in the array of each component that stays in place.
    void make_places(std::uint32_t count);
    /// Tells a table where the arrays of its components that stay in place are, and makes missing ones.
    void aim_at_places(Table& table);
    std::uint32_t table_with(const Mask& mask);
    /// The edge (link between two tables) to the table that has this component as well (`more`), or that
    /// lacks only this component.
    const TableEdge& edge_from(std::uint32_t table, std::uint32_t component, bool more, Entity entity) {
        const auto* edge = last_edge_;
        if (edge->key != edge_key(table, component, more)) [[unlikely]] {
            edge = &find_edge(table, component, more, entity);
        }
        return *edge;
    }
    /// Looks up the edge (link between two tables) that adds or removes a component, and remembers it. An
    /// assertion fails if the entity already has the component to be added, or lacks the one to be removed.
    const TableEdge& find_edge(std::uint32_t table, std::uint32_t component, bool more, Entity entity);
    /// Moves the entity along the edge (link between two tables) and returns its row in the new table.
    std::uint32_t follow(const TableEdge& edge, Record& record, Entity entity);
    void forget_packs();
    void call(const Hook& hook, std::uint32_t component, Entity entity);
    void added(std::uint32_t component, Entity entity) {
        if (added_[component].call != nullptr) call(added_[component], component, entity);
    }
    void removing(std::uint32_t component, Entity entity) {
        if (removed_[component].call != nullptr) call(removed_[component], component, entity);
    }
    void removing_all(const Table& table, std::uint32_t row);
    /// Moves the entity to the table that has this component as well. Returns the cell of the new component,
    /// which is not written yet.
    Cell extend(Entity entity, std::uint32_t component);
    /// Calls the hook for removed components, and moves the entity to the table that lacks only this
    /// component. This leaves a hole, the entity's old cell, in the component's column, which the caller must
    /// fill.
    Hole narrow(Entity entity, std::uint32_t component);
    void mark(Entity entity, std::uint32_t tag);
    void unmark(Entity entity, std::uint32_t tag);
    /// The next functions reach components by their numbers and bytes; commands and the typed calls share
    /// them.
    void add_bytes(Entity entity, std::uint32_t component, const void* bytes);
    void remove_by_id(Entity entity, std::uint32_t component);
    const void* find_bytes(Entity entity, std::uint32_t component) const;
    const void* single_bytes(std::uint32_t component) const;
    void refresh(Query& query) const;
    void declare_info(ComponentInfo info, std::uint32_t type_number);
    std::uint32_t declare_resource(std::string_view name, std::uint32_t type_number);
    void resize_blob(std::uint32_t component, std::size_t bytes);
    template <class... Cs>
    const Pack& pack_of();
    template <class... Cs>
    void make_pack(std::uint32_t type);
    void note_pack(std::uint32_t type, std::span<const std::uint32_t> components);

    std::vector<ComponentInfo> infos_;
    // Names of the resources. They are numbered downwards from the greatest number, so that a resource
    // changes no number of a component.
    std::vector<std::string_view> resources_;
    // Maps a type number of this process to a component or a resource of this World.
    std::vector<std::uint32_t> id_of_type_;
    std::array<Hook, max_components> added_{}, removed_{};
    bool has_remove_hooks_ = false;
    std::array<std::uint32_t, max_components> counts_{};
    std::vector<Bytes> blobs_;  // bytes of each blob, by component number; empty for components
    mutable TableMemory memory_{table_memory_bytes};
    std::vector<Pooled<Table>> tables_;  // tables; the first one has no components
    /// Arrays of the components that stay in place, by component number. The value of an entity is at its
    /// number. Empty while no table has the component.
    std::array<RawArray, max_components> places_;
    std::uint32_t place_count_ = 16;  // number of entities for which each of these arrays has room
    const TableEdge no_edge_{memory_};
    // The table edge (ecs/table.h) that was used last. Entities that are spawned together get the same
    // component one after another. Their edge is then known before their records are read. Such a change
    // takes 13 ns instead of 14 (1,000 loose objects of the game lose their Body, row remove_1 of the bench).
    const TableEdge* last_edge_ = &no_edge_;
    std::vector<Record, ArrayAllocator<Record>> records_;
    std::uint32_t free_ = none;
    Commands commands_;
    // Cache of queries (the tables that match one kind of view), by the type number of the view. Each query
    // keeps its address, since views refer to it.
    mutable std::vector<Pooled<Query>> queries_;
    std::vector<Pack> packs_;  // cached data of `create`, by the type number of the list of components
    mutable std::uint32_t locks_ = 0;
    const Access* access_ = nullptr;
};

// Implementation of the templates.

namespace detail {
template <class... Cs>
struct Pack {};
}  // namespace detail

template <Declarable C>
void World::declare() {
    if constexpr (Blob<C>) {
        declare_info(blob_info<C>(), detail::type_number<C>);
    } else {
        declare_info(component_info<C>(), detail::type_number<C>);
    }
}

template <Blob B>
void World::resize(std::size_t elements) {
    const auto b = id<B>();
    check_write(b);
    resize_blob(b, elements * sizeof(typename B::Element));
}

template <Blob B>
std::span<const typename B::Element> World::blob() const {
    const auto b = id<B>();
    check_read(b);
    const auto& bytes = blobs_[b];
    return {reinterpret_cast<const typename B::Element*>(bytes.data()),
            bytes.size() / sizeof(typename B::Element)};
}

template <Blob B>
std::span<typename B::Element> World::blob() {
    check_write(id<B>());
    const auto elements = std::as_const(*this).template blob<B>();
    return {const_cast<typename B::Element*>(elements.data()), elements.size()};
}

template <Accessible A>
[[gnu::always_inline]] inline std::uint32_t World::id() const {
    const auto type = detail::type_number<A>;
    const auto number = id_of_type_[type];
    if (number == none) [[unlikely]] {
        fail_undeclared(A::name);
    }
    return number;
}

template <class... Cs>
[[gnu::always_inline]] inline const World::Pack& World::pack_of() {
    static_assert(sizeof...(Cs) <= std::tuple_size_v<decltype(Pack::components)>);
    const auto type = detail::type_number<detail::Pack<Cs...>>;
    if (packs_[type].table == none) [[unlikely]] {
        make_pack<Cs...>(type);
    }
    return packs_[type];
}

template <class... Cs>
[[gnu::cold, gnu::noinline]] void World::make_pack(std::uint32_t type) {
    const std::array<std::uint32_t, sizeof...(Cs)> components{id<Cs>()...};
    note_pack(type, components);
}

// Inlined, so that components go from registers into their cells. They are passed by value, since a reference
// could point to a cell of the table that grows here.
template <Component... Cs>
[[gnu::always_inline]] inline Entity World::create(Cs... components) {
    const Pack& pack = pack_of<Cs...>();
    assert_unlocked(sizeof...(Cs) > 0 ? pack.components[0] : none);
    const auto index = take_number();
    auto& record = records_[index];
    auto& table = *tables_[pack.table];
    const Entity entity{index, record.generation};
    const auto row = table.append(entity);
    record.table = pack.table;
    record.row = row;
    [[maybe_unused]] const auto* id = pack.components.data();
    [[maybe_unused]] const auto put = [&]<class C>(const C& component) {
        if constexpr (Tag<C>) {
            table.tag_column(*id).set(row);
        } else {
            table.cells_of<C>(*id)[place_of<C>(entity, row)] = component;
        }
        ++counts_[*id++];
    };
    (put(components), ...);
    if (pack.hooked) [[unlikely]] {
        (added(known_id<Cs>(), entity), ...);
    }
    return entity;
}

inline void World::mark(Entity entity, std::uint32_t tag) {
    assert_unlocked(tag);
    const auto& r = record(entity, tag);
    auto& column = tables_[r.table]->tag_column(tag);
    if (column.test(r.row)) [[unlikely]] {
        fail("already has", tag, entity);
    }
    column.set(r.row);
}

inline void World::unmark(Entity entity, std::uint32_t tag) {
    assert_unlocked(tag);
    const auto& r = record(entity, tag);
    auto& table = *tables_[r.table];
    const auto at = table.tag_of[tag];
    if (at == no_tag || !table.tags[at].test(r.row)) [[unlikely]] {
        fail("has no", tag, entity);
    }
    removing(tag, entity);
    table.tags[at].clear(r.row);
}

// The cells are moved last, through byte pointers. The compiler must assume that such a write can change any
// value, so it would load those that are used afterwards again.
[[gnu::always_inline]] inline std::uint32_t World::follow(const TableEdge& edge, Record& record,
                                                          Entity entity) {
    const auto row = record.row;
    const auto [to_row, last, filler] = edge.from->move(row, entity, edge);
    records_[filler.index].row = row;
    // This is set after the record of `filler`, the entity that takes the free row. If the entity was in the
    // last row, both are the same record, which must end up with the new place.
    record.table = edge.to_number;
    record.row = to_row;
    Table::move_cells(edge, row, last, to_row);
    return to_row;
}

[[gnu::always_inline]] inline World::Cell World::extend(Entity entity, std::uint32_t component) {
    assert_unlocked(component);
    auto& r = record(entity, component);
    const auto& edge = edge_from(r.table, component, true, entity);
    const auto row = follow(edge, r, entity);
    return {edge.to->cells[component], row};
}

[[gnu::always_inline]] inline World::Hole World::narrow(Entity entity, std::uint32_t component) {
    assert_unlocked(component);
    auto& r = record(entity, component);
    const auto& edge = edge_from(r.table, component, false, entity);
    if (has_remove_hooks_) [[unlikely]] {
        removing(component, entity);
    }
    const auto row = r.row;
    follow(edge, r, entity);
    return {edge.from->cells[component], row, edge.from->rows};
}

// Inlined, so that the component goes from registers into its cell.
template <Component C>
[[gnu::always_inline]] inline void World::add(Entity entity, const C& component) {
    const auto c = id<C>();
    check_write(c);
    if constexpr (Tag<C>) {
        mark(entity, c);
    } else {
        const C value = component;  // a copy, since the argument may be in a table that changes now
        const auto [array, row] = extend(entity, c);
        reinterpret_cast<C*>(array)[place_of<C>(entity, row)] = value;
    }
    ++counts_[c];
    added(c, entity);
}

template <Component C>
[[gnu::always_inline]] inline void World::remove(Entity entity) {
    const auto c = id<C>();
    check_write(c);
    if constexpr (Tag<C>) {
        unmark(entity, c);
    } else {
        const auto [array, row, filler] = narrow(entity, c);
        if constexpr (!StaysInPlace<C>) {
            auto* cells = reinterpret_cast<C*>(array);
            cells[row] = cells[filler];
        }
    }
    --counts_[c];
}

template <Component C>
bool World::has(Entity entity) const {
    const auto c = id<C>();
    check_read(c);
    const auto& r = record(entity, c);
    const auto& table = *tables_[r.table];
    if constexpr (Tag<C>) {
        const auto at = table.tag_of[c];
        return at != no_tag && table.tags[at].test(r.row);
    } else {
        return table.cells[c] != nullptr;
    }
}

template <Component C>
const C& World::get(Entity entity) const {
    static_assert(!Tag<C>, "a tag has no value");
    const auto c = id<C>();
    check_read(c);
    const auto& r = record(entity, c);
    const auto* cells = tables_[r.table]->template cells_of<const C>(c);
    if (cells == nullptr) [[unlikely]] {
        fail("has no component", c, entity);
    }
    return cells[place_of<C>(entity, r.row)];
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
