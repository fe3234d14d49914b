// The swing wand: while fire is held, a rope joins the wizard's body and a fixed point of the arena. The
// point is an anchor near the crosshair, or the ground or wall under the crosshair. The rope is the spring of
// the lift wand (paper 002), but it only pulls. The rope reels in to a share of its initial length, and a
// hand that pulls shortens it further. The body is moved by force alone.
#include <algorithm>
#include <cmath>

#include "game/context/hand_forces.h"
#include "game/context/shot.h"
#include "game/data/wand.h"
#include "game/wands/wand_coupling.h"

namespace thaum::game::inline wands {
namespace {

using input::Button;

struct SwingData {
    double energy_per_use{};  ///< energy that holding the rope costs per gameplay tick
    /// Reach of the rope from the eye (m), its length when reeled in as a share of its first length, and the
    /// speed at which it is reeled in (m per tick).
    double reach{}, rest_share{}, reel{};
    double stiffness{}, damping_ratio{};  ///< stiffness of the rope (N/m), its damping as a share of critical
                                          ///< damping
    double max_tension{};                 ///< largest tension of the rope (N); beyond it the rope slips
    /// Cosine of the largest angle between the crosshair and an anchor, a point in the arena for ropes.
    double aim_cos{};
    double metres_per_metre{}, newtons_per_newton{};
    double max_force{};  ///< largest force of the rope on the hand, at the device (N)
};

/// State of the swing wand in a wizard's hand.
struct SwingHand {
    vec3 anchor{};         ///< position of the rope's fixed end (m, world)
    vec3 taken_device{};   ///< position of the device when the rope was attached (m, device frame)
    double length{};       ///< length of the slack rope before `pulled` is subtracted (m); 0: no rope
    double rest_length{};  ///< value of `length` at which reeling in ends (m)
    double pulled{};       ///< length by which the hand, pulling, has shortened the rope (m)
    double tension{};      ///< mean tension of the rope over the last tick (N)
    WandCoupling coupling{};
    std::uint32_t slot{};  ///< slot of the wand whose rope it is
    std::uint32_t spare{};
    THAUM_COMPONENT(SwingHand, anchor, taken_device, length, rest_length, pulled, tension, coupling, slot,
                    spare);
};

SwingData read(const ConfigTable& root) {
    SwingData data;
    data.energy_per_use = root.table("energy").number("per_s", {0, 1e6}) * gameplay_dt;
    const auto rope = root.table("rope");
    data.reach = rope.number("reach_m", {0.1, 100});
    data.rest_share = rope.number("rest_share", {0.01, 1});
    data.reel = rope.number("reel_m_s", {0, 100}) * physics_dt;
    data.stiffness = rope.number("stiffness_n_per_m", {1, 1e6});
    data.damping_ratio = rope.number("damping_ratio", {0, 10});
    data.max_tension = rope.number("tension_max_n", {1, 1e6});
    data.aim_cos = det::cos(rope.number("aim_deg", {0, 90}) * radians_per_degree);
    const auto hand = root.table("hand");
    data.metres_per_metre = hand.number("metres_per_metre", {0, 1000});
    data.newtons_per_newton = hand.number("newtons_per_newton", {0, 1});
    data.max_force = hand.number("force_max_n", {0, 100});
    return data;
}

// ---- attaching --------------------------------------------------------------------------------------------

/// Point at which a rope would be attached.
struct Hold {
    vec3 point{};  ///< place at which the rope would be attached (m, world)
    /// the anchor, a point in the arena for ropes; not a valid entity if the point is on a fixed body
    ecs::Entity anchor{};
};

/// The anchor (a point in the arena for ropes) nearest to the crosshair, or else the point of a fixed body
/// under the crosshair; std::nullopt if neither is within reach.
std::optional<Hold> latched_at(const MatchContext& context, const SwingData& data, ecs::Entity wizard) {
    const auto& const_world = std::as_const(context.world);
    const Sight sight = sight_of(context, wizard);
    const vec3 eye = sight.eye, ahead = sight.ahead;
    std::optional<Hold> found;
    double best = data.aim_cos;
    const_world.view<const Anchor, const Motion>().each([&](ecs::Entity e, const Motion& motion) {
        const vec3 to = motion.position - eye;
        const double distance = glm::length(to);
        if (distance > data.reach || distance < 1e-6) return;
        const double nearness = glm::dot(to / distance, ahead);
        if (nearness < best) return;
        const auto hit = context.physics.read().ray(eye, motion.position, layer::ground, wizard.index);
        // What the ray hits first is an obstacle between wizard and anchor, unless it is the anchor itself,
        // which is in the ground layer, too.
        if (hit && hit->key != e.index) return;
        best = nearness;
        found = Hold{motion.position, e};
    });
    if (found) return found;
    const auto hit =
        context.physics.read().ray(eye, eye + ahead * data.reach, physics::all_layers, wizard.index);
    if (!hit || context.physics.read().desc(hit->key).mass > 0) return std::nullopt;
    return Hold{hit->point, {}};
}

void unlatch(MatchContext& context, ecs::Entity wizard, SwingHand& hand) {
    if (context.physics.read().has(wizard.index))
        end_coupling(context.physics.write(), wizard.index, hand.coupling);
    hand = {};
    context.world.get<Stance>(wizard).rope_lift = 0;
    let_go(context, wizard);
}

void latch(const WandUse& use, const SwingData& data, SwingHand& hand) {
    auto& world = use.context.world;
    const auto hold = latched_at(use.context, data, use.wizard);
    if (!hold) return;
    if (!spend(world.get<WandBelt>(use.wizard), use.stats)) return note_dry(use);
    hand = {.anchor = hold->point,
            .taken_device = std::as_const(world).get<HandState>(use.wizard).device.position};
    hand.length = glm::distance(hold->point, sight_of(use.context, use.wizard).eye);
    hand.slot = use.stats.slot;
    hand.rest_length = data.rest_share * hand.length;
    hand.coupling.expected = use.context.physics.read().velocity(use.wizard.index);
}

void fire(const WandUse& use, const SwingData& data) {
    auto& world = use.context.world;
    const auto& controls = std::as_const(world).get<Controls>(use.wizard);
    auto& hand = world.get<SwingHand>(use.wizard);
    const auto fire = input::bit(Button::fire);
    if (hand.length == 0) {
        if ((controls.pressed & fire) != 0) latch(use, data, hand);
        return;
    }
    if ((controls.held & fire) == 0) return unlatch(use.context, use.wizard, hand);
    if (!spend(world.get<WandBelt>(use.wizard), use.stats, data.energy_per_use)) {
        unlatch(use.context, use.wizard, hand);
        note_dry(use);
    }
}

// ---- every tick -------------------------------------------------------------------------------------------

/// Force of the rope on the hand (N, device frame), limited to the wand's largest force.
vec3 felt(const MatchContext& context, const SwingData& data, ecs::Entity wizard, vec3 way, double tension) {
    const auto& gaze = std::as_const(context.world).get<Gaze>(wizard);
    const double size = std::min(data.max_force, data.newtons_per_newton * tension);
    return glm::conjugate(look_rotation(gaze.yaw, gaze.pitch)) * (way * size);
}

/// Unstretched length of the rope (m). The rope reels in, a pulling hand shortens it, and it slips when the
/// tension exceeds the maximum.
double slack_length(const SwingData& data, double distance, double pulled, SwingHand& hand) {
    hand.length -= std::min(data.reel, std::max(0.0, hand.length - hand.rest_length));
    hand.length = std::max(hand.length, distance + pulled - data.max_tension / data.stiffness);
    return hand.length - pulled;
}

void pull(MatchContext& context, const SwingData& data, ecs::Entity wizard, SwingHand& hand) {
    const auto key = wizard.index;
    auto& physics = context.physics.write();
    const double mass = physics.desc(key).mass;
    const vec3 eye = sight_of(context, wizard).eye;
    const double distance = glm::distance(hand.anchor, eye);
    const double drawn =
        std::as_const(context.world).get<HandState>(wizard).device.position.z - hand.taken_device.z;
    const double pulled = std::clamp(data.metres_per_metre * drawn, 0.0, 0.9 * hand.rest_length);
    const double before = hand.length - hand.pulled;
    const double slack = slack_length(data, distance, pulled, hand);
    hand.pulled = pulled;
    const Rope rope{.anchor = hand.anchor,
                    .length = slack,
                    .growth = (slack - before) / physics_dt,
                    .stiffness = data.stiffness,
                    .damping = data.damping_ratio * 2 * std::sqrt(data.stiffness * mass)};
    const auto result = hang(rope, mass, eye, coupled_velocity(physics, key, hand.coupling),
                             physics.settings().gravity, physics_dt);
    const vec3 way = (hand.anchor - eye) / std::max(distance, 1e-9);
    hand.tension = result ? std::max(0.0, glm::dot(result->mean_force, way)) : 0;
    if (result) {
        apply_coupling(physics, key, *result, physics_dt, hand.coupling);
    } else {
        end_coupling(physics, key, hand.coupling);
    }
    context.world.get<Stance>(wizard).rope_lift = std::max(0.0, hand.tension * way.y);
    context.world.get<HandState>(wizard).steady_force.force = felt(context, data, wizard, way, hand.tension);
}

void add_force_systems(const WandSystems& to, const SwingData& data, std::uint32_t slot) {
    auto& world = to.context.world;
    to.schedule.add({.name = "swing",
                     .period = physics_period,
                     .reads = world.mask<Wizard, Gaze, Motion, Dead>(),
                     .writes = world.mask<SwingHand, Stance, HandState, resource::Physics>(),
                     .needs = world.mask<SwingHand>(),
                     .run = [&context = to.context, &data, slot](ecs::World& w, Tick) {
                         w.view<SwingHand, ecs::Without<Dead>>().each([&](ecs::Entity e, SwingHand& hand) {
                             if (hand.slot == slot && hand.length > 0) pull(context, data, e, hand);
                         });
                     }});
}

class SwingWand final : public WandRules {
public:
    SwingWand(const ConfigTable& root, std::uint32_t slot) : data_(read(root)), slot_(slot) {}

