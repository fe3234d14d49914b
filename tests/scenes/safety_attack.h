// tests/scenes/safety_attack.h: hostile input for the safety stage (the last part of the servo, which limits
// forces), for the tests and the benchmark. The input goes through phases, because pure noise would keep the
// stage switched off or limiting, and never test it while motors are warm or forces fade in and out.
#pragma once
#include <limits>

#include "core/random.h"
#include "haptics/safety.h"

namespace thaum::bench {

class SafetyAttack {
public:
    SafetyAttack(const haptics::DeviceSpec& spec, std::uint64_t seed) : spec_(spec), random_{seed} {
        begin_phase();
    }

    haptics::SafetyInput next() {
        if (left_-- == 0) begin_phase();
        ++at_;
        age_ = next_age();
        const vec3 all = wanted();
        return {.wanted = all,
                .spring = spring_of(all),
                .brake = brake(),
                .tip = tip(),
                .velocity = velocity(),
                .path_speed = path_speed(),
                .model_age = age_,
                .switched = once_in(switches_),
                .on = !once_in(offs_),
                .panic = once_in(panics_),
                .rearm = once_in(1000)};
    }
    /// Safety limits that hold for the last input. The player changes the force limit, too.
    const haptics::SafetyLimits& limits() const { return limits_; }

private:
    bool once_in(std::uint64_t n) { return n != 0 && random_.below(n) == 0; }
    std::uint64_t one_of(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
        const std::uint64_t which = random_.below(3);
        return which == 0 ? a : which == 1 ? b : c;
    }

    void begin_phase() {
        left_ = 1 + random_.below(4000);
        kind_ = random_.below(8);
        haste_ = random_.below(6);
        lateness_ = random_.below(4);
        switches_ = one_of(0, 3, 200);
        offs_ = one_of(0, 0, 150);
        panics_ = one_of(0, 0, 1000);
        direction_ = {random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
        limits_ = haptics::safety_limits(spec_, once_in(3) ? random_.uniform(-0.1, 1.1) : 1);
    }

    double hostile_number() {
        constexpr double infinite = std::numeric_limits<double>::infinity();
        switch (random_.below(9)) {
            case 0: return std::numeric_limits<double>::quiet_NaN();
            case 1: return random_.below(2) == 0 ? infinite : -infinite;
            case 2: return random_.uniform(-1, 1) * 1e300;
            case 3: return random_.uniform(-1, 1) * 1e-310;
            case 4: return -0.0;
            case 5: return random_.uniform(-1, 1) * 5 * spec_.peak_force;
            default: return random_.uniform(-1, 1) * spec_.peak_force;
        }
    }
    vec3 hostile_vector() { return {hostile_number(), hostile_number(), hostile_number()}; }

    /// Part of the requested force `all` that comes from springs: none of it, all of it, or a random force.
    vec3 spring_of(vec3 all) {
        if (kind_ == 0 && once_in(2)) return hostile_vector();
        return kind_ % 2 == 0 ? vec3(0) : all;
    }

    vec3 wanted() {
        const double peak = spec_.peak_force;
        const auto phase = static_cast<double>(at_ % 250) / 250;
        switch (kind_) {
            case 0: return hostile_vector();
            case 1: return once_in(60) ? hostile_vector() : peak * direction_;
            case 2:
                return 2 * peak * direction_;  // twice the peak force, which heats the motors
            // A force that alternates its direction.
            case 3: return (at_ / 40 % 2 == 0 ? 3.0 : -3.0) * peak * direction_;
            case 4:
                return peak * (1 - std::abs(4 * phase - 2)) * direction_;  // the force is a triangular pulse
            // A force that is held and released.
            case 5: return at_ % 1500 < 300 ? peak * direction_ : vec3(0);
            case 6: return {peak * random_.uniform(-1, 1), 0, peak * random_.uniform(-1, 1)};
            default: return once_in(50) ? vec3(-0.0) : 0.2 * peak * direction_;
        }
    }

    /// Braking force: none in most phases, else along the motion or against it. The safety stage must be safe
    /// with either.
    vec3 brake() {
        if (lateness_ == 3 && once_in(100)) return hostile_vector();
        return haste_ == 4 && once_in(3) ? random_.uniform(-1, 1) * spec_.peak_force * direction_ : vec3(0);
    }

    /// Position of the tip: moving to and fro along the force, oblique, far away, or not finite.
    vec3 tip() {
        if (haste_ == 5 && once_in(200)) return hostile_vector();
        const double step = 1e-4 * (at_ / 300 % 2 == 0 ? 1.0 : -1.0);
        tip_ += step * (kind_ % 3 == 0 ? direction_ : vec3(random_.uniform(-1, 1), 0, direction_.z));
        return tip_;
    }

    vec3 velocity() {
        const double fastest = limits_.max_speed;
        if (haste_ == 0 && once_in(300)) return hostile_vector();
        if (haste_ == 1 && once_in(500)) return {0, fastest * random_.uniform(0.9, 1.1), 0};
        return fastest * 0.55 * (once_in(50) ? direction_ : 0.3 * direction_);
    }

    double path_speed() {
        if (haste_ == 2 && once_in(400)) return hostile_number();
        return limits_.max_speed * (haste_ == 3 && once_in(500) ? random_.uniform(0.9, 1.1) : 0.4);
    }

    std::uint32_t next_age() {
        // The age of the model jumps.
        if (lateness_ == 0) return static_cast<std::uint32_t>(random_.below(30));
        if (lateness_ > 1 || once_in(60)) return 0;
        return once_in(500) ? std::numeric_limits<std::uint32_t>::max() - 1 : age_ + 1;
    }

    haptics::DeviceSpec spec_;
    Random random_;
    haptics::SafetyLimits limits_{};
    std::uint64_t left_{}, at_{}, kind_{}, haste_{}, lateness_{}, switches_{}, offs_{}, panics_{};
    vec3 direction_{}, tip_{};
    std::uint32_t age_{};
};

}  // namespace thaum::bench
