// Tests of the wand's tip as the probe with which a hand feels things: the frames of world and device, and
// that turning and walking give no force on the hand.
#include <algorithm>

#include "core/random.h"
#include "game/components/hand_state.h"
#include "game/context/surfaces.h"
#include "unit/game_duel.h"

namespace thaum::game::test {
namespace {

vec3 any_place(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

HandFrame any_frame(Random& random) {
    return {.origin = any_place(random, 10),
            .turn = look_rotation(random.uniform(-3, 3), random.uniform(-1, 1)),
            .metres_per_metre = 10};
}

/// Position (m) after one tick of a point on a rigid body with this velocity and spin about a pivot, which is
/// at `pivot_now` after the tick. A patch of surfaces gives the motion of its bodies in this form.
vec3 moved(vec3 velocity, vec3 spin, vec3 pivot_now, vec3 place) {
    const double speed = glm::length(spin);
    const vec3 arm = place - (pivot_now - tick_seconds * velocity);
    return pivot_now + (speed > 0 ? rotation(spin / speed, speed * tick_seconds) * arm : arm);
}

TEST(Probe, ThingsAtRestMoveExactlyInATurningFrame) {
    Random random{1};
    for (int n = 0; n < 200; ++n) {
        const HandFrame frame = any_frame(random);
        HandFrame before = frame;
        before.origin += any_place(random, 0.02);
        before.turn = frame.turn * rotation({0, 1, 0}, random.uniform(-0.05, 0.05)) *
                      rotation({1, 0, 0}, random.uniform(-0.05, 0.05));
        const vec3 middle = frame.origin + any_place(random, 0.3);
        physics::Physics world;
        world.add(5, {.shape = physics::Shape::box, .size = {0.2, 0.1, 0.3}}, {.position = middle});
        haptics::SurfacePatch patch;
        fill_patch(patch, world, {.point = middle, .radius = 0.1}, frame, before, {.stiffness = 250});
        ASSERT_EQ(patch.count, 1U);
        const auto& body = patch.bodies[patch.surfaces[0].body];
        EXPECT_EQ(body.key, 5U);
        EXPECT_LE(glm::length(body.position - frame.to_device(middle)), 1e-15);
        const auto drift = frame_motion_of(frame, before);
        for (int i = 0; i < 10; ++i) {
            const vec3 place = middle + any_place(random, 0.3);
            const vec3 was = before.to_device(place), is = frame.to_device(place);
            EXPECT_LE(glm::length(moved(body.velocity, body.spin, body.position, was) - is), 1e-13);
            EXPECT_LE(glm::length(moved(drift.velocity, drift.spin, tick_seconds * drift.velocity, was) - is),
                      1e-13);
        }
        fill_patch(patch, world, {.point = middle, .radius = 0.1}, frame, frame, {.stiffness = 250});
        EXPECT_EQ(patch.bodies[0].velocity, vec3(0));
        EXPECT_EQ(patch.bodies[0].spin, vec3(0));
    }
}

TEST(Probe, SizesAndReachAreThoseOfTheDevice) {
    physics::Physics world;
    world.add(1, {.shape = physics::Shape::box, .size = {1, 2, 3}, .friction = 0.5},
              {.position = {0, -2, 0}});
    for (physics::Key key = 2; key < 20; ++key)
        world.add(key, {.shape = physics::Shape::sphere, .size = {0.1, 0, 0}},
                  {.position = {0.3 * key, 1, 0}});
    haptics::SurfacePatch patch;
    const HandFrame frame{.metres_per_metre = 10};
    const Feel feel{.stiffness = 250, .damping = 1, .static_friction = 0.8, .dynamic_friction = 0.6};
    fill_patch(patch, world, {.point = {0, 0.5, 0}, .radius = 0.6}, frame, frame, feel);
    EXPECT_LE(glm::length(patch.surfaces[0].b - vec3(0.1, 0.2, 0.3)), 1e-15);
    EXPECT_EQ(patch.bodies[0].material.static_friction, 0.4);
    EXPECT_EQ(patch.bodies[0].material.dynamic_friction, 0.3);
    EXPECT_NEAR(patch.reach, 0.06, 1e-15);
    fill_patch(patch, world, {.point = {0, 0.5, 0}, .radius = 50}, frame, frame, feel);
    EXPECT_EQ(patch.body_count, haptics::surface_body_capacity) << "of 19";
    const double left_out = glm::length(vec3(0.3 * 9, 0.5, 0)) - 0.1;
    EXPECT_NEAR(patch.reach, left_out / 10, 1e-12);
}

/// The wizard walks and turns for a minute over the whole arena, against walls, over the bowl and down the
/// pits.
TEST(Probe, TurningAndWalkingGiveNoForce) {
    Simulation match(duel_data({}),
                     {.seed = 1,
                      .devices = {{.player = 0, .kind = input::DeviceKind::script, .name = "one"},
                                  {.player = 1, .kind = input::DeviceKind::script, .name = "two"}}});
    Random random{2};
    double strongest = 0;
    int shifted = 0;
    input::InputFrame frame;
    for (int tick = 0; tick < 60'000; ++tick) {
        if (tick % 200 == 0) {
            frame.devices[0].counts[input::hand::forward] = static_cast<std::int32_t>(random.below(2)) * 127;
            frame.devices[0].counts[input::hand::look_right] = static_cast<std::int32_t>(random.below(9)) - 4;
            frame.devices[0].counts[input::hand::look_up] = static_cast<std::int32_t>(random.below(3)) - 1;
        }
        match.tick(frame);
        const auto& hand_state = match.world().get<HandState>(wizard_of(match.world(), 0));
        strongest = std::max(strongest, glm::length(hand_state.servo.safety.output));
        if (glm::length(hand_state.servo.contact_offset) > 0.005) ++shifted;
    }
    EXPECT_LT(strongest, 0.1);
    EXPECT_GT(shifted, 1000) << "the wand met nothing at all";
}

}  // namespace
}  // namespace thaum::game::test
