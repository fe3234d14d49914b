// game/data/reading.h: reads what a drawn stroke means.
#pragma once
#include <span>
#include <vector>

#include "game/components/casting.h"
#include "game/components/stroke_reading.h"
#include "game/data/casting_rules.h"
#include "game/data/gesture_set.h"

namespace thaum::game {

/// Memory of the reader, which is no state: the same stroke gives the same reading whatever was read before.
struct ReadingSpace {
    gesture::RecogniserSpace recogniser;
    std::array<gesture::StrokePoint, most_drawn_points> stroke{};
};

struct Reading {
    StrokeReading stroke;
    std::uint32_t nearest = no_gesture;  ///< nearest gesture, although it may not be meant; no_gesture: none
};

/// Spreads the jumps of a hand whose device tells its place only now and then, such as a mouse over a remote desktop.
/// Such a hand seems to rest and then to leap, many times as fast as it was. A jump after a short rest becomes an even
/// motion through that rest. Slow motion, whose steps are short, and all rests from 64 ms on stay as they are.
/// `apart`: time between two places (s).
void spread_jumps(std::span<vec3> places, double apart);

/// Points of a stroke with their times (s). Allocates.
std::vector<gesture::StrokePoint> points_of(const DrawnStroke& stroke);
/// Mean force along the way of a stroke (N).
double mean_force_of(const DrawnStroke& stroke);

/// Why a stroke is not read at all.
enum class Slip : std::uint8_t {
    none,       ///< it is read
    tap,        ///< a press of Trace without a stroke
    too_small,  ///< the hand moved, but not far enough
    too_quick   ///< Trace was let go too soon
};
Slip slip_of(const CastingRules& rules, const DrawnStroke& trace);

/// Whether the stroke is too short to mean anything, such as a slip of the finger.
inline bool is_slip(const CastingRules& rules, const DrawnStroke& trace) {
    return slip_of(rules, trace) != Slip::none;
}

/// Whether a stroke of this mean force (N) was drawn so fast that a hand can no longer follow sharp corners. If such a
/// stroke could not be read, its pace is the reason. A star 10 cm wide is this fast if it lasts 0.5 s, and is still read
/// if it lasts 0.3 s.
bool is_too_fast(const CastingRules& rules, double force);

/// Reads the points of a stroke as a match does, with any recogniser: as a whole, and turn by turn where it goes round
/// several times.
gesture::Recognition recognise_drawn(const gesture::Recogniser& recogniser, gesture::Points stroke,
                                     gesture::RecogniserSpace& space);

/// Reads a stroke. Several turns of a closed gesture in one stroke are read one by one: all must be the gesture.
Reading read_drawn(const GestureSet& gestures, const DrawnStroke& trace, ReadingSpace& space);

}  // namespace thaum::game
