// Benchmark of contact with surfaces, in the cases in which CHAI3D was measured (500 N/m, no friction, 0.1
// m/s): evenness of the force on a plane, time of a tick that slides on a mesh of 5,000 triangles with its
// look-up (and on one of 39,600, for the growth of the time), and the force of a rising box.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/hash.h"
#include "core/text.h"
#include "core/units.h"
#include "game/context/surfaces.h"
#include "haptics/servo.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using haptics::SurfaceKind;
using haptics::SurfacePatch;
using haptics::SurfaceState;

constexpr double stiffness = 500;  // stiffness of the touched surface (N/m)
constexpr double depth = 0.005;    // depth of the tip below the surface (m)

SurfacePatch patch_of(SurfaceKind kind, vec3 a, vec3 b) {
    SurfacePatch patch;
    patch.bodies[0].material.stiffness = stiffness;
    patch.body_count = 1;
    patch.surfaces[0] = {.kind = kind, .a = a, .b = b};
    patch.count = 1;
    return patch;
}

/// Largest change of the force from tick to tick, 5 mm below a plane (N). The exact change is zero.
double plane_chatter(double speed) {
    const SurfacePatch patch = patch_of(SurfaceKind::plane, {}, {0, 1, 0});
    SurfaceState state;
    haptics::touch(patch, state, {{0, 0.001, 0}}, tick_seconds);
    vec3 before = haptics::touch(patch, state, {{0, -depth, 0}}, tick_seconds).force;
    double most = 0;
    for (int tick = 1; tick < 2000; ++tick) {
        const double x = tick_seconds * speed * tick;
        const vec3 force = haptics::touch(patch, state, {{x, -depth, 0.3 * x}}, tick_seconds).force;
        most = std::max(most, glm::length(force - before));
        before = force;
    }
    return most;
}

void proxy_plane(Report& report) {
    for (const double speed : {0.05, 0.1, 0.3}) {
        const double chatter = plane_chatter(speed);
        report.rows.push_back({.area = "haptics",
                               .name = "proxy_plane",
                               .setting = {{"speed_m_per_s", speed}},
                               .metrics = {{"force_chatter_n", chatter}}});
    }
}

// ---- sliding on a mesh ------------------------------------------------------------------------------------

constexpr double radius = 0.05;  // radius of the ball (m)

/// A ball of this many rings and sides, without the degenerate triangles at the poles.
physics::TriangleMesh ball_mesh(std::uint32_t rings, std::uint32_t sides) {
    physics::TriangleMesh mesh;
    for (std::uint32_t r = 0; r <= rings; ++r) {
        const double down = pi * r / rings;
        for (std::uint32_t s = 0; s < sides; ++s) {
            const double round = 2 * pi * s / sides;
            mesh.vertices.push_back(radius * vec3(det::sin(down) * det::cos(round), det::cos(down),
                                                  -det::sin(down) * det::sin(round)));
        }
    }
    for (std::uint32_t r = 0; r < rings; ++r) {
        for (std::uint32_t s = 0; s < sides; ++s) {
            const std::uint32_t a = r * sides + s, b = r * sides + (s + 1) % sides, c = a + sides,
                                d = b + sides;
            if (r != 0) mesh.triangles.push_back({a, c, b});
            if (r + 1 != rings) mesh.triangles.push_back({b, c, d});
        }
    }
    return mesh;
}

struct MeshRun {
    double friction{};
    SurfaceState state{};
    double max_surfaces{};
    double worst{};  // largest distance of the proxy (point on the surface) from the sphere, beyond that of
                     // the flat triangles (m)
};

constexpr int mesh_ticks = 4000;

/// Position of a tip that slides 5 mm below the surface at 0.1 m/s, around and upwards: over flat triangles
/// and slivers.
vec3 mesh_tip(int tick, double in) {
    const double round = 0.002 * tick, up = 0.6 * det::sin(0.0007 * tick);
    return (radius - in) *
           vec3(det::cos(up) * det::cos(round), det::sin(up), -det::cos(up) * det::sin(round));
}

