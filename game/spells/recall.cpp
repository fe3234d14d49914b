// Recall: the loose thing that its wizard took up or threw last flies back and brakes in front of the wizard.
// A wand that can hold the thing catches it; otherwise the thing lands at the wizard's feet. If the ground is
// in the way, the thing rises first. A harsh recall is faster and shoves aside whatever the thing meets.
#include <algorithm>
#include <cmath>

#include "game/components/casting.h"
#include "game/context/shot.h"
#include "game/context/shove.h"
#include "game/data/spell.h"
#include "game/data/wand_slots.h"

namespace thaum::game::inline spells {
namespace {

struct RecallData {
    double reach{};         ///< largest distance of the thing from the eye (m)
    double speed{};         ///< largest speed of the thing's flight (m/s)
    double acceleration{};  ///< largest acceleration of the thing (m/s^2)
    double before{};        ///< distance from the eye to the nearest point of a thing that has arrived (m)
    double aside{};         ///< speed that a harsh (forceful) recall gives to things in the way (m/s)
    Tick gives_up{};        ///< number of ticks after which a thing that has not arrived falls
};

/// The thing that flies back to a wizard. A wizard has this component only during the flight.
struct Recalled {
    ecs::Entity thing{};
    Tick until{};           ///< tick at which the thing falls if it has not arrived
    double strength{};      ///< strength of the spell: 1 for a gentle stroke, more for a harsh (forceful) one
    std::uint32_t spell{};  ///< number of the spell
    std::uint32_t spare{};
    THAUM_COMPONENT(Recalled, thing, until, strength, spell, spare);
};

constexpr double arrived = 0.35;  ///< distance from its destination at which a thing counts as arrived (m)
/// Upward part of the direction over an obstacle, relative to the forward part.
constexpr double way_upwards = 3;
constexpr double noticed_push = 1;  ///< gain of speed above which a wizard counts as pushed (m/s)
constexpr double below_eye = 0.35;  ///< height of the hand below the eye (m)

bool holds(const MatchContext& context, ecs::Entity wizard, ecs::Entity thing) {
    const auto& world = context.world;
    const auto& wands = context.data.wands;
    return std::any_of(wands.begin(), wands.end(), [&](const LoadedWand& wand) {
        return wand.rules->held_thing(world, wizard) == thing;
    });
}

bool is_there(const ecs::World& world, ecs::Entity thing) {
    return thing && world.alive(thing) && world.has<Body>(thing) && world.has<Prop>(thing);
}

/// Whether the thing still exists and no wizard holds it.
bool is_loose(const MatchContext& context, ecs::Entity thing) {
    const auto& world = context.world;
    return is_there(world, thing) && !holds(context, wizard_of(world, 0), thing) &&
           !holds(context, wizard_of(world, 1), thing);
}

/// Half of the largest extent of a body (m).
double half_extent(const physics::BodyDesc& body) {
    switch (body.shape) {
        case physics::Shape::box: return std::max({body.size.x, body.size.y, body.size.z});
        case physics::Shape::sphere: return body.size.x;
        default: return std::max(body.size.x, body.size.y);
    }
}

/// Place in front of the wizard to which the thing's middle flies (m, world).
vec3 place_before(const MatchContext& context, const RecallData& data, ecs::Entity wizard,
                  physics::Key thing) {
    const vec3 eye = sight_of(context, wizard).eye;
    const double yaw = std::as_const(context.world).get<Gaze>(wizard).yaw;
    const double far = data.before + half_extent(context.physics.read().desc(thing));
    return eye + rotation({0, 1, 0}, yaw) * vec3(0, 0, -far) - vec3(0, below_eye, 0);
}

/// Target velocity of the thing: towards its destination, slower as it comes near, and upwards over
/// obstacles.
vec3 wanted_velocity(const physics::Physics& physics, const RecallData& data, const Recalled& recalled,
                     vec3 from, vec3 to) {
    const vec3 way = to - from;
    const double distance = glm::length(way);
    const double braking = std::sqrt(data.acceleration * distance);
    const vec3 ahead = way / distance;
    const bool blocked = physics.ray(from, to, layer::ground).has_value();
    const vec3 turned = blocked ? glm::normalize(ahead + vec3(0, way_upwards, 0)) : ahead;
    return turned * std::min(data.speed * recalled.strength, braking);
}

/// Shoves a body that the flying thing touches, so that the body moves on at least as fast as `data.aside`.
void shove_aside(MatchContext& context, const RecallData& data, ecs::Entity body, vec3 way,
                 std::uint32_t player, Tick tick) {
    auto& world = context.world;
    const auto& state = context.physics.read().state(body.index);
    const double gain = data.aside - glm::dot(state.velocity, way);
    const double mass = context.physics.read().desc(body.index).mass;
    if (gain <= 0 || mass <= 0) return;
    shove(context, body, way * (gain * mass), state.position, player, tick);
    if (!world.has<Wizard>(body)) return;
    world.get<Health>(body).foe_did_at = tick;
    if (gain < noticed_push) return;
    record(context, {.tick = tick,
                     .kind = EventKind::pushed,
                     .subject = std::as_const(world).get<Wizard>(body).player,
                     .by = player,
                     .amount = gain,
                     .place = state.position - way});
}

/// Shoves aside everything that the thing touches, except its wizard and fixed bodies.
void clear_way(MatchContext& context, const RecallData& data, ecs::Entity wizard, physics::Key thing,
               vec3 way, Tick tick) {
    const auto player = std::as_const(context.world).get<Wizard>(wizard).player;
    for (const auto& contact : context.physics.read().contacts()) {
        if (contact.a != thing && contact.b != thing) continue;
        const auto other = context.world.entity(contact.a == thing ? contact.b : contact.a);
        if (other && other != wizard) shove_aside(context, data, other, way, player, tick);
    }
}

/// Why the wand in hand has not caught a thing that has arrived, in words for the wizard.
std::string_view words_of_miss(const MatchContext& context, ecs::Entity wizard, const LoadedWand* wand,
                               double mass) {
    const auto grasp = wand == nullptr ? std::nullopt : wand->rules->grasp();
    if (!grasp) return "it lies before you: only a wand that lifts can catch it";
    if (wand->rules->held_thing(context.world, wizard)) return "it lies before you: your hand was full";
    if (mass > grasp->max_mass) return "it lies before you: it is too heavy to catch";
    return "it lies before you: the wand has no energy to catch it";
}

/// Stores, for display to the wizard, how a recall has ended.
void tell(MatchContext& context, ecs::Entity wizard, std::string_view words, Tick tick) {
    auto& shown = context.output.strokes.write()[std::as_const(context.world).get<Wizard>(wizard).player];
    shown.outcome = words;
    shown.outcome_at = std::max<Tick>(tick, 1);
}

/// Lets the wand in hand catch the thing, or lets the thing fall to the ground.
void arrive(MatchContext& context, ecs::Entity wizard, ecs::Entity thing, Tick tick) {
    const auto* wand = wand_in_hand(context.data, std::as_const(context.world).get<WandBelt>(wizard));
    context.physics.write().set_velocity(thing.index, vec3(0));
    const double mass = context.physics.read().desc(thing.index).mass;
    const auto miss = words_of_miss(context, wizard, wand, mass);
    if (wand == nullptr || !wand->rules->catch_thing({context, wizard, tick, wand->stats}, thing))
        tell(context, wizard, miss, tick);
}

/// Whether the flight must end before the thing has arrived. Stores the reason for the wizard.
bool is_over(MatchContext& context, ecs::Entity wizard, const Recalled& recalled, Tick tick) {
    if (context.world.has<Dead>(wizard)) return true;
    if (!is_loose(context, recalled.thing)) {
        const auto foe =
            wizard_of(context.world, 1 - std::as_const(context.world).get<Wizard>(wizard).player);
        if (holds(context, foe, recalled.thing)) tell(context, wizard, "your foe has caught it", tick);
        return true;
    }
    if (tick < recalled.until) return false;
    tell(context, wizard, "something is in its way", tick);
    return true;
}

/// One step of the flight. Returns false when it has ended.
bool fly(MatchContext& context, const RecallData& data, ecs::Entity wizard, const Recalled& recalled,
         Tick tick) {
    auto& world = context.world;
    const auto thing = recalled.thing;
    if (is_over(context, wizard, recalled, tick)) return false;
    auto& physics = context.physics.write();
    const auto key = thing.index;
    const auto state = physics.state(key);
    const vec3 place = place_before(context, data, wizard, key);
    if (glm::distance(state.position, place) <= arrived) return arrive(context, wizard, thing, tick), false;
    const vec3 wanted = wanted_velocity(physics, data, recalled, state.position, place);
    const vec3 change = limited(wanted - state.velocity, data.acceleration * recalled.strength * physics_dt);
    const double mass = physics.desc(key).mass;
    physics.apply_central_impulse(key, mass * (change - physics.settings().gravity * physics_dt));
    world.get<Prop>(thing) = {.moved_at = tick, .moved_by = std::as_const(world).get<Wizard>(wizard).player};
    if (recalled.strength > 1) clear_way(context, data, wizard, key, glm::normalize(wanted), tick);
    return true;
}

/// Components that the flight of a recalled thing writes, and those that a wand writes when it catches the
/// thing.
ecs::Mask writes_of_flight(const MatchContext& context) {
    const auto& world = context.world;
    auto all = world.mask<Recalled, Prop, Stance, Health, WandBelt, EventLog, resource::Journal,
                          resource::Physics, resource::Strokes>();
    for (const auto& wand : context.data.wands) all |= wand.rules->writes(world);
    return all;
}

constexpr double worth_the_call = 6;  ///< distance of a thing beyond which a bot recalls it (m)
constexpr double close = 4;           ///< distance of the foe below which a bot does not recall (m)
/// share of the focus (the supply that spells cost) above which a bot spends it on a recall
constexpr double plenty = 0.6;

class RecallSpell final : public SpellRules {
public:
    RecallSpell(const ConfigTable& root, std::uint32_t number) : number_(number) {
        data_.reach = root.number("reach_m", {0, 1000});
        data_.speed = root.number("speed_m_s", {0.1, 100});
        data_.acceleration = root.number("acceleration_m_s2", {0.1, 1e4});
        data_.before = root.number("before_m", {0.5, 10});
        data_.aside = root.number("aside_m_s", {0, 100});
        data_.gives_up = ticks(root.number("gives_up_s", {0, 60}));
    }

