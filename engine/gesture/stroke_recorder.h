// gesture/stroke_recorder.h: cuts strokes out of motion while a button is down.
#pragma once
#include <vector>

#include "gesture/stroke.h"

namespace thaum::gesture {

class StrokeRecorder {
public:
    /// Strokes shorter than `least_seconds` are taken for an accidental press.
    explicit StrokeRecorder(double least_seconds = 0.1) : least_seconds_(least_seconds) {}

    /// Takes the hand of one tick. Times must not run backwards.
    void feed(const StrokePoint& hand, bool down);
    /// Ends a stroke whose button is still down.
    void end();

    /// Takes the last stroke back, if there is one.
    void drop_last();

    /// Strokes that have ended; each begins at time 0.
    const std::vector<std::vector<StrokePoint>>& strokes() const { return strokes_; }
    /// The stroke whose button is down; empty: none.
    Points open() const { return open_; }

private:
    double least_seconds_;
    std::vector<StrokePoint> open_;
    std::vector<std::vector<StrokePoint>> strokes_;
};

}  // namespace thaum::gesture
