// The reference device that the haptic tests share.
#pragma once
#include "tests/scenes/z_width.h"

namespace thaum::haptics {

inline DeviceSpec reference_spec() { return bench::reference_device(0.5, 0); }

}  // namespace thaum::haptics