void slide(const physics::Physics& world, MeshRun& run) {
    const game::Feel feel{
        .stiffness = stiffness, .static_friction = 1.5 * run.friction, .dynamic_friction = run.friction};
    SurfacePatch patch;
    run.state = {.proxy = mesh_tip(0, -0.001), .begun = 1};
    for (int tick = 0; tick < mesh_ticks; ++tick) {
        game::fill_patch(patch, world, {.point = run.state.proxy, .radius = 0.002}, {}, {}, feel);
        do_not_optimise(haptics::touch(patch, run.state, {mesh_tip(tick, depth)}, tick_seconds));
        run.max_surfaces = std::max(run.max_surfaces, static_cast<double>(patch.count));
        run.worst = std::max(run.worst, std::abs(glm::length(run.state.proxy) - radius));
    }
}

void proxy_mesh(const Options& options, Report& report, std::string_view name,
                const physics::TriangleMesh& mesh) {
    physics::Physics world({}, {mesh});
    physics::BodyDesc desc{.shape = physics::Shape::mesh};
    desc.friction = 1;
    world.add(1, desc, {});
    std::array runs{MeshRun{0}, MeshRun{0.4}};
    std::vector<Contestant> contestants;
    for (MeshRun& run : runs) contestants.push_back({{}, [&run, &world] { slide(world, run); }});
    auto samples = measure(contestants, {.seconds = options.quick ? 0.3 : 2.0, .least = 11});
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (double& us : samples[i]) us /= mesh_ticks;
        report.rows.push_back(
            {.area = "haptics",
             .name = std::string(name),
             .setting = {{"triangles", static_cast<std::int64_t>(mesh.triangles.size())},
                         {"friction", runs[i].friction}},
             .time_us = times(samples[i]),
             .metrics = {{"surfaces", runs[i].max_surfaces}, {"off_sphere_m", runs[i].worst}},
             .hash = hex(hash_value(runs[i].state.proxy))});
    }
}

// ---- look-up among many bodies ----------------------------------------------------------------------------

constexpr std::array<std::int64_t, 3> crowds{1, 100, 1000};
constexpr int crowd_ticks = 4000;

/// Crates of 0.4 m on a grid. The first one lies below the wand's tip.
void add_crates(physics::Physics& world, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t column = i % 10, row = i / 10 % 10, layer = i / 100;
        const vec3 place(static_cast<double>(column), static_cast<double>(layer), static_cast<double>(row));
        physics::BodyDesc crate{.shape = physics::Shape::box, .size = vec3(0.2)};
        crate.mass = 5;
        crate.friction = 0.6;
        world.add(static_cast<physics::Key>(i + 1), crate, {.position = 0.8 * place});
    }
}

struct CrowdRun {
    std::int64_t bodies{};
    bool steps{};  // true: compute forces (servo steps), too; false: only the look-up, along the same path
    physics::Physics world{};
    haptics::ServoState state{};
    double pressed{};  // mean force (N)
};

/// Does the work of a match for a wizard who turns while a hand slides on a crate: looks up the surfaces near
/// the hand, passes them to the servo, and runs the servo step.
void feel_crowd(CrowdRun& run) {
    const haptics::DeviceSpec spec{
        .peak_force = 12, .continuous_force = 12, .max_damping = 5, .position_quantum = 5.5e-5};
    const haptics::Servo servo = haptics::servo_of(spec, 1);
    const game::Feel feel{.stiffness = 300, .static_friction = 0.9, .dynamic_friction = 0.6};
    haptics::HapticModel model;
    model.start = {0.01, 0.003, 0};
    model.patch_number = 1;
    run.state = {};
    run.pressed = 0;
    game::HandFrame before{.origin = {0, 0.2, 0}, .metres_per_metre = 10};
    for (int tick = 0; tick < crowd_ticks; ++tick) {
        game::HandFrame frame = before;
        frame.turn = rotation({0, 1, 0}, 0.2 * det::sin(0.002 * tick));
        // The tip comes from above, because a body that contains the tip at the start gives no force.
        const double down = std::min(tick / 300.0, 1.0);
        const vec3 tip(0.01 * det::cos(0.005 * tick), 0.003 - 0.006 * down, 0.01 * det::sin(0.005 * tick));
        const auto& surface = run.state.surface;
        const vec3 at = frame.to_world(tip);
        const vec3 proxy = surface.begun != 0 ? before.to_world(surface.proxy) : at;
        model.frame_motion = game::frame_motion_of(frame, before);
        game::fill_patch(model.patch, run.world,
                         {.point = 0.5 * (at + proxy), .radius = 0.5 * glm::length(at - proxy) + 0.15}, frame,
                         before, feel);
        if (run.steps)
            run.pressed += glm::length(haptics::servo_step(servo, run.state, model, {tip, 0})) / crowd_ticks;
        do_not_optimise(model.patch.count);
        before = frame;
    }
}

