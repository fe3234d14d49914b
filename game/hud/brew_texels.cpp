#include "game/hud/brew_texels.h"

#include <algorithm>
#include <cmath>

namespace thaum::game {
namespace {

// Light of the brew: hottest in the middle, and where a cloud of a substance turns its side up.
constexpr float base_light = 1.7F, substance_light = 1.5F;
constexpr float middle_light = 1.6F, rim_light = 0.6F;
constexpr float relief = 0.55F;
const fvec3 towards_light = glm::normalize(fvec3(0.35F, 0.85F, 0.25F));
constexpr float steepest = 3;  // 1/m: a gradient as strong as this shows as much as one can

constexpr float base_cover = 0.45F;  // of a place without substances

constexpr float rim_foam = 0.62F;

constexpr int rings = 22, sectors = 60;

float smooth(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

/// Boxes of numbers, one for each texel; x is contiguous.
struct Box {
    std::size_t x, y, z;
    std::size_t row(std::size_t j, std::size_t k) const { return x * (j + y * k); }
    std::size_t size() const { return x * y * z; }
};

Box box_of(const fluid::Lattice& lattice) {
    const auto n = [&](std::size_t axis) { return static_cast<std::size_t>(lattice.cells[axis]); };
    return {n(0), n(1), n(2)};
}

/// Of one column of cells.
struct Column {
    float lift{};   ///< cells: the displacement of the surface above
    float light{};  ///< grows towards the middle, where it wells up
};

void find_columns(const BrewPicture& picture, const BrewPlace& place, std::size_t k,
                  std::vector<Column>& out) {
    const double h = picture.lattice.h;
    const vec3 corner = corner_of(picture, place);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const vec2 at(corner.x + h * (static_cast<double>(i) + 0.5),
                      corner.z + h * (static_cast<double>(k) + 0.5));
        const auto away = static_cast<float>(glm::length(at) / place.basin.radius);
        const double lift = picture.sheet.asleep != 0 ? 0 : fluid::height_at(picture.sheet, at);
        out[i] = {.lift = std::isfinite(lift) ? static_cast<float>(lift / h) : 0.0F,
                  .light = glm::mix(middle_light, rim_light, smooth(0, 1, away))};
    }
}

/// One row of a substance as it is seen, lifted with the surface: what is seen at a layer stands at rest elsewhere in its column.
void lift_row(const fluid::Samples& samples, const fluid::Lattice& lattice, std::size_t j, std::size_t k,
              std::span<const Column> columns, float transmitted, float* out) {
    const float top = static_cast<float>(lattice.cells[1] - 1);
    const float* first = &samples[static_cast<std::size_t>(lattice.at(0, 0, static_cast<int>(k)))];
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const float from = std::clamp(static_cast<float>(j) - columns[i].lift * transmitted, 0.0F, top);
        const float low = std::floor(from), part = from - low;
        const float* at = first + i + static_cast<std::ptrdiff_t>(low) * lattice.stride[1];
        const float above = low < top ? at[lattice.stride[1]] : *at;
        const float seen = *at + part * (above - *at);
        out[i] = seen > 0 ? seen : 0;
    }
}

/// 1/m; as at the sides beyond them.
fvec3 gradient(const float* of, const Box& box, std::size_t i, std::size_t j, std::size_t k,
               float per_two_h) {
    const auto at = [&](std::size_t x, std::size_t y, std::size_t z) { return of[box.row(y, z) + x]; };
    const auto before = [](std::size_t n) { return n == 0 ? 0 : n - 1; };
    return per_two_h * fvec3(at(std::min(i + 1, box.x - 1), j, k) - at(before(i), j, k),
                             at(i, std::min(j + 1, box.y - 1), k) - at(i, before(j), k),
                             at(i, j, std::min(k + 1, box.z - 1)) - at(i, j, before(k)));
}

/// The same hue with less white in it: the tone curve makes pale what shines.
fvec3 vivid(fvec3 c) {
    const float most = std::max({c.r, c.g, c.b});
    return most > 0 ? c * (0.25F + 0.75F * c / most) : c;
}

/// What a side of a cloud that faces the light gives more, and one that faces away less.
float lit_by(fvec3 slope) {
    const float square = glm::dot(slope, slope);
    if (!(square > 1e-8F)) return 1;
    return 1 - relief * glm::dot(slope, towards_light) / std::max(std::sqrt(square), steepest);
}

/// The densities of all substances as they are seen, one box after the other, then their sum, at most 1.
struct Seen {
    Box box;
    std::span<float> all;

