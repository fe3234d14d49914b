// The swing wand: while fire is held, a rope joins the wizard's body and a point of the court that nothing moves: an anchor
// near the crosshair, or the ground or wall under it. It is the lift's spring (paper 002) that only pulls; it reels in to a share of
// its length, and a hand that pulls shortens it further. The body is moved by force alone.
#include <algorithm>
#include <cmath>

#include "game/match/touch.h"
#include "game/wands/shot.h"
#include "game/wands/tug.h"
#include "game/wands/wand.h"

namespace thaum::game {
namespace {

using input::Button;

struct SwingData {
    double energy_per_use{};               ///< each gameplay tick
    double reach{}, rest_share{}, reel{};  ///< m, of the length at first, m per tick
    double stiffness{}, damping_ratio{};   ///< N/m, of critical damping
    double tension_max{};                  ///< N
    double aim_cos{};
    double metres_per_metre{}, newtons_per_newton{};
    double force_max{};  ///< N
};

/// A wizard's hand on this wand.
struct SwingHand {
    vec3 anchor{};         ///< m
    vec3 taken_device{};   ///< m
    double length{};       ///< m, of the rope when it is slack; 0: not latched
    double rest_length{};  ///< m, to which it reels in
    double pulled{};       ///< m, by which the hand has shortened it
    double tension{};      ///< N, mean over the last tick
    Tug tug{};
    static constexpr std::string_view name = "SwingHand";
    static constexpr auto fields() {
        using H = SwingHand;
        return std::tuple(field("anchor", &H::anchor), field("taken_device", &H::taken_device),
                          field("length", &H::length), field("rest_length", &H::rest_length),
                          field("pulled", &H::pulled), field("tension", &H::tension), field("tug", &H::tug));
    }
};

std::shared_ptr<const void> read(const ConfigTable& root) {
    SwingData data;
    data.energy_per_use = root.table("energy").number("per_s", {0, 1e6}) * gameplay_dt;
    const auto rope = root.table("rope");
    data.reach = rope.number("reach_m", {0.1, 100});
    data.rest_share = rope.number("rest_share", {0.01, 1});
    data.reel = rope.number("reel_m_s", {0, 100}) * physics_dt;
    data.stiffness = rope.number("stiffness_n_per_m", {1, 1e6});
    data.damping_ratio = rope.number("damping_ratio", {0, 10});
    data.tension_max = rope.number("tension_max_n", {1, 1e6});
    data.aim_cos = det::cos(rope.number("aim_deg", {0, 90}) * radians_per_degree);
    const auto hand = root.table("hand");
    data.metres_per_metre = hand.number("metres_per_metre", {0, 1000});
    data.newtons_per_newton = hand.number("newtons_per_newton", {0, 1});
    data.force_max = hand.number("force_max_n", {0, 100});
    return std::make_shared<SwingData>(data);
}

// ---- latching -----------------------------------------------------------------------------------------------------

/// The anchor nearest to the crosshair, else what stands still under it; nothing where both are too far.
std::optional<vec3> latched_at(const Stage& stage, const SwingData& data, ecs::Entity wizard) {
    const auto& now = std::as_const(stage.world);
    const Sight sight = sight_of(stage, wizard);
    const vec3 eye = sight.eye, ahead = sight.ahead;
    std::optional<vec3> found;
    double best = data.aim_cos;
    now.view<const Anchor, const Motion>().each([&](ecs::Entity e, const Motion& motion) {
        const vec3 to = motion.position - eye;
        const double distance = glm::length(to);
        if (distance > data.reach || distance < 1e-6) return;
        const double nearness = glm::dot(to / distance, ahead);
        if (nearness < best) return;
        const auto hit = stage.physics.ray(eye, motion.position, layer::ground, wizard.index);
        if (hit && hit->key != e.index) return;  // the anchor is of the ground, too
        best = nearness;
        found = motion.position;
    });
    if (found) return found;
    const auto hit = stage.physics.ray(eye, eye + ahead * data.reach, physics::all_layers, wizard.index);
    if (!hit || stage.physics.desc(hit->key).mass > 0) return std::nullopt;
    return hit->point;
}

void unlatch(Stage& stage, ecs::Entity wizard, SwingHand& hand) {
    if (stage.physics.has(wizard.index)) end_tug(stage.physics, wizard.index, hand.tug);
    hand = {};
    stage.world.get<Stance>(wizard).hung = 0;
    let_go(stage, wizard);
}

void latch(const WandUse& use, const SwingData& data, SwingHand& hand) {
    auto& world = use.stage.world;
    const auto point = latched_at(use.stage, data, use.wizard);
    if (!point) return;
    if (!spend(world.get<WandBelt>(use.wizard), use.stats)) return note_dry(use);
    hand = {.anchor = *point, .taken_device = std::as_const(world).get<Grip>(use.wizard).device.position};
    hand.length = glm::distance(*point, sight_of(use.stage, use.wizard).eye);
    hand.rest_length = data.rest_share * hand.length;
    hand.tug.expected = use.stage.physics.velocity(use.wizard.index);
}

void use(const WandUse& use) {
    const auto& data = *static_cast<const SwingData*>(use.data);
    auto& world = use.stage.world;
    const auto& controls = std::as_const(world).get<Controls>(use.wizard);
    auto& hand = world.get<SwingHand>(use.wizard);
    const auto fire = input::bit(Button::fire);
    if (hand.length == 0) {
        if ((controls.pressed & fire) != 0) latch(use, data, hand);
        return;
    }
    if ((controls.held & fire) == 0) return unlatch(use.stage, use.wizard, hand);
    if (!spend(world.get<WandBelt>(use.wizard), use.stats, data.energy_per_use)) {
        unlatch(use.stage, use.wizard, hand);
        note_dry(use);
    }
}

// ---- every tick ---------------------------------------------------------------------------------------------------

/// The hand feels the rope's direction; the spring is clipped, as springs are.
vec3 felt(const Stage& stage, const SwingData& data, ecs::Entity wizard, vec3 way, double tension) {
    const auto& gaze = std::as_const(stage.world).get<Gaze>(wizard);
    const double size = std::min(data.force_max, data.newtons_per_newton * tension);
    return glm::conjugate(look_rotation(gaze.yaw, gaze.pitch)) * (way * size);
}

/// How long the slack rope is, m: it reels in, a hand that pulls shortens it, and beyond the most that it bears it slips through.
double slack_length(const SwingData& data, double distance, double pulled, SwingHand& hand) {
    hand.length -= std::min(data.reel, std::max(0.0, hand.length - hand.rest_length));
    hand.length = std::max(hand.length, distance + pulled - data.tension_max / data.stiffness);
    return hand.length - pulled;
}

void pull(Stage& stage, const SwingData& data, ecs::Entity wizard, SwingHand& hand) {
    const auto key = wizard.index;
    const double mass = stage.physics.desc(key).mass;
    const vec3 eye = sight_of(stage, wizard).eye;
    const double distance = glm::distance(hand.anchor, eye);
    const double drawn = std::as_const(stage.world).get<Grip>(wizard).device.position.z - hand.taken_device.z;
    const double pulled = std::clamp(data.metres_per_metre * drawn, 0.0, 0.9 * hand.rest_length);
    const double before = hand.length - hand.pulled;
    const double slack = slack_length(data, distance, pulled, hand);
    hand.pulled = pulled;
    const Rope rope{.anchor = hand.anchor,
                    .length = slack,
                    .growth = (slack - before) / physics_dt,
                    .stiffness = data.stiffness,
                    .damping = data.damping_ratio * 2 * std::sqrt(data.stiffness * mass)};
    const auto result = hang(rope, mass, eye, tugged_velocity(stage.physics, key, hand.tug),
                             stage.physics.settings().gravity, physics_dt);
    const vec3 way = (hand.anchor - eye) / std::max(distance, 1e-9);
    hand.tension = result ? std::max(0.0, glm::dot(result->mean_force, way)) : 0;
    if (result) {
        give_tug(stage.physics, key, *result, physics_dt, hand.tug);
    } else {
        end_tug(stage.physics, key, hand.tug);
    }
    stage.world.get<Stance>(wizard).hung = std::max(0.0, hand.tension * way.y);
    stage.world.get<Grip>(wizard).lean.force = felt(stage, data, wizard, way, hand.tension);
}

void add_forces(const WandSystems& to, const void* wand) {
    auto& world = to.stage.world;
    to.schedule.add({.name = "swing",
                     .period = physics_period,
                     .reads = world.mask<Wizard, Gaze, Motion, Dead>(),
                     .writes = world.mask<SwingHand, Stance, Grip>(),
                     .needs = world.mask<SwingHand>(),
                     .run = [&stage = to.stage, wand](ecs::World& w, Tick) {
                         w.view<SwingHand, ecs::Without<Dead>>().each([&](ecs::Entity e, SwingHand& hand) {
                             if (hand.length > 0) pull(stage, *static_cast<const SwingData*>(wand), e, hand);
                         });
                     }});
}

const WandRegistration registration({
    .name = "swing",
    .read = read,
    .declare = [](ecs::World& world) { world.declare<SwingHand>(); },
    .outfit = [](ecs::World& world, ecs::Entity wizard) { world.add(wizard, SwingHand{}); },
    .use = use,
    .put_away =
        [](const WandUse& use) {
            auto& hand = use.stage.world.get<SwingHand>(use.wizard);
            if (hand.length > 0) unlatch(use.stage, use.wizard, hand);
        },
    .writes =
        [](const ecs::World& world) { return world.mask<SwingHand, Stance, Chronicle, Grip, Anchor>(); },
    .add_forces = add_forces,
    .add_systems = [](const WandSystems&, const void*) {},
    .show = [](const ecs::World&, const std::function<void(const Missile&)>&) {},
    .held_at = [](const ecs::World& world, ecs::Entity wizard) -> std::optional<vec3> {
        const auto& hand = world.get<SwingHand>(wizard);
        return hand.length > 0 ? std::optional(hand.anchor) : std::nullopt;
    },
    .rope =
        [](const void* wand) {
            const auto& data = *static_cast<const SwingData*>(wand);
            return RopeKind{.reach = data.reach, .aim_cos = data.aim_cos};
        },
});

}  // namespace
}  // namespace thaum::game
