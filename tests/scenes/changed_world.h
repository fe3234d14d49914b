// tests/scenes/changed_world.h: a hand that presses into a spring of the device's stiffness while conditions
// change repeatedly: the force limit changes, forces are switched off and on, the haptic model (what the
// match tells the servo of the world) becomes old, the spring disappears and returns. The energy is summed as
// F dx from the device's own motion. The servo's own energy observer is not used.
#pragma once
#include <algorithm>
#include <array>

#include "haptics/servo.h"
#include "haptics/simulated.h"
#include "tests/scenes/worse.h"

namespace thaum::bench {

enum class WorldChange : std::uint8_t { max_force, off_and_on, stale_model, spring };
inline constexpr std::array world_changes{WorldChange::max_force, WorldChange::off_and_on,
                                          WorldChange::stale_model, WorldChange::spring};

/// Hands that hold the device loosely, as most people do, and firmly.
inline constexpr std::array pressing_hands{haptics::Hand{.mass = 0.55, .stiffness = 135, .damping = 6.5},
                                           haptics::Hand{},
                                           haptics::Hand{.mass = 0.3, .stiffness = 1500, .damping = 30}};

class ChangedWorld {
public:
    ChangedWorld(haptics::DeviceSpec spec, const haptics::Hand& hand, bool surface)
        : spec_(std::move(spec)), surface_(surface) {
        // This limit is high, because warm motors weaken springs, which would hide created energy.
        spec_.continuous_force = 10 * spec_.peak_force;
        device_ = haptics::simulated_device(spec_, hand);
        servo_ = haptics::servo_of(spec_, 1);
        set_spring(true);
        const double force = 0.9 * spec_.peak_force;
        const double depth =
            std::min(force / spec_.max_stiffness + force / hand.stiffness, 0.45 * spec_.workspace.y);
        for (int i = 0; i < 600; ++i) {
            target_.y = -depth * std::min(1.0, i / 300.0);
            tick();
        }
        created_ = max_created_ = max_jump_ = 0;
    }

    /// Makes a change of the conditions and undoes it, with 150 ticks after each.
    void change(WorldChange change) {
        for (const bool back : {false, true}) {
            switch (change) {
                case WorldChange::max_force: model_.force_percent = back ? 100 : 5; break;
                case WorldChange::off_and_on: model_.on = back; break;
                case WorldChange::stale_model: age_ = back ? 0 : 1; break;
                case WorldChange::spring: set_spring(back); break;
            }
            for (int i = 0; i < 150; ++i) tick();
        }
    }

    /// Largest energy that the changes have created (J). Energy that the hand has put into the spring and the
    /// spring still holds does not count.
    double most_created() const { return max_created_; }
    /// Largest change of force in a tick (N), beyond the change that a spring and a damper with the device's
    /// limits may cause.
    double max_jump() const { return max_jump_; }

private:
    void set_spring(bool there) {
        model_.set_number += 1;
        model_.patch_number += surface_ ? 1 : 0;
        model_.start = tip_.position;
        model_.primitives.clear();
        model_.patch.count = model_.patch.body_count = 0;
        model_.coupling = {.stiffness = spec_.max_stiffness};
        if (!there) return;
        if (!surface_) {
            model_.primitives.add({haptics::PrimitiveKind::plane, vec3(0), vec3(0, 1, 0), spec_.peak_force});
            return;
        }
        model_.patch.count = model_.patch.body_count = 1;
        model_.patch.surfaces[0] = {.kind = haptics::SurfaceKind::plane, .b = {0, 1, 0}};
        model_.patch.bodies[0].material = {.stiffness = spec_.max_stiffness};
        model_.patch.bodies[0].key = 1;
    }

    void tick() {
        const vec3 measured = haptics::measured_position(device_, tip_);
        const vec3 step = measured - measured_, turn = (step - step_) / tick_seconds;
        const vec3 force = haptics::servo_step(servo_, state_, model_, {measured, age_});
        if (age_ != 0) ++age_;
        max_jump_ = worse(max_jump_, glm::length(force - force_) - spec_.max_stiffness * glm::length(step) -
                                         spec_.max_damping * glm::length(turn));
        force_ = force;
        measured_ = measured;
        step_ = step;
        const vec3 from = tip_.position;
        tip_ = haptics::step(device_, tip_, target_, force);
        const double depth = std::max(0.0, -tip_.position.y), felt = glm::length(force);
        const double bent = std::min(depth, felt / spec_.max_stiffness);
        created_ = std::max(created_ + glm::dot(tip_.force, tip_.position - from),
                            -(spec_.max_stiffness * bent * bent / 2 + felt * (depth - bent)));
        max_created_ = worse(max_created_, created_);
    }

    haptics::DeviceSpec spec_;
    bool surface_{};
    haptics::SimulatedDevice device_{};
    haptics::SimulatedState tip_ = haptics::resting_at({});
    haptics::Servo servo_{};
    haptics::ServoState state_{};
    haptics::HapticModel model_{};
    vec3 target_{}, measured_{}, step_{}, force_{};
    std::uint32_t age_{};
    double created_{}, max_created_{}, max_jump_{};
};

}  // namespace thaum::bench
