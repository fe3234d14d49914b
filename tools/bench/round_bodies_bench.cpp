// Benchmark of sliding over round bodies: time of a servo step, and error of the force against the closed
// form.
//
// The tip circles at 0.2 m/s under a surface of radius R = 10 mm, at a distance rho from the axis. By
// Coulomb's law the proxy is an angle theta behind the tip, with sin(theta + alpha) = sin(alpha) R / rho,
// where tan(alpha) is the friction. In the groove between two spheres of radius S both resist the pull, so
// the friction is multiplied by S / R.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/hash.h"
#include "core/text.h"
#include "core/units.h"
#include "haptics/servo.h"
#include "tests/scenes/worse.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using haptics::SurfaceKind;
using haptics::SurfacePatch;
using haptics::SurfaceState;

constexpr double surface_stiffness = 300;  // stiffness of the surfaces (N/m)
constexpr double body_radius = 0.01;       // radius of the touched surface (m)
constexpr double depth_ratio = 0.4;        // depth of the tip divided by the radius
constexpr double speed = 0.2;              // speed of the tip (m/s)
constexpr double groove_radius = 1.25;     // radius of the two spheres divided by that of their groove
constexpr int ticks = 4000;

enum class Ground : std::uint8_t { sphere, capsule, cylinder, groove, crowd };

struct Slide {
    Ground ground{};
    std::string_view name{};
    double friction{};
    haptics::ServoState state{};
    double worst{};  ///< largest error of the force (N)
    /// Largest change of the force per tick, in the tip's frame, during steady sliding (N).
    double chatter{};
    int lost{};  ///< number of ticks in which the contact gave no force
};

void add(SurfacePatch& patch, SurfaceKind kind, vec3 centre, vec3 size) {
    patch.surfaces[patch.count] = {
        .kind = kind, .body = patch.body_count - 1, .part = patch.count, .a = centre, .b = size};
    ++patch.count;
}

void add_body(SurfacePatch& patch, double friction) {
    haptics::SurfaceBody& body = patch.bodies[patch.body_count];
    body.key = patch.body_count++;
    body.orientation = rotation({1, 0, 0}, pi / 2);  // so that the axes of capsules and cylinders lie along z
    body.material = {
        .stiffness = surface_stiffness, .static_friction = friction, .dynamic_friction = friction};
}

/// Adds as many round bodies as fit into the patch (the list of surfaces near the hand), around the sphere
/// that is touched.
void add_crowd(SurfacePatch& patch, double friction) {
    constexpr std::array kinds{SurfaceKind::sphere, SurfaceKind::capsule, SurfaceKind::cylinder};
    while (patch.count < haptics::surface_capacity) {
        if (patch.count % 4 == 0 && patch.body_count < haptics::surface_body_capacity)
            add_body(patch, friction);
        const double angle = 2 * pi * patch.count / haptics::surface_capacity;
        add(patch, kinds[patch.count % kinds.size()], {0.03 * det::cos(angle), 0.03 * det::sin(angle), 0},
            {0.004, 0.004, 0});
    }
}

SurfacePatch patch_of(const Slide& run) {
    SurfacePatch patch;
    add_body(patch, run.friction);
    const double aside = body_radius * std::sqrt(groove_radius * groove_radius - 1);
    switch (run.ground) {
        case Ground::capsule: add(patch, SurfaceKind::capsule, {}, {body_radius, body_radius, 0}); break;
        case Ground::cylinder: add(patch, SurfaceKind::cylinder, {}, {body_radius, body_radius, 0}); break;
        case Ground::groove:
            add(patch, SurfaceKind::sphere, {0, 0, aside}, {groove_radius * body_radius, 0, 0});
            add(patch, SurfaceKind::sphere, {0, 0, -aside}, {groove_radius * body_radius, 0, 0});
            break;
        case Ground::crowd:
            add(patch, SurfaceKind::sphere, {}, {body_radius, 0, 0});
            add_crowd(patch, run.friction);
            break;
        case Ground::sphere: add(patch, SurfaceKind::sphere, {}, {body_radius, 0, 0}); break;
    }
    return patch;
}

std::vector<Slide> all_slides() {
    std::vector<Slide> runs;
    for (const double friction : {0.0, 0.35}) {
        runs.push_back({Ground::sphere, "sphere", friction});
        runs.push_back({Ground::capsule, "capsule", friction});
        runs.push_back({Ground::cylinder, "cylinder", friction});
        runs.push_back({Ground::groove, "two_spheres", friction});
        runs.push_back({Ground::crowd, "sphere_among_31", friction});
    }
    return runs;
}

