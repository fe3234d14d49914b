// gesture/generated_users.h: strokes of simulated users, for the shipped templates and for tests of them.
//
// A figure is a list of nodes joined by arcs. The hand goes from node to node in minimum-jerk movements
// (Flash, Hogan 1985) that overlap in time (Flash, Henis 1991): the more they overlap, the rounder the
// corners. The force is the answer of a viscous field, 3.5 N s/m times the speed of the hand, and the pace is
// chosen so that its mean becomes what the user intends.
//
// A user keeps a style: where figures begin and which way they turn, their proportions, tilt, corners,
// tremor, pace and device. Each stroke differs from the style by jitter. This model of users shares nothing
// with that of variations.h, by which a recogniser sets its thresholds. So a test with these users does not
// check a recogniser with the model by which it was tuned.
//
// The same seed gives the same strokes on every processor.
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "core/random.h"
#include "gesture/gesture.h"

namespace thaum::gesture {

/// Viscosity of the imagined fluid that resists the hand while a stroke is drawn (N s/m).
inline constexpr double stroke_viscosity = 3.5;
/// Mean force below which a stroke is gentle, and above which it is harsh (N).
inline constexpr double gentle_force = 1.0, harsh_force = 1.5;

/// Figures that generated users draw.
enum class Figure : std::uint8_t { circle, v, s, star };
inline constexpr std::size_t figures = 4;

/// Names of the figures, in the order of Figure.
std::span<const std::string_view> figure_names();

/// Properties that all strokes of one user share. Figures are defined with the height 1 and then scaled to
/// `size`.
struct UserStyle {
    static constexpr std::size_t max_nodes = 8;

    double size{};              ///< height of a figure (m)
    double aspect{};            ///< width of a figure, as a multiple of its usual width
    double slant{};             ///< shear: shift of x for each unit of y
    double tilt{};              ///< turn about the z axis (rad)
    double lean_x{}, lean_y{};  ///< turns of the plane of drawing about the x and y axes (rad)
    double bow{};               ///< depth of the middle of a figure relative to its rim (share of the size)
    double bulge{};             ///< turn of the hand's heading along a line that should be straight (rad)
    /// Overlap in time of two movements at a corner, which rounds it (share of a movement).
    double corner_overlap{};
    double tremor{};  ///< amplitude of the tremor (m)
    /// Standard deviation of the position of a node (end of an arc of the figure) from stroke to stroke
    /// (share of the size).
    double jitter{};
    double circle_start{};  ///< angle at which a circle begins (rad)
    double gap{};  ///< angle by which a circle is drawn beyond its start; negative: it is left open (rad)
    double gentle{}, harsh{};  ///< mean force of gentle and of harsh strokes (N)
    std::size_t star_start{};  ///< corner at which a star begins
    bool mirrored_circle{};    ///< true if circles go clockwise
    bool mirrored_star{};      ///< true if stars begin with a line towards the left
    bool flat{};               ///< true for a mouse: no depth, steps of 0.1 mm
    /// Offsets of the nodes (ends of the arcs of a figure), the same in all strokes of the user: the user's
    /// own idea of a figure (share of the size).
    std::array<vec3, max_nodes> idea{};
};

/// Draws the style of a new user at random.
UserStyle random_style(Random& random);

/// How hard a user draws.
enum class Effort : std::uint8_t { gentle, normal, harsh };

/// Draws a stroke of a figure in the style of a user.
std::vector<StrokePoint> draw_figure(Figure figure, const UserStyle& style, Effort effort, Random& random);

/// A stroke that is none of the figures (circle, V, S, star): a tangle, a zigzag, a line, a spiral, an eight,
/// or only a part of a figure.
std::vector<StrokePoint> draw_scribble(const UserStyle& style, Random& random);

/// The gestures that the game ships, with their recorded strokes: three of each figure, by careful users.
std::vector<Gesture> generated_templates(std::uint64_t seed);

/// How many users and strokes a generated set has, and the seed of its random numbers.
struct GeneratedSetSettings {
    std::size_t users = 20;
    std::size_t samples = 3;  ///< number of gentle strokes, and of harsh ones, of each figure by each user
    std::uint64_t seed = 1;
};

/// Strokes of generated users, with samples named "gentle 1", "harsh 1" and so on. None of these users drew a
/// template.
std::vector<Stroke> generated_strokes(const GeneratedSetSettings& settings);
/// Strokes that mean nothing, named "scribble", as many as `generated_strokes` gives strokes.
std::vector<Stroke> generated_scribbles(const GeneratedSetSettings& settings);

}  // namespace thaum::gesture
