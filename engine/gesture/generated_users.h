// gesture/generated_users.h: strokes of people who do not exist, for the shipped templates and for tests of them.
//
// A figure is a list of nodes joined by arcs. The hand goes from node to node in minimum-jerk movements (Flash, Hogan
// 1985) that overlap in time (Flash, Henis 1991): the more they overlap, the rounder the corners. The force is the
// answer of a viscous field, 3.5 N s/m times the speed of the hand, and the pace is chosen so that its mean becomes
// what the user intends.
//
// A user keeps a style: where figures begin and which way they turn, their proportions, tilt, corners, tremor, pace
// and device. Each stroke differs from the style by jitter. None of this is shared with variations.h, by which a
// recogniser sets its thresholds, so a test with these users does not measure a recogniser by its own yardstick.
//
// The same seed gives the same strokes on every processor.
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "core/random.h"
#include "gesture/gesture.h"

namespace thaum::gesture {

/// Viscosity of the field that a stroke is drawn against (N s/m).
inline constexpr double stroke_viscosity = 3.5;
/// Mean force below which a stroke is gentle, and above which it is harsh (N).
inline constexpr double gentle_force = 1.0, harsh_force = 1.5;

enum class Figure : std::uint8_t { circle, v, s, star };
inline constexpr std::size_t figures = 4;

/// Names of the figures, in order.
std::span<const std::string_view> figure_names();

/// What stays the same in all strokes of one user. The figures of nodes are 1 high.
struct UserStyle {
    static constexpr std::size_t most_nodes = 8;

    double size{};              ///< height of a figure (m)
    double aspect{};            ///< width of a figure, as a multiple of the usual
    double slant{};             ///< shear of x by y
    double tilt{};              ///< turn about the z axis (rad)
    double lean_x{}, lean_y{};  ///< turns of the plane of drawing about the x and y axes (rad)
    double bow{};               ///< depth of the strokes' middle against their rim (share of the size)
    double bulge{};             ///< turn of the heading along a straight line (rad)
    double corner_overlap{};    ///< overlap of two movements at a corner (share of a movement)
    double tremor{};            ///< amplitude of the tremor (m)
    double jitter{};            ///< standard deviation of a node's place between strokes (share of the size)
    double circle_start{};      ///< angle at which a circle begins (rad)
    double gap{};               ///< angle by which a circle is drawn too far, negative: not far enough (rad)
    double gentle{}, harsh{};   ///< mean force of gentle and of harsh strokes (N)
    std::size_t star_start{};   ///< corner at which a star begins
    bool mirrored_circle{};     ///< true if circles go clockwise
    bool mirrored_star{};       ///< true if stars are begun towards the left
    bool flat{};                ///< true for a mouse: no depth, steps of 0.1 mm
    std::array<vec3, most_nodes>
        idea{};  ///< offsets of nodes by the user's idea of a figure (share of the size)
};

UserStyle random_style(Random& random);

enum class Effort : std::uint8_t { gentle, normal, harsh };

std::vector<StrokePoint> draw_figure(Figure figure, const UserStyle& style, Effort effort, Random& random);

/// A stroke that is no figure: a tangle, a zigzag, a line, a spiral, an eight, or a part of a figure.
std::vector<StrokePoint> draw_scribble(const UserStyle& style, Random& random);

/// The gestures that the game ships: three strokes of each figure by careful users.
std::vector<Gesture> generated_templates(std::uint64_t seed);

struct GeneratedSetSettings {
    std::size_t users = 20;
    std::size_t samples = 3;  ///< gentle and as many harsh strokes of each figure by each user
    std::uint64_t seed = 1;
};

/// Strokes of users, sample "gentle 1", "harsh 1" and so on. None of the users drew a template.
std::vector<Stroke> generated_strokes(const GeneratedSetSettings& settings);
/// As many scribbles as `generated_strokes` has strokes, named "scribble".
std::vector<Stroke> generated_scribbles(const GeneratedSetSettings& settings);

}  // namespace thaum::gesture
