// haptics/audit/safety_audit.h: an independent audit of the safety stage. It counts violations of its rules.
//
//     wanted ---- make_safe ---- output ---- device
//        |                         |
//        +----- SafetyAudit -------+
//
// The audit checks the output against the rules of HAPTICS.md, "Safety". It shares no code with the
// stage and does not see the stage's state. It keeps moments where the stage keeps counters, and every square
// of the window where the stage keeps bins. The rules leave one thing free: how the stage scales down near
// the thermal budget. Only there the audit accepts any choice.
//
// One audit follows one device from its start and must see every tick. It takes 90 kB at construction and
// allocates nothing later.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/maths.h"
#include "haptics/safety.h"

namespace thaum::haptics {

/// Rules that every commanded force must obey.
enum class SafetyRule : std::uint32_t {
    finite,
    cap,     ///< length at most the cap, to the bit, or on the way down to a lowered one
    budget,  ///< mean square over exactly the last 10 s
    /// No jump at a switch; then the wanted force plus an offset that fades by time, work and cap.
    slew,
    /// Without a switch: wanted force and brake in full, or parts of both while the motors are warm.
    unasked,
    stale,    ///< not above the line to zero in 50 ms
    waiting,  ///< zero before the first wanted force in range; the causes below likewise
    over_speed,
    off,  ///< not above the line to zero in 50 ms
    shut_off,
    panic,
};
inline constexpr std::size_t safety_rules = 11;

/// Name of a rule, for messages.
const char* name(SafetyRule rule);

/// Checks each commanded force against all rules of safety.
class SafetyAudit {
public:
    SafetyAudit();

    /// Records one tick: the input of make_safe and its output, or the force that the device was told (N).
    void record(const SafetyLimits& limits, const SafetyInput& input, vec3 output);

    std::uint64_t violations() const;
    /// Ticks in which a rule was broken. A tick that breaks several rules counts for each.
    std::uint64_t violations(SafetyRule rule) const { return counts_[static_cast<std::size_t>(rule)]; }
    /// Number of ticks that were checked.
    std::uint64_t ticks() const { return now_; }
    /// Root of the mean square over the last 10 s (N); time before the start counts as zero.
    double warmth() const;

private:
    using Moment = std::uint64_t;  // tick number from 1; 0: never

    void count(SafetyRule rule, bool broken);
    void follow_latches(const SafetyLimits& limits, const SafetyInput& input);
    void follow_hand(const SafetyLimits& limits, const SafetyInput& input);
    void follow_ramp(const SafetyInput& input);
    SafetyLimits follow_cap(SafetyLimits limits);
    void judge_always(const SafetyLimits& limits, vec3 output);
    bool is_on_ramp(vec3 output) const;
    bool judge_stopped(const SafetyInput& input, vec3 output);
    void judge_following(const SafetyLimits& limits, const SafetyInput& input, vec3 output);
    bool is_cool(const SafetyLimits& limits) const;
    void begin_fade(const SafetyLimits& limits, const SafetyInput& input, vec3 goal, vec3 output, bool cool);
    double share_that_hides(vec3 goal) const;
    double steady_share(vec3 goal, const SafetyInput& input) const;
    void fade_on(const SafetyLimits& limits, vec3 goal, const SafetyInput& input, bool begins, bool goes_on);
    void heat(vec3 output);

    std::array<std::uint64_t, safety_rules> counts_{};
    Moment now_{};
    vec3 last_output_{};  // last output (N)

    bool panicked_{};
    bool shut_off_{};
    bool gate_open_{};
    Moment last_excess_{};
    std::array<Moment, 3> episodes_{};  // starts of the last three, the newest last
    Moment last_too_fast_{};            // last tick too fast; 0: no cut
    Moment last_felt_{};                // last tick with a fresh model and a player who wants forces
    vec3 ramp_start_{};                 // start of the ramp (N)
    double cap_{};                      // cap, or what is left above it of a higher one (N)

    bool next_is_switch_ = true;  // the next force let through is a switch; so is the first one
    bool may_be_fading_ = false;  // an offset may be left
    bool offset_known_ = true;    // `offset_` is known
    // The stage neither scales down to keep the motors cool nor recovers from that.
    bool unscaled_ = true;
    vec3 offset_{};            // rest of an old force that fades (N)
    vec3 remnant_{};           // output before the switch, shortened by what time took off the offset (N)
    vec3 tip_{};               // position of the tip (m)
    double initial_length_{};  // length of the offset at the switch (N)
    double fade_work_{};       // work of the offset (J)
    double fade_budget_{};     // work that it may do (J)
    Moment last_fading_{};     // last tick in which there may be an offset

    std::vector<double> squared_outputs_;  // squares of the output, a ring (N^2)
    double window_sum_{};                  // sum over the last 10 s (N^2)
    double memory_sum_{};                  // sum over the longest time that the stage may remember (N^2)
};

}  // namespace thaum::haptics
