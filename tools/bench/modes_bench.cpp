// Benchmarks of haptic modes and of surfaces in scanned volumes (engine/haptics/modes.h, level_contact.h,
// volume_feel.h).
//
//     modes           time of each mode on fields of 128^3 samples, its reads of the field included
//     sphere_normal   direction of the force on a sphere, compared with the true normal, by kernel and method
//     shell_chatter   noise of the force of a tip that slides on a sphere at an even depth
//     held_on_sphere  noise of the force when a simulated hand slides a device on a sphere, servo in the loop
//     edge_vibration  noise of the force on a block with hard edges: on a face, along an edge, across an edge
//
// Methods: "isosurface" holds the proxy at the true surface (local distance by Newton's method). "density" is
// that of R. S. Avila and L. M. Sobierajski, A haptic interaction method for volume visualization (1996): a
// force along the gradient at the tip that grows with the density there. Kernels: "smooth" is SmoothGrid.
// "ball" is spherical contact, the mean of 8 places on a ball of 0.87 samples.
#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/hash.h"
#include "core/random.h"
#include "core/text.h"
#include "core/units.h"
#include "haptics/volume/volume_feel.h"
#include "tests/scenes/scanned_volumes.h"
#include "tests/scenes/z_width.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

// A separate namespace, because other benchmarks also define slides and depths.
namespace thaum::bench::touched {
namespace {

using field::Kernel;
using field::Scalar;
using field::ScalarField;

constexpr int samples_each_way = 128;
constexpr double spacing = 0.0008;         // spacing of the samples (m); the volume is 10 cm wide
constexpr double stiffness = 300;          // stiffness of the spring between tip and proxy, the point held on
                                           // the surface (N/m)
constexpr double depth = 1.0 / stiffness;  // depth of the tip (m), for a push of 1 N
constexpr double level = 127.5;            // density at the surface: half of the full density
constexpr double reach = 1.5 * spacing;    // distance from the surface within which the haptic mode acts (m)
constexpr double radius = 40 * spacing;    // radius of the ball (m)

// ---- fields -----------------------------------------------------------------------------------------------

/// A scan as felt by spherical contact (with a small ball instead of a point). Value and gradient are means
/// over the corners of a cube that is inscribed in the ball and one voxel wide.
struct BallMean {
    field::Grid grid{};

    Scalar operator()(vec3 place) const {
        Scalar mean;
        for (int corner = 0; corner < 8; ++corner) {
            const vec3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                            (corner & 4) != 0 ? 1 : -1);
            const Scalar there = grid(place + 0.5 * grid.spacing * sign);
            mean.value += there.value / 8;
            mean.gradient += there.gradient / 8.0;
        }
        return mean;
    }
};

/// One scanned volume, read with each interpolation kernel.
struct Readings {
    explicit Readings(const ScannedVolume& v)
        : smooth(v.smooth()),
          catmull_rom(v.grid(Kernel::catmull_rom)),
          linear(v.grid(Kernel::linear)),
          ball{v.grid(Kernel::linear)} {}

    haptics::SmoothGrid smooth;
    field::Grid catmull_rom, linear;
    BallMean ball;

    std::array<std::pair<const char*, ScalarField>, 4> all() const {
        return {{{"smooth", field::field_of<Scalar>(smooth)},
                 {"catmull_rom", field::field_of<Scalar>(catmull_rom)},
                 {"linear", field::field_of<Scalar>(linear)},
                 {"ball", field::field_of<Scalar>(ball)}}};
    }
};

// ---- methods to feel a surface ----------------------------------------------------------------------------

/// A tip that touches a surface by one of the two methods, isosurface or density.
struct Feeler {
    ScalarField density{};
    bool by_density{};
    TouchedModes hand{{}, stiffness};

