#include "gesture/stroke_recorder.h"

namespace thaum::gesture {

void StrokeRecorder::feed(const StrokePoint& hand, bool down) {
    if (!down) return end();
    open_.push_back(hand);
    if (open_.size() > 1) open_.back().t -= open_.front().t;
}

void StrokeRecorder::end() {
    if (open_.size() > 1 && open_.back().t >= min_seconds_) {
        open_.front().t = 0;
        strokes_.push_back(open_);
    }
    open_.clear();
}

void StrokeRecorder::drop_last() {
    if (!strokes_.empty()) strokes_.pop_back();
}

}  // namespace thaum::gesture
