// input/pad_mapping.h: mappings of pads in the form of SDL's gamecontrollerdb.txt, which say which part of a joystick is
// which control of a pad:
//
//     03000000aabb00001122000001000000,Name of the model,a:b0,leftx:a0,dpup:h0.1,platform:Linux,
//
// SDL takes a mapping without a single control as well, and then shows a pad that does nothing. So lines of a file are
// checked here first.
#pragma once
#include <string>
#include <string_view>

#include "core/error.h"

namespace thaum::input {

struct PadMapping {
    std::string model{};     ///< 32 hexadecimal digits, small letters
    std::string words{};     ///< the line as SDL takes it
    bool for_linux = false;  ///< false: the line is for another system
};

/// Reads a line, whose blanks at both ends do not count. The error says what is wrong, without the place of the line.
Expected<PadMapping> read_pad_mapping(std::string_view line);

/// The words before the first comma: the model of the joysticks that a mapping is for.
std::string_view model_of_mapping(std::string_view mapping);

/// Whether two mappings have the same name and controls, whatever their models and other words.
bool same_pad_controls(std::string_view a, std::string_view b);

}  // namespace thaum::input
