#include "field/transfer.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace thaum::field {
namespace {

constexpr double max_coordinate = 1e100;
/// Largest number of columns (values of x at which a stroke sets the function) of one stroke. In a longer
/// stroke they are farther apart.
constexpr double max_columns = 512;

double limited_coordinate(double v) {
    return std::isnan(v) ? 0 : std::clamp(v, -max_coordinate, max_coordinate);
}

std::size_t used(const TransferFunction& f) {
    return std::min(static_cast<std::size_t>(f.count), max_transfer_points);
}

std::span<const vec2> points_of(const TransferFunction& f) { return std::span(f.points).first(used(f)); }

/// Points of a function while set_column changes it: room for three more than the function can keep, namely
/// the new point and one on either side. thin_out then removes the surplus.
struct Draft {
    std::array<vec2, max_transfer_points + 3> points{};
    std::size_t count{};

    void add(vec2 point) { points[count++] = point; }
};

/// Twice the area of the triangle that a point forms with its neighbours: how much the shape changes if the
/// point is removed.
double bend(vec2 before, vec2 here, vec2 after) {
    const vec2 a = here - before, b = after - before;
    return std::abs(a.x * b.y - a.y * b.x);
}

/// Removes points until the others fit into a function, but never the first, the last, or the point at x =
/// kept.
void thin_out(Draft& draft, double kept) {
    while (draft.count > max_transfer_points) {
        std::size_t least = 0;
        double min_bend = 0;
        for (std::size_t i = 1; i + 1 < draft.count; ++i) {
            if (draft.points[i].x == kept) continue;
            const double here = bend(draft.points[i - 1], draft.points[i], draft.points[i + 1]);
            if (least == 0 || here < min_bend) least = i, min_bend = here;
        }
        std::copy(draft.points.begin() + static_cast<std::ptrdiff_t>(least) + 1,
                  draft.points.begin() + static_cast<std::ptrdiff_t>(draft.count),
                  draft.points.begin() + static_cast<std::ptrdiff_t>(least));
        --draft.count;
    }
}

/// Gives the function the value y at x. At `left` and `right`, the neighbouring values of x that a stroke can
/// set, and beyond them it stays as it was.
void set_column(TransferFunction& f, double left, double x, double right, double y) {
    const auto old = points_of(f);
    const auto has = [&](double at) { return std::ranges::any_of(old, [&](vec2 p) { return p.x == at; }); };
    Draft draft;
    for (const vec2 p : old) {
        if (p.x <= left) draft.add(p);
    }
    if (!has(left)) draft.add({left, f(left)});
    draft.add({x, y});
    if (!has(right)) draft.add({right, f(right)});
    for (const vec2 p : old) {
        if (p.x >= right) draft.add(p);
    }
    thin_out(draft, x);
    f = {};
    std::copy_n(draft.points.begin(), draft.count, f.points.begin());
    f.count = draft.count;
}

}  // namespace

double TransferFunction::operator()(double x) const {
    const auto p = points_of(*this);
    if (p.empty()) return 0;
    if (!(x >= p.front().x)) return p.front().y;
    // The first point beyond x.
    const auto next = std::ranges::upper_bound(p, x, {}, &vec2::x);
    if (next == p.end()) return p.back().y;
    const vec2 a = *(next - 1), b = *next;
    const double y = a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x));
    // Keeps y between those of a and b, beyond which rounding could take it by a unit in the last place.
    return std::clamp(y, std::min(a.y, b.y), std::max(a.y, b.y));
}

TransferFunction constant(double y) {
    TransferFunction f;
    f.points[0] = {0, limited_coordinate(y)};
    f.count = 1;
    return f;
}

TransferFunction window(double low, double high, double from, double to) {
    vec2 a(limited_coordinate(low), limited_coordinate(from));
    vec2 b(limited_coordinate(high), limited_coordinate(to));
    if (b.x < a.x) std::swap(a, b);
    TransferFunction f;
    f.points[0] = a;
    f.points[1] = b;
    f.count = 2;
    return f;
}

Expected<TransferFunction> transfer_function(std::span<const vec2> points) {
    if (points.empty()) return fail("a transfer function needs at least one point");
    if (points.size() > max_transfer_points)
        return fail(
            text("a transfer function has ", points.size(), " points, more than ", max_transfer_points));
    TransferFunction f;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const vec2 p = points[i];
        if (!(std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate))
            return fail(text("point ", i + 1, " of a transfer function is not a number within 1e100"));
        if (i > 0 && p.x < points[i - 1].x)
            return fail(text("point ", i + 1, " of a transfer function stands left of the point before it; ",
                             "sort the points by x"));
        f.points[i] = p;
    }
    f.count = points.size();
    return f;
}

void draw(TransferFunction& f, double x, double y, double width) {
    if (!(width > 0) || !std::isfinite(x) || !std::isfinite(width) || std::isnan(y)) return;
    const double column = std::round(limited_coordinate(x) / width);
    const double left = (column - 1) * width, middle = column * width, right = (column + 1) * width;
    // Far from 0, neighbouring columns (values of x that can be set) may round to the same number. Then
    // nothing is drawn.
    if (!(left < middle && middle < right && -max_coordinate <= left && right <= max_coordinate)) return;
    set_column(f, left, middle, right, limited_coordinate(y));
}

void draw_stroke(TransferFunction& f, vec2 from, vec2 to, double width) {
    if (!(width > 0) || !is_finite({from, 0}) || !is_finite({to, 0})) return;
    for (vec2* end : {&from, &to}) *end = {limited_coordinate(end->x), limited_coordinate(end->y)};
    const double columns = std::clamp(std::ceil(std::abs(to.x - from.x) / width), 1.0, max_columns);
    for (int i = 0; i <= static_cast<int>(columns); ++i) {
        const double t = i / columns;
        draw(f, from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), width);
    }
}

}  // namespace thaum::field
