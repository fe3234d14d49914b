// ecs/resource.h: a value that systems share beside components, such as a physics engine. Systems
// declare access to it as to a component:
//
//     struct Bodies {
//         using Value = physics::Physics;
//         static constexpr std::string_view name = "bodies";
//     };
//
//     World world;
//     Resource<Bodies> bodies(world, settings);
//     schedule.add({.name = "step", .writes = world.mask<Bodies>(), .run = [&](World&, Tick) {
//                       bodies.write().step(dt);
//                   }});
//
// A resource is no part of the World's state: it is neither saved nor hashed nor restored.
#pragma once
#include "ecs/world.h"

namespace thaum::ecs {

/// Owns the value of one resource, which the systems of a World share.
template <ResourceType R>
class Resource {
public:
    /// Type of the value that the systems share.
    using Value = typename R::Value;

    /// Declares the resource in the World, which must outlive it, and constructs the value from the
    /// arguments.
    template <class... Args>
    explicit Resource(World& world, Args&&... args)
        : world_(world),
          number_(world.declare_resource(R::name, detail::type_number<R>)),
          value_{std::forward<Args>(args)...} {}
    Resource(const Resource&) = delete;
    Resource& operator=(const Resource&) = delete;

    /// The value for reading. The running system must have declared that it reads or writes the resource.
    const Value& read() const {
        world_.check_read(number_);
        return value_;
    }
    /// The value for changing it. The running system must have declared that it writes the resource.
    Value& write() {
        world_.check_write(number_);
        return value_;
    }

private:
    const World& world_;
    std::uint32_t number_;
    Value value_;
};

}  // namespace thaum::ecs