    Feeler(ScalarField field, bool density_method) : density(field), by_density(density_method) {
        haptics::ModeSettings settings;
        settings.strength = field::constant(20);
        settings.level = level;
        settings.reach = reach;
        hand.uses = {{haptics::find_mode("isosurface"), haptics::any_field(field), settings}};
    }
    haptics::PrimitiveSet primitives() const {
        haptics::PrimitiveSet set;
        if (!by_density) haptics::add_modes(hand.uses, hand.input(), set);
        if (!by_density) return set;
        haptics::VolumeFeel feel;
        feel.density = density;
        feel.shell = {.low = 2, .high = 255, .stiffness = 2};
        haptics::add_volume_feel(feel, hand.input(), set);
        return set;
    }
    vec3 move(vec3 to) { return hand.settle(primitives(), to); }
};

const char* method_name(bool by_density) { return by_density ? "density" : "isosurface"; }

// ---- sphere_normal ----------------------------------------------------------------------------------------

Row normal_row(const char* kernel, ScalarField field, bool by_density, int directions) {
    std::vector<double> errors;
    double lost = 0;
    std::uint64_t hash = 0;
    for (int i = 0; i < directions; ++i) {
        const vec3 out = even_direction(i, directions);
        Feeler feeler(field, by_density);
        feeler.hand.start((radius + 0.5 * reach) * out);
        // The density method gives no force deeper than its shell of one sample, so its tip stays at the
        // surface.
        const double rest = by_density ? radius : radius - depth;
        vec3 force(0);
        for (int tick = 0; tick < 60; ++tick)
            force = feeler.move(std::max(rest, radius + 0.5 * reach - 1e-4 * tick) * out);
        const double length = glm::length(force);
        if (!(length > 0)) ++lost;
        if (!(length > 0)) continue;
        errors.push_back(det::acos(std::clamp(glm::dot(force, out) / length, -1.0, 1.0)) /
                         radians_per_degree);
        hash = hash_combine(hash, hash_value(force));
    }
    return {.area = "haptics",
            .name = "sphere_normal",
            .setting = {{"kernel", std::string(kernel)}, {"method", std::string(method_name(by_density))}},
            .error = ErrorMeasure{"largest_degrees", percentile(errors, 1)},
            .is_default = kernel == std::string_view("smooth") && !by_density,
            .metrics = {{"median_degrees", median(errors)},
                        {"p99_degrees", percentile(errors, 0.99)},
                        {"directions", static_cast<double>(directions)},
                        {"lost_share", lost / directions}},
            .hash = hex(hash)};
}

// ---- sliding ----------------------------------------------------------------------------------------------

/// A path of the tip on a surface, and the part of the path that is measured.
struct Slide {
    const char* name;
    std::function<vec3(int tick)> tip;
    int ticks;
};

struct Noise {
    double mean{};   ///< mean force (N)
    double rms{};    ///< root mean square of the force minus its mean over the nearest 64 ms (N)
    double worst{};  ///< largest difference of the force from its mean over the nearest 64 ms (N)
    double jump{};   ///< largest change of the force from tick to tick (N)
    double swing{};  ///< half of the sum of all rises and falls of the force beyond its net change (N)
    std::uint64_t hash{};
};

/// Half the length of the window (ticks) over which noise_of() takes the mean. A hand feels vibrations, not
/// slow changes, so the noise is the force minus its mean over the nearest 64 ms. Only ticks after `from`
/// count.
constexpr int noise_half = 32;

Noise noise_of(std::span<const vec3> forces, int from) {
    const int ticks = static_cast<int>(forces.size());
    Noise noise;
    double square = 0, way = 0;
    int count = 0;
    for (int t = from + noise_half; t + noise_half < ticks; ++t) {
        vec3 mean(0);
        for (int i = t - noise_half; i <= t + noise_half; ++i)
            mean += forces[static_cast<std::size_t>(i)] / (2.0 * noise_half + 1);
        const vec3 here = forces[static_cast<std::size_t>(t)];
        const double off = glm::distance(here, mean);
        noise.mean += glm::length(here);
        square += off * off;
        noise.worst = std::max(noise.worst, off);
        way += std::abs(glm::length(here) - glm::length(forces[static_cast<std::size_t>(t - 1)]));
        noise.jump = std::max(noise.jump, glm::distance(here, forces[static_cast<std::size_t>(t - 1)]));
        noise.hash = hash_combine(noise.hash, hash_value(here));
        ++count;
    }
    noise.mean /= count;
    noise.rms = std::sqrt(square / count);
    const auto size_at = [&](int t) { return glm::length(forces[static_cast<std::size_t>(t)]); };
    noise.swing = (way - std::abs(size_at(ticks - noise_half - 1) - size_at(from + noise_half - 1))) / 2;
    return noise;
}

Row slide_row(const char* name, const Slide& slide, const char* kernel, ScalarField field, bool by_density) {
    Feeler feeler(field, by_density);
    std::vector<vec3> forces;
    feeler.hand.start(slide.tip(0));
    for (int tick = 0; tick < slide.ticks; ++tick) forces.push_back(feeler.move(slide.tip(tick)));
    const Noise noise = noise_of(forces, 100);
    return {.area = "haptics",
            .name = name,
            .setting = {{"way", std::string(slide.name)},
                        {"kernel", std::string(kernel)},
                        {"method", std::string(method_name(by_density))}},
            .error = ErrorMeasure{"noise_of_mean", noise.rms / noise.mean},
            .is_default = kernel == std::string_view("smooth") && !by_density,
            .metrics = {{"mean_n", noise.mean},
                        {"largest_of_mean", noise.worst / noise.mean},
                        {"largest_step_n", noise.jump},
                        {"swing_n", noise.swing}},
            .hash = hex(noise.hash)};
}

/// Depth of a tip (m) that comes in from outside during the first 60 ticks and then keeps its depth.
double depth_at(int tick, double full) {
    return full * std::min(1.0, tick / 60.0) - 0.5 * reach * std::max(0.0, 1 - tick / 60.0);
}

Slide round_sphere(bool by_density, int ticks) {
    const double inside = by_density ? 0.0 : depth;
    return {"great_circle",
            [=](int tick) {
                const double turn = 0.1 / radius * tick_seconds * tick;  // angle (rad), at 0.1 m/s
                const vec3 a = glm::normalize(vec3(1, 0.3, -0.2)),
                           b = glm::normalize(glm::cross(a, vec3(0.3, 1, 0.5)));
                return (radius - depth_at(tick, inside)) * (det::cos(turn) * a + det::sin(turn) * b);
            },
            ticks};
}

// ---- a device held by a hand ------------------------------------------------------------------------------

/// A Touch, with or without its dry friction and the quantum of its encoders.
haptics::DeviceSpec touch_device(bool ideal) {
    haptics::DeviceSpec spec = reference_device(0.2, 1);
    spec.peak_force = spec.continuous_force = 3.3;
    spec.max_damping = 3;
    spec.mass = 0.045;
    spec.position_quantum = ideal ? 0 : 5.5e-5;
    spec.coulomb_friction = ideal ? 0 : 0.26;
    return spec;
}

/// A simulated hand presses a device on the sphere and draws it along a great circle at 0.1 m/s. The servo
/// and its safety stage are in the loop, so an unstable surface would shake here.
struct HeldSlide {
    Feeler feeler;
    haptics::DeviceSpec spec;
    double goal{};  ///< distance of the hand's target from the sphere's centre (m)

