// tactile/detail/tact.h: .tact files, the effects of bHaptics' designer, as clips.
//
// The format, as derived from public sample files (JSON):
//
//     project.tracks[].effects[]   startTime, offsetTime (its length), modes.VestFront and modes.VestBack:
//         DOT_MODE    dotMode.feedback[]: startTime, endTime, playbackType NONE, FADE_IN, FADE_OUT or
//                     FADE_IN_OUT, pointList[]: index 0 to 19, intensity 0 to 1. dotConnected: each step
//                     fades into the next.
//         PATH_MODE   pathMode.feedback[]: movingPattern CONST_SPEED or CONST_TDM, playbackType, pointList[]:
//                     x and y from 0 (left, top) to 1, intensity, time (ms)
//     feedback                     "MS": [{position, mode, values[20] of 0 to 100}], for players that cannot
//                                  draw paths
//
// Numbers may be strings ("0.500"). The tracks are read if they have anything for the vest, otherwise the
// frames in `feedback`. The tracks come first because the frames of files with paths have only zeros. Parts
// for arms, head and hands are skipped and counted. A point on a path is felt between cells by the same law
// as phantom actuators (phantom.h).
#pragma once
#include <string_view>

#include "core/error.h"
#include "tactile/clip.h"

namespace thaum::tactile {

inline constexpr std::size_t max_tact_bytes = std::size_t{4} << 20U;

struct TactImport {
    Clip clip{};
    std::size_t clipped{};  ///< number of values in the file that were out of their range
    /// Number of parts for other devices than the vest, and of entries of unknown form.
    std::size_t skipped{};
};

/// Reads a .tact file. Its effects are drawn into the frames of a clip. The error is one line: too large,
/// nested too deep, not JSON, longer than a minute, far more to draw than in any real file, or nothing for
/// the vest.
Expected<TactImport> import_tact(std::string_view json);

}  // namespace thaum::tactile
