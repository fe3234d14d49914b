// Makes the templates of the gestures that the game ships: strokes of generated users who draw with care.
#include <array>

#include "gesture/generated_users.h"

namespace thaum::gesture {
namespace {

constexpr std::size_t strokes_of_each = 3;
constexpr double tolerance = 15;  // largest rotation against the template (degrees)

GestureOptions options_of(Figure figure) {
    GestureOptions o;
    // A user may start a circle or star at another place, which looks like a rotated one whose force rises
    // and falls elsewhere. So these two figures may be rotated by any angle.
    o.closed = figure == Figure::circle || figure == Figure::star;
    o.rotation = o.closed ? pi : tolerance / (180 / pi);
    o.direction_sensitive = figure == Figure::s;
    // Users do not hold the drawing plane exactly upright, so only x and y count.
    o.planar = true;
    o.gentle_below = gentle_force;
    o.harsh_above = harsh_force;
    return o;
}

/// Style of one of the three users, drawing slowly and well, from whom the shipped templates come. They
/// differ in proportions and in how round their corners are.
UserStyle careful_style(std::size_t number) {
    static constexpr std::array<double, strokes_of_each> aspects{1, 0.93, 1.08}, corners{0.15, 0.25, 0.2},
        leans{0, 0.1, -0.1};
    UserStyle s;
    s.size = 0.075;
    s.aspect = aspects[number];
    s.lean_x = leans[number];
    s.bow = 0.02;
    s.corner_overlap = corners[number];
    s.tremor = 5e-5;
    s.jitter = 0.006;
    s.circle_start = pi / 2;
    return s;
}

/// Rounds to steps of 10 um, 1 ms and 1 mN, which keeps files short.
void round_to_steps(std::vector<StrokePoint>& stroke) {
    const auto rounded = [](double value, double steps) { return std::floor(value * steps + 0.5) / steps; };
    for (auto& p : stroke) {
        p.t = rounded(p.t, 1000);
        for (int axis = 0; axis < 3; ++axis) p.at[axis] = rounded(p.at[axis], 1e5);
        p.force = rounded(p.force, 1000);
    }
}

}  // namespace

std::vector<Gesture> generated_templates(std::uint64_t seed) {
    std::vector<Gesture> gestures;
    for (std::size_t f = 0; f < figures; ++f) {
        const auto figure = static_cast<Figure>(f);
        Gesture gesture{.name = std::string(figure_names()[f]), .options = options_of(figure), .strokes = {}};
        Random random = random_stream(seed, 0x3a7e + f);
        for (std::size_t i = 0; i < strokes_of_each; ++i) {
            gesture.strokes.push_back(draw_figure(figure, careful_style(i), Effort::normal, random));
            round_to_steps(gesture.strokes.back());
        }
        gestures.push_back(std::move(gesture));
    }
    return gestures;
}

}  // namespace thaum::gesture
