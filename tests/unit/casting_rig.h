// unit/casting_rig.h: pictures of a wizard who draws a stroke, for the tests of the HUD.
#pragma once
#include "gesture/prefix.h"
#include "unit/hud_rig.h"

namespace thaum::game::hud_tests {

/// The picture of a new match, into which a test writes strokes and what was recognised in them.
inline Picture new_casting_picture() { return picture_of(*new_match()); }

inline std::uint32_t gesture_number(const CastingPicture& casting, std::string_view name) {
    return *casting.gestures->number(name);
}

/// Writes points into the picture as a match keeps them: one in each gameplay tick, in a long stroke one in
/// every second tick, and so on.
inline void draw_points(StrokePicture& stroke, gesture::Points points) {
    stroke.drawing = true;
    stroke.count = 0;
    stroke.apart_s = gameplay_dt;
    const double lasts = points.back().t - points[0].t;
    while (lasts >= stroke.apart_s * (StrokePicture::max_points - 1)) stroke.apart_s *= 2;
    std::size_t i = 0;
    for (double t = points[0].t; t <= points.back().t; t += stroke.apart_s) {
        while (i + 1 < points.size() && points[i].t < t) ++i;
        const auto& p = points[i];
        stroke.points.at(stroke.count++) = {static_cast<float>(p.at.x), static_cast<float>(p.at.y),
                                            static_cast<float>(p.at.z), static_cast<float>(p.force)};
    }
}

/// Writes the first part of a recorded stroke into the picture, as if the player were drawing it.
inline void draw_part(CastingPicture& casting, std::string_view gesture, double share) {
    const auto& points = casting.gestures->gestures()[gesture_number(casting, gesture)].strokes[0];
    const auto part = gesture::beginning_of(points, share);
    draw_points(casting.stroke, part);
}

}  // namespace thaum::game::hud_tests