    std::string_view refusal(const MatchContext& context, ecs::Entity wizard) const override {
        const auto& world = context.world;
        const auto thing = world.get<LastProp>(wizard).thing;
        if (!is_there(world, thing)) return "it calls the thing lifted last; lift one first";
        if (holds(context, wizard, thing)) return "you hold the thing already";
        if (!is_loose(context, thing)) return "your foe holds the thing lifted last";
        const vec3 eye = sight_of(context, wizard).eye;
        const bool near = glm::distance(world.get<Motion>(thing).position, eye) <= data_.reach;
        return near ? "" : "the thing lifted last is too far away";
    }
    void cast(const SpellCast& cast) const override {
        auto& world = cast.context.world;
        const Recalled recalled{.thing = std::as_const(world).get<LastProp>(cast.wizard).thing,
                                .until = cast.tick + data_.gives_up,
                                .strength = cast.strength,
                                .spell = number_};
        if (auto* flying = world.find<Recalled>(cast.wizard))
            *flying = recalled;
        else
            world.commands().add(cast.wizard, recalled);
    }
    double worth(const SpellOccasion& occasion) const override {
        const bool far = occasion.thing_distance > worth_the_call && occasion.thing_distance < data_.reach;
        const bool calm = occasion.sees_foe && !occasion.under_fire && occasion.foe_distance > close;
        return far && calm && occasion.focus > plenty ? 0.4 : 0;
    }
    bool brings_thing() const override { return true; }
    ecs::Mask reads(const ecs::World& world) const override {
        return world.mask<Wizard, Gaze, Motion, Body, Prop, LastProp, WandBelt, resource::Physics>();
    }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Recalled>(); }
    void add_systems(const SpellSystems& to) const override;

private:
    RecallData data_;
    std::uint32_t number_;
};

void RecallSpell::add_systems(const SpellSystems& to) const {
    auto& world = to.context.world;
    to.schedule.add(
        {.name = "recall",
         .period = physics_period,
         .reads = world.mask<Wizard, Gaze, Motion, Body, Dead, WandBelt, Controls>(),
         .writes = writes_of_flight(to.context),
         .needs = world.mask<Recalled>(),
         .run = [&context = to.context, &data = data_, number = number_](ecs::World& w, Tick tick) {
             w.view<const Recalled>().each([&](ecs::Entity wizard, const Recalled& recalled) {
                 if (recalled.spell == number && !fly(context, data, wizard, recalled, tick))
                     w.commands().remove<Recalled>(wizard);
             });
         }});
}

const SpellRegistration registration({
    .name = "recall",
    .declare = declare_all<Recalled>,
    .read = read_rules<SpellRules, RecallSpell>,
});

}  // namespace
}  // namespace thaum::game::inline spells
