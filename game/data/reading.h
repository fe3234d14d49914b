// game/data/reading.h: recognises which gesture a drawn stroke is.
#pragma once
#include <span>
#include <vector>

#include "game/components/casting.h"
#include "game/components/stroke_reading.h"
#include "game/data/casting_rules.h"
#include "game/data/gesture_set.h"

namespace thaum::game::inline data {

/// Working memory of the reader of strokes, kept to save time. It is no state: the reading of a stroke does
/// not depend on earlier strokes.
struct ReadingSpace {
    gesture::RecogniserSpace recogniser;
    std::array<gesture::StrokePoint, max_drawn_points> stroke{};
};

struct Reading {
    StrokeReading stroke;
    /// Nearest gesture, even if the stroke was not recognised; no_gesture: none.
    std::uint32_t nearest = no_gesture;
};

/// Smooths the jumps of a device that reports its position only now and then, such as a mouse over a remote
/// desktop. The reported positions alternate between rests and jumps, which are many times as fast as the
/// hand. A jump after a short rest is replaced by an even motion through that rest. Slow motion, whose steps
/// are short, and rests of 64 ms or more are not changed. `apart`: time between two positions (s).
void spread_jumps(std::span<vec3> places, double apart);

/// Points of a stroke with their times (s). Allocates.
std::vector<gesture::StrokePoint> points_of(const DrawnStroke& stroke);
/// Mean of the force over the length of a stroke's path (N).
double mean_force_of(const DrawnStroke& stroke);

/// Reason why a stroke is not read at all.
enum class Slip : std::uint8_t {
    none,       ///< the stroke is read
    tap,        ///< the button Trace was pressed only for a moment, or the hand hardly moved
    too_small,  ///< the hand moved, but not far enough
    too_quick   ///< the button Trace was let go too soon
};
Slip slip_of(const CastingRules& rules, const DrawnStroke& trace);

/// Whether the stroke is too short to be a gesture, such as a slip of the finger.
inline bool is_slip(const CastingRules& rules, const DrawnStroke& trace) {
    return slip_of(rules, trace) != Slip::none;
}

/// Whether a stroke of this mean force (N) was so fast that a hand can no longer follow sharp corners. If
/// such a stroke was not recognised, its speed is the probable reason. A star 10 cm wide is this fast if
/// drawn in 0.5 s, and is still recognised if drawn in 0.3 s.
bool is_too_fast(const CastingRules& rules, double force);

/// Reads the points of a stroke as a match does, with any recogniser: as a whole, or turn by turn if the
/// stroke has several turns.
gesture::Recognition recognise_drawn(const gesture::Recogniser& recogniser, gesture::Points stroke,
                                     gesture::RecogniserSpace& space);

/// Reads a stroke. Several turns of a closed gesture in one stroke are read one by one, and all must be that
/// gesture.
Reading read_drawn(const GestureSet& gestures, const DrawnStroke& trace, ReadingSpace& space);

/// A probability as a whole percentage, as captions and the gesture wall show it. Only a certain reading
/// gives 100.
int whole_percent(double probability);

}  // namespace thaum::game::inline data
