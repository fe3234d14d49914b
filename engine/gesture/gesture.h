// gesture/gesture.h: a gesture as a designer records it: a name, one to three
// strokes, and how strokes may differ.
#pragma once
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "gesture/stroke.h"

namespace thaum::gesture {

inline constexpr std::size_t max_gestures = 256;
/// Largest number of templates (recorded strokes) of all gestures together, including copies that are drawn
/// backwards.
inline constexpr std::size_t max_templates = 1024;
/// Largest number of points of one recorded stroke.
inline constexpr std::size_t max_template_points = 100'000;

/// How strokes of one gesture may differ from its templates, the recorded strokes.
struct GestureOptions {
    /// True if the stroke must be drawn in the recorded direction. False if it may also be drawn backwards.
    bool direction_sensitive = true;
    double rotation = 0;   ///< largest turn of a stroke about the z axis against the template, 0 to pi (rad)
    double min_scale = 0;  ///< least size of a stroke divided by that of the template
    double max_scale = 1e9;  ///< largest size of a stroke divided by that of the template
    bool closed = false;     ///< true if the stroke is a closed curve that may start anywhere
    bool planar = false;     ///< true if z is ignored
    /// Mean force below which a stroke is gentle (unit of the device); 0: 0.6 times that of the templates.
    double gentle_below = 0;
    /// Mean force above which a stroke is harsh (unit of the device); 0: 1.6 times that of the templates.
    double harsh_above = 0;

    bool operator==(const GestureOptions&) const = default;
};

/// A gesture with the strokes that were recorded for it, its templates.
struct Gesture {
    std::string name;
    GestureOptions options;
    std::vector<std::vector<StrokePoint>> strokes;
};

}  // namespace thaum::gesture
