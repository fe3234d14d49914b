// Push: throws back the wizard and the loose things in a cone ahead. A wizard gets a speed, a thing an
// impulse, so that a crate flies and a table slides. A wizard who dies by a fall soon afterwards counts as
// killed by the caster.
#include <algorithm>
#include <cmath>

#include "game/context/shot.h"
#include "game/context/shove.h"
#include "game/data/spell.h"
#include "game/data/wand_slots.h"

namespace thaum::game::inline spells {
namespace {

struct PushData {
    double reach{};          ///< length of the cone (m)
    double narrowest_cos{};  ///< cosine of the largest angle off the cone's axis (half its opening angle)
    double speed{};          ///< speed that the push gives to a wizard (m/s)
    double impulse{};        ///< impulse that the push gives to a thing (N s)
    double fastest{};        ///< largest speed that a thing gains by the push (m/s)
    double lift{};           ///< minimum upward component of the direction in which a thing is pushed
};

/// A body that the cone of the push reaches.
struct Reached {
    vec3 way{};    ///< direction from the eye to the body's middle (unit)
    vec3 point{};  ///< nearest point of the body's surface in the direction `way` (m, world)
};

/// Tests whether the cone reaches a body: its middle is within the angle, its surface within reach, and
/// nothing is in between.
std::optional<Reached> reach(const MatchContext& context, const PushData& data, ecs::Entity caster,
                             physics::Key key, vec3 middle) {
    const auto& physics = context.physics.read();
    const auto [eye, ahead] = sight_of(context, caster);
    const vec3 to = middle - eye;
    const double whole = glm::length(to);
    if (!(whole > 0) || glm::dot(to, ahead) < whole * data.narrowest_cos) return {};
    const vec3 way = to / whole;
    const auto hit =
        physics.ray(eye, eye + way * std::min(whole, data.reach), physics::all_layers, caster.index);
    if (!hit || hit->key != key) return {};
    return Reached{way, hit->point};
}

/// The horizontal direction of a vector; straight ahead if the vector is vertical.
vec3 level(vec3 way, double yaw) {
    const vec3 flat(way.x, 0, way.z);
    const double length = glm::length(flat);
    return length > 1e-6 ? flat / length : rotation({0, 1, 0}, yaw) * vec3(0, 0, -1);
}

void push_wizard(const SpellCast& cast, const PushData& data, ecs::Entity foe, const Reached& reached) {
    auto& world = cast.context.world;
    const auto& const_world = std::as_const(world);
    const auto by = const_world.get<Wizard>(cast.wizard).player;
    const double speed = data.speed * cast.strength;
    const vec3 way = level(reached.way, const_world.get<Gaze>(cast.wizard).yaw);
    shove(cast.context, foe, way * (speed * const_world.get<Body>(foe).mass),
          const_world.get<Motion>(foe).position, by, cast.tick);
    world.get<Health>(foe).foe_did_at = cast.tick;
    record(cast.context, {.tick = cast.tick,
                          .kind = EventKind::pushed,
                          .subject = const_world.get<Wizard>(foe).player,
                          .by = by,
                          .amount = speed,
                          .place = reached.point});
}

void push_thing(const SpellCast& cast, const PushData& data, ecs::Entity thing, const Reached& reached) {
    const auto& const_world = std::as_const(cast.context.world);
    const double impulse =
        std::min(data.impulse, data.fastest * const_world.get<Body>(thing).mass) * cast.strength;
    const vec3 up(reached.way.x, std::max(reached.way.y, data.lift), reached.way.z);
    const double length = glm::length(up);
    const vec3 way = length > 0 ? up / length : vec3(0, 1, 0);
    shove(cast.context, thing, way * impulse, reached.point, const_world.get<Wizard>(cast.wizard).player,
          cast.tick);
}

/// The thing that the wizard holds with the wand in hand; an invalid entity if there is none.
ecs::Entity thing_in_hand(const MatchContext& context, ecs::Entity wizard) {
    const auto* wand = wand_in_hand(context.data, std::as_const(context.world).get<WandBelt>(wizard));
    return wand != nullptr ? wand->rules->held_thing(context.world, wizard) : ecs::Entity{};
}

/// Share of the reach within which a bot casts, since the foe moves while the stroke is drawn.
constexpr double well_within = 0.9;
constexpr double close = 2.5;  ///< distance below which a bot wants its foe farther away, so pushes (m)

class PushSpell final : public SpellRules {
public:
    explicit PushSpell(const ConfigTable& root) {
        data_.reach = root.number("reach_m", {0, 100});
        data_.narrowest_cos = det::cos(root.number("angle_deg", {1, 180}) / 2 * radians_per_degree);
        data_.speed = root.number("speed_m_s", {0, 100});
        const auto things = root.table("things");
        data_.impulse = things.number("impulse_n_s", {0, 1e5});
        data_.fastest = things.number("fastest_m_s", {0, 100});
        data_.lift = things.number("lift", {0, 1});
    }

    void cast(const SpellCast& cast) const override {
        auto& world = cast.context.world;
        const auto held = thing_in_hand(cast.context, cast.wizard);
        world.view<const Body, const Motion>().each(
            [&](ecs::Entity e, const Body& body, const Motion& motion) {
                if (body.mass <= 0 || e == cast.wizard || e == held) return;
                const auto reached = reach(cast.context, data_, cast.wizard, e.index, motion.position);
                if (!reached) return;
                world.has<Wizard>(e) ? push_wizard(cast, data_, e, *reached)
                                     : push_thing(cast, data_, e, *reached);
            });
    }
    double worth(const SpellOccasion& occasion) const override {
        const bool meets = occasion.sees_foe && occasion.foe_distance < well_within * data_.reach &&
                           occasion.foe_aside < det::acos(data_.narrowest_cos) / 2;
        if (!meets) return 0;
        if (occasion.foe_at_edge) return 1;
        return occasion.foe_distance < close ? 0.5 : 0;
    }
    ecs::Mask reads(const ecs::World& world) const override {
        return world.mask<Wizard, Gaze, Motion, Body, WandBelt>();
    }
    ecs::Mask writes(const ecs::World& world) const override {
        return world.mask<Health, Stance, Prop, EventLog, resource::Journal, resource::Physics>();
    }

private:
    PushData data_;
};

const SpellRegistration registration({
    .name = "push",
    .declare = declare_all<>,
    .read = read_rules<SpellRules, PushSpell>,
});

}  // namespace
}  // namespace thaum::game::inline spells
