#include "tactile/frame.h"

#include <algorithm>

namespace thaum::tactile {

bool TactileFrame::is_silent() const {
    return std::all_of(amplitude.begin(), amplitude.end(), [](float a) { return a == 0; });
}

TactileFrame frame_at(const TactileFrame& frame, Tick now) {
    TactileFrame result = frame;
    if (now < frame.tick || now - frame.tick >= frame.time_to_live) result.amplitude.fill(0);
    return result;
}

}  // namespace thaum::tactile
