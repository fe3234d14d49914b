// game/scenario/script_arm.h: a simulated arm of a real device, moved by a script. The work of the device's
// thread is done step by step in the match's own thread. The hand follows the script's path exactly, whatever
// force acts on it.
#pragma once
#include <array>
#include <memory>

#include "core/maths.h"
#include "game/components/wizard.h"
#include "input/arm_servo.h"
#include "input/frame.h"

namespace thaum::game::inline scenario {

struct ScriptArm {
    input::ArmServo servo{};
    std::uint32_t device{};  ///< index of the device in the input frame
    std::int64_t time_ns{};
    vec3 at{}, to{};  ///< position and target of the hand (m, device frame)
    double step{};    ///< distance moved per tick (m); 0: the hand jumps to the target
    vec3 told{};      ///< force that the arm's thread has computed in the last tick (N)
};
using ScriptArms = std::array<std::unique_ptr<ScriptArm>, players>;

/// Runs one tick of each arm's thread.
void step_arms(ScriptArms& arms);
/// Puts the next sample of each arm into the input frame.
void take_samples(ScriptArms& arms, input::InputFrame& frame);
/// Number of ticks in which the match computed another force than the arm's thread. It must be 0.
std::uint64_t differing_forces(const ScriptArms& arms);

}  // namespace thaum::game::inline scenario
