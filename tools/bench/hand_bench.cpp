// Benchmarks the hand in the fluid (haptics/fluid_touch.h): cost and error of copying a patch of the flow and
// of reading it; cost of a servo step, and the largest jump that a fluid step causes; cost of a ladle's push,
// and the error of the fluid's momentum; and the energy that passive modes create.
#include <array>

#include "core/hash.h"
#include "core/text.h"
#include "fluid/fields.h"
#include "fluid/fluid.h"
#include "haptics/servo.h"
#include "tests/scenes/fluid_flows.h"
#include "tests/scenes/stirring_attack.h"
#include "tests/scenes/z_width.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using haptics::FlowPatch;
using haptics::FlowSample;
using haptics::FlowSource;

// ---- patches of the flow ----------------------------------------------------------------------------------

constexpr std::size_t hand_places = 64;
constexpr double brew_density = 8;  // density of the brew (kg/m^3)

/// A brew of three substances whose velocity is known exactly at every point.
struct TurningBrew {
    fluid::Fluid fluid;
    std::vector<vec3> places{};

    FlowSource source() const {
        FlowSource result{.velocity = face_grid(fluid.lattice, fluid.state.velocity),
                          .density = brew_density};
        for (std::size_t s = 0; s < fluid.state.substances.size(); ++s)
            result.substances[s] = {cell_grid(fluid.lattice, fluid.state.substances[s]), 1, 0.5};
        return result;
    }
};

vec3 turning(vec3 p) {
    return {det::sin(2 * pi * p.x) * det::cos(2 * pi * p.y), -det::cos(2 * pi * p.x) * det::sin(2 * pi * p.y),
            0.5};
}

Expected<TurningBrew> turning_brew(int n) {
    auto made = fluid::flows::brew(n);
    if (!made) return made.error();
    TurningBrew brew{.fluid = std::move(*made)};
    set_velocity(brew.fluid, turning);
    Random random = random_stream(5, 1);
    for (std::size_t i = 0; i < hand_places; ++i)
        brew.places.emplace_back(random.uniform(0.25, 0.75), random.uniform(0.25, 0.75),
                                 random.uniform(0.25, 0.75));
    return brew;
}

/// Relative root mean square error of velocities that are read from a patch (a copied part of the flow), at
/// places within a cell of its middle.
double patch_error(const TurningBrew& brew) {
    Random random = random_stream(5, 2);
    const double cell = brew.fluid.lattice.h;
    double off = 0, all = 0;
    for (const vec3 middle : brew.places) {
        const FlowPatch patch = patch_of(brew.source(), middle);
        for (int i = 0; i < 20; ++i) {
            const vec3 place =
                middle + cell * vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            const vec3 missing = flow_at(patch, place).velocity - turning(place);
            off += glm::dot(missing, missing);
            all += glm::dot(turning(place), turning(place));
        }
    }
    return std::sqrt(off / all);
}

/// Reads all nodes of a patch (a part of the flow that is copied for the servo) straight from the fluid's
/// fields. Returns a sum of the values.
double read_through_fields(const FlowSource& source, const FlowPatch& patch) {
    double sum = 0;
    for (int n = 0; n < 64; ++n) {
        const vec3 place = patch.origin + patch.spacing * vec3(n % 4, n / 4 % 4, n / 16);
        sum += source.velocity(place).value.x;
        for (const auto& substance : source.substances) sum += substance.amount(place).value;
    }
    return sum;
}

/// Times for each place (us): copying a patch (a part of the flow for the servo), reading the copy twice, and
/// reading its nodes from the fields.
std::vector<std::vector<double>> patch_times(const TurningBrew& brew, const FlowSource& source,
                                             const std::vector<FlowPatch>& patches, const Options& options) {
    const auto each = [&brew](const auto& visit) {
        return [&brew, visit] {
            for (std::size_t i = 0; i < hand_places; ++i) visit(i, brew.places[i]);
        };
    };
    const std::array contestants{
        Contestant{{}, each([&](std::size_t, vec3 at) { do_not_optimise(patch_of(source, at)); })},
        Contestant{{}, each([&](std::size_t i, vec3 at) {
                       do_not_optimise(flow_at(patches[i], at));
                       do_not_optimise(flow_at(patches[hand_places - 1 - i], at));
                   })},
        Contestant{{}, each([&](std::size_t i, vec3) {
                       do_not_optimise(read_through_fields(source, patches[i]));
                   })}};
    // The patches (copied parts of the flow) stay in the processor's cache, as in the servo, which reads its
    // patch again and again.
    auto samples = measure(contestants, {.seconds = options.quick ? 0.3 : 1.0, .least = 11, .calls = 16});
    for (auto& one : samples) {
        for (double& us : one) us /= hand_places;
    }
    return samples;
}

