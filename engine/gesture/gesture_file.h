// gesture/gesture_file.h: gestures as TOML files, one gesture a file.
//
//     version = 1
//     name = "circle"
//     [options]                      all optional, see GestureOptions
//     closed = true
//     rotation_degrees = 20
//     [[stroke]]                     one for each recorded stroke
//     t = [0, 0.01, ...]             s
//     x = [...]                      any unit, the same in all files
//     y = [...]
//     z = [...]                      optional
//     force = [...]                  optional
#pragma once
#include <filesystem>
#include <string>

#include "core/config.h"
#include "gesture/gesture.h"

namespace thaum::gesture {

inline constexpr std::int64_t gesture_file_version = 1;
inline constexpr std::size_t max_gesture_bytes = std::size_t{16} << 20U;

/// Describes why a stroke must not be written to the file of a gesture; empty if it may be.
std::string fault_of_stroke(Points stroke);

/// Reads a gesture. The error names file, line and fault, such as lists `t` and `x` of different lengths.
Expected<Gesture> read_gesture(const Config& config);
/// Reads the file of a gesture.
Expected<Gesture> load_gesture(const std::filesystem::path& path);

/// Text of a file from which the same gesture is read, bit for bit.
std::string to_file(const Gesture& gesture);

/// A text as a quoted TOML string.
std::string toml_string(std::string_view words);

}  // namespace thaum::gesture