    std::vector<vec3> play(int ticks, double& created) {
        const auto servo = haptics::servo_of(spec, 1);
        const auto device = haptics::simulated_device(spec, haptics::Hand{});
        const double start = radius + 0.004;
        auto hand = haptics::resting_at({0, start, 0});
        haptics::ServoState state;
        haptics::HapticModel model;
        std::vector<vec3> forces;
        feeler.hand.start(hand.position);
        for (int tick = 0; tick < ticks; ++tick) {
            const vec3 place = haptics::measured_position(device, hand);
            if (tick > 0) feeler.hand.proxy = state.proxy;
            model.primitives = feeler.primitives();
            const vec3 force = haptics::servo_step(servo, state, model, {place, 0});
            feeler.hand.before = feeler.hand.tip;
            feeler.hand.tip = place;
            const double turn = 0.1 / radius * tick_seconds * std::max(0, tick - 1500);
            const double out = start + std::min(1.0, tick / 800.0) * (goal - start);
            hand = haptics::step(device, hand, out * vec3(det::sin(turn), det::cos(turn), 0), force);
            forces.push_back(hand.force);
        }
        created = state.energy.most_created;
        return forces;
    }
};

Row held_row(ScalarField field, bool by_density, bool ideal, int ticks) {
    HeldSlide slide{Feeler(field, by_density), touch_device(ideal), radius - (by_density ? 0.002 : 0.0058)};
    double created = 0;
    const Noise noise = noise_of(slide.play(ticks, created), 1600);
    return {.area = "haptics",
            .name = "held_on_sphere",
            .setting = {{"way", std::string(ideal ? "ideal" : "touch")},
                        {"kernel", std::string("smooth")},
                        {"method", std::string(method_name(by_density))}},
            .error = ErrorMeasure{"noise_of_mean", noise.rms / noise.mean},
            .is_default = !ideal && !by_density,
            .metrics = {{"mean_n", noise.mean},
                        {"largest_of_mean", noise.worst / noise.mean},
                        {"largest_step_n", noise.jump},
                        {"created_j", created}},
            .hash = hex(noise.hash)};
}

// ---- paths on a block -------------------------------------------------------------------------------------

constexpr double half_block = 30 * spacing;

TurnedBlock hard_block() {
    return {{.half = vec3(half_block)}, mat3(glm::mat3_cast(rotation(glm::normalize(vec3(1, 2, 0.5)), 0.6)))};
}

/// Position that moves between -half and half at this speed (m/s).
double to_and_fro(int tick, double speed, double half) {
    const double turns = speed * tick_seconds * tick / (4 * half);
    return half * (4 * std::abs(turns - std::floor(turns) - 0.5) - 1);
}

/// Paths on the block, in the block's own frame: on the face y, along the edge between x and y, and across
/// that edge.
std::array<Slide, 3> block_ways(const TurnedBlock& block, bool by_density, int ticks) {
    const double inside = by_density ? 0.0 : depth, wide = 0.6 * half_block;
    const auto on_face = [=, turn = block.turn](int t) {
        return turn *
               vec3(to_and_fro(t, 0.04, wide), half_block - depth_at(t, inside), to_and_fro(t, 0.1, wide));
    };
    const auto along_edge = [=, turn = block.turn](int t) {
        const double in = half_block - depth_at(t, inside);
        // The tip is a little nearer to the face y than to the face x, so that only one face is nearest.
        return turn * vec3(in - 0.1 * depth, in, to_and_fro(t, 0.1, wide));
    };
    const auto across_edge = [=, turn = block.turn](int t) {
        return turn * vec3(half_block - 0.01 + 2e-5 * t, half_block - depth_at(t, inside), 0.002);
    };
    return {{{"face", on_face, ticks}, {"along_edge", along_edge, ticks}, {"across_edge", across_edge, 700}}};
}

// ---- modes ------------------------------------------------------------------------------------------------

/// Fields of 128^3 samples for all haptic modes.
struct ModeFields {
    ScannedVolume density = scanned(haptics::Ball{{}, radius}, samples_each_way, spacing);
    std::array<ScannedVolume, 3> flow{density, density, density};
    haptics::SmoothGrid smooth = density.smooth();
    field::Grid plain = density.grid(Kernel::catmull_rom);
    field::StaggeredGrid vectors{};

