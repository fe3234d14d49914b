// unit/omni_like.h: a device with the forces of an Omni, for tests of the safety stage (which limits forces)
// and of its audit.
#pragma once
#include "haptics/device.h"

namespace thaum::haptics {

inline DeviceSpec omni_like() {
    DeviceSpec spec;
    spec.peak_force = 3.3;
    spec.continuous_force = 0.88;
    return spec;
}

}  // namespace thaum::haptics
