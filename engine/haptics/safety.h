// haptics/safety.h: the last stage before a device, for every device, always on (haptics.md, "Safety stage").
//
// Whatever the stages before it ask for, the device gets a finite force of at most the cap, that changes slowly where a source is
// switched, keeps the motors cool, and is zero when the model is stale, the hand too fast, the player wants none, or the
// panic key was pressed. The force in the world is not its business: a gentle player lifts as much.
//
// A switch makes no jump: output = wanted + offset, where the offset begins as the last output less the first wanted force and fades to
// zero. Three things shorten it, and nothing lengthens it:
//   - time: by `slew`, so that it is over after 2 cap / slew at the latest;
//   - work: the offset may give the hand `switch_energy` and no more, so a hand that yields to it is let go of;
//   - the cap: where wanted force and offset together are beyond it.
// The wanted force itself is never delayed. So a passive source stays passive while the offset fades, and since an offset that can only
// shrink gives back no more than it was given, the switch as a whole creates at most `switch_energy`.
//
// One pure function of its arguments; no allocation, no clock: time is counted in ticks.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/maths.h"
#include "core/units.h"
#include "haptics/device.h"

namespace thaum::haptics {

/// What no tick changes.
struct SafetyLimits {
    double cap{};     ///< N, length of the vector: the smaller of the device's peak and the player's own cap
    double excess{};  ///< N: what nothing sane asks for; to ask for it repeatedly shuts the device off
    double spring_excess{};  ///< N: the same of a spring that the world stretches
    double continuous{};     ///< N: the root of the mean square over any thermal_window stays below
    double slew{};           ///< rate at which the offset of a switch fades (N/s)
    double max_speed{};      ///< m/s, of the tip: beyond, nothing is felt until the hand is slow again
};

inline constexpr double gentle_share = 0.45;         ///< of the device's peak: the cap of who chose nothing
inline constexpr double thermal_window = 10;         ///< s
inline constexpr std::uint32_t freshest_ticks = 20;  ///< a model of at most this age is as good as new
inline constexpr double switch_energy = 0.01;  ///< work that the offset of one switch may do on the hand (J)

/// share: the player's cap as a part of the device's peak, 0 to 1.
SafetyLimits safety_limits(const DeviceSpec& spec, double share);

/// Why the device gets less than was asked for; the gravest, in this order. Each has a caption on the screen.
enum class SafetyCause : std::uint32_t {
    none,
    capped,      ///< clipped to the cap
    warm,        ///< scaled down to keep the motors cool
    waiting,     ///< start gate: no output before the first wanted force in range
    stale,       ///< no fresh model: ramping to zero, or there
    over_speed,  ///< cut out until the hand is slow
    off,         ///< the player wants no forces
    shut_off,    ///< repeated excess: until re-armed
    panic,       ///< until re-armed
};

inline constexpr std::array<std::string_view, 9> safety_cause_names{
    "none", "capped", "warm", "waiting", "stale", "over_speed", "off", "shut_off", "panic"};

/// Of half a second each: the window, one that fills, and one that has left the window and fades, so that the force does not
/// jump up where half a second of heat is forgotten.
inline constexpr std::size_t thermal_bins = 22;

/// Progress of a switch.
enum class Fade : std::uint32_t {
    over,     ///< the output is what is wanted
    running,  ///< an offset is left
    begins,   ///< the next force that is let through begins at the last output
};

/// All that a tick leaves behind; no padding.
struct SafetyState {
    vec3 output{};                            ///< N, of the last tick
    vec3 offset{};                            ///< fading remainder of the last switch (N)
    vec3 unrequested{};                       ///< part of the output that no source wanted in its tick (N)
    vec3 tip{};                               ///< measured position at the last tick (m)
    double initial_offset{};                  ///< length of the offset when it began (N)
    double fade_work{};                       ///< work of the offset on the hand since it began (J)
    std::array<double, thermal_bins> heat{};  ///< N^2 s, of the output, in a ring of bins
    std::uint32_t tick{};                     ///< in the bin that fills
    std::uint32_t bin{};                      ///< that fills
    std::uint32_t gate_open{};                ///< 1 once a wanted force was in range
    std::uint32_t fade{};                     ///< Fade
    std::uint32_t fast_ticks{};               ///< left before an over-speed cut-out may end
    std::uint32_t latched{};                  ///< SafetyCause shut_off or panic; 0
    std::uint32_t excess_ticks{};             ///< left before excess begins another episode
    std::uint32_t excess_count{};             ///< episodes of it that still count, at most two
    std::uint32_t cause{};                    ///< SafetyCause of the last tick
    std::uint32_t stale_ticks{};              ///< without a fresh model, up to the end of the ramp
    std::array<std::uint32_t, 2> episodes{};  ///< ticks since they began, the older one first
};
static_assert(sizeof(SafetyState) == (14 + thermal_bins) * sizeof(double) + 12 * sizeof(std::uint32_t));

/// One tick.
struct SafetyInput {
    vec3 wanted{};  ///< N, device frame
    vec3
        spring{};  ///< N, what of that is of a spring whose other end the world holds: it may be stretched far
    vec3 brake{};  ///< damping of the passivity controller, beyond `wanted`: the cap cuts the rest first (N)
    vec3 tip{};    ///< measured position (m, device frame)
    vec3 velocity{};            ///< m/s, of the tip as measured
    double path_speed{};        ///< m/s, along its path: one that is back where it was has moved all the same
    std::uint32_t model_age{};  ///< ticks since the model was made
    bool switched{};            ///< a source came or went, or the model jumped
    bool on{true};              ///< the player wants forces
    bool panic{};               ///< somebody's panic key is down
    bool rearm{};               ///< the player asks for forces again after a panic or shut-off
};

/// What the device is to be told, N. Why, if it is less: state.cause.
vec3 make_safe(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input);

}  // namespace thaum::haptics
