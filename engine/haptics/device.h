// haptics/device.h: specification of a force feedback device. The models are files in assets/devices.
//
// Device frame: +x right, +y up, +z towards the user, origin in the middle of the workspace.
#pragma once
#include <string>

#include "core/config.h"

namespace thaum::haptics {

/// Largest delay from a measured position to its force that a device may have (ticks).
inline constexpr int max_latency = 8;

/// Abilities and physical properties of a force feedback device.
struct DeviceSpec {
    std::string name{};
    int sensed{};               ///< measured degrees of freedom: 3, 6 or 7 (the seventh is a gripper)
    int actuated{};             ///< driven degrees of freedom, at most `sensed`; 3: forces without torques
    double peak_force{};        ///< largest length of the force vector (N)
    double continuous_force{};  ///< force that the motors can hold without overheating (N); 0: unknown
    double max_stiffness{};     ///< largest stiffness that the device renders stably at its rate (N/m)
    double max_damping{};       ///< largest damping that the device renders stably at its rate (N s/m)
    vec3 workspace{};           ///< edges of the reachable box (m, device frame)
    double position_quantum{};  ///< motion of the tip per encoder count (m); 0: exact measurement
    double mass{};              ///< apparent mass at the tip (kg)
    double damping{};           ///< viscous damping at the tip (N s/m)
    double coulomb_friction{};  ///< dry friction on each axis (N)
    double update_rate{};       ///< rate at which the device measures and gets forces (Hz)
    /// Delay from a measured position to the force computed from it (ticks); 0:
    /// the force acts in the same tick.
    int latency{};
};

/// Reads a device's specification from its file. An error names file, line and key, and says what is unknown,
/// missing, out of range or contradictory.
Expected<DeviceSpec> read_device(const Config& file);

}  // namespace thaum::haptics
