// input/pad_mapping.h: mappings of pads in the form of SDL's gamecontrollerdb.txt, which say which part of a
// joystick is which control of a pad:
//
//     03000000aabb00001122000001000000,Name of the model,a:b0,leftx:a0,dpup:h0.1,platform:Linux,
//
// SDL also accepts a mapping without any control, and then reports a pad that does nothing. So lines of a
// file are checked here first.
#pragma once
#include <string>
#include <string_view>

#include "core/error.h"

namespace thaum::input {

/// One mapping: which part of a model of joysticks is which control of a pad.
struct PadMapping {
    std::string model{};     ///< the joystick's model: 32 hexadecimal digits in lower case
    std::string words{};     ///< the line in the form that SDL reads
    bool for_linux = false;  ///< false: the line is for another system
};

/// Reads a line; blanks at its ends are ignored. The error says what is wrong, without naming the line.
Expected<PadMapping> read_pad_mapping(std::string_view line);

/// The text before the first comma: the model of joysticks to which a mapping applies.
std::string_view model_of_mapping(std::string_view mapping);

/// Whether two mappings have the same name and controls, whatever their models and other fields.
bool same_pad_controls(std::string_view a, std::string_view b);

}  // namespace thaum::input
