#include "render/detail/shapes2d.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace thaum::render::detail {
namespace {

constexpr float full_turn = 2 * std::numbers::pi_v<float>;

std::uint32_t packed(fvec4 colour) {
    const auto byte = [](float v) {
        return static_cast<std::uint32_t>(std::lround(std::clamp(v, 0.0F, 1.0F) * 255));
    };
    return byte(srgb_from_linear(colour.r)) | byte(srgb_from_linear(colour.g)) << 8U |
           byte(srgb_from_linear(colour.b)) << 16U | byte(colour.a) << 24U;
}

std::uint32_t faded(std::uint32_t colour) { return colour & 0xFFFFFFU; }

struct Pen {
    std::vector<OverlayVertex>& out;
    fvec2 solid;

    void triangle(const OverlayVertex& a, const OverlayVertex& b, const OverlayVertex& c) const {
        out.insert(out.end(), {a, b, c});
    }
    void quad(const OverlayVertex& a, const OverlayVertex& b, const OverlayVertex& c,
              const OverlayVertex& d) const {
        triangle(a, b, c);
        triangle(a, c, d);
    }
    OverlayVertex at(fvec2 p, std::uint32_t colour) const { return {p, solid, colour}; }
};

fvec2 unit_or_zero(fvec2 v) {
    const float length = glm::length(v);
    return length > 1e-6F ? v / length : fvec2(0);
}

float area_twice(std::span<const fvec2> corners) {
    float sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const fvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

/// For each corner the vector outwards that moves both adjacent edges by one pixel.
std::vector<fvec2> outward(std::span<const fvec2> corners) {
    const float side = area_twice(corners) > 0 ? 1.0F : -1.0F;
    const auto count = corners.size();
    const auto normal = [&](std::size_t i) {
        const fvec2 along = unit_or_zero(corners[(i + 1) % count] - corners[i]);
        return side * fvec2(along.y, -along.x);
    };
    std::vector<fvec2> out;
    for (std::size_t i = 0; i < count; ++i) {
        const fvec2 sum = normal((i + count - 1) % count) + normal(i);
        // Sharp corners, which would be moved far out, are limited to two pixels.
        out.push_back(sum / std::max(0.5F * glm::dot(sum, sum), 0.5F));
    }
    return out;
}

/// Fills a convex polygon by halving it down to triangles. A fan would consist of slivers as long as the
/// polygon, and a software rasteriser pays for every pixel block they touch.
void fill(const Pen& pen, std::span<const OverlayVertex> corners) {
    if (corners.size() < 3) return;
    const auto middle = corners.size() / 2;
    pen.triangle(corners.front(), corners[middle], corners.back());
    fill(pen, corners.first(middle + 1));
    fill(pen, corners.subspan(middle));
}

/// Draws a convex polygon whose edge fades out over one pixel.
void convex(const Pen& pen, std::span<const fvec2> corners, fvec4 colour) {
    const auto full = packed(colour), none = faded(full);
    const auto out = outward(corners);
    const auto inner = [&](std::size_t i) { return pen.at(corners[i] - 0.5F * out[i], full); };
    const auto outer = [&](std::size_t i) { return pen.at(corners[i] + 0.5F * out[i], none); };
    std::vector<OverlayVertex> filled;
    for (std::size_t i = 0; i < corners.size(); ++i) filled.push_back(inner(i));
    fill(pen, filled);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto next = (i + 1) % corners.size();
        pen.quad(inner(i), inner(next), outer(next), outer(i));
    }
}

/// Number of sides of an arc over `sweep` with which it deviates from a circle by at most a fifth of a pixel.
int arc_steps(float radius, float sweep) {
    if (!std::isfinite(radius) || !std::isfinite(sweep)) return 1;
    const float one = 2 * std::acos(1 - 0.2F / std::max(radius, 1.0F));
    return std::clamp(static_cast<int>(std::ceil(std::abs(sweep) / one)), 1, 256);
}

/// Unit vector at a clockwise angle from the top.
fvec2 clockwise(float angle) { return {std::sin(angle), -std::cos(angle)}; }

std::vector<fvec2> rounded_corners(const RectItem& r, float radius) {
    std::vector<fvec2> out;
    const std::array centres{
        fvec2(r.high.x - radius, r.low.y + radius), fvec2(r.high.x - radius, r.high.y - radius),
        fvec2(r.low.x + radius, r.high.y - radius), fvec2(r.low.x + radius, r.low.y + radius)};
    const int steps = arc_steps(radius, full_turn / 4);
    for (std::size_t corner = 0; corner < 4; ++corner) {
        for (int i = 0; i <= steps; ++i) {
            const float angle =
                full_turn / 4 *
                (static_cast<float>(corner) + static_cast<float>(i) / static_cast<float>(steps));
            out.push_back(centres[corner] + radius * clockwise(angle));
        }
    }
    return out;
}

void draw(const Pen& pen, const RectItem& r) {
    const float radius = std::min(r.corner, 0.5F * std::min(r.high.x - r.low.x, r.high.y - r.low.y));
    if (radius > 0.5F) return convex(pen, rounded_corners(r, radius), r.colour);
    const auto colour = packed(r.colour);
    pen.quad(pen.at(r.low, colour), pen.at({r.high.x, r.low.y}, colour), pen.at(r.high, colour),
             pen.at({r.low.x, r.high.y}, colour));
}

void draw(const Pen& pen, const TriangleItem& t) { convex(pen, std::array{t.a, t.b, t.c}, t.colour); }

void draw(const Pen& pen, const LineItem& l) {
    const fvec2 along = unit_or_zero(l.to - l.from);
    const fvec2 side = 0.5F * std::max(l.width, 1.0F) * fvec2(-along.y, along.x);
    // A line thinner than a pixel is drawn one pixel wide with less opacity.
    const fvec4 colour(fvec3(l.colour), l.colour.a * std::clamp(l.width, 0.0F, 1.0F));
    convex(pen, std::array{l.from - side, l.to - side, l.to + side, l.from + side}, colour);
}

/// One radial section of an arc: radii and colours from the inner fringe to the outer one.
struct Spoke {
    std::array<float, 4> radius;
    std::array<std::uint32_t, 4> colour;
};

Spoke spoke_of(const ArcItem& arc) {
    const auto full = packed(arc.colour), none = faded(full);
    const float inner = std::max(arc.inner, 0.0F);
    const float half = std::min(0.5F, 0.5F * (arc.outer - inner));
    // A slice of pie has no inner edge to be smoothed.
    return {{std::max(inner - 0.5F, 0.0F), inner > 0 ? inner + half : 0, arc.outer - half, arc.outer + 0.5F},
            {inner > 0 ? none : full, full, full, none}};
}

void draw(const Pen& pen, const ArcItem& arc) {
    if (!(arc.outer > std::max(arc.inner, 0.0F))) return;
    const float sweep = std::clamp(arc.sweep, -full_turn, full_turn);
    const int steps = arc_steps(arc.outer, sweep);
    const Spoke spoke = spoke_of(arc);
    const auto at = [&](int step, std::size_t ring) {
        const float angle = arc.start + sweep * static_cast<float>(step) / static_cast<float>(steps);
        return pen.at(arc.centre + spoke.radius[ring] * clockwise(angle), spoke.colour[ring]);
    };
    for (int i = 0; i < steps; ++i) {
        for (std::size_t ring = 0; ring < 3; ++ring) {
            pen.quad(at(i, ring), at(i, ring + 1), at(i + 1, ring + 1), at(i + 1, ring));
        }
    }
}

void draw_glyph(const Pen& pen, fvec2 low, glm::ivec2 texel, const Glyph& glyph, std::uint32_t colour) {
    const fvec2 size(glyph.width, glyph.height), from(texel);
    const fvec2 high = low + size, to = from + size;
    pen.quad({low, from, colour}, {{high.x, low.y}, {to.x, from.y}, colour}, {high, to, colour},
             {{low.x, high.y}, {from.x, to.y}, colour});
}

float aligned(const TextItem& item, int width) {
    switch (item.align) {
        case Align::left: break;
        case Align::centre: return item.position.x - 0.5F * static_cast<float>(width);
        case Align::right: return item.position.x - static_cast<float>(width);
    }
    return item.position.x;
}

void draw_text(const Pen& pen, const TextItem& item, Font& font, Atlas& atlas) {
    const int size = Font::whole_size(item.size);
    const auto colour = packed(item.colour);
    float top = std::round(item.position.y);
    for (const auto& line : lines_of(item.text)) {
        const auto laid = font.lay_out(line, size);
        // Rounded to whole pixels, since a glyph between pixels would be blurred.
        const float left = std::round(aligned(item, laid.width));
        for (const auto& placed : laid.glyphs) {
            const auto& glyph = font.glyph(placed.character, size);
            const auto texel = atlas.place(placed.character, size, glyph);
            if (texel.x < 0 || glyph.width == 0) continue;
            draw_glyph(pen, fvec2(left, top) + fvec2(placed.x, placed.y), texel, glyph, colour);
        }
        top += static_cast<float>(laid.height);
    }
}

}  // namespace

