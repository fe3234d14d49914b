#include "gesture/generated_users.h"

#include <algorithm>
#include <array>

#include "core/text.h"
#include "gesture/variations.h"

namespace thaum::gesture {
namespace {

constexpr double seconds_between_points = 0.008;
constexpr double mouse_step = 1e-4;  // distance of the hand for each count of a mouse (m)
/// Overlap of two movements along a smooth curve, as a share of a movement.
constexpr double curve_overlap = 0.55;
constexpr std::array<std::string_view, figures> all_figures{"circle", "v", "s", "star"};

/// One arc of the path along which a generated user draws a figure (circle, V, S or star).
struct Leg {
    vec3 to{};      ///< place at which the arc ends
    double turn{};  ///< turn of the heading along the arc (rad)
    /// Overlap in time with the movement along the next arc (share of the duration).
    double overlap{};
};

struct Path {
    vec3 start{};
    std::vector<Leg> legs;
};

double minimum_jerk(double u) {
    u = std::clamp(u, 0.0, 1.0);
    return u * u * u * (10 + u * (6 * u - 15));
}

/// Displacement after a share `u` of an arc in the plane of x and y. `chord` leads from start to end of the
/// arc, and the heading along it turns by `turn` (rad).
vec3 along_arc(vec3 chord, double turn, double u) {
    if (std::abs(turn) < 1e-6) return u * chord;
    // The arc turns by `turn` in all and its chord has the mean heading. So the part up to u has a chord of
    // sin(u turn / 2) / sin(turn / 2) times the whole, turned by (u - 1) turn / 2.
    const double part = det::sin(u * turn / 2) / det::sin(turn / 2);
    return part * (rotation({0, 0, 1}, (u - 1) * turn / 2) * chord);
}

vec3 on_circle(double angle) { return 0.5 * vec3(det::cos(angle), det::sin(angle), 0); }

Path circle_path(const UserStyle& style, Random& random) {
    constexpr int legs = 4;
    const double way = style.mirrored_circle ? -1 : 1;
    const double whole = 2 * pi + style.gap + 0.15 * normal(random);
    const double start = style.circle_start + 0.25 * normal(random);
    Path path{on_circle(start), {}};
    for (int i = 1; i <= legs; ++i)
        path.legs.push_back({on_circle(start + way * whole * i / legs), way * whole / legs, curve_overlap});
    return path;
}

Path v_path(const UserStyle& style) {
    return {{-0.4, 0.5, 0},
            {{{0, -0.5, 0}, style.bulge, style.corner_overlap}, {{0.4, 0.5, 0}, style.bulge, 0}}};
}

Path s_path() {
    return {{0.3, 0.36, 0},
            {{{-0.12, 0.46, 0}, 1.5, curve_overlap},
             {{0, 0, 0}, 2.3, curve_overlap},
             {{0.12, -0.46, 0}, -2.3, curve_overlap},
             {{-0.3, -0.36, 0}, -1.5, 0}}};
}

/// Path of a pentagram: every second corner of a pentagon, the first at the lower left.
Path star_path(const UserStyle& style) {
    const double way = style.mirrored_star ? -1 : 1;
    const auto corner = [&](std::size_t i) {
        const double angle = pi / 2 + 0.8 * pi - 0.8 * pi * static_cast<double>(i + style.star_start);
        return 0.53 * vec3(way * det::cos(angle), det::sin(angle), 0);
    };
    Path path{corner(0), {}};
    for (std::size_t i = 1; i <= 5; ++i) path.legs.push_back({corner(i), style.bulge, style.corner_overlap});
    return path;
}

Path path_of(Figure figure, const UserStyle& style, Random& random) {
    switch (figure) {
        case Figure::circle: return circle_path(style, random);
        case Figure::v: return v_path(style);
        case Figure::s: return s_path();
        case Figure::star: return star_path(style);
    }
    return {};
}

vec3 random_offset(Random& random, double deviation) {
    const double x = normal(random);
    return deviation * vec3(x, normal(random), 0);
}

/// Moves each node (end of an arc) of a path by the user's own offset and by jitter, and bends each arc a
/// little.
void disturb(Path& path, const UserStyle& style, Random& random) {
    path.start += style.idea[0] + random_offset(random, style.jitter);
    for (std::size_t i = 0; i < path.legs.size(); ++i) {
        auto& leg = path.legs[i];
        leg.to += style.idea[(i + 1) % UserStyle::max_nodes] + random_offset(random, style.jitter);
        leg.turn += 0.1 * normal(random);
        if (leg.overlap > 0) leg.overlap = std::clamp(leg.overlap + 0.05 * normal(random), 0.02, 0.75);
    }
}

/// A movement of the hand along one arc of the path. Its times have an arbitrary unit; the pace of the stroke
/// turns them into seconds.
struct Movement {
    double begin{}, seconds{};
    vec3 chord{};
    double turn{};
};

std::vector<Movement> movements_of(const Path& path, Random& random) {
    std::vector<Movement> movements;
    vec3 from = path.start;
    double begin = 0;
    for (const auto& leg : path.legs) {
        const vec3 chord = leg.to - from;
        // Longer movements are faster: the duration grows with the square root of the length.
        const double seconds =
            std::sqrt(std::max(glm::length(chord), 0.05)) * det::exp(0.12 * normal(random));
        movements.push_back({begin, seconds, chord, leg.turn});
        begin += seconds * (1 - leg.overlap);
        from = leg.to;
    }
    return movements;
}

double end_of(std::span<const Movement> movements) {
    double end = 0;
    for (const auto& m : movements) end = std::max(end, m.begin + m.seconds);
    return end;
}

vec3 place_at(std::span<const Movement> movements, double time) {
    vec3 at(0);
    for (const auto& m : movements)
        at += along_arc(m.chord, m.turn, minimum_jerk((time - m.begin) / m.seconds));
    return at;
}

/// Converts a place on a figure that is drawn 1 high to a position of the user's hand (m).
class Frame {
public:
    Frame(const UserStyle& style, Random& random)
        : size_(style.size * det::exp(0.12 * normal(random))),
          aspect_(style.aspect * det::exp(0.06 * normal(random))),
          slant_(style.slant + 0.05 * normal(random)),
          bow_(style.flat ? 0 : style.bow + 0.02 * normal(random)),
          tilt_(style.tilt + 0.06 * normal(random)) {
        const double lean_x = style.lean_x + 0.06 * normal(random),
                     lean_y = style.lean_y + 0.06 * normal(random);
        if (!style.flat) lean_ = rotation({1, 0, 0}, lean_x) * rotation({0, 1, 0}, lean_y);
    }

