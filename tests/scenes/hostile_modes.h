// tests/scenes/hostile_modes.h: haptic modes in fields with faults, felt through the servo by a simulated
// hand. Used by the stress test and by tests.
//
// The fields have samples that are not finite, edges as sharp as possible, and jumps. Strengths reach 10^6 N
// with either sign and jump with the data. The hand makes sudden motions, inside the volume and outside. The
// work of the forces on the hand is computed here from the device's own motion, not by the servo's observer.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/random.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"
#include "haptics/volume/volume_feel.h"
#include "tests/scenes/scanned_volumes.h"

namespace thaum::bench {

/// A random strength (N). If `bounded`, a device can render it; otherwise it may have any size, and may shut
/// a device off.
inline double hostile_strength(Random& random, bool bounded) {
    switch (random.below(8)) {
        case 0: return bounded ? random.uniform(0, 8) : 1e6;
        case 1: return bounded ? random.uniform(-4, 0) : -1e6;
        case 2: return 0;
        case 3: return bounded ? random.uniform(0, 1) : random.uniform(-20, 20);
        default: return random.uniform(0, 2);
    }
}

/// A random curve of strength over the value of a field, with jumps at four places.
inline field::TransferFunction hostile_function(Random& random, double from, double to, bool bounded) {
    std::array<vec2, 8> points{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        // Two points at each x make a jump of the curve.
        const double x = from + (to - from) * std::floor(static_cast<double>(i) / 2) / 3;
        points[i] = {x, hostile_strength(random, bounded)};
    }
    return field::transfer_function(points).value_or(field::constant(1));
}

struct HostileFields {
    static constexpr int n = 32;
    static constexpr double spacing = 0.0025;  // spacing of the samples (m), for a cube of 8 cm

    ScannedVolume density = scanned(haptics::Ball{{}, 0.025}, n, spacing);
    std::array<ScannedVolume, 3> flow{density, density, density};
    haptics::SmoothGrid smooth{};
    field::StaggeredGrid vectors{};

    /// One sample in `faults_every` is NaN or infinite; 0: all are finite.
    HostileFields(std::uint64_t seed, std::uint32_t faults_every) {
        Random random = random_stream(seed, 1);
        for (ScannedVolume& part : flow) {
            for (float& sample : part.samples) sample = static_cast<float>(random.uniform(-1, 1));
        }
        if (faults_every != 0) spoil(random, faults_every);
        smooth = density.smooth();
        for (std::size_t axis = 0; axis < 3; ++axis)
            vectors.component[axis] = flow[axis].grid(field::Kernel::catmull_rom);
    }
    HostileFields(const HostileFields&) = delete;
    HostileFields& operator=(const HostileFields&) = delete;
    ~HostileFields() = default;

private:
    void spoil(Random& random, std::uint32_t faults_every) {
        constexpr std::array faults{std::numeric_limits<float>::quiet_NaN(),
                                    std::numeric_limits<float>::infinity(), -3e38F};
        for (ScannedVolume* part : {&density, flow.data(), &flow[1], &flow[2]}) {
            for (float& sample : part->samples) {
                if (random.below(faults_every) == 0) sample = faults[random.below(faults.size())];
            }
        }
    }
};

/// Which forces act on the hand in a run.
enum class HostileFeel : std::uint8_t {
    all,      ///< all modes act at once
    passive,  ///< all passive modes, and the walls and the resistance of a volume
    volume,   ///< a volume alone, with forces linked to its density
};

/// Result of a run with hostile modes.
struct HostileResult {
    std::uint64_t ticks{};
    std::uint64_t not_finite{};  ///< number of ticks with a force that is not finite
    double largest{};            ///< largest force on the hand (N)
    /// Largest energy that the forces gave to the hand since spring and primitives last stored none (J).
    /// Meaningless for the forces of a volume, because a field that pushes can store more energy.
    double most_created{};
    double max_given{};        ///< largest energy that the forces gave to the hand since the start (J)
    double felt{};             ///< share of the ticks in which a force acted
    double observed{};         ///< largest energy created, according to the servo's observer (J)
    std::uint64_t left_out{};  ///< number of modes that were left out for lack of room, summed over all ticks
};

/// A simulated hand on a simulated device that feels random modes.
class HostileHand {
public:
    HostileHand(HostileFields& fields, std::uint64_t seed, HostileFeel feel)
        : fields_(&fields), random_(random_stream(seed, 2)), feel_(feel) {
        choose_modes();
    }

    double cap() const { return servo_.limits.cap; }

    /// Chooses other modes and settings at random. The servo fades to the new forces.
    void choose_modes() {
        uses_.clear();
        const bool bounded = random_.below(2) == 0;
        for (const haptics::Mode& mode : haptics::modes()) {
            if (feel_ == HostileFeel::volume || (feel_ == HostileFeel::passive && !mode.passive)) continue;
            haptics::ModeUse use{
                &mode, haptics::any_field(field::field_of<field::Scalar>(fields_->smooth)), {}};
            if (mode.reads == haptics::FieldKind::vector)
                use.field = haptics::any_field(field::field_of<field::Vector>(fields_->vectors));
            const double range = mode.reads == haptics::FieldKind::vector ? 2 : 255;
            use.settings.strength = hostile_function(random_, 0, range, bounded);
            use.settings.friction =
                hostile_function(random_, 0, mode.name == "isosurface" ? 0.01 : range, bounded);
            use.settings.level = 127.5;
            use.settings.magnet = bounded ? 0.5 : 1e6;
            use.settings.reach = 0.003;
            uses_.push_back(use);
        }
        choose_volume(bounded);
        ++model_.set_number;
    }

