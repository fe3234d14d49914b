// The lift wand: while fire is held, a spring and damper join the hand and the loose thing that was under the
// crosshair (paper 002, 3.1.1). The hand's point in the world (haptic interface point, HIP) moves with the
// wizard, with the view and, magnified, with the device. The thing is moved by force alone, and the hand
// feels the opposite force.
//
// Three forces on the thing are not felt by the hand. The first holds the weight up (a fader lets the hand
// feel a share). The second is drag against the wizard's frame, without which a thing of 120 kg would
// oscillate for ten seconds. The third, up to a limit, carries the thing along with the wizard's frame, so
// that neither a step nor a turn of the view kicks the hand. The frame follows the view smoothly.
#include <algorithm>
#include <cmath>

#include "game/components/casting.h"
#include "game/context/hand_forces.h"
#include "game/context/shot.h"
#include "game/data/wand.h"
#include "game/wands/wand_coupling.h"

namespace thaum::game::inline wands {
namespace {

using input::Button;

struct LiftData {
    double energy_per_use{},
        energy_per_impulse{};    ///< energy that a gameplay tick of holding costs, energy that an impulse
                                 ///< costs (1/(N s))
    double range{}, max_mass{};  ///< reach of the wand from the eye (m), largest mass of a thing that it
                                 ///< lifts (kg)
    /// Stiffness (N/m) and damping (N s/m) of the spring between hand and thing; drag on the thing, as a
    /// share of critical damping.
    double stiffness{}, damping{}, drag_ratio{};
    /// Distance between hand and thing beyond which the wand loses the thing (m).
    double lost{};
    /// Largest torque that keeps the held thing's orientation (N m).
    double turn_torque{};
    /// Largest force that carries the thing along with the wizard's frame, which moves with the wizard and
    /// follows the view smoothly (N).
    double carry{};
    double follow{};  ///< rate at which the rotation of the wizard's frame follows the view (1/s)
    /// Limits of the rotation of the wizard's frame, which follows the view (rad/s, rad/s^2)
    double follow_rate{}, follow_acceleration{};
    /// Largest speed that a turn of the view gives to a held thing (m/s).
    double follow_speed{};
    double wheel{};  ///< distance by which a wheel step moves the held thing (m, world)
    Tick caught{};   ///< time for which a thing that flew to the hand is held without fire (ticks)
    double metres_per_metre{}, finest{};
    double felt_stiffness{};  ///< stiffness of the spring as felt at the device (N/m)
    double weight{};          ///< force felt per mass, which is the felt share of the weight (N/kg)
    /// Kick of the hand per impulse of a blow on the held thing (N/(N s)); smallest impulse felt (N s).
    double blow{}, min_blow{};
    double throw_speed{}, recoil{};  ///< largest speed of a throw (m/s), peak of its recoil (N)
    Tick recoil_length{};
};

/// State of the lift wand in a wizard's hand. Symbols with P_ are those of paper 002.
struct LiftHand {
    ecs::Entity held{};
    quat turn{1, 0, 0, 0};  ///< orientation of the held thing relative to the yaw of the wizard's frame
    double yaw{}, pitch{};  ///< direction of the wizard's frame, which follows the view smoothly (rad)
    double yaw_rate{}, pitch_rate{};  ///< rotation rates of the wizard's frame (rad/s)
    vec3 taken_object{};  ///< P_obj0: position of the held thing when taken up (m, wizard's frame)
    /// P_device0: position of the device when the held thing was taken up (m, device frame)
    vec3 taken_device{};
    vec3 hip{};            ///< P_HIP: place of the hand in the world (haptic interface point) after the last
                           ///< tick (m)
    vec3 base{};           ///< place of the hand in the world without the device's own displacement (m)
    vec3 base_velocity{};  ///< velocity of `base`, the hand's point without the device's own displacement
                           ///< (m/s, world)
    WandCoupling coupling{};
    double metres_per_metre{};
    double impulse{};  ///< impulse of the spring that has not been paid for with energy yet (N s)
    Tick next_blow{};
    /// Tick until which a caught thing is held without fire; 0: it is held by fire.
    Tick caught_until{};
    std::uint32_t slot{};  ///< slot of the wand that holds the thing
    std::uint32_t spare{};
    THAUM_COMPONENT(LiftHand, held, turn, yaw, pitch, yaw_rate, pitch_rate, taken_object, taken_device, hip,
                    base, base_velocity, coupling, metres_per_metre, impulse, next_blow, caught_until, slot,
                    spare);
};

constexpr Tick between_blows = 40;  ///< minimum time between two felt blows on the held thing (ticks)
constexpr Tick blow_length = 20;    ///< duration of the kick by which a blow is felt (ticks)
constexpr double blow_force = 2.5;  ///< largest force of the kick by which a blow is felt (N)
/// Downward acceleration at which a thing weighs as the wand's file says (m/s^2)
constexpr double usual_gravity = 9.81;
/// Distance from the eye at which a throw's path crosses the line of sight (m)
constexpr double throw_reach = 20;

LiftData read(const ConfigTable& root) {
    LiftData data;
    const auto energy = root.table("energy");
    data.energy_per_use = energy.number("per_s", {0, 1e6}) * gameplay_dt;
    data.energy_per_impulse = energy.number("per_n_s", {0, 1e6});
    const auto hold = root.table("hold");
    data.range = hold.number("range_m", {0, 100});
    data.max_mass = hold.number("mass_max_kg", {0, 1e5});
    data.stiffness = hold.number("stiffness_n_per_m", {1, 1e6});
    data.damping = hold.number("damping_n_s_per_m", {0, 1e5});
    data.drag_ratio = hold.number("drag_ratio", {0, 10});
    data.lost = hold.number("lost_m", {0.01, 100});
    data.turn_torque = hold.number("turn_torque_n_m", {0, 1e6});
    data.carry = hold.number("carry_max_n", {0, 1e6});
    data.follow = 1 / hold.number("follow_s", {0.01, 10});
    data.follow_rate = hold.number("follow_deg_per_s", {0, 1e4}) * radians_per_degree;
    data.follow_acceleration = hold.number("follow_deg_per_s2", {0, 1e6}) * radians_per_degree;
    data.follow_speed = hold.number("follow_m_s", {0, 1000});
    data.wheel = hold.number("wheel_m", {0, 10});
    data.caught = ticks(hold.number("caught_s", {0, 3600}));
    const auto hand = root.table("hand");
    data.metres_per_metre = hand.number("metres_per_metre", {0.01, 1000});
    data.finest = hand.number("finest", {0.001, 1});
    data.felt_stiffness = hand.number("stiffness_n_per_m", {0, 1e4});
    data.weight = hand.number("weight_n_per_kg", {0, 10});
    data.blow = hand.number("blow_n_per_n_s", {0, 100});
    data.min_blow = hand.number("blow_least_n_s", {0, 1e4});
    const auto thrown = root.table("throw");
    data.throw_speed = thrown.number("speed_m_s", {0, 100});
    data.recoil = thrown.number("recoil_n", {0, 100});
    data.recoil_length = std::max<Tick>(1, ticks(thrown.number("length_s", {0.001, 10})));
    return data;
}

/// Largest extent of a body (m).
double extent(const physics::BodyDesc& body) {
    switch (body.shape) {
        case physics::Shape::box: return 2 * std::max({body.size.x, body.size.y, body.size.z});
        case physics::Shape::sphere: return 2 * body.size.x;
        default: return 2 * (std::max(body.size.x, body.size.y));
    }
}

/// Largest of a body's three moments of inertia (kg m^2).
double max_inertia(const physics::BodyDesc& body) {
    const vec3 s2 = body.size * body.size;
    switch (body.shape) {
        case physics::Shape::box: return body.mass / 3 * (s2.x + s2.y + s2.z - std::min({s2.x, s2.y, s2.z}));
        case physics::Shape::sphere: return 0.4 * body.mass * s2.x;
        default: return body.mass * std::max(s2.x / 2, s2.x / 4 + s2.y / 3);
    }
}

double wrapped(double angle) { return angle - 2 * pi * std::round(angle / (2 * pi)); }

double newtons_per_newton(const LiftData& data, const LiftHand& hand) {
    return data.felt_stiffness / (hand.metres_per_metre * data.stiffness);
}

haptics::CouplingFrame frame_of(const MatchContext& context, const LiftData& data, ecs::Entity wizard,
                                const LiftHand& hand) {
    return {.player_to_world = glm::mat3_cast(look_rotation(hand.yaw, hand.pitch)),
            .device_to_player = mat3(1.0),
            .metres_per_metre = hand.metres_per_metre,
            .newtons_per_newton = newtons_per_newton(data, hand),
            .player = sight_of(context, wizard).eye,
            .taken_object = hand.taken_object,
            .taken_device = hand.taken_device};
}

// ---- taking up and letting go -----------------------------------------------------------------------------

/// A loose thing under the crosshair.
struct Sighted {
    ecs::Entity thing{};  ///< the loose thing; not a valid entity if there is none
    double mass{};        ///< mass of the loose thing (kg)
    double distance{};    ///< distance from the eye to the thing's surface (m)
};

/// Finds the loose thing under the crosshair, at most `far` m from the eye.
Sighted loose_thing_ahead(const MatchContext& context, ecs::Entity wizard, double far) {
    const auto [eye, ahead] = sight_of(context, wizard);
    const auto& physics = context.physics.read();
    const auto hit = physics.ray(eye, eye + ahead * far, physics::all_layers, wizard.index);
    if (!hit) return {};
    const auto thing = context.world.entity(hit->key);
    if (!thing || !context.world.has<Prop>(thing)) return {};
    return {thing, physics.desc(hit->key).mass, hit->fraction * far};
}

/// The loose thing under the crosshair, if it is near and light enough.
ecs::Entity aimed_at(const MatchContext& context, const LiftData& data, ecs::Entity wizard) {
    const auto sighted = loose_thing_ahead(context, wizard, data.range);
    return sighted.mass <= data.max_mass ? sighted.thing : ecs::Entity{};
}

/// For the picture: whether the loose thing under the crosshair can be taken up, or why not.
Target target_of(const MatchContext& context, const LiftData& data, ecs::Entity wizard) {
    // Multiple of the wand's range within which the picture tells about a thing under the crosshair.
    constexpr double shown_reach = 3;
    if (std::as_const(context.world).get<LiftHand>(wizard).held) return {};
    const auto [thing, mass, distance] = loose_thing_ahead(context, wizard, shown_reach * data.range);
    if (!thing) return {};
    const auto kind = mass > data.max_mass    ? TargetKind::too_heavy
                      : distance > data.range ? TargetKind::too_far
                                              : TargetKind::take;
    return {.kind = kind, .thing = thing, .mass = mass, .mass_share = mass / std::max(data.max_mass, 1e-9)};
}

void take(const WandUse& use, const LiftData& data, ecs::Entity thing, LiftHand& hand) {
    const auto& context = use.context;
    const auto wizard = use.wizard;
    const auto& const_world = std::as_const(context.world);
    const auto& gaze = const_world.get<Gaze>(wizard);
    const auto& body = context.physics.read().state(thing.index);
    hand = {.held = thing, .yaw = gaze.yaw, .pitch = gaze.pitch, .slot = use.stats.slot};
    hand.taken_device = const_world.get<HandState>(wizard).device.position;
    hand.taken_object =
        glm::conjugate(look_rotation(gaze.yaw, gaze.pitch)) * (body.position - sight_of(context, wizard).eye);
    hand.turn = glm::conjugate(rotation({0, 1, 0}, gaze.yaw)) * body.orientation;
    hand.hip = hand.base = body.position;
    hand.base_velocity = context.physics.read().velocity(wizard.index);
    hand.coupling.expected = body.velocity;
    const double size = extent(context.physics.read().desc(thing.index));
    const auto player = const_world.get<Wizard>(wizard).player;
    hand.metres_per_metre = context.input.haptic_setup.workspace_scale[player] * data.metres_per_metre *
                            std::clamp(size, data.finest, 1.0);
}

bool holds(const MatchContext& context, const LiftHand& hand) {
    return hand.held && context.world.alive(hand.held) && context.world.has<Body>(hand.held);
}

void let_thing_go(MatchContext& context, ecs::Entity wizard, LiftHand& hand) {
    if (holds(context, hand)) end_coupling(context.physics.write(), hand.held.index, hand.coupling);
    hand = {};
    let_go(context, wizard);
}

GraspKind grasp_of(const LiftData& data) {
    return {.reach = data.range,
            .max_mass = data.max_mass,
            .speed = data.throw_speed,
            .energy_per_impulse = data.energy_per_impulse,
            .crossing = throw_reach};
}

/// Throws the thing towards a point on the line of sight, as fast as the remaining energy allows.
void throw_thing(const WandUse& use, const LiftData& data, LiftHand& hand) {
    auto& context = use.context;
    auto& belt = context.world.get<WandBelt>(use.wizard);
    auto& energy = belt.energy[use.stats.energy_slot];
    const auto key = hand.held.index;
    const double mass = context.physics.read().desc(key).mass;
    const auto grasp = grasp_of(data);
    const double speed = throw_speed(grasp, mass, energy);
    const auto [eye, ahead] = sight_of(context, use.wizard);
    const vec3 way = glm::normalize(eye + ahead * throw_reach - context.physics.read().state(key).position);
    const double before = glm::dot(coupled_velocity(context.physics.read(), key, hand.coupling), way);
    const double per_speed = grasp.energy_per_impulse * mass;
    energy = std::max(0.0, energy - per_speed * std::max(0.0, speed - before));
    let_thing_go(context, use.wizard, hand);
    context.physics.write().set_velocity(key, way * std::max(speed, before));
    recoil(context, use.wizard, data.recoil * speed / std::max(data.throw_speed, 1e-9), data.recoil_length);
    ++belt.fired;
}

void begin(const WandUse& use, const LiftData& data, LiftHand& hand) {
    auto& world = use.context.world;
    const auto thing = aimed_at(use.context, data, use.wizard);
    if (!thing) return;
    if (!spend(world.get<WandBelt>(use.wizard), use.stats)) return note_dry(use);
    take(use, data, thing, hand);
    // taking a thing up is an attack, which ends the wizard's protection
    world.get<Health>(use.wizard).shielded_until = use.tick;
    if (auto* last = world.find<LastProp>(use.wizard)) last->thing = thing;
}

/// Catches a thing that has come near, and holds it for some seconds without fire. If fire is pressed, the
/// thing is held until fire is released.
bool catch_loose(const WandUse& use, const LiftData& data, ecs::Entity thing) {
    auto& world = use.context.world;
    auto& hand = world.get<LiftHand>(use.wizard);
    const bool light = use.context.physics.read().desc(thing.index).mass <= data.max_mass;
    if (hand.held || !light || !spend(world.get<WandBelt>(use.wizard), use.stats)) return false;
    take(use, data, thing, hand);
    hand.caught_until = use.tick + data.caught;
    record(use.context, {.tick = use.tick,
                         .kind = EventKind::caught,
                         .subject = std::as_const(world).get<Wizard>(use.wizard).player,
                         .by = std::as_const(world).get<Wizard>(use.wizard).player,
                         .amount = use.context.physics.read().desc(thing.index).mass,
                         .place = std::as_const(world).get<Motion>(thing).position});
    return true;
}

/// Pays for holding the thing, credits its hits to the holder, and moves it nearer or farther by the wheel.
void go_on(const WandUse& use, const LiftData& data, const Controls& controls, LiftHand& hand) {
    auto& world = use.context.world;
    const double cost = data.energy_per_use + data.energy_per_impulse * hand.impulse;
    hand.impulse = 0;
    if (!spend(world.get<WandBelt>(use.wizard), use.stats, cost)) {
        let_thing_go(use.context, use.wizard, hand);
        return note_dry(use);
    }
    world.get<Prop>(hand.held) = {.moved_at = use.tick,
                                  .moved_by = std::as_const(world).get<Wizard>(use.wizard).player};
    world.get<HandState>(use.wizard).home.z -= controls.wheel * data.wheel / hand.metres_per_metre;
}

void fire(const WandUse& use, const LiftData& data) {
    auto& world = use.context.world;
    const auto& controls = std::as_const(world).get<Controls>(use.wizard);
    auto& hand = world.get<LiftHand>(use.wizard);
    if (!hand.held) {
        if ((controls.pressed & input::bit(Button::fire)) != 0) begin(use, data, hand);
        return;
    }
    if (!holds(use.context, hand)) return let_thing_go(use.context, use.wizard, hand);
    go_on(use, data, controls, hand);
    if (!hand.held) return;
    if ((controls.pressed & input::bit(Button::throw_)) != 0) return throw_thing(use, data, hand);
    const bool fires = ((controls.held | controls.pressed) & input::bit(Button::fire)) != 0;
    if (fires) hand.caught_until = 0;
    const bool keeps = fires || use.tick < hand.caught_until;
    if (!keeps) let_thing_go(use.context, use.wizard, hand);
}

// ---- every tick -------------------------------------------------------------------------------------------

/// New angular velocity after an implicit step of a critically damped spring, about one axis or three.
/// `frequency` is in rad/s.
template <class T>
T eased_rate(T rate, T off, double frequency) {
    const double x = frequency * physics_dt;
    return (rate + x * frequency * off) / (1 + 2 * x + x * x);
}

void follow_angle(const LiftData& data, double reach, double off, double& angle, double& rate) {
    const double most = data.follow_acceleration * physics_dt;
    const double fastest = std::min(data.follow_rate, data.follow_speed / std::max(reach, 0.1));
    const double wanted = std::clamp(eased_rate(rate, off, data.follow), -fastest, fastest);
    rate += std::clamp(wanted - rate, -most, most);
    angle += rate * physics_dt;
}

/// Turns the wizard's frame, in which the thing is held, smoothly towards the view.
void follow(const LiftData& data, const Gaze& gaze, LiftHand& hand) {
    const double reach = glm::length(hand.taken_object);
    follow_angle(data, reach, wrapped(gaze.yaw - hand.yaw), hand.yaw, hand.yaw_rate);
    follow_angle(data, reach, gaze.pitch - hand.pitch, hand.pitch, hand.pitch_rate);
    hand.yaw = wrapped(hand.yaw);
}

/// Keeps the same side of the thing towards the wizard. Uses an implicit step of a critically damped
/// rotational spring, with the coupling's frequency and a bounded torque.
void hold_turned(physics::Physics& physics, const LiftData& data, const LiftHand& hand) {
    const auto key = hand.held.index;
    const auto& body = physics.desc(key);
    const auto& state = physics.state(key);
    quat off = rotation({0, 1, 0}, hand.yaw) * hand.turn * glm::conjugate(state.orientation);
    if (off.w < 0) off = -off;
    // Approximate rotation vector (rad): exact for small angles, too short for large ones.
    const vec3 angle = 2.0 * vec3(off.x, off.y, off.z);
    const double frequency = std::sqrt(data.stiffness / body.mass);
    const vec3 reference(0, hand.yaw_rate, 0);
    const vec3 spin = reference + eased_rate(state.spin - reference, angle, frequency);
    const double most = data.turn_torque / max_inertia(body) * physics_dt;
    physics.set_spin(key, state.spin + limited(spin - state.spin, most));
}

bool touches_holder(const physics::Physics& physics, ecs::Entity wizard, ecs::Entity held) {
    const auto a = std::min(wizard.index, held.index), b = std::max(wizard.index, held.index);
    const auto contacts = physics.contacts();
    return std::any_of(contacts.begin(), contacts.end(), [=](const auto& c) { return c.a == a && c.b == b; });
}

/// Kicks the hand by the impulse (N s) of whatever has hit the thing since the last tick.
void feel_blow(MatchContext& context, const LiftData& data, const haptics::CouplingFrame& frame,
               ecs::Entity wizard, Tick tick, vec3 blow, LiftHand& hand) {
    const double size = glm::length(blow);
    if (size < data.min_blow || tick < hand.next_blow) return;
    hand.next_blow = tick + between_blows;
    const vec3 way = haptics::to_device(frame, blow / size);
    const double share =
        context.input.haptic_setup.blows[std::as_const(context.world).get<Wizard>(wizard).player];
    if (share > 0) kick(context, wizard, way * (share * std::min(blow_force, data.blow * size)), blow_length);
}

/// The spring between hand and thing that the device feels until the next tick.
haptics::Tether tether_to(const LiftData& data, const haptics::CouplingFrame& frame, const LiftHand& hand,
                          vec3 device, vec3 object, vec3 object_velocity, vec3 base_velocity) {
    return {.anchor = device - haptics::to_device(frame, hand.hip - object) / frame.metres_per_metre,
            .anchor_velocity =
                haptics::to_device(frame, object_velocity - base_velocity) / frame.metres_per_metre,
            .stiffness = haptics::felt_stiffness(frame, data.stiffness),
            .damping = haptics::felt_stiffness(frame, data.damping)};
}

/// Number of wizards who hold the thing. Its weight must be compensated only once.
int holders(const ecs::World& world, ecs::Entity thing) {
    int count = 0;
    world.view<const LiftHand>().each([&](const LiftHand& hand) { count += hand.held == thing; });
    return count;
}

/// Change of the thing's velocity that an obstacle is expected to make in the next step (m/s). An obstacle
/// that has just changed the thing's velocity by `blow` is expected to do so again, at most by as much.
/// Otherwise the hand would feel a thing at a wall as if it were still moving.
vec3 held_back(vec3 velocity, vec3 blow) {
    const double size = glm::length(blow);
    if (!(size > 0)) return vec3(0);
    const vec3 way = blow / size;
    return way * std::clamp(-glm::dot(velocity, way), 0.0, size);
}

/// Motion of the hand's point in the world, and of its base, which is the point without the device's own
/// displacement.
struct HandMotion {
    vec3 hip{}, base{};                    ///< positions of the hand's point and of its base (m)
    vec3 hip_velocity{}, base_velocity{};  ///< velocities of the hand's point and of its base (m/s)
};

HandMotion motion_of(const haptics::CouplingFrame& frame, vec3 device, const LiftHand& hand) {
    const vec3 hip = haptics::interface_point(frame, device);
    const vec3 base = haptics::interface_point(frame, hand.taken_device);
    return {.hip = hip,
            .base = base,
            .hip_velocity = (hip - hand.hip) / physics_dt,
            .base_velocity = (base - hand.base) / physics_dt};
}

/// The thing that the hand holds.
struct HeldThing {
    const physics::BodyState& body;
    double mass{};  ///< mass of the thing (kg)
    int holders{};  ///< number of wizards who hold the thing
};

/// Solves the spring between hand and thing for the coming step.
haptics::CouplingResult couple_thing(const physics::Physics& physics, const LiftData& data,
                                     const LiftHand& hand, const HandMotion& motion, const HeldThing& thing) {
    const double mass = thing.mass;
    const double drag = data.drag_ratio * 2 * std::sqrt(data.stiffness * mass);
    const auto step = haptics::coupling_step({data.stiffness, data.damping, drag}, 1 / mass, 0, physics_dt);
    const vec3 carry = limited(mass * (motion.base_velocity - hand.base_velocity) / physics_dt, data.carry);
    return haptics::couple(
        step, {.hand = hand.hip,
               .hand_velocity = motion.hip_velocity,
               .object = thing.body.position,
               .object_velocity = coupled_velocity(physics, hand.held.index, hand.coupling),
               .drag_velocity = motion.base_velocity,
               .object_acceleration = carry / mass + physics.settings().gravity * (1 - 1.0 / thing.holders)});
}

/// Gives the thing the impulse of the spring and keeps its orientation. If the thing touches its holder it
/// gets neither, because otherwise a wizard could ride on it.
void move_thing(physics::Physics& physics, const LiftData& data, ecs::Entity wizard,
                const haptics::CouplingResult& result, LiftHand& hand) {
    const auto key = hand.held.index;
    if (touches_holder(physics, wizard, hand.held)) {
        end_coupling(physics, key, hand.coupling);
        hand.coupling.expected = physics.state(key).velocity + physics.settings().gravity * physics_dt;
    } else {
        hand.impulse += glm::length(result.impulse);
        apply_coupling(physics, key, result, physics_dt, hand.coupling);
        hold_turned(physics, data, hand);
    }
}

void feel_weight(MatchContext& context, const LiftData& data, ecs::Entity wizard, double mass) {
    const auto player = std::as_const(context.world).get<Wizard>(wizard).player;
    const double share = context.input.haptic_setup.weight[player];
    const double force = data.weight * share * mass * (context.data.wizard.gravity / usual_gravity);
    set_steady_force(context, wizard, vec3(0, -force, 0));
}

/// One tick of holding: the spring pulls hand and thing towards each other, and the hand feels it until the
/// next tick.
void pull(MatchContext& context, const LiftData& data, ecs::Entity wizard, Tick tick, LiftHand& hand) {
    const auto key = hand.held.index;
    auto& physics = context.physics.write();
    const auto& const_world = std::as_const(context.world);
    const vec3 device = const_world.get<HandState>(wizard).device.position;
    follow(data, const_world.get<Gaze>(wizard), hand);
    const auto frame = frame_of(context, data, wizard, hand);
    const HandMotion motion = motion_of(frame, device, hand);
    const HeldThing thing{.body = physics.state(key),
                          .mass = physics.desc(key).mass,
                          .holders = holders(const_world, hand.held)};
    const vec3 blow = thing.body.velocity - hand.coupling.expected;
    if (thing.holders == 1) feel_blow(context, data, frame, wizard, tick, thing.mass * blow, hand);
    const auto result = couple_thing(physics, data, hand, motion, thing);
    const vec3 back = held_back(result.displacement / physics_dt, blow);
    const vec3 object = thing.body.position + result.displacement + back * physics_dt;
    hand.hip = motion.hip;
    hand.base = motion.base;
    hand.base_velocity = motion.base_velocity;
    move_thing(physics, data, wizard, result, hand);
    const vec3 moving = hand.coupling.expected + held_back(hand.coupling.expected, blow);
    tether(context, wizard, tether_to(data, frame, hand, device, object, moving, motion.base_velocity));
    feel_weight(context, data, wizard, thing.mass);
    if (glm::distance(motion.hip, object) > data.lost) let_thing_go(context, wizard, hand);
}

void add_force_systems(const WandSystems& to, const LiftData& data, std::uint32_t slot) {
    auto& world = to.context.world;
    to.schedule.add({.name = "lift",
                     .period = physics_period,
                     .reads = world.mask<Wizard, Gaze, Motion, Body, Dead>(),
                     .writes = world.mask<LiftHand, HandState, WandBelt, resource::Physics>(),
                     .needs = world.mask<LiftHand>(),
                     .run = [&context = to.context, &data, slot](ecs::World& w, Tick tick) {
                         w.view<LiftHand, ecs::Without<Dead>>().each([&](ecs::Entity e, LiftHand& hand) {
                             if (hand.slot == slot && holds(context, hand))
                                 pull(context, data, e, tick, hand);
                         });
                     }});
}

class LiftWand final : public WandRules {
public:
    LiftWand(const ConfigTable& root, std::uint32_t slot) : data_(read(root)), slot_(slot) {}