    vec3 operator()(vec3 p) const {
        const vec3 sheared{aspect_ * p.x + slant_ * p.y, p.y, bow_ * 4 * glm::dot(p, p)};
        return size_ * (lean_ * (rotation({0, 0, 1}, tilt_) * sheared));
    }

private:
    double size_, aspect_, slant_, bow_, tilt_;
    quat lean_{1, 0, 0, 0};
};

/// Returns the mean force along the path of a stroke that is drawn at the pace 1 (one second for each unit of
/// time).
double mean_force_at_pace_one(std::span<const Movement> movements, const Frame& frame) {
    constexpr int steps = 200;
    const double step = end_of(movements) / steps;
    double way = 0, sum = 0;
    vec3 before = frame(place_at(movements, 0));
    for (int i = 1; i <= steps; ++i) {
        const vec3 at = frame(place_at(movements, step * i));
        const double length = glm::length(at - before);
        way += length;
        sum += length * stroke_viscosity * length / step;
        before = at;
    }
    return way > 0 ? sum / way : 1;
}

/// Shaking of the hand: two sines of 6 to 11 Hz on each axis.
struct Tremor {
    std::array<vec3, 2> height{}, phase{};
    std::array<double, 2> frequency{};

    Tremor(const UserStyle& style, Random& random) {
        for (std::size_t k = 0; k < 2; ++k) {
            frequency[k] = 2 * pi * random.uniform(6, 11);
            for (int axis = 0; axis < 3; ++axis) {
                const double most = axis == 2 && style.flat ? 0 : style.tremor;
                height[k][axis] = most * random.uniform(0.3, 1);
                phase[k][axis] = random.uniform(0, 2 * pi);
            }
        }
    }