    void run(std::uint64_t ticks, HostileResult& result) {
        for (std::uint64_t i = 0; i < ticks; ++i) tick(result);
        result.observed = state_.energy.most_created;
    }

private:
    /// Sets up a wall and resistance; for the feel `volume`, also forces that push out of the solid.
    void choose_volume(bool bounded) {
        const double largest = bounded ? 1 : 1e6, pushes = feel_ == HostileFeel::volume ? largest : 0;
        volume_ = {.density = field::field_of<field::Scalar>(fields_->smooth)};
        volume_.walls[0] = {.density = 60, .strength = largest, .friction = 0.5 * largest, .reach = 0.003};
        volume_.wall_count = 1;
        volume_.shell = {.low = 20, .high = 250, .stiffness = 2 * pushes, .retarding = largest};
        volume_.opacity = {.density = hostile_function(random_, 0, 255, bounded),
                           .gradient = hostile_function(random_, 0, 1e5, bounded),
                           .stiffness = pushes,
                           .retarding = largest};
    }

    void move_target() {
        if (random_.below(400) == 0)
            aim_ = {random_.uniform(-0.07, 0.07), random_.uniform(-0.07, 0.07), random_.uniform(-0.07, 0.07)};
        const double rate = random_.below(400) == 0 ? 1.0 : 0.01;  // sometimes a sudden motion
        target_ += rate * (aim_ - target_);
    }

    void tick(HostileResult& result) {
        const vec3 place = haptics::measured_position(device_, hand_);
        const haptics::ModeInput input{state_.samples == 0 ? place : state_.proxy, before_,
                                       before_ - before_last_, model_.coupling.stiffness,
                                       before_ - before_last_};
        model_.primitives.clear();
        // Switches forces on again, because excessive forces shut the device off.
        model_.rearm = result.ticks % 40 < 20;
        result.left_out += haptics::add_modes(uses_, input, model_.primitives);
        if (feel_ != HostileFeel::all)
            model_.viscosity = haptics::add_volume_feel(volume_, input, model_.primitives).viscosity;
        const vec3 force = haptics::servo_step(servo_, state_, model_, {place, 0});
        before_last_ = state_.samples < 2 ? place : before_;
        before_ = place;
        move_target();
        const vec3 from = hand_.position;
        hand_ = haptics::step(device_, hand_, target_, force);
        const double work = glm::dot(hand_.force, hand_.position - from);
        created_ += work;
        // At rest springs and primitives store no energy. Energy that damping dissipated earlier must not
        // hide energy that the forces create later.
        if (stored() < 1e-3) created_ = std::max(created_, 0.0);
        given_ += work;
        ++result.ticks;
        result.not_finite += is_finite(force) ? 0 : 1;
        result.largest = std::max(result.largest, glm::length(force));
        result.most_created = std::max(result.most_created, created_);
        result.max_given = std::max(result.max_given, given_);
        result.felt += force != vec3(0) ? 1 : 0;
    }

    /// Energy stored in the spring between tip and proxy and in the primitives, as far as the force limit
    /// lets it act (J).
    double stored() const {
        const double stretch = glm::distance(state_.proxy, hand_.position), k = model_.coupling.stiffness;
        const double most = cap() / k;
        double energy = stretch < most ? k * stretch * stretch / 2 : cap() * (stretch - most / 2);
        for (const haptics::Primitive& p : model_.primitives.items()) {
            const vec3 off = state_.proxy - p.position;
            const double along = glm::dot(off, p.direction);
            const bool line = p.kind == haptics::PrimitiveKind::line,
                       plane = p.kind == haptics::PrimitiveKind::plane;
            if (p.kind == haptics::PrimitiveKind::directed) continue;
            const double distance =
                plane ? std::max(0.0, -along) : glm::length(line ? off - along * p.direction : off);
            energy += std::min(p.strength, cap()) * distance;
        }
        return energy;
    }

    static haptics::DeviceSpec spec() {
        return {.name = "touch",
                .sensed = 3,
                .actuated = 3,
                .peak_force = 3.3,
                // This limit is high, because warm motors would weaken springs, which is not tested here.
                .continuous_force = 3.3,
                .max_stiffness = 400,
                .max_damping = 3,
                .workspace = vec3(0.16, 0.12, 0.12),
                .position_quantum = 5.5e-5,
                .mass = 0.045,
                .damping = 0.2,
                .coulomb_friction = 0.26,
                .update_rate = 1000,
                .latency = 1};
    }

    HostileFields* fields_;
    Random random_;
    HostileFeel feel_;
    std::vector<haptics::ModeUse> uses_{};
    haptics::VolumeFeel volume_{};
    haptics::Servo servo_ = haptics::servo_of(spec(), 1);
    haptics::SimulatedDevice device_ = haptics::simulated_device(spec(), haptics::Hand{});
    /// The hand starts outside of the solid.
    haptics::SimulatedState hand_ = haptics::resting_at({0.06, 0, 0});
    haptics::ServoState state_{};
    haptics::HapticModel model_{};
    vec3 target_{0.06, 0, 0}, aim_{}, before_{}, before_last_{};
    double created_{}, given_{};
};

}  // namespace thaum::bench
