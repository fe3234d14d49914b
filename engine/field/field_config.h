// field/field_config.h: transfer functions and filters as data files hold them.
//
//     strength = [0, 0, 60, 0.7]     x, y, x, y, ... of a transfer function, in the order of x
//     [[mode.filter]]
//     kind = "smooth"                a name of filter_names()
//     a = 1.0                        its parameters, 0 if left out
//     b = 0.0
#pragma once
#include <string_view>
#include <vector>

#include "core/config.h"
#include "field/filters.h"
#include "field/transfer.h"

namespace thaum::field {

/// Reads the points of a transfer function, each coordinate within the range. If there is a fault, it is
/// reported at the key, and the function is 0 everywhere.
TransferFunction read_transfer(const ConfigTable& table, std::string_view key, Range range,
                               const std::vector<double>& fallback);

/// Reads a filter of fields. A parameter outside the range is reported as a fault.
Filter read_filter(const ConfigTable& table, Range range);

}  // namespace thaum::field
