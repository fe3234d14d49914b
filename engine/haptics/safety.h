// haptics/safety.h: the safety stage, the last one before every device, always on (HAPTICS.md,
// "Safety").
//
// The device gets a finite force of at most the cap, the largest allowed force. At a switch (a source of
// force comes, ends or jumps) the force changes slowly. It never heats the motors too much. It is zero if the
// haptic model is stale, the hand is too fast, the player wants no forces, or the panic key was pressed. The
// stage does not change the force in the world: a player with a low cap lifts as much.
//
// Forces that the player switches off ramp to zero in `ramp_seconds`, like those of a stale model, and
// a cap that is lowered comes down by `cap_slew`. Only danger (panic, shut-off, a hand that is too
// fast) makes the force zero at once.
//
// A switch makes no jump: output = wanted + offset. The offset starts as the last output minus the first
// wanted force, and fades to zero. Four things shorten it, and nothing lengthens it:
//   - time: by `slew`, so that the fade ends after 2 cap / slew at the latest; ten times as fast when other
//     switches have used up the energy of a switch;
//   - work: the offset may do the work `switch_energy` on the hand and no more, so it fades if the hand
//     yields;
//   - the cap: if the sum of wanted force and offset exceeds it;
//   - the wanted force that it hides: the offset leads from the wanted force to what is left of the force
//     before the switch. An offset that cancels the force of a wall ends with that force when the wall
//     breaks.
// But in a tick the sum of wanted force and offset changes by no more than a spring of the device's stiffness
// and `SafetyInput::change` together would change it. If a spring already yields to the hand, an offset that
// would yield too has to wait: only its fade by `slew` goes on.
//
// The wanted force itself is never delayed. A passive source therefore stays passive while the offset fades.
// An offset that only shrinks returns no more energy than it was given. So the whole switch creates at most
// `switch_energy`.
//
// A pure function of its arguments; no allocation, no clock. Time is counted in ticks.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/maths.h"
#include "core/units.h"
#include "haptics/device.h"

