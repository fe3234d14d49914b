// game/lab/hand_path.h: ways of a hand through a volume, without a person.
#pragma once
#include <string_view>
#include <vector>

#include "game/lab/stir_path.h"

namespace thaum::game {

enum class HandWay : std::uint8_t { rest, press, circle, file };

/// Tool and undo of a hand in one step, as in a row of a trace.
struct HandUse {
    std::size_t tool{};  ///< place of the held tool in the sorted list, from 1; 0: none
    int history{};       ///< -1: undo, 1: redo
};

/// Wanted places of the hand over time.
struct HandPath {
    HandWay way{};
    StirPath file{};              ///< for HandWay::file: points in the lab's frame
    std::vector<HandUse> uses{};  ///< one per point for a trace of the lab, otherwise empty
};

/// Parses a word of the command line: rest, press, circle, or the path of a CSV file with the columns
/// time_s,x_m,y_m,z_m, or of a trace that the lab wrote. The error names the fault, and for a file its line.
Expected<HandPath> hand_path(std::string_view word);

/// Parses a trace of the lab (game/lab/volume_trace.h): the hand wants the same places at the same ticks, and uses the
/// same tools. `name` stands in errors.
Expected<HandPath> parse_hand_trace(std::string_view csv, std::string_view name);

/// Tool and undo of the hand in the step that begins at a time; none without a trace.
HandUse use_at(const HandPath& path, double seconds);

/// Place where the hand wants to be (m, lab frame, whose workspace has these edges). A press goes from above through
/// the middle and back in 4 s; a circle is level, at half of the width, and takes 4 s. Before and after a file's times
/// the hand is at its first and last place.
vec3 wanted_place(const HandPath& path, vec3 workspace, double seconds);

/// Place where a hand begins that a mouse moves: as near to the viewer as the workspace allows, a little within it (m).
/// `to_viewer` is the direction from the middle to the viewer, not zero.
vec3 place_before(vec3 to_viewer, vec3 workspace);

}  // namespace thaum::game
