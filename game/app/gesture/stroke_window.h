// game/app/gesture/stroke_window.h: records strokes of a gesture in a window that shows them while they are drawn.
#pragma once
#include <string>
#include <vector>

#include "game/app/gesture/drawing_hand.h"

namespace thaum::app {

struct StrokeWish {
    std::string name;       ///< name of the gesture
    std::size_t count = 3;  ///< number of strokes
    std::string device;     ///< "mouse", or an arm as `--feel` names it
};

/// Strokes so far, and what the window says of them.
class StrokeDesk {
public:
    explicit StrokeDesk(StrokeWish wish) : wish_(std::move(wish)) {}

    gesture::StrokeRecorder& recorder() { return recorder_; }
    const gesture::StrokeRecorder& recorder() const { return recorder_; }
    void key(std::string_view name);
    bool complete() const { return recorder_.strokes().size() >= wish_.count; }
    bool left() const { return left_; }
    /// Line above the strokes: "circle: stroke 2 of 3".
    std::string title() const;
    std::string advice() const;

private:
    StrokeWish wish_;
    gesture::StrokeRecorder recorder_;
    bool left_ = false;
};

/// Opens a window until the strokes are drawn. The error says why there are none: no display, no such device, or that
/// the window was closed before.
Expected<std::vector<std::vector<gesture::StrokePoint>>> draw_strokes(const StrokeWish& wish);

}  // namespace thaum::app
