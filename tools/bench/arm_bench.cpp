// Benchmarks the thread of a real arm without an arm: the cost of a tick in that thread and in the
// simulation, which repeats the same step, and how well our own thread keeps 1 kHz on this machine. The
// library of a real arm has its own thread, which `thaum doctor` measures.
#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include "core/clock.h"
#include "input/arm_servo.h"
#include "input/tick_times.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

constexpr std::int64_t arm_period_ns = 1'000'000;
constexpr int exchange_ticks = 4000;

/// Haptic model (data from which the servo computes forces) of a point that attracts the hand.
haptics::HapticModel pulling_model() {
    haptics::HapticModel model;
    model.coupling = {.stiffness = 300, .damping = 1};
    model.primitives.add({.kind = haptics::PrimitiveKind::point, .strength = 1});
    return model;
}

haptics::Servo touch_servo() {
    haptics::DeviceSpec spec;
    spec.peak_force = 3.3;
    spec.continuous_force = 0.88;
    return {haptics::safety_limits(spec, 1)};
}

/// Reading of an arm whose tip moves to and fro by 2 cm.
input::ArmReading reading_at(int tick) {
    const auto phase = tick % 80;
    return {.time_ns = (tick + 1) * arm_period_ns,
            .position_um = {500 * (phase < 40 ? phase : 80 - phase), 1000, 0}};
}

/// The simulation's half of a tick, as in a match with a real arm: takes the arm's sample, repeats the step
/// by which the arm's thread computed the force (servo step), and publishes the next haptic model to that
/// thread.
struct ArmMatchHalf {
    input::ArmServo& door;
    haptics::Servo servo = touch_servo();
    haptics::HapticModel model = pulling_model();
    input::ArmState state{};
    std::array<input::RememberedModel, input::remembered_models> models{};

    void tick() {
        const auto sample = door.take();
        const auto number = input::model_of(state, sample);
        const auto& used = models[number % models.size()];
        const bool known = number != 0 && used.number == number;
        input::take_sample(state, servo, sample, known ? &used : nullptr, false);
        const auto next = ++state.number;
        models[next % models.size()] = {model, state.offset, next, state.samples};
        door.order() = {.servo = servo,
                        .model = model,
                        .offset = state.offset,
                        .start = state.servo,
                        .epoch = state.epoch,
                        .number = next,
                        .samples = state.samples};
        door.publish();
    }
};

/// Runs ticks of the simulation and of the arm's thread alternately.
struct Exchange {
    input::ArmServo door{};
    ArmMatchHalf half{door};
    double allocations = 0, strongest = 0;

    void run() {
        const auto before = allocation_count();
        for (int tick = 0; tick < exchange_ticks; ++tick) {
            half.tick();
            strongest = std::max(strongest, glm::length(door.step(reading_at(tick))));
        }
        allocations = static_cast<double>(allocation_count() - before);
    }
};

void arm_exchange(const Options& options, Report& report) {
    Exchange exchange;
    auto samples = measure(std::array{Contestant{{}, [&] { exchange.run(); }}},
                           {.seconds = options.quick ? 0.3 : 2.0, .least = 11});
    for (double& us : samples[0]) us /= exchange_ticks;
    const auto faults = exchange.door.faults();
    report.rows.push_back({.area = "haptics",
                           .name = "arm_exchange",
                           .time_us = times(samples[0]),
                           .is_default = true,
                           .metrics = {{"allocations", exchange.allocations},
                                       {"strongest_n", exchange.strongest},
                                       {"differing", static_cast<double>(faults.differing)},
                                       {"lost", static_cast<double>(faults.lost)}}});
}

/// The arm's thread: in each tick it sleeps, reads the arm's position and computes the force, until `stop` is
/// set.
void run_arm(input::ArmServo& door, input::TickTimes& kept, const std::atomic<bool>& stop) {
    auto due = monotonic_ns();
    for (int tick = 0; !stop; ++tick) {
        sleep_until_ns(due += arm_period_ns);
        const auto now = monotonic_ns();
        kept.begins(now);
        auto reading = reading_at(tick);
        reading.time_ns = now;
        do_not_optimise(door.step(reading));
        kept.ends(monotonic_ns());
    }
}

/// Runs simulation and arm at 1 kHz, each in a thread of its own. Neither waits for the other.
void arm_thread(const Options& options, Report& report) {
    input::ArmServo door;
    input::TickTimes kept;
    std::atomic<bool> stop = false;
    std::jthread arm([&] { run_arm(door, kept, stop); });
    ArmMatchHalf half{door};
    auto due = monotonic_ns();
    for (int tick = 0; tick < (options.quick ? 500 : 3000); ++tick) {
        half.tick();
        sleep_until_ns(due += arm_period_ns);
    }
    stop = true;
    arm.join();
    auto metrics = metrics_of(kept.report());
    metrics.emplace_back("differing", static_cast<double>(door.faults().differing));
    report.rows.push_back(
        {.area = "haptics", .name = "arm_thread", .is_default = true, .metrics = std::move(metrics)});
}

}  // namespace

void arms(const Options& options, Report& report) {
    arm_exchange(options, report);
    arm_thread(options, report);
}

}  // namespace thaum::bench