namespace thaum::haptics {

/// Constants of the safety stage, which limits the force for the device.
struct SafetyLimits {
    /// Largest length of the output: the smaller of the device's peak and the player's own cap (N).
    double cap{};
    /// Largest force that a correct source asks for (N); asking for more repeatedly shuts the device off.
    double excess{};
    /// Largest force that a correct tether, a spring that the world may stretch far, asks for (N).
    double spring_excess{};
    double continuous{};  ///< largest root mean square of the output over 10 s that keeps the motors cool (N)
    double slew{};        ///< rate at which the offset that hides a jump of the force fades (N/s)
    /// Speed of the tip beyond which the force is cut until the hand is slow again (m/s).
    double max_speed{};
};

inline constexpr double gentle_share = 0.45;  ///< default cap (largest force) as a share of the device's peak
inline constexpr double thermal_window = 10;  ///< time over which the motors' heat is averaged (s)
/// Age up to which a haptic model counts as fresh, so that the device gets its full force (ticks).
inline constexpr std::uint32_t freshest_ticks = 20;
/// Largest work on the hand by the offsets that hide jumps of the force (J).
inline constexpr double switch_energy = 0.01;
/// Time in which the force ramps to zero if the haptic model is stale or the player wants no forces (s).
inline constexpr double ramp_seconds = 0.05;
/// Rate at which the output falls to a cap that was lowered, and at which an offset fades that may do no more
/// work (N/s): 12 N in 30 ms, and less than 0.5 N a tick.
inline constexpr double cap_slew = 400;

/// Largest change of the output in a tick at a switch (N), beyond that of a spring with the device's largest
/// stiffness on the way that the tip has moved.
inline constexpr double steady_change = 0.49;

/// Limits for a device. `share` is the player's cap as a share of the device's peak, 0 to 1.
SafetyLimits safety_limits(const DeviceSpec& spec, double share);

/// Returns the limits with another cap (largest output): the device's peak times `share`, 0 to 1.
SafetyLimits with_share(SafetyLimits limits, double share);

/// Reason why the device gets less force than was asked for. If there are several, it is the last one in this
/// order. The screen shows a caption for each.
enum class SafetyCause : std::uint32_t {
    none,
    capped,      ///< clipped to the cap, the largest allowed force
    warm,        ///< scaled down to keep the motors cool
    waiting,     ///< start gate: no output before sources first want a force within the cap
    stale,       ///< no fresh model: the force ramps to zero or is zero
    over_speed,  ///< the hand was too fast: the force is zero until it is slow
    off,         ///< the player wants no forces
    /// Sources repeatedly wanted more than SafetyLimits::excess: no force until the player asks for forces
    /// again.
    shut_off,
    panic,  ///< the panic key was pressed: no force until the player asks for forces again
};

inline constexpr std::array<std::string_view, 9> safety_cause_names{
    "none", "capped", "warm", "waiting", "stale", "over_speed", "off", "shut_off", "panic"};

/// Number of bins of half a second in which the squared force is summed as heat: those of the window of 10 s,
/// the bin being filled, and one that is older than the window and counts less and less. Without the last
/// one, the force would jump up when half a second of heat is forgotten.
inline constexpr std::size_t thermal_bins = 22;

/// Progress of the fade after a switch, a jump of the wanted force.
enum class Fade : std::uint32_t {
    over,     ///< nothing fades: the output is the wanted force
    running,  ///< an offset that hides a jump is still fading
    begins,   ///< the next force that is let through starts from the last output
};

/// State of the safety stage; no padding.
struct SafetyState {
    vec3 output{};            ///< output of the last tick (N)
    vec3 offset{};            ///< what is left of the offset that hides the last jump (N)
    vec3 active_offset{};     ///< part of `offset` by sources that may push (N)
    vec3 unrequested{};       ///< part of the output that no source asked for in its tick (N)
    vec3 tip{};               ///< measured position at the last tick (m)
    double initial_offset{};  ///< length of the fading offset when it began (N)
    double fade_work{};       ///< work of the fading offset on the hand so far (J)
    double fade_budget{};     ///< largest work of the fading offset on the hand (J)
    double cap{};             ///< largest allowed force now; it falls to a lowered one slowly (N)
    std::array<double, thermal_bins> heat{};  ///< integral of the squared output, a ring of bins (N^2 s)
    std::uint32_t tick{};        ///< number of ticks so far in that bin of `heat` which is being filled
    std::uint32_t bin{};         ///< index of the bin of `heat` that is being filled
    std::uint32_t gate_open{};   ///< 1 once a wanted force was within the cap; until then no output
    std::uint32_t fade{};        ///< progress of a fade, a value of Fade
    std::uint32_t fast_ticks{};  ///< ticks of slow motion left until an over-speed cut ends
    std::uint32_t latched{};     ///< why the force stays zero: SafetyCause shut_off or panic; 0: it does not
    std::uint32_t excess_ticks{};  ///< ticks left until more excess would count as a new episode
    /// Number of recent episodes of excess (far too large wanted force), at most two.
    std::uint32_t excess_count{};
    std::uint32_t cause{};  ///< why the last output was less than wanted, a SafetyCause
    /// Ticks without a fresh model or without the player's wish for forces, up to the end of the ramp.
    std::uint32_t ramp_ticks{};
    /// Ticks since each recent episode of excess began, the older one first.
    std::array<std::uint32_t, 2> episodes{};
    /// Output of the tick before the switch, shortened since then by as much as time shortens the offset (N).
    /// The offset may lead from the wanted force to this force, and no farther.
    vec3 remnant{};
    double heat_limit{};  ///< limit by heat in the last tick, if it held the force back (N); 0: it did not
};
static_assert(sizeof(SafetyState) == (23 + thermal_bins) * sizeof(double) + 12 * sizeof(std::uint32_t));

/// Input of the safety stage in one tick.
struct SafetyInput {
    vec3 wanted{};  ///< force asked for by all sources (N, device frame)
    /// Part of `wanted` by the tether, a spring whose other end the world holds and may pull far away (N).
    vec3 spring{};
    /// Damping force that takes excess energy out of the hand (N, passivity controller). It is added to
    /// `wanted` after `wanted` was cut to the cap.
    vec3 brake{};
    /// Part of `wanted` by active sources (those that may push the hand), and their part of the last output
    /// (N).
    vec3 active{}, last_active{};
    vec3 tip{};       ///< measured position (m, device frame)
    vec3 velocity{};  ///< measured velocity of the tip (m/s)
    /// Speed along the tip's path; a tip that vibrates in place is fast too (m/s).
    double path_speed{};
    /// Largest force of springs, by the energy that they may still give after a switch (N). It limits a ramp
    /// to zero too. Infinite: the springs are not held back.
    double reserve_force{HUGE_VAL};
    /// Work that the offsets which hide jumps may still do on the hand (J); less than `switch_energy` soon
    /// after other switches.
    double fade_energy{switch_energy};
    /// Largest stiffness of the device (N/m). A fading offset and the wanted force together change no faster
    /// than a spring of this stiffness and `change`. 0: no limit.
    double stiffness{};
    /// Largest change of the output in a tick while an offset fades (N). The change that a spring of
    /// `stiffness` makes as the tip moves is allowed in addition.
    double change{steady_change};
    std::uint32_t model_age{};  ///< ticks since the haptic model was made
    bool switched{};            ///< a source of force appeared, ended or jumped
    /// True: the sources' forces still jump after a switch, and the offset hides their jump in this tick.
    bool settles{};
    bool on{true};  ///< the player wants forces
    bool panic{};   ///< a panic key is down
    bool rearm{};   ///< the player asks for forces again after a panic or shut-off
};

/// Returns the force for the device (N). `state.cause` says why it is less than the wanted force.
vec3 make_safe(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input);

}  // namespace thaum::haptics
