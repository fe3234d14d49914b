// input/pad_state.h: what game pads and other joysticks say at a moment (input/pads.h reads it).
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
    std::string name{};  ///< for people: "X360 Controller"
    std::string
        path{};  ///< its device file, such as "/dev/input/event3"; another one may follow when it comes back
    /// Sticks -1..1, right and up positive; triggers 0..1; indices as in PadAxis.
    std::array<double, pad_axes> axes{};
    std::uint32_t buttons{};  ///< bit i is PadButton i
};

/// The pads that can play. A pad keeps its index, also when it is unplugged and comes back (detail/pad_places.h).
using Pads = std::array<PadState, 4>;

/// What a joystick without a layout says: its parts have numbers only.
struct StickState {
    std::vector<std::int16_t> axes{};
    std::vector<bool> buttons{};
    std::vector<std::uint8_t> hats{};  ///< sums of 1 up, 2 right, 4 down, 8 left
    bool operator==(const StickState&) const = default;
};

/// A joystick that is no pad, because nothing says which of its buttons is which.
struct Stick {
    std::string name{};
    std::string path{};
    std::string guid{};  ///< identification of the model in mappings: 32 hexadecimal digits
    StickState state{};
    bool operator==(const Stick&) const = default;
};

}  // namespace thaum::input