void hand_patches(const Options& options, Report& report) {
    for (const int n : {16, 32, 64}) {
        const auto made = turning_brew(n);
        if (!made) return report.faults.push_back(text("fluid: ", made.error().message));
        const TurningBrew& brew = *made;
        const FlowSource source = brew.source();
        std::vector<FlowPatch> patches;
        for (const vec3 place : brew.places) patches.push_back(patch_of(source, place));
        const auto samples = patch_times(brew, source, patches, options);
        const double error = patch_error(brew);
        const auto row = [&](const char* what, std::size_t which) {
            return Row{.area = "fluid",
                       .name = "hand_patch",
                       .setting = {{"what", std::string(what)}, {"n", std::int64_t{n}}},
                       .time_us = times(samples[which]),
                       .error = ErrorMeasure{"relative_l2_velocity", error},
                       .is_default = n == 32,
                       .hash = hex(hash_value(flow_at(patches[0], brew.places[1]).velocity.x))};
        };
        Row publish = row("publish", 0);
        publish.metrics = {{"ratio_to_fields", ratio(samples[0], samples[2])},
                           {"bytes", static_cast<double>(sizeof(FlowPatch))}};
        report.rows.push_back(std::move(publish));
        report.rows.push_back(row("read", 1));
    }
}

// ---- the servo's step -------------------------------------------------------------------------------------

struct StirLoad {
    std::string_view name;
    bool fluid{};
    haptics::FluidModes modes{};
};
constexpr std::array stir_loads{StirLoad{"none", false}, StirLoad{"off", true, {0, 0, 0, 0, 0, 0, 0}},
                                StirLoad{"flow", true, {1, 1, 1, 0, 0, 0, 0}}, StirLoad{"all", true, {}}};

/// Haptic model (data from which the servo computes forces) of a ladle with mass in a flow. The ladle is
/// pressed against the surface from below and against the wall.
haptics::HapticModel stirring_model(const StirLoad& load) {
    haptics::HapticModel model;
    if (!load.fluid) return model;
    auto& fluid = model.fluid;
    fluid.number = 1;
    fluid.modes = load.modes;
    fluid.frame = {.metres_per_metre = 20, .newtons_per_newton = 0.00375};
    fluid.drag = {.viscous = 10, .form = 1, .stirred_mass = 10, .height = 0.1};
    fluid.surface = {
        .height = 0.01, .stiffness = 4000, .pop_through = 200, .cling = 40, .inside = 1, .present = 1};
    fluid.wall = round_bowl(0.02, 0.11);
    fluid.wall.centre = {0.01, 0.1, 0.01};
    fluid.wall.stiffness = 4000;
    fluid.wall.damping = 10;
    fluid.ladle = {.mass = 1.5, .stiffness = 4000, .damping = 20};
    return model;
}

FlowPatch some_flow(Random& random) {
    return uniform_flow({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)},
                        random.uniform(), random.uniform());
}

/// Largest change of the force within one tick, divided by the change over the whole fluid step. The hand
/// rests, so the force changes only with the fluid.
double max_step_share(const StirLoad& load) {
    auto spec = reference_device(0.5, 0);
    const haptics::Servo servo = servo_of(spec, 1);
    haptics::ServoState state;
    haptics::HapticModel model = stirring_model(load);
    Random random = random_stream(5, 3);
    double worst = 0;
    vec3 before{};
    for (int step = 0; step < 200; ++step) {
        add_fluid_step(model.fluid, some_flow(random));
        const vec3 start = before;
        double largest = 0;
        for (std::uint32_t tick = 0; tick < haptics::fluid_period; ++tick, ++model.fluid.step_age) {
            servo_step(servo, state, model, {{}, 0});
            largest = std::max(largest, glm::length(state.fluid.force - before));
            before = state.fluid.force;
        }
        if (step > 1) worst = std::max(worst, largest / glm::length(before - start));
    }
    return worst;
}

constexpr std::uint32_t stir_ticks = 5000;

haptics::ServoState stir(const StirLoad& load) {
    auto spec = reference_device(0.5, 0);
    spec.max_damping = 5;
    const haptics::Servo servo = servo_of(spec, 1);
    haptics::ServoState state;
    haptics::HapticModel model = stirring_model(load);
    Random random = random_stream(5, 4);
    for (int i = 0; i < 2; ++i) add_fluid_step(model.fluid, some_flow(random));
    for (std::uint32_t tick = 0; tick < stir_ticks; ++tick) {
        model.fluid.step_age = tick % haptics::fluid_period;
        const double x = 1e-5 * (tick % 100);
        do_not_optimise(haptics::servo_step(servo, state, model, {{x, x, -x}, 0}));
    }
    return state;
}

void hand_steps(const Options& options, Report& report) {
    std::array<haptics::ServoState, stir_loads.size()> ends;
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < stir_loads.size(); ++i)
        contestants.push_back({{}, [&end = ends[i], &load = stir_loads[i]] { end = stir(load); }});
    auto samples = measure(contestants, {.seconds = options.quick ? 0.3 : 1.5, .least = 11});
    for (std::size_t i = 0; i < stir_loads.size(); ++i) {
        for (double& us : samples[i]) us /= stir_ticks;
        Row row{.area = "fluid",
                .name = "hand_step",
                .setting = {{"modes", std::string(stir_loads[i].name)}},
                .time_us = times(samples[i]),
                .is_default = stir_loads[i].name == "all",
                .metrics = {{"ratio_to_none", ratio(samples[i], samples[0])}},
                .hash = hex(hash_value(ends[i]))};
        if (stir_loads[i].modes.flow > 0 && stir_loads[i].fluid)
            row.error =
                ErrorMeasure{"largest_share_of_a_fluid_step_in_a_tick", max_step_share(stir_loads[i])};
        report.rows.push_back(std::move(row));
    }
}