    static constexpr std::size_t count = fluid::substances_most;
    float* density(std::size_t s) const { return &all[s * box.size()]; }
    float* sum() const { return &all[count * box.size()]; }
};

void find_layer(const BrewPicture& picture, const BrewPlace& place, std::size_t j, std::size_t k,
                std::span<const Column> columns, const Seen& seen) {
    const double depth = -(corner_of(picture, place).y + (static_cast<double>(j) + 0.5) * picture.lattice.h);
    const auto transmitted =
        static_cast<float>(fluid::transmitted(picture.sheet.settings, std::max(depth, 0.0), 1));
    const auto row = seen.box.row(j, k);
    float* sum = seen.sum() + row;
    for (std::size_t s = 0; s < Seen::count; ++s) {
        if (picture.densities[s].empty()) continue;
        float* out = seen.density(s) + row;
        lift_row(picture.densities[s], picture.lattice, j, k, columns, transmitted, out);
        for (std::size_t i = 0; i < seen.box.x; ++i) sum[i] = std::min(sum[i] + out[i], 1.0F);
    }
}

/// A sheet's heights, slopes and speed between its nodes.
struct SheetPoint {
    float height{}, slope_x{}, slope_z{}, speed{};
};

SheetPoint node(const fluid::Sheet& sheet, std::size_t x, std::size_t z) {
    const auto& s = sheet.settings;
    const std::size_t last = s.nodes - 1;
    const std::size_t x0 = x == 0 ? 0 : x - 1, x1 = std::min(x + 1, last), z0 = z == 0 ? 0 : z - 1,
                      z1 = std::min(z + 1, last);
    const auto at = [&](std::size_t i, std::size_t j) { return sheet.height[fluid::sheet_index(s, i, j)]; };
    const double spacing = fluid::sheet_spacing(s);
    return {static_cast<float>(at(x, z)),
            static_cast<float>((at(x1, z) - at(x0, z)) / (static_cast<double>(x1 - x0) * spacing)),
            static_cast<float>((at(x, z1) - at(x, z0)) / (static_cast<double>(z1 - z0) * spacing)),
            static_cast<float>(std::abs(sheet.velocity[fluid::sheet_index(s, x, z)]))};
}

/// `from` the middle of the sheet, m; beyond its sides as at the nearest place.
SheetPoint point(const fluid::Sheet& sheet, vec2 from) {
    if (sheet.asleep != 0 || sheet.height.empty()) return {};
    const auto& s = sheet.settings;
    const double last = s.nodes - 1;
    const vec2 at = glm::clamp((from + s.side / 2) / fluid::sheet_spacing(s), vec2(0), vec2(last));
    const auto x = std::min(static_cast<std::size_t>(at.x), static_cast<std::size_t>(s.nodes - 2)),
               z = std::min(static_cast<std::size_t>(at.y), static_cast<std::size_t>(s.nodes - 2));
    const auto px = static_cast<float>(at.x - static_cast<double>(x)),
               pz = static_cast<float>(at.y - static_cast<double>(z));
    SheetPoint sum;
    for (const std::size_t j : {0U, 1U}) {
        for (const std::size_t i : {0U, 1U}) {
            const auto n = node(sheet, x + i, z + j);
            const float weight = (i == 0 ? 1 - px : px) * (j == 0 ? 1 - pz : pz);
            sum.height += weight * n.height;
            sum.slope_x += weight * n.slope_x;
            sum.slope_z += weight * n.slope_z;
            sum.speed += weight * n.speed;
        }
    }
    const bool is_one = std::isfinite(sum.height + sum.slope_x + sum.slope_z + sum.speed);
    return is_one ? sum : SheetPoint{};
}

/// Where the surface tears: it is steep, or it snaps back.
float foam_of(const SheetPoint& p) {
    return std::min(smooth(0.25F, 0.8F, std::hypot(p.slope_x, p.slope_z)) + smooth(0.35F, 1.5F, p.speed),
                    1.0F);
}

/// m, of the level surface.
double surface_radius(const BrewPlace& place) { return width_at(place.basin, 0); }

render::SkinVertex skin_vertex(const fluid::Sheet& sheet, const BrewPlace& place, double out, double angle) {
    const vec2 from(out * std::cos(angle), -out * std::sin(angle));
    const auto p = point(sheet, from);
    // A ring of foam hangs on the wall.
    const float rim = rim_foam * smooth(0.93F, 0.99F, static_cast<float>(out / surface_radius(place)));
    return {.position = fvec3(place.middle + vec3(from.x, p.height, from.y)),
            .normal = glm::normalize(fvec3(-p.slope_x, 1, -p.slope_z)),
            .foam = std::max(foam_of(p), rim)};
}

}  // namespace

