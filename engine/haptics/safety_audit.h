// haptics/safety_audit.h: an independent recorder behind the safety stage, which counts what must not be.
//
//     wanted ---- make_safe ---- output ---- device
//        |                         |
//        +----- SafetyAudit -------+
//
// It holds the rules of haptics.md, "Safety stage", against the force that left, and shares no code with the stage: it keeps
// moments where the stage keeps counters, every square of the window where the stage keeps bins. It knows nothing of the
// stage's state, so it cannot believe it. Where the rules leave the stage free (how it scales down near the thermal budget) it
// gives the benefit of the doubt, and only there.
//
// One audit follows one device from its start, and must see every tick. It takes 90 kB when made and allocates no more.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/maths.h"
#include "haptics/safety.h"

namespace thaum::haptics {

enum class SafetyRule : std::uint32_t {
    finite,
    cap,      ///< not longer than it, to the bit
    budget,   ///< mean square over exactly the last 10 s
    slew,     ///< no jump at a switch; then wanted force and an offset that fades by time, work and cap
    unasked,  ///< otherwise: wanted force and brake in full, or parts of both while the motors are warm
    stale,    ///< not above the line to zero in 50 ms
    waiting,  ///< zero before the first wanted force in range; the others below likewise
    over_speed,
    off,
    shut_off,
    panic,
};
inline constexpr std::size_t safety_rules = 11;

const char* name(SafetyRule rule);

class SafetyAudit {
public:
    SafetyAudit();

    /// One tick: what make_safe was given, and what it returned or the device was told, N.
    void record(const SafetyLimits& limits, const SafetyInput& input, vec3 output);

    std::uint64_t violations() const;
    /// Ticks; one that breaks several rules counts for each.
    std::uint64_t violations(SafetyRule rule) const { return counts_[static_cast<std::size_t>(rule)]; }
    std::uint64_t ticks() const { return now_; }
    /// N, root of the mean square over the last 10 s; what lies before the start counts as zero.
    double warmth() const;

private:
    using Moment = std::uint64_t;  // a tick, from 1; 0: never

    void count(SafetyRule rule, bool broken);
    void watch_latches(const SafetyLimits& limits, const SafetyInput& input);
    void watch_hand(const SafetyLimits& limits, const SafetyInput& input);
    void watch_model(const SafetyInput& input);
    void judge_always(const SafetyLimits& limits, vec3 output);
    bool judge_stopped(const SafetyInput& input, vec3 output);
    void judge_following(const SafetyLimits& limits, const SafetyInput& input, vec3 output);
    bool is_cool(const SafetyLimits& limits) const;
    void begin_fade(const SafetyLimits& limits, vec3 goal, vec3 output, bool cool);
    void fade_on(const SafetyLimits& limits, vec3 goal, vec3 tip);
    void heat(vec3 output);

    std::array<std::uint64_t, safety_rules> counts_{};
    Moment now_{};
    vec3 before_{};  // N, the last output

    bool panicked_{};
    bool shut_off_{};
    bool gate_open_{};
    Moment last_excess_{};
    std::array<Moment, 3> episodes_{};  // began; the newest last
    Moment last_hurry_{};               // 0: no cut-out
    Moment last_fresh_{};
    vec3 at_stale_{};  // N, where the ramp begins

    bool begins_ = true;        // the next force that is let through is a switch, as the first one is
    bool maybe_fading_ = true;  // an offset may be left
    bool known_ = false;        // and is the one below
    bool unscaled_ = true;  // the stage does not scale down to keep the motors cool, nor come back from that
    vec3 offset_{};         // N
    vec3 tip_{};            // m
    double full_{};         // N, length of the offset when it began
    double spent_{};        // J, work of the offset
    Moment last_fading_{};  // the last tick in which there may be an offset

    std::vector<double> squares_;  // N^2, a ring
    double window_sum_{};          // N^2, of the last 10 s
    double memory_sum_{};          // N^2, of as long as the stage may remember
};

}  // namespace thaum::haptics
