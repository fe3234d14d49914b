// haptics/device.h: what a force feedback device is and can do; its models are files in assets/devices.
//
// Device frame: +x right, +y up, +z towards the user, origin in the middle of the workspace.
#pragma once
#include <string>

#include "core/config.h"

namespace thaum::haptics {

/// The longest delay a model may have, in ticks.
inline constexpr int most_latency = 8;

struct DeviceSpec {
    std::string name{};
    int sensed{};  ///< degrees of freedom that it measures: 3, 6 or 7 (the seventh is a gripper)
    int actuated{};  ///< degrees of freedom in which it pushes, not more than it measures; 3: forces, no torques
    double peak_force{};        ///< N, length of the vector
    double continuous_force{};  ///< N, which it can hold without getting too hot
    double max_stiffness{};     ///< N/m that it can render in closed loop at its rate
    double max_damping{};       ///< N s/m, likewise
    vec3 workspace{};           ///< m, the edges of the box
    double position_quantum{};  ///< m, one encoder count at the tip; 0: it measures exactly
    double mass{};              ///< kg, apparent at the tip
    double damping{};           ///< N s/m, viscous
    double coulomb_friction{};  ///< N, dry friction on each axis
    double update_rate{};       ///< Hz
    int latency{};  ///< ticks from a position read to the force computed from it, beyond the same tick
};

/// A whole device file; the error names file, line and key: what is unknown, missing, out of range or contradicts itself.
Expected<DeviceSpec> read_device(const Config& file);

}  // namespace thaum::haptics