    ModeFields() {
        const auto n = static_cast<std::size_t>(samples_each_way);
        for (std::size_t i = 0; i < n * n * n; ++i) {
            const vec3 at = density.origin() + spacing * vec3(i % n, i / n % n, i / (n * n));
            // A vortex about the z axis with a flow along it.
            const double wide = 1 + glm::dot(at, at) / (0.01 * 0.01);
            flow[0].samples[i] = static_cast<float>(-at.y / wide);
            flow[1].samples[i] = static_cast<float>(at.x / wide);
            flow[2].samples[i] = static_cast<float>(0.01 + at.z * 0.1);
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
            vectors.component[axis] = flow[axis].grid(Kernel::catmull_rom);
    }
};

constexpr std::size_t places_in_a_call = 64;

/// Evaluates one haptic mode at places near the surface of the ball.
struct ModeRunner {
    haptics::ModeUse use;
    std::vector<haptics::ModeInput> inputs{};
    std::size_t next = 0;
    std::uint64_t hash = 0;

    void run() {
        for (std::size_t i = 0; i < places_in_a_call; ++i) {
            haptics::PrimitiveSet set;
            haptics::add_modes(std::span(&use, 1), inputs[next + i], set);
            do_not_optimise(set);
        }
        next = (next + places_in_a_call) % inputs.size();
    }
};

/// Inputs for a tip that slides over the ball with a push of 1 N, with the proxy (the point that follows the
/// tip) on the surface.
std::vector<haptics::ModeInput> inputs_near_surface() {
    std::vector<haptics::ModeInput> inputs;
    for (int i = 0; i < 1024; ++i) {
        const double turn = 0.1 / radius * tick_seconds * i;
        const vec3 out(det::cos(turn), det::sin(turn), 0.1);
        const vec3 unit = glm::normalize(out);
        inputs.push_back({(radius - 0.02 * spacing) * unit, (radius - depth) * unit,
                          vec3(-unit.y, unit.x, 0) * 1e-4, stiffness});
    }
    return inputs;
}

ModeRunner runner_of(const haptics::Mode& mode, const ModeFields& fields, ScalarField scalar) {
    haptics::ModeSettings settings;
    settings.strength = field::window(0, 255, 1, 2);
    settings.friction = field::constant(0.3);
    settings.level = level;
    settings.reach = reach;
    settings.pitch = 2 * spacing;
    const auto any = mode.reads == haptics::FieldKind::scalar
                         ? haptics::any_field(scalar)
                         : haptics::any_field(field::field_of<field::Vector>(fields.vectors));
    ModeRunner runner{{&mode, any, settings}, inputs_near_surface()};
    for (const auto& input : runner.inputs) {
        haptics::PrimitiveSet set;
        haptics::add_modes(std::span(&runner.use, 1), input, set);
        runner.hash = hash_combine(runner.hash, hash_value(set));
    }
    return runner;
}

/// Evaluates haptics::VolumeFeel, the feel of a whole scan, with all its parts, for comparison with single
/// modes.
struct VolumeRunner {
    haptics::VolumeFeel feel{};
    std::vector<haptics::ModeInput> inputs = inputs_near_surface();
    std::size_t next = 0;

