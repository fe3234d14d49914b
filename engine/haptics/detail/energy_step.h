// haptics/detail/energy_step.h: updates of the servo's account of energy in one tick, before the safety stage
// and after it.
#pragma once
#include "haptics/detail/felt_patch.h"
#include "haptics/detail/sources.h"

namespace thaum::haptics {

/// Limits of the forces in this tick, from the account of the energy that sources gave the hand.
struct EnergyLimits {
    /// Damping force that takes out the energy which passive sources (springs, walls) gave in excess (N).
    vec3 brake{};
    /// Largest force that the springs may exert, from the energy that they may still give (N); infinite: no
    /// limit.
    double reserve_force{HUGE_VAL};
    double fade_energy{};  ///< work that the fading offset after a jump of the force may do (J)
    double change{};       ///< largest change of the output in a tick while an offset fades (N)
};

/// Updates the passivity observer, which sums the energy between hand and sources. Limits active sources,
/// which may push, to their energy budget. After a switch (a source of force came, ended or jumped), limits
/// the springs to the energy reserved for them.
EnergyLimits update_energy(const Servo& servo, ServoState& state, const HapticModel& model,
                           const Tether& tether, const Tip& tip, const SurfaceForces& surfaces,
                           const FluidForces& fluid, Sources& sources);

/// Records the force that the safety stage lets through (N), split into its passive and active parts. From it
/// the energy account computes the work of this tick once the tip has moved.
void record_force(ServoState& state, vec3 output, const Sources& sources);

}  // namespace thaum::haptics
