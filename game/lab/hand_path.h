// game/lab/hand_path.h: paths of a simulated hand through a volume.
#pragma once
#include <string_view>
#include <vector>

#include "game/lab/stir_path.h"

namespace thaum::game::inline lab {

enum class HandWay : std::uint8_t { rest, press, circle, file };

/// Use of tool and undo by the hand in one step, as in a row of a trace (the table of a session of the lab).
struct HandUse {
    std::size_t tool{};  ///< index of the held tool in the sorted list, counted from 1; 0: none
    int history{};       ///< -1: undo, 1: redo, 0: neither
};

/// Target positions of the hand over time.
struct HandPath {
    HandWay way{};
    StirPath file{};  ///< for HandWay::file: points of the path (lab frame)
    /// For each point, tool and undo, if the file is a trace (the table of a session of the lab); otherwise
    /// empty.
    std::vector<HandUse> uses{};
};

/// Parses a word of the command line: rest, press, circle, or the path of a CSV file. The file has the
/// columns time_s,x_m,y_m,z_m, or is a trace that the lab wrote. The error says what is wrong, and for a file
/// in which line.
Expected<HandPath> hand_path(std::string_view word);

/// Parses a trace of the lab (game/lab/volume_trace.h), so that the hand gets the same targets at the same
/// ticks as before, and uses the same tools. `name`: file name for errors.
Expected<HandPath> parse_hand_trace(std::string_view csv, std::string_view name);

/// Tool and undo in the step that begins at this time; neither if the path was not read from a trace of the
/// lab.
HandUse use_at(const HandPath& path, double seconds);

/// Target position of the hand (m, lab frame). `workspace`: edge lengths of the workspace (m). A press goes
/// from above through the middle and back in 4 s. A circle is horizontal and takes 4 s; its diameter is half
/// of the workspace's narrower horizontal edge. Before and after a file's times, the target is the first or
/// last position.
vec3 wanted_place(const HandPath& path, vec3 workspace, double seconds);

/// Start position of a hand moved by the mouse (m): near the side of the workspace towards the viewer,
/// slightly inside. `to_viewer`: direction from the middle to the viewer, not zero.
vec3 place_before(vec3 to_viewer, vec3 workspace);

}  // namespace thaum::game::inline lab