    void outfit(ecs::World& world, ecs::Entity wizard) const override { world.add(wizard, SwingHand{}); }
    void use(const WandUse& use) const override { fire(use, data_); }
    void put_away(const WandUse& use) const override {
        auto& hand = use.context.world.get<SwingHand>(use.wizard);
        if (hand.length > 0) unlatch(use.context, use.wizard, hand);
    }
    ecs::Mask writes(const ecs::World& world) const override {
        return world
            .mask<SwingHand, Stance, EventLog, HandState, Anchor, resource::Journal, resource::Physics>();
    }
    void add_forces(const WandSystems& to) const override { add_force_systems(to, data_, slot_); }
    std::optional<vec3> held_at(const ecs::World& world, ecs::Entity wizard) const override {
        const auto& hand = world.get<SwingHand>(wizard);
        return hand.slot == slot_ && hand.length > 0 ? std::optional(hand.anchor) : std::nullopt;
    }
    double holding_force(const ecs::World& world, ecs::Entity wizard, double) const override {
        const auto& hand = world.get<SwingHand>(wizard);
        return hand.slot == slot_ ? hand.tension : 0;
    }
    Target target(const MatchContext& context, ecs::Entity wizard) const override {
        const bool hangs = context.world.get<SwingHand>(wizard).length > 0;
        const auto hold = hangs ? std::nullopt : latched_at(context, data_, wizard);
        if (!hold) return {};
        return {.kind = TargetKind::hook, .thing = hold->anchor};
    }
    std::optional<RopeKind> rope() const override {
        return RopeKind{.reach = data_.reach, .aim_cos = data_.aim_cos};
    }

private:
    SwingData data_;
    std::uint32_t slot_;
};

const WandRegistration registration({
    .name = "swing",
    .declare = declare_all<SwingHand>,
    .read = read_rules<WandRules, SwingWand>,
});

}  // namespace
}  // namespace thaum::game::inline wands