    explicit VolumeRunner(ScalarField density) {
        feel.density = density;
        feel.walls[0] = {.density = level, .strength = 5, .friction = 0.2, .reach = reach};
        feel.wall_count = 1;
        feel.shell = {.low = 50, .high = 255, .stiffness = 1, .retarding = 1};
        feel.opacity = {
            .density = field::window(50, 200, 0, 1), .gradient = field::window(0, 1e4, 0, 1), .stiffness = 1};
    }
    std::uint64_t hash() const {
        std::uint64_t sum = 0;
        for (const auto& input : inputs) {
            haptics::PrimitiveSet set;
            const haptics::VolumeFelt felt = haptics::add_volume_feel(feel, input, set);
            sum = hash_combine(hash_combine(sum, hash_value(set)), hash_value(felt.stiff));
        }
        return sum;
    }
    void run() {
        for (std::size_t i = 0; i < places_in_a_call; ++i) {
            haptics::PrimitiveSet set;
            do_not_optimise(haptics::add_volume_feel(feel, inputs[next + i], set));
            do_not_optimise(set);
        }
        next = (next + places_in_a_call) % inputs.size();
    }
};

Row mode_row(std::string mode, const char* kernel, std::vector<double> us, double allocations,
             std::uint64_t hash) {
    for (double& one : us) one /= places_in_a_call;
    return {.area = "haptics",
            .name = "modes",
            .setting = {{"mode", std::move(mode)},
                        {"kernel", std::string(kernel)},
                        {"n", std::int64_t{samples_each_way}}},
            .time_us = times(us),
            .is_default = kernel == std::string_view("smooth"),
            .metrics = {{"allocations", allocations}},
            .hash = hex(hash)};
}

/// Number of memory allocations in one run of a benchmark.
template <class Runner>
double allocations_of(Runner& runner) {
    const auto before = allocation_count();
    runner.run();
    return static_cast<double>(allocation_count() - before);
}

void time_modes(const Options& options, Report& report) {
    const auto fields = std::make_unique<ModeFields>();
    const ScalarField smooth = field::field_of<Scalar>(fields->smooth),
                      plain = field::field_of<Scalar>(fields->plain);
    std::vector<ModeRunner> runners;
    std::vector<const char*> kernels;
    for (const haptics::Mode& mode : haptics::modes()) {
        const bool scalar = mode.reads == haptics::FieldKind::scalar;
        runners.push_back(runner_of(mode, *fields, plain));
        kernels.push_back("catmull_rom");
        if (scalar) runners.push_back(runner_of(mode, *fields, smooth));
        if (scalar) kernels.push_back("smooth");
    }
    VolumeRunner volume(smooth);
    std::vector<Contestant> contestants;
    for (ModeRunner& runner : runners) contestants.push_back({{}, [&runner] { runner.run(); }});
    contestants.push_back({{}, [&volume] { volume.run(); }});
    const auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 3.0, .least = 21});
    for (std::size_t i = 0; i < runners.size(); ++i)
        report.rows.push_back(mode_row(std::string(runners[i].use.mode->name), kernels[i], samples[i],
                                       allocations_of(runners[i]), runners[i].hash));
    report.rows.push_back(
        mode_row("volume_feel", "smooth", samples.back(), allocations_of(volume), volume.hash()));
}