void add_slide_row(const Slide& run, const std::vector<double>& samples_us, Report& report) {
    constexpr double max_chatter = 1e-6;  // largest accepted error and change of the force (N)
    report.rows.push_back(
        {.area = "haptics",
         .name = "round_bodies",
         .setting = {{"shape", std::string(run.name)}, {"friction", run.friction}},
         .time_us = times(samples_us),
         .error = ErrorMeasure{"force_error_n", run.worst},
         .metrics = {{"force_chatter_n", run.chatter}, {"ticks_lost", static_cast<double>(run.lost)}},
         .hash = hex(hash_value(run.state))});
    if (run.lost > 0 || !(run.chatter <= max_chatter) || !(run.worst <= max_chatter))
        report.faults.push_back(text("haptics: round_bodies ", run.name, " friction ", shown(run.friction),
                                     " loses ", run.lost, " ticks, errs by ", shown(run.worst),
                                     " N and chatters by ", shown(run.chatter), " N"));
}

vec3 on_circle(double r, double angle) { return {r * det::cos(angle), r * det::sin(angle), 0}; }

/// Position of the tip at a tick. The tip comes from outside.
vec3 tip_at(int tick) {
    const double in = (1 - depth_ratio) * body_radius;
    return tick == 0 ? vec3(1.5 * body_radius, 0, 0)
                     : on_circle(in, speed * tick_seconds / body_radius * tick);
}

/// Compares the forces with the closed form once the proxy, the point that follows the tip on the surface,
/// slides.
void judge(Slide& run) {
    const SurfacePatch patch = patch_of(run);
    const double felt = run.friction * (run.ground == Ground::groove ? groove_radius : 1);
    const double alpha = det::atan2(felt, 1);
    const double lag = det::asin(det::sin(alpha) / (1 - depth_ratio)) - alpha;
    SurfaceState state;
    vec3 before(0);
    for (int tick = 0; tick < ticks; ++tick) {
        const vec3 tip = tip_at(tick);
        const vec3 force = haptics::touch(patch, state, {tip}, tick_seconds).force;
        if (tick > 0 && force == vec3(0)) ++run.lost;
        const double angle = speed * tick_seconds / body_radius * tick;
        const vec3 out = on_circle(1, angle), round = on_circle(1, angle + pi / 2);
        const vec3 seen(glm::dot(force, out), glm::dot(force, round), force.z);
        constexpr int steady = 400;
        if (tick > steady) {
            const vec3 exact =
                surface_stiffness * (on_circle(body_radius + haptics::surface_gap, angle - lag) - tip);
            run.worst = worse(run.worst, glm::length(force - exact));
            run.chatter = worse(run.chatter, glm::length(seen - before));
        }
        before = seen;
    }
}

std::vector<vec3> tips_of_all_ticks() {
    std::vector<vec3> tips;
    for (int tick = 0; tick < ticks; ++tick) tips.push_back(tip_at(tick));
    return tips;
}

/// Runs the servo over the whole slide. The positions of the tip are precomputed, since only the servo step
/// is to be timed.
void play(Slide& run, const haptics::Servo& servo, const haptics::HapticModel& model,
          const std::vector<vec3>& tips) {
    run.state = {};
    for (const vec3 tip : tips) do_not_optimise(haptics::servo_step(servo, run.state, model, {tip, 0}));
}

}  // namespace

void round_bodies(const Options& options, Report& report) {
    std::vector<Slide> runs = all_slides();
    const haptics::DeviceSpec spec{
        .peak_force = 12, .continuous_force = 12, .max_damping = 5, .position_quantum = 5.5e-5};
    const haptics::Servo servo = haptics::servo_of(spec, 1);
    const std::vector<vec3> tips = tips_of_all_ticks();
    std::vector<haptics::HapticModel> models(runs.size());
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        judge(runs[i]);
        models[i].patch = patch_of(runs[i]);
        models[i].patch_number = 1;
        models[i].start = tip_at(0);
        contestants.push_back(
            {{}, [&run = runs[i], &servo, &model = models[i], &tips] { play(run, servo, model, tips); }});
    }
    auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 3.0, .least = 11});
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (double& us : samples[i]) us /= ticks;
        add_slide_row(runs[i], samples[i], report);
    }
}

}  // namespace thaum::bench
