// haptics/audit/safety_audit.h: an independent audit of the safety stage. It counts violations of its rules.
//
//     wanted ---- make_safe ---- output ---- device     (make_safe: safety stage, haptics/safety.h)
//        |                         |
//        +----- SafetyAudit -------+
//
// The audit checks the output against the rules of HAPTICS.md, "Safety". It shares no code with the stage and
// does not see the stage's state. It keeps tick numbers where the stage keeps counters, and the squared
// output of every tick of the last seconds where the stage keeps sums of many ticks. The rules leave one
// thing free: how the stage scales the force down when the mean square of the output over 10 s comes near its
// limit, the thermal budget. Only there the audit accepts any choice.
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
    /// The output is at most as long as the cap (largest allowed force), to the bit; it reaches a lowered cap
    /// over some ticks.
    cap,
    budget,  ///< the mean square of the output over exactly the last 10 s is at most the continuous force
             ///< squared
    /// The output does not jump at a switch (a source of force came, ended or jumped). After it, the output
    /// is the wanted force plus an offset that fades by time, by its own work and by the cap.
    slew,
    /// Without a switch (jump of the wanted force), the output is wanted force plus brake (the force that
    /// takes excess energy from the hand) in full, or parts of both while the motors are warm.
    unasked,
    /// Once the haptic model is too old, the output falls to zero within 50 ms, at least as fast as a
    /// straight line.
    stale,
    waiting,     ///< from the start until sources first want a force within the cap, the output is zero
    over_speed,  ///< the output is zero while the device's tip is too fast
    /// Once the player wants no forces, the output falls to zero within 50 ms, at least as fast as a straight
    /// line; it is zero at once if the tip is too fast.
    off,
    shut_off,  ///< after the wanted force was far too large for the third time, the output is zero
    panic,     ///< after a panic, the player's emergency stop, the output is zero
};
inline constexpr std::size_t safety_rules = 11;

/// Name of a rule, for messages.
const char* name(SafetyRule rule);

/// Checks each commanded force against all rules of safety.
class SafetyAudit {
public:
    SafetyAudit();

    /// Records and checks one tick: the input of make_safe and its output, or the force that was sent to the
    /// device (N).
    void record(const SafetyLimits& limits, const SafetyInput& input, vec3 output);

    std::uint64_t violations() const;
    /// Ticks in which a rule was broken. A tick that breaks several rules counts for each.
    std::uint64_t violations(SafetyRule rule) const { return counts_[static_cast<std::size_t>(rule)]; }
    /// Number of ticks that were checked.
    std::uint64_t ticks() const { return now_; }
    /// Root of the mean square of the output over the last 10 s, which measures how warm the motors are (N).
    /// Time before the start counts as zero output.
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
    vec3 last_output_{};  // force that the device got in the last tick (N)

    bool panicked_{};
    bool shut_off_{};
    bool gate_open_{};
    Moment last_excess_{};  // last tick in which the wanted force was far too large
    // Starts of the last three episodes of far too large wanted forces, the newest last.
    std::array<Moment, 3> episodes_{};
    Moment last_too_fast_{};  // last tick in which the tip was too fast; 0: the force is not cut
    Moment last_felt_{};      // last tick with a fresh haptic model and a player who wants forces
    vec3 ramp_start_{};       // output from which a ramp to zero starts (N)
    double cap_{};            // largest output: the cap, or a value that falls to a lowered cap (N)

    // True: the next force that is let through counts as a switch (a jump to be faded), as the very first one
    // does.
    bool next_is_switch_ = true;
    bool may_be_fading_ = false;  // make_safe may still be fading the offset that hides a jump of the force
    // True: `offset_` equals the offset in make_safe. False after make_safe scaled the force down because of
    // warm motors, since the audit does not know by how much.
    bool offset_known_ = true;
    // True: make_safe neither scales the force down to keep the motors cool nor is still raising it again
    // after that.
    bool unscaled_ = true;
    vec3 offset_{};  // force that make_safe adds to the wanted one after a jump, and fades (N)
    // Output before the jump of the wanted force, shortened by as much as time shortens the offset (N).
    vec3 remnant_{};
    vec3 tip_{};               // position of the tip (m)
    double initial_length_{};  // length of the offset that hides a jump, when its fade began (N)
    double fade_work_{};       // work of the fading offset on the hand since its fade began (J)
    double fade_budget_{};     // largest work that the fading offset may do on the hand (J)
    Moment last_fading_{};     // last tick in which make_safe may have added an offset that hides a jump

    std::vector<double> squared_outputs_;  // squared forces of the last 11 s, a ring buffer (N^2)
    double window_sum_{};                  // sum of the squared outputs of the last 10 s (N^2)
    // Sum of the squared outputs of the last 11 s, the longest time that make_safe may sum (N^2).
    double memory_sum_{};
};

}  // namespace thaum::haptics
