#include "game/hud/likely_spell.h"

#include <algorithm>

#include "gesture/prefix.h"

namespace thaum::game {
namespace {

/// Working memory, and the points of a stroke. They are chosen evenly in time, and only shares of time count.
struct LikelySpace {
    gesture::PrefixSpace prefix{};
    std::array<gesture::StrokePoint, StrokePicture::most_points> points{};
};

gesture::Points points_of(const StrokePicture& stroke, LikelySpace& space) {
    for (std::uint32_t i = 0; i < stroke.count; ++i) {
        const auto& p = stroke.points[i];
        space.points[i] = {static_cast<double>(i), vec3(p.x, p.y, p.z), p.force};
    }
    return gesture::Points(space.points).first(stroke.count);
}

bool is_long_enough(gesture::Points stroke, double least) {
    double length = 0;
    for (std::size_t i = 1; i < stroke.size() && length < least; ++i)
        length += glm::distance(stroke[i - 1].at, stroke[i].at);
    return length >= least;
}

}  // namespace

const SpellPresentation* likely_spell(const CastingPicture& casting, const Presentation& shown) {
    const auto& stroke = casting.stroke;
    if (!stroke.drawing || stroke.on_brew || stroke.curve || stroke.chord || !casting.gestures)
        return nullptr;
    thread_local const auto space = std::make_unique<LikelySpace>();
    const auto points = points_of(stroke, *space);
    if (!is_long_enough(points, casting.rules->smallest)) return nullptr;
    const auto likely = casting.gestures->prefixes().read(points, space->prefix);
    if (likely.probability < gesture::likely_enough) return nullptr;
    const auto name = casting.gestures->name(likely.gesture);
    const auto found = std::find_if(shown.spells.begin(), shown.spells.end(),
                                    [&](const auto& s) { return s.gesture == name; });
    return found == shown.spells.end() ? nullptr : &*found;
}

}  // namespace thaum::game
