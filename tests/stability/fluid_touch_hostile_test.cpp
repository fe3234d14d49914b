// A hand that stirs creates no energy and comes to no harm, whatever hand, fluid and delay do.
#include <gtest/gtest.h>

#include <deque>
#include <filesystem>

#include "core/file.h"
#include "core/random.h"
#include "fluid/sheet.h"
#include "unit/stirring_rig.h"

namespace thaum::haptics {
namespace {

/// A device's file.
DeviceSpec shipped(const char* name) {
    const auto file = std::string(name) + ".toml";
    const auto toml = read_text_file(THAUM_SOURCE_DIR "/assets/devices/" + file, 1U << 16U);
    return *read_device(*Config::parse(*toml, file, 1));
}

vec3 vector_within(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// ---- the way through the fluid -------------------------------------------------------------------------------------

/// A fluid that is one mass: it is pushed in the step after the one in which the hand moved it, and is read when that has ended.
struct LateFluid {
    double mass{};  ///< kg
    vec3 velocity{}, pushed{}, coming{};

    void step(FluidTouch& touch) {
        velocity += coming / mass;
        coming = pushed;
        pushed = {};
        newest_step(touch, uniform_flow(velocity, 4, 8));
    }
};

/// m/s, of the flow after so many steps, begun at 1; the hand is held fast where hand_mass is 0. told: the mass that the model names.
double flow_after(int steps, double told, double mass, double hand_mass) {
    StirringRig rig;
    rig.servo.most_damping = hand_mass > 0 ? 4 : 1e9;
    if (hand_mass > 0) {
        rig.spec.mass = hand_mass;
        rig.device = simulated_device(rig.spec, no_hand);
    }
    rig.fluid().modes.resistance = 1;
    rig.fluid().drag = {.form = 1e9, .stirred_mass = told};
    LateFluid fluid{.mass = mass, .velocity = {1, 0, 0}};
    for (int step = 0; step < steps; ++step) {
        fluid.step(rig.fluid());
        for (std::uint32_t tick = 0; tick < fluid_period; ++tick, ++rig.fluid().step_age) {
            if (hand_mass > 0)
                rig.tick();
            else
                rig.feel_at({});
            fluid.pushed -= force_on_ladle(rig.fluid(), rig.state.fluid) * tick_seconds;
        }
    }
    return glm::length(fluid.velocity - rig.fluid().frame.turn * rig.tip.velocity * 16.0);
}

TEST(FluidTouchHostile, TheWayThroughTheFluidDoesNotRing) {
    for (const double mass : {0.1, 3.0, 200.0}) {
        EXPECT_LE(flow_after(60, mass, mass, 0), 1e-4) << mass;
        for (const double hand : {0.02, 0.1, 1.0}) EXPECT_LE(flow_after(300, mass, mass, hand), 1e-3);
        // What the limit is for: up to a gain of 0.83 it fades, beyond it grows.
        EXPECT_LE(flow_after(400, mass * 0.80 / loop_gain, mass, 0), 0.2);
        EXPECT_GE(flow_after(400, mass * 0.86 / loop_gain, mass, 0), 5);
    }
}

// ---- energy --------------------------------------------------------------------------------------------------------

/// What a run of one device comes to, of which the test itself keeps the books.
struct EnergyRun {
    double created{}, most_created{};  ///< J, by the sum of F dx less what the world gave
    double moved{};                    ///< J, either way: nothing proves nothing
};

/// The world of one kind of source, and what it gives to the hand.
struct World {
    FluidModes modes{};
    double flow{};          ///< m/s: it changes by as much in each step
    bool waves{};           ///< of a sheet that is real
    std::uint32_t delay{};  ///< ticks that a model is late
    const char* device{};
};

/// So that no cap takes anything from the hand that the world gave; with stiffnesses as matches have them at most.
DeviceSpec unlimited(DeviceSpec spec) {
    spec.peak_force = spec.continuous_force = 1000;
    spec.max_stiffness = std::min(spec.max_stiffness, 1000.0);
    return spec;
}

class StirringAttack {
public:
    explicit StirringAttack(const World& world)
        : world_(world),
          spec_(unlimited(shipped(world.device))),
          device_(simulated_device(spec_, Hand{})),
          servo_(servo_of(spec_, 1)) {
        servo_.limits.fastest = 1e9;
        servo_.limits.slew = 1e12;
        auto& touch = model_.fluid;
        touch = some_fluid();
        touch.modes = world.modes;
        touch.frame = {.turn = touch.frame.turn, .metres_per_metre = 20, .newtons_per_newton = 0.00375};
        const double felt = 20 * 0.00375;
        touch.drag = {.viscous = 4 / felt, .form = 1.5 / felt, .stirred_mass = 10, .height = 0.2};
        touch.wall = {.radius = 0.5,
                      .depth = 0.4,
                      .stiffness = spec_.max_stiffness / felt,
                      .damping = spec_.max_damping / 2 / felt};
        touch.ladle = {.mass = 0.1 / felt, .stiffness = spec_.max_stiffness / felt / 2, .damping = 2 / felt};
        settings_.contact = spec_.max_stiffness / felt;
    }

    EnergyRun run(int ticks) {
        for (int tick = 0; tick < ticks; ++tick) advance_tick(tick);
        return run_;
    }

private:
    void advance_tick(int tick) {
        move_world(tick);
        past_.push_back(model_);
        if (past_.size() > world_.delay + 1) past_.pop_front();
        const auto age = static_cast<std::uint32_t>(past_.size() - 1);
        const vec3 measured = measured_position(device_, tip_);
        const HapticModel& used = past_.front();
        const vec3 force = servo_step(servo_, state_, used, {measured, age});
        if (tick % 40 == 0) goal_ = vector_within(random_, 0.05);
        const vec3 from = tip_.position;
        tip_ = step(device_, tip_, goal_, force);
        book(used, age, from);
    }

    /// What left at the hand in this tick, and what the world gave for it: to the resistance the newest flow, by which the ladle is
    /// carried, to the surface's spring its other end. Viscosity is met in fluids at rest only.
    void book(const HapticModel& used, std::uint32_t age, vec3 from) {
        const auto& touch = used.fluid;
        const double height = touch.surface.height + touch.surface.velocity * age * tick_seconds;
        const double out = glm::dot(tip_.force, tip_.position - from);
        run_.created += out - flow_gives_ - surface_force_ * (height - height_) / 20;
        run_.created = std::max(run_.created, -held(touch, height));
        run_.most_created = std::max(run_.most_created, run_.created);
        run_.moved += std::abs(out);
        const vec3 flow = flow_at(touch.newer, state_.fluid.place).velocity;
        flow_gives_ = glm::dot(touch.frame.turn * state_.fluid.force, flow) * (tick_seconds / 20);
        surface_force_ = state_.fluid.surface_force;
        height_ = height;
    }

    /// J, in the springs to wall and surface and in the ladle: what damping took is gone, only so much may come back.
    double held(const FluidTouch& touch, double height) const {
        const auto& fluid = state_.fluid;
        const vec3 place = to_bowl(touch.frame, tip_.position);
        const double in = glm::length(held_in(touch.wall, place) - place) / 20;
        const vec3 off = fluid.mass_position - tip_.position, speed = fluid.mass_velocity;
        const double wall = touch.modes.wall * spec_.max_stiffness * in * in / 2;
        const double ladle = touch.modes.inertia *
                             (0.1 * glm::dot(speed, speed) + spec_.max_stiffness / 2 * glm::dot(off, off)) /
                             2;
        return wall + ladle + std::abs(fluid.surface_force * (height - place.y) / 20);
    }

    void move_world(int tick) {
        auto& touch = model_.fluid;
        if (tick % static_cast<int>(fluid_period) == 0)
            newest_step(touch, uniform_flow(vector_within(random_, world_.flow), random_.uniform(0, 1),
                                            random_.uniform(0, 1)));
        else
            ++touch.step_age;
        if (!world_.waves) return;
        const vec3 place = to_bowl(touch.frame, tip_.position);
        const std::array probe{
            fluid::SheetProbe{.place = {place.x, place.z}, .height = place.y, .radius = 0.1}};
        const auto reaction = fluid::advance(sheet_, scratch_, probe, tick_seconds).probes[0];
        const double velocity = (reaction.height - touch.surface.height) / tick_seconds;
        touch.surface = {.height = reaction.height,
                         .velocity = velocity,
                         .stiffness = settings_.contact,
                         .pop_through = settings_.pop_through,
                         .cling = settings_.cling,
                         .inside = reaction.inside ? 1U : 0U,
                         .there = 1};
    }

    World world_;
    DeviceSpec spec_;
    SimulatedDevice device_;
    Servo servo_;
    ServoState state_{};
    HapticModel model_{};
    std::deque<HapticModel> past_{};
    SimulatedState tip_ = resting_at({});
    vec3 goal_{};
    Random random_{12};
    fluid::SheetSettings settings_{};
    fluid::Sheet sheet_ = sheet_of(settings_);
    fluid::SheetScratch scratch_{};
    EnergyRun run_{};
    double flow_gives_{}, surface_force_{}, height_{};
};

constexpr FluidModes only(double FluidModes::*mode) {
    FluidModes modes{0, 0, 0, 0, 0, 0, 0};
    modes.*mode = 1;
    return modes;
}

TEST(FluidTouchHostile, PassiveModesCreateNothing) {
    const std::array modes{only(&FluidModes::viscosity), only(&FluidModes::resistance),
                           only(&FluidModes::surface),   only(&FluidModes::wall),
                           only(&FluidModes::inertia),   FluidModes{0, 0, 1, 1, 1, 1, 0}};
    for (const char* device : {"touch", "falcon", "omega3"}) {
        for (const std::uint32_t delay : {0U, 5U}) {
            for (std::size_t i = 0; i < modes.size(); ++i) {
                const EnergyRun run = StirringAttack({.modes = modes[i],
                                                      .flow = modes[i].resistance > 0 ? 2.0 : 0.0,
                                                      .waves = modes[i].surface > 0,
                                                      .delay = delay,
                                                      .device = device})
                                          .run(10'000);
                EXPECT_LE(run.most_created, 0.02) << device << " " << delay << " " << i;
                EXPECT_GT(run.moved, 0.02) << device << " " << delay << " " << i;
            }
        }
    }
}

// ---- what is no number ---------------------------------------------------------------------------------------------

double nasty_number(Random& random) {
    switch (random.below(9)) {
        case 0: return std::numeric_limits<double>::quiet_NaN();
        case 1: return random.below(2) == 0 ? HUGE_VAL : -HUGE_VAL;
        case 2: return random.uniform(-1, 1) * 1e300;
        case 3: return random.uniform(-1, 1) * 1e-300;
        case 4: return 0;
        default: return random.uniform(-3, 3);
    }
}
vec3 nasty_vector(Random& random) {
    return {nasty_number(random), nasty_number(random), nasty_number(random)};
}

FlowPatch nasty_patch(Random& random) {
    FlowPatch patch = uniform_flow({1, 0, 0}, 2, 3);
    for (FlowNode& node : patch.nodes) {
        if (random.below(4) != 0) continue;
        node = {fvec3(nasty_vector(random)), static_cast<float>(nasty_number(random)),
                static_cast<float>(nasty_number(random))};
    }
    if (random.below(4) == 0) patch.origin = nasty_vector(random);
    if (random.below(8) == 0) patch.spacing = nasty_number(random);
    return patch;
}

void spoil(FluidTouch& touch, Random& random) {
    const auto sometimes = [&random](double& value) {
        if (random.below(6) == 0) value = nasty_number(random);
    };
    touch = some_fluid();
    touch.number = random.below(3);
    touch.modes = {1, 1, 1, 1, 1, 1, 1};
    touch.ladle = {2, 4000, 40};
    touch.wall = {.radius = 1.5, .depth = 1, .stiffness = 5000, .damping = 10};
    touch.surface = {.stiffness = 5000, .pop_through = 200, .cling = 40, .there = 1};
    touch.surface.inside = static_cast<std::uint32_t>(random.below(2));
    for (double* value : {&touch.modes.viscosity,
                          &touch.modes.flow,
                          &touch.modes.resistance,
                          &touch.modes.surface,
                          &touch.modes.wall,
                          &touch.modes.inertia,
                          &touch.frame.origin.y,
                          &touch.frame.turn[0][1],
                          &touch.frame.metres_per_metre,
                          &touch.frame.newtons_per_newton,
                          &touch.drag.viscous,
                          &touch.drag.form,
                          &touch.drag.stirred_mass,
                          &touch.drag.height,
                          &touch.surface.height,
                          &touch.surface.velocity,
                          &touch.surface.stiffness,
                          &touch.surface.pop_through,
                          &touch.surface.cling,
                          &touch.wall.centre.x,
                          &touch.wall.radius,
                          &touch.wall.depth,
                          &touch.wall.stiffness,
                          &touch.wall.damping,
                          &touch.ladle.mass,
                          &touch.ladle.stiffness,
                          &touch.ladle.damping})
        sometimes(*value);
    touch.older = nasty_patch(random);
    touch.newer = nasty_patch(random);
    touch.step_age = random.below(2) == 0 ? random.below(40) : ~std::uint64_t{0} - random.below(3);
}

TEST(FluidTouchHostile, NothingGetsThroughAndWhatIsSaneAgainIsFeltAgain) {
    const auto spec = shipped("touch");
    Servo servo = servo_of(spec, 1);
    Random random{33};
    for (int run = 0; run < 300; ++run) {
        ServoState state;
        HapticModel model;
        vec3 tip{};
        for (int tick = 0; tick < 100; ++tick) {
            if (random.below(3) == 0) spoil(model.fluid, random);
            tip += vector_within(random, random.below(30) == 0 ? 10 : 1e-3);
            const vec3 at = random.below(60) == 0 ? nasty_vector(random) : tip;
            const auto age = static_cast<std::uint32_t>(random.below(4) == 0 ? random.below(60) : 0);
            const vec3 force = servo_step(servo, state, model, {at, age});
            ASSERT_TRUE(is_finite(force));
            ASSERT_LE(glm::length(force), servo.limits.cap * (1 + 1e-12));
            ASSERT_TRUE(is_finite(state.fluid.force) && std::isfinite(state.fluid.surface_force));
            ASSERT_TRUE(is_finite(state.fluid.wall) && std::isfinite(state.fluid.flow_work));
            ASSERT_TRUE(std::isfinite(state.energy.created));
        }
        // Sane again. What was asked for repeatedly has shut it off, perhaps: armed anew.
        model = {};
        model.fluid = some_fluid();
        model.fluid.number = 77;
        model.fluid.modes = {1, 0, 1, 0, 0, 1, 0};
        model.fluid.ladle = {2, 4000, 40};
        for (int tick = 0; tick < 1500; ++tick) {
            model.rearm = tick == 1000;
            servo_step(servo, state, model, {vec3(1e-5 * tick, 0, 0), 0});
        }
        // 0.01 m/s: 1/16 (2 4 + 1/2 8) of it; the mass goes along by now.
        EXPECT_NEAR(state.fluid.force.x, -0.01 * 0.75, 1e-6);
        EXPECT_NEAR(state.safety.output.x, -0.01 * 0.75, 1e-4) << run << " " << state.safety.cause;
    }
}

}  // namespace
}  // namespace thaum::haptics