// ---- momentum ---------------------------------------------------------------------------------------------

/// A hand that moves straight through the brew at an even speed, whatever the force on it.
struct StrokingHand {
    haptics::Servo servo;
    vec3 from, velocity;  ///< position at the start (m) and velocity (m/s) of the device
    haptics::HapticModel model{};
    haptics::ServoState state{};
    std::uint32_t tick{};

    StrokingHand(vec3 start, vec3 speed)
        : servo(haptics::servo_of(reference_device(0.5, 0), 1)), from(start), velocity(speed) {
        auto& fluid = model.fluid;
        fluid.number = 1;
        fluid.modes = {1, 1, 1, 0, 0, 0, 0};
        fluid.frame = {.origin = vec3(0.5), .metres_per_metre = 20, .newtons_per_newton = 0.00375};
        fluid.drag = {.viscous = 0.4, .form = 0.15, .stirred_mass = 0.01 * brew_density};
    }

    vec3 place() const { return from + velocity * (tick * tick_seconds); }

    void take_flow(const fluid::Fluid& fluid) {
        const FlowSource source{.velocity = face_grid(fluid.lattice, fluid.state.velocity),
                                .viscosity = fluid.settings.viscosity * brew_density,
                                .density = brew_density};
        add_fluid_step(model.fluid, patch_of(source, haptics::to_bowl(model.fluid.frame, place())));
    }

    /// Impulse that the fluid receives in one of its steps (N s).
    vec3 stroke() {
        vec3 impulse{};
        for (std::uint32_t i = 0; i < haptics::fluid_period; ++i, ++tick, ++model.fluid.step_age) {
            servo_step(servo, state, model, {place(), 0});
            impulse -= force_on_ladle(model.fluid, state.fluid) * tick_seconds;
        }
        return impulse;
    }
};

/// Two ladles in a periodic brew without walls, which would absorb momentum. After each step, the momentum
/// that the ladles gave is compared with the brew's.
void ladle_momentum(const Options&, Report& report) {
    for (const int n : {16, 32, 64}) {
        auto made =
            fluid::make_fluid({.cells = {n, n, n},
                               .h = 1.0 / n,
                               .edges = {fluid::Edge::periodic, fluid::Edge::periodic, fluid::Edge::periodic},
                               .viscosity = 0.02});
        if (!made) return report.faults.push_back(text("fluid: ", made.error().message));
        auto& brew = *made;
        std::array hands{StrokingHand{{-0.016, 0.002, 0}, {0.05, 0, 0}},
                         StrokingHand{{0.004, -0.01, 0.012}, {0.01, 0.03, -0.02}}};
        vec3 given{};
        double worst = 0;
        std::vector<double> samples;
        for (int step = 0; step < 40; ++step) {
            for (StrokingHand& hand : hands) {
                hand.take_flow(brew);
                const vec3 impulse = hand.stroke();
                given += impulse;
                samples.push_back(us_of([&] {
                    push(brew, {hand.state.fluid.place, 0.2, impulse / brew_density});
                }));
            }
            advance(brew, fluid::flows::step);
            worst = std::max(worst,
                             glm::length(brew_density * fluid::momentum(brew) - given) / glm::length(given));
        }
        report.rows.push_back({.area = "fluid",
                               .name = "momentum",
                               .setting = {{"n", std::int64_t{n}}, {"ladles", std::int64_t{2}}},
                               .time_us = times(samples),
                               .error = ErrorMeasure{"relative_to_given", worst},
                               .is_default = n == 32,
                               .metrics = {{"given_n_s", glm::length(given)}},
                               .hash = hex(hash_value(fluid::momentum(brew).x))});
    }
}

}  // namespace

void fluid_hand(const Options& options, Report& report) {
    hand_patches(options, report);
    hand_steps(options, report);
    ladle_momentum(options, report);
}

void stirring_passivity(const Options& options, Report& report) {
    const int ticks = options.quick ? 5000 : 60'000;
    for (const int latency : {0, 1}) {
        auto spec = reference_device(0.5, latency);
        spec.max_damping = 5;
        for (const std::uint32_t delay : {0U, 5U}) {
            for (auto [name, world] : stirred_cases()) {
                world.delay = delay;
                const auto energy = StirringAttack(world, spec).run(ticks);
                report.rows.push_back(
                    {.area = "haptics",
                     .name = "stirring_passivity",
                     .setting = {{"mode", std::string(name)},
                                 {"delay_ticks", std::int64_t{latency}},
                                 {"model_ticks", std::int64_t{delay}}},
                     .is_default = std::string_view(name) == "all" && latency == 0 && delay == 0,
                     .metrics = {{"energy_j", energy.most_created}, {"moved_j", energy.moved}}});
            }
        }
    }
}

}  // namespace thaum::bench
