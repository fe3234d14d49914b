// game/app/gesture/stroke_window.h: records strokes of a gesture in a window that shows each stroke while it
// is drawn.
#pragma once
#include <string>
#include <vector>

#include "game/app/gesture/drawing_hand.h"

namespace thaum::game::inline app {

struct StrokeWish {
    std::string name;       ///< name of the gesture to record
    std::size_t count = 3;  ///< number of strokes to record
    std::string device;     ///< "mouse", or the name of an arm as for the option --feel
};

/// Shortest stroke that a match would read.
struct LeastStroke {
    double way = 0.015;    ///< least arc length of a stroke (m)
    double seconds = 0.1;  ///< least time from the first to the last point of a stroke (s)
};

/// Why a stroke cannot be a template (an example of its gesture), and what to do about it. Empty if it can.
std::string fault_of(gesture::Points stroke, const LeastStroke& least);

/// The strokes drawn so far, and the texts that the window shows about them.
class StrokeDesk {
public:
    explicit StrokeDesk(StrokeWish wish, LeastStroke least = {}) : wish_(std::move(wish)), min_(least) {}

    gesture::StrokeRecorder& recorder() { return recorder_; }
    const gesture::StrokeRecorder& recorder() const { return recorder_; }
    /// Takes the strokes that have ended from the recorder. A stroke that cannot be a template is dropped,
    /// and `note` says why.
    void take_ended();
    void key(std::string_view name);
    bool complete() const { return recorder_.strokes().size() >= wish_.count; }
    bool left() const { return left_; }
    /// Line above the strokes: "circle: stroke 2 of 3".
    std::string title() const;
    std::string advice() const;
    /// Why the last stroke does not count; empty: it counts.
    const std::string& note() const { return note_; }

private:
    StrokeWish wish_;
    LeastStroke min_;
    std::string note_;
    std::size_t taken_ = 0;  ///< number of accepted strokes
    /// The recorder's minimum length is 0, because short strokes are refused with a message instead of being
    /// ignored.
    gesture::StrokeRecorder recorder_{0};
    bool left_ = false;
};

/// Opens a window until the strokes are drawn. The error says why there are none: no display, no such device,
/// or a window closed too early.
Expected<std::vector<std::vector<gesture::StrokePoint>>> draw_strokes(const StrokeWish& wish);

}  // namespace thaum::game::inline app