    void outfit(ecs::World& world, ecs::Entity wizard) const override { world.add(wizard, LiftHand{}); }
    void use(const WandUse& use) const override { fire(use, data_); }
    void put_away(const WandUse& use) const override {
        auto& hand = use.context.world.get<LiftHand>(use.wizard);
        if (hand.held) let_thing_go(use.context, use.wizard, hand);
    }
    ecs::Mask writes(const ecs::World& world) const override {
        return world.mask<LiftHand, EventLog, Health, HandState, Prop, LastProp, resource::Journal,
                          resource::Physics>();
    }
    void add_forces(const WandSystems& to) const override { add_force_systems(to, data_, slot_); }
    std::optional<vec3> held_at(const ecs::World& world, ecs::Entity wizard) const override {
        const auto held = held_thing(world, wizard);
        const auto* motion = held ? world.find<Motion>(held) : nullptr;
        return motion != nullptr ? std::optional(motion->position) : std::nullopt;
    }
    ecs::Entity held_thing(const ecs::World& world, ecs::Entity wizard) const override {
        const auto& hand = world.get<LiftHand>(wizard);
        return hand.slot == slot_ ? hand.held : ecs::Entity{};
    }
    bool catch_thing(const WandUse& use, ecs::Entity thing) const override {
        return catch_loose(use, data_, thing);
    }
    double holding_force(const ecs::World& world, ecs::Entity wizard, double gravity) const override {
        const auto held = held_thing(world, wizard);
        const auto* body = held ? world.find<Body>(held) : nullptr;
        return body != nullptr ? body->mass * gravity : 0;
    }
    Target target(const MatchContext& context, ecs::Entity wizard) const override {
        return target_of(context, data_, wizard);
    }
    bool moves_by_wheel() const override { return true; }
    std::optional<GraspKind> grasp() const override { return grasp_of(data_); }

private:
    LiftData data_;
    std::uint32_t slot_;
};

const WandRegistration registration({
    .name = "lift",
    .declare = declare_all<LiftHand>,
    .read = read_rules<WandRules, LiftWand>,
});

}  // namespace
}  // namespace thaum::game::inline wands
