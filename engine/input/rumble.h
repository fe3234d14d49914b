// input/rumble.h: the two motors of a game pad, by Linux's force feedback (evdev).
//
// The left actuator of the layout `pad` runs the strong motor, which sits in the left hand, and the right one the weak
// motor. The motors take no carrier frequency. Each effect ends by itself after the frame's time to live, and the
// system ends it when the program does, so no motor stays on.
//
// A window knows a pad without its path in /dev/input. So we look for it by model and name. Pads that are equal in both
// are taken in the order of their paths, as GLFW numbers them at its start. GLFW and Linux both give a pad that comes
// back the lowest free number, so the order usually stays right. If equal pads have been pulled and put back, their
// rumble may be exchanged; an unplugged pad's never goes to another model.
#pragma once
#include <cstddef>
#include <memory>

#include "input/tactile_output.h"

namespace thaum::input {

/// A pad as the window knows it.
struct PadId {
    std::string guid{};  ///< identification of the model, as GLFW and SDL write it: 32 hexadecimal digits
    std::string name{};  ///< name that the system's driver gives the pad
    std::size_t equal_one{};  ///< number of the pad among the plugged ones with the same guid and name
    bool operator==(const PadId&) const = default;
};

/// The motors of a pad. Nothing is opened yet.
std::unique_ptr<TactileOutput> rumble_output(const PadId& pad);

}  // namespace thaum::input
