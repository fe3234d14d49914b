#include "ecs/commands.h"

#include <algorithm>
#include <cstring>

#include "core/assert.h"
#include "core/text.h"
#include "ecs/world.h"

namespace thaum::ecs {

Commands::Commands() {
    constexpr std::size_t bytes_of_a_busy_tick = 16384, entities_of_a_busy_tick = 128;
    bytes_.reserve(bytes_of_a_busy_tick);
    made_.reserve(entities_of_a_busy_tick);
}

Commands::Pending Commands::create_empty() {
    const Pending pending{pending_++};
    put(Kind::create, {pending.number, pending_generation}, 0, {});
    return pending;
}

void Commands::put(Kind kind, Entity entity, std::uint32_t type, std::span<const std::byte> bytes) {
    const Header header{kind, entity, type, static_cast<std::uint32_t>(bytes.size())};
    const auto at = bytes_.size();
    bytes_.resize(at + sizeof header + bytes.size());
    std::memcpy(bytes_.data() + at, &header, sizeof header);
    std::copy(bytes.begin(), bytes.end(), bytes_.data() + at + sizeof header);
}

void Commands::put_add(Entity entity, std::uint32_t type, std::string_view name, const void* bytes,
                       std::size_t size) {
    THAUM_ASSERT(entity.generation != pending_generation || entity.index < pending_,
                 text("a pending entity of applied commands gets component ", name));
    put(Kind::add, entity, type, {static_cast<const std::byte*>(bytes), size});
}

void Commands::apply(World& world) {
    made_.clear();
    const auto real = [&](Entity e) { return e.generation == pending_generation ? made_[e.index] : e; };
    for (std::size_t at = 0; at < bytes_.size();) {
        Header header;
        std::memcpy(&header, bytes_.data() + at, sizeof header);
        at += sizeof header;
        switch (header.kind) {
            case Kind::create: made_.push_back(world.create()); break;
            case Kind::add:
                world.add_bytes(real(header.entity), world.id_of_type_[header.type], bytes_.data() + at);
                break;
            case Kind::remove: world.remove_by_id(real(header.entity), world.id_of_type_[header.type]); break;
            case Kind::destroy: world.destroy(real(header.entity)); break;
        }
        at += header.size;
    }
    bytes_.clear();
    pending_ = 0;
}

}  // namespace thaum::ecs