void Atlas::clear() {
    constexpr int first_height = 128;
    texels_.assign(std::size_t{width} * first_height, 0);
    texels_[0] = 255;
    buckets_.assign(512, {});
    shelf_y_ = 0;
    shelf_height_ = 1;
    pen_x_ = 2;
    full_ = false;
    changed_ = true;
}

std::vector<Atlas::Entry>& Atlas::bucket(Key key) {
    return buckets_[(static_cast<std::size_t>(key.character) * 31 + static_cast<std::size_t>(key.size)) %
                    buckets_.size()];
}

void Atlas::start_frame() {
    if (full_) clear();
}

bool Atlas::take_changed() { return std::exchange(changed_, false); }

glm::ivec2 Atlas::place(char32_t character, int size, const Glyph& glyph) {
    const Key key{character, size};
    auto& entries = bucket(key);
    for (const auto& entry : entries) {
        if (entry.key == key) return entry.at;
    }
    if (pen_x_ + glyph.width > width) {
        shelf_y_ += shelf_height_ + 1;
        shelf_height_ = 0;
        pen_x_ = 0;
    }
    const int bottom = shelf_y_ + glyph.height;
    if (bottom > limit || glyph.width > width) {
        full_ = true;
        return {-1, -1};
    }
    while (bottom > height()) texels_.resize(2 * texels_.size(), 0);
    const glm::ivec2 at(pen_x_, shelf_y_);
    for (int row = 0; row < glyph.height; ++row) {
        std::copy_n(glyph.coverage.begin() + row * glyph.width, glyph.width,
                    texels_.begin() + (at.y + row) * width + at.x);
    }
    pen_x_ += glyph.width + 1;
    shelf_height_ = std::max(shelf_height_, glyph.height);
    changed_ = true;
    entries.push_back({key, at});
    return at;
}

void build(const Overlay& overlay, Font& font, Atlas& atlas, std::vector<OverlayVertex>& out) {
    const Pen pen{out, atlas.solid()};
    for (const auto& item : overlay.items) {
        if (const auto* text = std::get_if<TextItem>(&item))
            draw_text(pen, *text, font, atlas);
        else if (const auto* rect = std::get_if<RectItem>(&item))
            draw(pen, *rect);
        else if (const auto* triangle = std::get_if<TriangleItem>(&item))
            draw(pen, *triangle);
        else if (const auto* arc = std::get_if<ArcItem>(&item))
            draw(pen, *arc);
        else if (const auto* line = std::get_if<LineItem>(&item))
            draw(pen, *line);
    }
}

}  // namespace thaum::render::detail
