// Entities, components and a system: balls fall and bounce for ten seconds. Prints how many still bounce.
#include <iostream>

#include "core/text.h"
#include "ecs/schedule.h"
#include "ecs/snapshot.h"
#include "ecs/world.h"

namespace {

using namespace thaum;

struct Height {
    double value{};  ///< height above the floor (m)
    THAUM_COMPONENT(Height, value);
};

struct Speed {
    double value{};  ///< vertical speed, positive upwards (m/s)
    THAUM_COMPONENT(Speed, value);
};

struct Resting {
    static constexpr std::string_view name = "Resting";  ///< a component without fields is a tag
};

void fall(ecs::World& world, Tick) {
    world.view<Height, Speed, ecs::Without<Resting>>().each(
        [&](ecs::Entity ball, Height& height, Speed& speed) {
            speed.value -= 9.81 * tick_seconds;
            height.value += speed.value * tick_seconds;
            if (height.value > 0 || speed.value > 0) return;
            height.value = 0;
            speed.value *= -0.8;
            if (speed.value < 0.05) world.commands().add(ball, Resting{});
        });
}

}  // namespace

int main() {
    ecs::World world;
    world.declare<Height>();
    world.declare<Speed>();
    world.declare<Resting>();
    for (int i = 1; i <= 100; ++i) world.create(Height{0.1 * i}, Speed{});

    ecs::Schedule schedule;
    schedule.add({.name = "fall",
                  .reads = world.mask<Height, Speed, Resting>(),
                  .writes = world.mask<Height, Speed>(),
                  .run = fall});
    for (Tick tick = 0; tick < 10 * ticks_per_second; ++tick) schedule.run(world, tick);

    const auto bouncing = world.size() - world.count<Resting>();
    std::cout << text(bouncing, " of ", world.size(), " balls bounce\n");
    std::cout << "hash " << hex(ecs::state_hash(world)) << '\n';
}
