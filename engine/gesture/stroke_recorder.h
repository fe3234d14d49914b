// gesture/stroke_recorder.h: records strokes: the motion while a button is held.
#pragma once
#include <vector>

#include "gesture/stroke.h"

namespace thaum::gesture {

/// Collects the points of a stroke while its button is down.
class StrokeRecorder {
public:
    /// A press shorter than `min_seconds` counts as accidental and gives no stroke.
    explicit StrokeRecorder(double min_seconds = 0.1) : min_seconds_(min_seconds) {}

    /// Takes the position of the hand in one tick. Times must not run backwards.
    void feed(const StrokePoint& hand, bool down);
    /// Ends the present stroke, although its button is still down, and keeps it like one that was released.
    void end();

    /// Removes the last stroke, if there is one.
    void drop_last();

    /// Strokes that have ended; each begins at time 0.
    const std::vector<std::vector<StrokePoint>>& strokes() const { return strokes_; }
    /// The points so far of the stroke whose button is down; empty: none.
    Points open() const { return open_; }

private:
    double min_seconds_;
    std::vector<StrokePoint> open_;
    std::vector<std::vector<StrokePoint>> strokes_;
};

}  // namespace thaum::gesture
