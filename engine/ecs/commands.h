// ecs/commands.h: structural changes requested during iteration. They are applied afterwards, in the order of
// the requests.
#pragma once
#include <cstdint>
#include <span>

#include "core/bytes.h"
#include "ecs/component.h"
#include "ecs/entity.h"

namespace thaum::ecs {

class World;

/// Changes of a World (to entities, and to the components that they have) that were requested and are made
/// later, by World::apply_commands.
class Commands {
public:
    /// Reserves room for the commands of a busy tick, so that the first such tick of a match allocates
    /// nothing.
    Commands();

    /// An entity that was requested and will exist once the commands are applied. Until then it can be passed
    /// to other calls of the same Commands.
    struct Pending {
        std::uint32_t number{};
    };

    /// Requests a new entity with these components.
    template <Component... Cs>
    Pending create(const Cs&... components) {
        const Pending pending = create_empty();
        (add(pending, components), ...);
        return pending;
    }
    /// Requests that a component is added to an entity, which must lack it at that time.
    template <Component C>
    void add(Pending pending, const C& component) {
        put_add({pending.number, pending_generation}, detail::type_number<C>, C::name, &component,
                Tag<C> ? 0 : sizeof(C));
    }
    template <Component C>
    void add(Entity entity, const C& component = {}) {
        put_add(entity, detail::type_number<C>, C::name, &component, Tag<C> ? 0 : sizeof(C));
    }
    /// Requests that a component is removed from an entity, which must have it at that time.
    template <Component C>
    void remove(Entity entity) {
        put(Kind::remove, entity, detail::type_number<C>, {});
    }
    /// Requests that an entity is destroyed.
    void destroy(Entity entity) { put(Kind::destroy, entity, 0, {}); }
    bool empty() const { return bytes_.empty(); }

private:
    friend class World;
    enum class Kind : std::uint32_t { create, add, remove, destroy };
    static constexpr std::uint32_t pending_generation = 0xffffffffU;
    struct Header {
        Kind kind;
        Entity entity;
        std::uint32_t type;
        std::uint32_t size;
    };

    Pending create_empty();
    void put(Kind kind, Entity entity, std::uint32_t type, std::span<const std::byte> bytes);
    void put_add(Entity entity, std::uint32_t type, std::string_view name, const void* bytes,
                 std::size_t size);
    void apply(World& world);

    Bytes bytes_;  // all commands: a header for each, then the `size` bytes of its component
    std::uint32_t pending_ = 0;
    std::vector<Entity> made_;
};

}  // namespace thaum::ecs
