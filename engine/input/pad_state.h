// input/pad_state.h: states of game pads and other joysticks at one moment, as input/pads.h reads them.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "input/bindings.h"

namespace thaum::input {

/// A game pad in the layout of an Xbox pad; all zero if there is none.
struct PadState {
    bool present = false;
    std::string name{};  ///< name for people, such as "X360 Controller"
    /// The pad's device file, such as "/dev/input/event3". It may change when the pad is plugged in again.
    std::string path{};
    /// Sticks -1..1, right and up positive; triggers 0..1; indices as in PadAxis.
    std::array<double, pad_axes> axes{};
    std::uint32_t buttons{};  ///< bit i is PadButton i
};

/// The pads that can play. A pad keeps its index, also when it is unplugged and
/// comes back (detail/pad_places.h).
using Pads = std::array<PadState, 4>;

/// State of a joystick without a layout: its parts are only numbered.
struct StickState {
    std::vector<std::int16_t> axes{};
    std::vector<bool> buttons{};
    std::vector<std::uint8_t> hats{};  ///< position of each hat: sum of 1 up, 2 right, 4 down, 8 left
    bool operator==(const StickState&) const = default;
};

/// A joystick that cannot be used as a pad, because no mapping says which of its buttons is which.
struct Stick {
    std::string name{};
    std::string path{};
    std::string guid{};  ///< identifies the model in mappings: 32 hexadecimal digits
    StickState state{};
    bool operator==(const Stick&) const = default;
};

}  // namespace thaum::input
