// haptics/detail/energy_step.h: updates of the servo's account of energy in one tick, before the safety stage
// and after it.
#pragma once
#include "haptics/detail/felt_patch.h"
#include "haptics/detail/sources.h"

namespace thaum::haptics {

/// Limits that the energy account sets for this tick.
struct EnergyLimits {
    vec3 brake{};  ///< damping force that keeps passive sources passive (N)
    double reserve_force{
        HUGE_VAL};         ///< largest force of the springs by their reserve (N); infinite: no limit
    double fade_energy{};  ///< work that the fading offset after a jump of the force may do (J)
    double change{};       ///< largest change of the output while an offset fades (N, SafetyInput::change)
};

/// Updates the passivity observer. Limits active sources to their budget. Limits the springs to their reserve
/// after a switch, that is, after a source of force came, ended or jumped.
EnergyLimits update_energy(const Servo& servo, ServoState& state, const HapticModel& model,
                           const Tether& tether, const Tip& tip, const SurfaceForces& surfaces,
                           const FluidForces& fluid, Sources& sources);

/// Records the force that the safety stage lets through (N), split into its passive and active parts.
void record_force(ServoState& state, vec3 output, const Sources& sources);

}  // namespace thaum::haptics
