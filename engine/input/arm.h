// input/arm.h: the door between the driver of a force feedback arm and whoever moves it: a function that the driver calls at
// each tick of the device, in the device's own thread, with what was measured, and that returns the force.
//
// A driver quantises what it reads before anything sees it (1 um, 1 urad), so that the integers of a log are the truth.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/maths.h"
#include "haptics/device.h"

namespace thaum::input {

/// One tick's measurement, device frame (+x right, +y up, +z towards the user).
struct ArmReading {
    std::int64_t time_ns{};                       ///< when it was made; monotonic clock
    std::array<std::int32_t, 3> position_um{};    ///< of the tip
    std::array<std::int32_t, 3> rotation_urad{};  ///< of the stylus: axis times angle, at most half a turn
    std::uint32_t buttons{};                      ///< bit i: the arm's button i is down
    bool usable{true};                            ///< false: what the device said is no number
};

/// What is done at each tick: takes no lock, allocates nothing, opens no file. Returns the force, N, device frame.
struct ArmTick {
    vec3 (*step)(void* context, const ArmReading& reading){};
    void* context{};
};

/// What an arm says of itself. One that pushes in three degrees of freedom gets forces and no torques, however many it measures.
struct ArmFacts {
    haptics::DeviceSpec spec{};  ///< what it does not tell is zero: mass, friction, quantum
    std::string serial{};
    std::string driver{};  ///< version of the vendor's library
};

/// What people call it: "Touch F0000001".
std::string name_of(const ArmFacts& facts);
/// The box that it says it reaches, as DeviceSpec::box_um; zero where it says none.
std::array<std::uint32_t, 3> box_um(const ArmFacts& facts);
/// Whether `word` means this arm: its model, its serial number or both, whatever the case, or "phantom" for any of the class.
bool is_called(const ArmFacts& facts, std::string_view word);

enum class ArmPresence : std::uint8_t {
    present,
    lost,   ///< it does not answer, or its ticks have stopped
    fault,  ///< it answers that something is wrong
};

struct ArmStatus {
    ArmPresence state{};
    std::string text{};        ///< one line: what is wrong and what to do; empty while present
    std::int64_t newest_ns{};  ///< when it was measured last; monotonic clock; 0: not yet
};

/// The first sentence of its text, for whoever holds the arm: "The arm's motors are too warm: let them rest". Empty while present.
std::string caption_of(const ArmStatus& status);

/// To whole units, at most 1e9 of them either way. The value is finite.
std::int32_t quantised(double value);

/// Axis times angle (rad, at most pi) of a rotation matrix.
vec3 rotation_vector(const mat3& rotation);

}  // namespace thaum::input