    vec3 at(double t) const {
        vec3 sum(0);
        for (std::size_t k = 0; k < 2; ++k) {
            for (int axis = 0; axis < 3; ++axis)
                sum[axis] += height[k][axis] * det::sin(frequency[k] * t + phase[k][axis]);
        }
        return sum;
    }
};

double rounded(double value, double step) { return std::floor(value / step + 0.5) * step; }

/// Adds the force with which a viscous fluid would resist the hand, smoothed over some points as by a device,
/// and noise.
void add_force(std::vector<StrokePoint>& points, Random& random) {
    constexpr std::size_t reach = 2;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& a = points[i < reach ? 0 : i - reach];
        const auto& b = points[std::min(i + reach, points.size() - 1)];
        const double speed = glm::length(b.at - a.at) / (b.t - a.t);
        const double gain = 1 + 0.03 * normal(random), noise = 0.01 * normal(random);
        points[i].force = std::max(0.0, stroke_viscosity * speed * gain + noise);
    }
}

/// Draws a path with the mean force `force` (N). The hand rests for a moment before and after.
std::vector<StrokePoint> draw(const Path& path, const UserStyle& style, double force, Random& random) {
    const auto movements = movements_of(path, random);
    const Frame frame(style, random);
    const Tremor tremor(style, random);
    // The viscous force, and so its mean, is inversely proportional to the time that the path takes.
    const double pace = mean_force_at_pace_one(movements, frame) / force;
    const double rest = random.uniform(0, 0.12), whole = rest + end_of(movements) * pace;
    const double end = whole + random.uniform(0, 0.1);
    const vec3 start = frame(path.start);
    std::vector<StrokePoint> points;
    for (int i = 0; seconds_between_points * i <= end; ++i) {
        const double t = seconds_between_points * i;
        const vec3 figure = path.start + place_at(movements, (t - rest) / pace);
        vec3 at = frame(figure) - start + tremor.at(t);
        if (style.flat) at = {rounded(at.x, mouse_step), rounded(at.y, mouse_step), 0};
        points.push_back({t, at, 0});
    }
    add_force(points, random);
    return points;
}

double force_of(Effort effort, const UserStyle& style, Random& random) {
    const double vary = det::exp(0.06 * normal(random));
    switch (effort) {
        case Effort::gentle: return style.gentle * vary;
        case Effort::normal: return std::sqrt(gentle_force * harsh_force) * vary;
        case Effort::harsh: return style.harsh * vary;
    }
    return 1;
}

vec3 random_place(Random& random) {
    const double x = random.uniform(-0.5, 0.5);
    return {x, random.uniform(-0.5, 0.5), 0};
}

Path tangle(Random& random) {
    Path path{random_place(random), {}};
    const auto legs = 3 + random.below(6);
    for (std::size_t i = 0; i < legs; ++i) {
        const vec3 to = random_place(random);
        path.legs.push_back({to, 0.9 * normal(random), random.uniform(0.05, 0.6)});
    }
    return path;
}

Path zigzag(Random& random) {
    const auto teeth = static_cast<int>(3 + random.below(5));
    const double height = random.uniform(0.1, 0.5);
    Path path{{-0.5, 0, 0}, {}};
    for (int i = 1; i <= teeth; ++i)
        path.legs.push_back({{-0.5 + static_cast<double>(i) / teeth, i % 2 == 1 ? height : -height, 0},
                             0.2 * normal(random),
                             random.uniform(0.05, 0.5)});
    return path;
}

Path line(Random& random) {
    const vec3 start = random_place(random);
    return {start, {{-start, 0.4 * normal(random), 0}}};
}

Path spiral(Random& random) {
    const auto legs = static_cast<int>(7 + random.below(6));
    const double way = random.uniform() < 0.5 ? -1 : 1, start = random.uniform(0, 2 * pi);
    Path path{0.1 * on_circle(start), {}};
    for (int i = 1; i <= legs; ++i) {
        const double angle = start + way * i * pi / 2, radius = 0.1 + 0.9 * i / legs;
        path.legs.push_back({radius * on_circle(angle), way * pi / 2, curve_overlap});
    }
    return path;
}

Path eight(Random& random) {
    const double way = random.uniform() < 0.5 ? -1 : 1;
    Path path{{0, 0, 0}, {}};
    const std::array<vec3, 4> nodes{vec3(0, 0.5, 0), vec3(0, 0, 0), vec3(0, -0.5, 0), vec3(0, 0, 0)};
    const std::array<double, 4> turns{1, 1, -1, -1};
    for (std::size_t i = 0; i < 4; ++i) path.legs.push_back({nodes[i], way * turns[i] * 2.5, curve_overlap});
    return path;
}

/// The first arcs of a figure's path, as if the user had given up half-way.
Path part_of_figure(const UserStyle& style, Random& random) {
    auto path = path_of(static_cast<Figure>(random.below(figures)), style, random);
    path.legs.resize((path.legs.size() + 1) / 2);
    return path;
}

std::string label(std::string_view word, std::size_t number) { return text(word, " ", number + 1); }

}  // namespace

