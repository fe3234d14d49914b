// input/locked_sticks.h: joysticks that are plugged in but whose device files this user may not read. SDL
// does not see them, so nothing else would tell the user why a pad does not work.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace thaum::input {

/// A joystick whose device file this user may not read.
struct LockedStick {
    std::string name{};
    std::string path{};
    bool operator==(const LockedStick&) const = default;
};

/// Finds joysticks that this user may not read, from Linux's lists of input devices. Takes less than a
/// millisecond.
std::vector<LockedStick> locked_sticks(const std::filesystem::path& system = "/sys/class/input",
                                       const std::filesystem::path& devices = "/dev/input");

}  // namespace thaum::input
