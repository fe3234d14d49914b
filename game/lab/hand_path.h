// game/lab/hand_path.h: ways of a hand through a volume, without a person.
#pragma once
#include "game/lab/stir_path.h"

namespace thaum::game {

enum class HandWay : std::uint8_t { rest, press, circle, file };

/// Wanted places of the hand over time.
struct HandPath {
    HandWay way{};
    StirPath file{};  ///< for HandWay::file: points in the lab's frame
};

/// Parses a word of the command line: rest, press, circle, or the path of a CSV file with the columns
/// time_s,x_m,y_m,z_m. The error names the fault, and for a file its line.
Expected<HandPath> hand_path(std::string_view word);

/// Place where the hand wants to be (m, lab frame, whose workspace has these edges). A press goes from above through
/// the middle and back in 4 s; a circle is level, at half of the width, and takes 4 s. Before and after a file's times
/// the hand is at its first and last place.
vec3 wanted_place(const HandPath& path, vec3 workspace, double seconds);

/// Place where a hand begins that a mouse moves: as near to the viewer as the workspace allows, a little within it (m). `to_viewer` is the
/// direction from the middle to the viewer, not zero.
vec3 place_before(vec3 to_viewer, vec3 workspace);

}  // namespace thaum::game
