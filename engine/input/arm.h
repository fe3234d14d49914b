// input/arm.h: measurements, forces and facts that pass between a force feedback arm and its user. The user
// gives a function, which the arm's servo thread calls once a tick with a measurement, and which returns the
// force.
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
    bool usable{true};        ///< false: the device gave no numbers
};

/// Step of each tick. It takes no lock, allocates nothing and opens no file. Returns the force (N, device frame).
struct ArmTick {
    vec3 (*step)(void* context, const ArmReading& reading){};
    void* context{};
};

/// Facts about an open arm. An arm that pushes in three degrees of freedom gets forces and no torques, however
/// many degrees it measures.
struct ArmFacts {
    haptics::DeviceSpec spec{};  ///< unknown numbers are zero, such as mass, friction and quantum
    std::string serial{};
    std::string driver{};  ///< version of the vendor's library
    std::string family{};  ///< word for any arm of its class, such as "phantom"; empty: none
};

/// Model and serial number: "Touch F0000001".
std::string name_of(const ArmFacts& facts);
/// Edges of the arm's workspace, as in DeviceSpec::box_um; zero if unknown.
std::array<std::uint32_t, 3> box_um(const ArmFacts& facts);
/// Whether `word` means this arm: "arm" for any, or its family, model, serial number, or the latter two, in any case.
bool is_called(const ArmFacts& facts, std::string_view word);

enum class ArmPresence : std::uint8_t {
    present,
    lost,   ///< the arm does not answer, or its ticks have stopped
    fault,  ///< the arm reports a fault
};

struct ArmStatus {
    ArmPresence state{};
    std::string text{};        ///< one line: what is wrong, then what to do; empty while present
    std::int64_t newest_ns{};  ///< time of the newest measurement (ns, monotonic clock); 0: none yet
};

/// First sentence of the text, for the player's view: "The arm's motors are too warm: let them rest". Empty
/// while present.
std::string caption_of(const ArmStatus& status);

/// A finite value in whole units, limited to 1e9 of them.
std::int32_t quantised(double value);

/// Axis times angle (rad, at most pi) of a rotation matrix.
vec3 rotation_vector(const mat3& rotation);

}  // namespace thaum::input