std::span<const std::string_view> figure_names() { return all_figures; }

UserStyle random_style(Random& random) {
    UserStyle s;
    s.size = 0.075 * det::exp(0.22 * normal(random));
    s.aspect = det::exp(0.12 * normal(random));
    s.slant = 0.08 * normal(random);
    s.tilt = 0.1 * normal(random);
    s.lean_x = 0.15 * normal(random);
    s.lean_y = 0.15 * normal(random);
    s.bow = 0.04 * normal(random);
    s.bulge = 0.15 * normal(random);
    s.corner_overlap = random.uniform(0.05, 0.4);
    s.tremor = random.uniform(0.5e-4, 2.5e-4);
    s.jitter = random.uniform(0.02, 0.05);
    const bool from_anywhere = random.uniform() < 0.4;
    s.circle_start = from_anywhere ? random.uniform(0, 2 * pi) : pi / 2;
    s.gap = random.uniform(-0.35, 0.45);
    s.gentle = random.uniform(0.45, 0.8);
    s.harsh = random.uniform(1.9, 2.8);
    s.star_start = random.uniform() < 0.7 ? 0 : random.below(5);
    s.mirrored_circle = random.uniform() < 0.35;
    s.mirrored_star = random.uniform() < 0.25;
    s.flat = random.uniform() < 0.5;
    for (auto& offset : s.idea) offset = random_offset(random, 0.04);
    return s;
}

std::vector<StrokePoint> draw_figure(Figure figure, const UserStyle& style, Effort effort, Random& random) {
    auto path = path_of(figure, style, random);
    disturb(path, style, random);
    return draw(path, style, force_of(effort, style, random), random);
}

std::vector<StrokePoint> draw_scribble(const UserStyle& style, Random& random) {
    Path path;
    switch (random.below(8)) {
        case 0: path = zigzag(random); break;
        case 1: path = line(random); break;
        case 2: path = spiral(random); break;
        case 3: path = eight(random); break;
        case 4: path = part_of_figure(style, random); break;
        default: path = tangle(random);
    }
    disturb(path, style, random);
    return draw(path, style, random.uniform(0.4, 3), random);
}

std::vector<Stroke> generated_strokes(const GeneratedSetSettings& settings) {
    std::vector<Stroke> strokes;
    for (std::size_t u = 0; u < settings.users; ++u) {
        Random random = random_stream(settings.seed, 0x7e57 + 2 * u);
        const auto style = random_style(random);
        for (std::size_t f = 0; f < figures; ++f) {
            for (std::size_t i = 0; i < settings.samples; ++i) {
                for (const auto effort : {Effort::gentle, Effort::harsh})
                    strokes.push_back({label("user", u), std::string(all_figures[f]),
                                       label(effort == Effort::gentle ? "gentle" : "harsh", i),
                                       draw_figure(static_cast<Figure>(f), style, effort, random)});
            }
        }
    }
    return strokes;
}

std::vector<Stroke> generated_scribbles(const GeneratedSetSettings& settings) {
    std::vector<Stroke> strokes;
    for (std::size_t u = 0; u < settings.users; ++u) {
        Random random = random_stream(settings.seed, 0x7e58 + 2 * u);
        const auto style = random_style(random);
        for (std::size_t i = 0; i < 2 * figures * settings.samples; ++i)
            strokes.push_back(
                {label("user", u), "scribble", label("scribble", i), draw_scribble(style, random)});
    }
    return strokes;
}

}  // namespace thaum::gesture
