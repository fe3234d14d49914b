// input/arm.h: measurements, forces and facts that pass between a force feedback arm and its user. The user
// of an arm passes a function, which the arm's servo thread calls once a tick. It gets a measurement and
// returns the force.
//
// A driver quantises its measurements before anything else sees them (1 um, 1 urad), so the integers of a log
// are exact.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/maths.h"
#include "haptics/device.h"

namespace thaum::input {

/// Measurement of one tick, in the device frame (+x right, +y up, +z towards the user).
struct ArmReading {
    std::int64_t time_ns{};                     ///< time of the measurement (ns, monotonic clock)
    std::array<std::int32_t, 3> position_um{};  ///< position of the tip (um)
    /// Rotation of the stylus: axis times angle, at most half a turn (urad).
    std::array<std::int32_t, 3> rotation_urad{};
    std::uint32_t buttons{};  ///< bit i: the arm's button i is down
    bool usable{true};        ///< false: the device returned values that are not numbers
};

/// Function that the arm's servo thread calls in each tick. It must take no lock, allocate nothing and open
/// no file. It returns the force (N, device frame).
struct ArmTick {
    vec3 (*step)(void* context, const ArmReading& reading){};
    void* context{};
};

/// Facts about an open arm. An arm that can push in three degrees of freedom gets forces and no torques, even
/// if it measures six.
struct ArmFacts {
    /// Properties of the device. Those that are unknown, such as mass, friction or the smallest measured
    /// motion, are zero.
    haptics::DeviceSpec spec{};
    std::string serial{};
    std::string driver{};  ///< version of the vendor's library
    std::string family{};  ///< word for any arm of this family, such as "phantom"; empty: none
};

/// Model and serial number, such as "Touch F0000001".
std::string name_of(const ArmFacts& facts);
/// Lengths of the edges of the box that the arm reports as its workspace (um); zero if unknown.
std::array<std::uint32_t, 3> box_um(const ArmFacts& facts);
/// Whether `word` names this arm: "arm" names any arm; otherwise its family, model, serial number, or model
/// and serial number, in upper or lower case.
bool is_called(const ArmFacts& facts, std::string_view word);

/// Whether an arm works.
enum class ArmPresence : std::uint8_t {
    present,
    lost,   ///< the arm does not answer, or its ticks have stopped
    fault,  ///< the arm reports a fault of its own, such as hot motors
};

/// State of an arm, for the user.
struct ArmStatus {
    ArmPresence state{};
    std::string text{};        ///< one line: what is wrong, then what to do; empty while the arm is present
    std::int64_t newest_ns{};  ///< time of the newest measurement (ns, monotonic clock); 0: none yet
};

/// First sentence of the text, for display in the player's view: "The arm's motors are too warm: let them
/// rest". Empty while the arm is present.
std::string caption_of(const ArmStatus& status);

/// A value rounded to whole units, limited to 1e9 units in size; the value must be finite.
std::int32_t quantised(double value);

/// Axis times angle (rad, at most pi) of a rotation matrix.
vec3 rotation_vector(const mat3& rotation);

}  // namespace thaum::input
