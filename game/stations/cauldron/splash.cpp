#include "game/stations/cauldron/splash.h"

#include <algorithm>
#include <array>

namespace thaum::game::inline stations {
namespace {

/// Speed that is added to the slip (the speed of a thing relative to the brew) in the law of drag (m/s). Well
/// below it, drag is proportional to the slip; well above it, drag grows with the square of the slip.
constexpr double slow = 1.5;
constexpr std::size_t max_dips = 8;

/// A thing in the brew or at its surface; vectors are in the brew frame.
struct Dip {
    ecs::Entity thing{};
    vec3 place{}, velocity{};
    double radius{};  ///< radius of a ball about as large as the thing in the brew (m)
    double mass{};
    bool rests{};
};

struct Dips {
    std::array<Dip, max_dips> list{};
    std::size_t count{};
};

double ball_radius(const Body& body) {
    const vec3 half = body.size;
    switch (body.shape) {
        case physics::Shape::box: return (half.x + half.y + half.z) / 3;
        case physics::Shape::cylinder: return (2 * half.x + half.y) / 3;
        default: return half.x;
    }
}

Dips find_dips(const ecs::World& world, const Cauldron& cauldron, const Basin& basin) {
    Dips dips;
    world.view<const Prop, const Body, const Motion>().each(
        [&](ecs::Entity e, const Prop&, const Body& body, const Motion& motion) {
            const double radius = ball_radius(body);
            const vec3 at = motion.position - cauldron.middle;
            const bool within = off_axis(at) < basin.radius && at.y < radius && at.y > -basin.depth - radius;
            if (!within || dips.count == dips.list.size()) return;
            dips.list[dips.count++] = {.thing = e,
                                       .place = at,
                                       .velocity = motion.velocity,
                                       .radius = radius,
                                       .mass = body.mass,
                                       .rests = motion.asleep != 0};
        });
    return dips;
}

/// Impulse on a thing in the brew over one step of the brew's surface (4 ticks): drag against the flow and
/// buoyancy (N s, world).
vec3 push_of(const MatchContext& context, const BrewWork* work, const Cauldron& cauldron, const Dip& dip,
             Tick tick) {
    const double density = context.data.cauldron->density * cauldron.density;
    const double level = surface_at(work, cauldron, cauldron.middle + dip.place) - cauldron.middle.y;
    const double wet = std::clamp((level - dip.place.y + dip.radius) / (2 * dip.radius), 0.0, 1.0);
    const vec3 below = cauldron.middle + dip.place - vec3(0, dip.radius / 2, 0);
    const vec3 slip = dip.velocity - current_at(context.world, work, below, tick);
    const double drag = wet * density * dip.radius * dip.radius * (slow + glm::length(slip));
    const double displaced = wet * density * 4 / 3 * pi * dip.radius * dip.radius * dip.radius;
    // The drag impulse is limited, so that it never reverses the relative velocity.
    const vec3 stop = std::min(drag * surface_dt, dip.mass / 2) * -slip;
    return stop - displaced * context.physics.read().settings().gravity * surface_dt;
}

void splash(MatchContext& context, const BrewWork* work, Cauldron& cauldron, const Dips& dips, Tick tick) {
    const auto& rules = context.data.cauldron->ladle;
    for (std::size_t i = 0; i < dips.count; ++i) {
        const auto& dip = dips.list[i];
        const vec3 push = push_of(context, work, cauldron, dip, tick);
        if (push == vec3(0) || !context.physics.read().has(dip.thing.index)) continue;
        context.physics.write().apply_central_impulse(dip.thing.index, push);
        add_stroke(cauldron, {.place = dip.place - vec3(0, dip.radius / 2, 0),
                              .impulse = -push,
                              .radius = std::max(rules.radius, dip.radius),
                              .by = dip.thing.index + 1});
    }
}

/// Greatest height above the level surface at which a burst still pushes the brew (m).
constexpr double burst_reach = 0.6;

/// Queues the bursts of this tick (missiles that explode) near the brew. If the queue is full, a further
/// burst counts as a repetition of the last one.
void note_bursts(MatchContext& context, BrewSolver& solver, const Basin& basin) {
    const auto& journal = context.output.journal.read();
    if (solver.bursts_seen == journal.count()) return;
    auto& cauldron = context.world.single<Cauldron>();
    auto& bursts = cauldron.bursts;
    journal.each_new(solver.bursts_seen, [&](const Event& event) {
        const vec3 at = event.place - cauldron.middle;
        if (event.kind != EventKind::burst || off_axis(at) > basin.radius || at.y > burst_reach) return;
        if (bursts.count < BrewBursts::most) {
            bursts.place[bursts.count] = at;
            bursts.times[bursts.count++] = 1;
        } else {
            ++bursts.times[bursts.count - 1];
        }
    });
}

/// Pushes the brew down below each queued burst.
void push_by_bursts(MatchContext& context, BrewSolver& solver, Cauldron& cauldron) {
    const auto& rules = *context.data.cauldron;
    const auto& bursts = cauldron.bursts;
    if (bursts.count == 0) return;
    touch_brew(context, solver);
    for (std::uint32_t i = 0; i < bursts.count; ++i) {
        add_stroke(cauldron, {.place = {bursts.place[i].x, -rules.ladle.radius, bursts.place[i].z},
                              .impulse = {0, -rules.burst * bursts.times[i], 0},
                              .radius = 2 * rules.ladle.radius});
    }
    cauldron.bursts = {};
}

}  // namespace

void add_splash_system(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule) {
    auto& world = context.world;
    const auto basin = basin_of(context.data.arena.bowl->size, context.data.cauldron->filled);
    schedule.add(
        {.name = "bursts at the brew",
         .reads = world.mask<resource::Journal>(),
         .writes = world.mask<Cauldron, resource::Brew>(),
         .needs = world.mask<Cauldron>(),
         .run = [&context, &brew, basin](ecs::World&, Tick) { note_bursts(context, brew.write(), basin); }});
    schedule.add(
        {.name = "splashes",
         .period = surface_period,
         .reads = world.mask<Prop, Body, Motion>(),
         .writes = world.mask<Cauldron, BrewSamples, SurfaceSamples, resource::Brew, resource::Physics>(),
         .needs = world.mask<Cauldron>(),
         .run = [&context, &brew, basin](ecs::World& w, Tick tick) {
             auto& cauldron = w.single<Cauldron>();
             auto& solver = brew.write();
             push_by_bursts(context, solver, cauldron);
             const Dips dips = find_dips(std::as_const(w), cauldron, basin);
             const bool all_rest =
                 std::all_of(dips.list.begin(), dips.list.begin() + static_cast<std::ptrdiff_t>(dips.count),
                             [](const Dip& dip) { return dip.rests; });
             if (all_rest) return;
             touch_brew(context, solver);
             splash(context, solver.work.get(), cauldron, dips, tick);
         }});
}

}  // namespace thaum::game::inline stations
