// game/scenario/script_arm.h: a real arm that a script moves: what its thread would do, a step at a time, in the same thread as
// the match. The hand goes where it is told to, however hard it is pulled.
#pragma once
#include <array>
#include <memory>

#include "game/match/simulation.h"
#include "input/arm_servo.h"

namespace thaum::game {

struct ScriptArm {
    input::ArmServo servo{};
    std::uint32_t device{};  ///< place in the frame
    std::int64_t time_ns{};
    vec3 at{}, to{};  ///< m, device frame: the hand, and where it goes
    double step{};    ///< m, of a tick; 0: it is there at once
    vec3 told{};      ///< N, in its last tick
};
using ScriptArms = std::array<std::unique_ptr<ScriptArm>, players>;

/// One tick of each arm's thread.
void step_arms(ScriptArms& arms);
/// The next sample of each, as the match is to take it.
void take_samples(ScriptArms& arms, input::InputFrame& frame);
/// What the match has published for them.
void publish_orders(const Simulation& match, ScriptArms& arms);
/// Forces that the match computed otherwise than the arms' threads had: there may be none.
std::uint64_t differing_forces(const ScriptArms& arms);

}  // namespace thaum::game