void feel_scans(const Options& options, Report& report) {
    const ScannedVolume sphere = scanned(haptics::Ball{{}, radius}, samples_each_way, spacing);
    const TurnedBlock block = hard_block();
    const ScannedVolume edges = scanned(block, samples_each_way, spacing);
    const Readings sphere_readings(sphere), edge_readings(edges);
    const int directions = options.quick ? 1000 : 10'000, ticks = options.quick ? 500 : 1000;
    for (const bool by_density : {false, true}) {
        for (const bool ideal : {true, false})
            report.rows.push_back(held_row(sphere_readings.all()[0].second, by_density, ideal, 5 * ticks));
        for (const auto& [kernel, field] : sphere_readings.all()) {
            report.rows.push_back(normal_row(kernel, field, by_density, directions));
            report.rows.push_back(
                slide_row("shell_chatter", round_sphere(by_density, ticks), kernel, field, by_density));
        }
        for (const auto& [kernel, field] : edge_readings.all()) {
            for (const Slide& way : block_ways(block, by_density, ticks))
                report.rows.push_back(slide_row("edge_vibration", way, kernel, field, by_density));
        }
    }
}

}  // namespace
}  // namespace thaum::bench::touched

namespace thaum::bench {

void modes(const Options& options, Report& report) {
    touched::time_modes(options, report);
    touched::feel_scans(options, report);
}

}  // namespace thaum::bench