fvec3 mixed(const BrewColours& colours, std::span<const float> densities) {
    fvec3 sum(0);
    float all = 0, most = 0;
    for (std::size_t s = 0; s < std::min(densities.size(), colours.substances.size()); ++s) {
        const float density = std::max(densities[s], 0.0F);
        sum += density * colours.substances[s];
        all += density;
        most = std::max(most, density);
    }
    if (!(most > 0)) return colours.base;
    return glm::mix(colours.base, sum / most, std::min(all, 1.0F));
}

render::Texel texel_of(fvec3 light, float brightest, float cover) {
    // No number counts as 0.
    const auto share = [](float v) { return v > 0 ? std::min(v, 1.0F) : 0.0F; };
    const auto byte = [&](float v) { return static_cast<std::uint8_t>(share(v) * 255 + 0.5F); };
    const auto root = [&](float v) { return byte(std::sqrt(share(v / brightest))); };
    return {root(light.r), root(light.g), root(light.b), byte(cover)};
}

vec3 corner_of(const BrewPicture& picture, const BrewPlace& place) {
    return {-place.basin.radius, -picture.lattice.h * picture.lattice.cells[1], -place.basin.radius};
}

void make_texels(const BrewPicture& picture, const BrewPlace& place, std::vector<float>& scratch,
                 std::vector<render::Texel>& out) {
    const auto box = box_of(picture.lattice);
    scratch.assign((Seen::count + 1) * box.size(), 0.0F);
    out.resize(box.size());
    const Seen seen{box, scratch};
    std::vector<Column> columns(box.x);
    std::vector<float> light(box.x * box.z);
    for (std::size_t k = 0; k < box.z; ++k) {
        find_columns(picture, place, k, columns);
        for (std::size_t i = 0; i < box.x; ++i) light[k * box.x + i] = columns[i].light;
        for (std::size_t j = 0; j < box.y; ++j) find_layer(picture, place, j, k, columns, seen);
    }
    const auto per_two_h = static_cast<float>(0.5 / picture.lattice.h);
    for (std::size_t k = 0; k < box.z; ++k) {
        for (std::size_t j = 0; j < box.y; ++j) {
            for (std::size_t i = 0; i < box.x; ++i) {
                const auto n = box.row(j, k) + i;
                const float all = seen.sum()[n];
                const float shine = light[k * box.x + i] * glm::mix(base_light, substance_light, all) *
                                    lit_by(gradient(seen.sum(), box, i, j, k, per_two_h));
                const std::array here{seen.density(0)[n], seen.density(1)[n], seen.density(2)[n]};
                out[n] = texel_of(shine * vivid(mixed(picture.colours, here)), brew_brightest,
                                  glm::mix(base_cover, 1.0F, all));
            }
        }
    }
}

void make_skin_indices(std::vector<std::uint32_t>& out) {
    const auto at = [](int ring, int sector) {
        return ring == 0 ? 0U : static_cast<std::uint32_t>(1 + (ring - 1) * sectors + sector % sectors);
    };
    out.clear();
    for (int sector = 0; sector < sectors; ++sector) {
        out.insert(out.end(), {at(0, 0), at(1, sector), at(1, sector + 1)});
        for (int ring = 1; ring < rings; ++ring) {
            out.insert(out.end(), {at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1)});
            out.insert(out.end(), {at(ring, sector), at(ring + 1, sector + 1), at(ring, sector + 1)});
        }
    }
}

void make_skin(const fluid::Sheet& sheet, const BrewPlace& place, std::vector<render::SkinVertex>& out) {
    out.clear();
    // A little into the wall, so that no gap is seen.
    const double drawn = 1.02 * surface_radius(place);
    out.push_back(skin_vertex(sheet, place, 0, 0));
    for (int ring = 1; ring <= rings; ++ring) {
        for (int sector = 0; sector < sectors; ++sector)
            out.push_back(skin_vertex(sheet, place, drawn * ring / rings, 2 * pi * sector / sectors));
    }
}

}  // namespace thaum::game