/// Times the look-up among 1 to 1,000 bodies, with and without the servo step. Only the look-up searches all
/// bodies; the servo step reads just the patch, the surfaces near the hand.
void servo_among_bodies(const Options& options, Report& report) {
    std::vector<CrowdRun> runs;
    for (const bool steps : {false, true}) {
        for (const auto bodies : crowds) {
            runs.push_back({.bodies = bodies, .steps = steps});
            add_crates(runs.back().world, bodies);
        }
    }
    std::vector<Contestant> contestants;
    for (CrowdRun& run : runs) contestants.push_back({{}, [&run] { feel_crowd(run); }});
    auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 3.0, .least = 11});
    std::vector<double> to_one;
    for (std::size_t i = 0; i < runs.size(); ++i)
        to_one.push_back(ratio(samples[i], samples[i / crowds.size() * crowds.size()]));
    for (auto& of_one : samples) {
        for (double& us : of_one) us /= crowd_ticks;
    }
    for (std::size_t i = 0; i < runs.size(); ++i)
        report.rows.push_back(
            {.area = "haptics",
             .name = "servo",
             .setting = {{"bodies", runs[i].bodies},
                         {"part", std::string(runs[i].steps ? "look_up_and_step" : "look_up")}},
             .time_us = times(samples[i]),
             .metrics = {{"to_one_body", to_one[i]}, {"mean_force_n", runs[i].pressed}},
             .hash = hex(hash_value(runs[i].state))});
}

// ---- a rising box -----------------------------------------------------------------------------------------

/// A box rises at 0.1 m/s from below until it has passed the tip, as in the measurement with CHAI3D.
void rising_box(Report& report) {
    const vec3 half(0.02, 0.01, 0.02);
    SurfacePatch patch = patch_of(SurfaceKind::box, {0, -0.0195, 0}, half);
    patch.bodies[0].velocity = {0, 0.1, 0};
    SurfaceState state;
    int overlapping = 0, felt = 0;
    for (int tick = 0; tick < 400; ++tick) {
        const double top = patch.surfaces[0].a.y + half.y;
        const auto touched = haptics::touch(patch, state, {{0.003, 0, -0.002}}, tick_seconds);
        patch.surfaces[0].a.y += tick_seconds * 0.1;
        patch.bodies[0].position.y += tick_seconds * 0.1;
        if (top < 1e-9 || top > 2 * half.y) continue;
        ++overlapping;
        if (std::abs(touched.force.y - stiffness * top) < 1e-6) ++felt;
    }
    report.rows.push_back({.area = "haptics",
                           .name = "rising_box",
                           .metrics = {{"ticks_overlapping", static_cast<double>(overlapping)},
                                       {"ticks_felt", static_cast<double>(felt)}}});
}

}  // namespace

void surfaces(const Options& options, Report& report) {
    proxy_plane(report);
    proxy_mesh(options, report, "proxy_mesh_5k", ball_mesh(51, 50));
    proxy_mesh(options, report, "proxy_mesh_40k", ball_mesh(100, 200));
    servo_among_bodies(options, report);
    rising_box(report);
}

}  // namespace thaum::bench
