#include "game/scene/brew_texels.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline scene {
namespace {

// Brightness of the base fluid and of the substances. The brew is brightest in the middle, and on sides of
// clouds that face the light.
constexpr float base_light = 1.7F, substance_light = 1.5F;
constexpr float middle_light = 1.6F, rim_light = 0.6F;
constexpr float relief = 0.55F;
const fvec3 towards_light = glm::normalize(fvec3(0.35F, 0.85F, 0.25F));
constexpr float steepest = 3;  // gradient at which light and dark sides of clouds differ most (1/m)

constexpr float base_cover = 0.45F;  // opacity of a place without substances

constexpr float rim_foam = 0.62F;

constexpr int rings = 22, sectors = 60;

float smooth(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

/// A 3D array with one number for each texel. The index along x changes fastest.
struct Box {
    std::size_t x, y, z;
    std::size_t row(std::size_t j, std::size_t k) const { return x * (j + y * k); }
    std::size_t size() const { return x * y * z; }
};

Box box_of(const fluid::Lattice& lattice) {
    const auto n = [&](std::size_t axis) { return static_cast<std::size_t>(lattice.cells[axis]); };
    return {n(0), n(1), n(2)};
}

/// Data for drawing one vertical column of the fluid's cells.
struct Column {
    float lift{};   ///< displacement of the surface above the column, in cells
    float light{};  ///< brightness, largest in the middle of the brew
};

void find_columns(const BrewPicture& picture, const BrewPlace& place, std::size_t k,
                  std::vector<Column>& out) {
    const double h = picture.lattice.h;
    const vec3 corner = corner_of(picture, place);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const vec2 at(corner.x + h * (static_cast<double>(i) + 0.5),
                      corner.z + h * (static_cast<double>(k) + 0.5));
        const auto away = static_cast<float>(glm::length(at) / place.basin.radius);
        const double lift = picture.surface.asleep != 0 ? 0 : fluid::height_at(picture.surface, at);
        out[i] = {.lift = std::isfinite(lift) ? static_cast<float>(lift / h) : 0.0F,
                  .light = glm::mix(middle_light, rim_light, smooth(0, 1, away))};
    }
}

/// Copies one row of a substance as it is drawn. Where the surface stands higher, the contents below it are
/// drawn higher, too, but less so at greater depth.
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

/// Brightens colours to `lit` and makes them more saturated, because tone mapping makes bright colours pale.
void shine(std::span<const float> lit, Rows& colours) {
    auto& [r, g, b] = colours;
    for (std::size_t i = 0; i < lit.size(); ++i) {
        const float most = std::max(std::max(r[i], g[i]), std::max(b[i], 1e-12F));
        const float plain = 0.25F * lit[i], pure = 0.75F * lit[i] / most;
        r[i] *= plain + pure * r[i];
        g[i] *= plain + pure * g[i];
        b[i] *= plain + pure * b[i];
    }
}

/// Converts 0 to 1 into 0 to 255, after taking the square root if `root` is set. NaN becomes 0.
template <bool root>
void to_bytes(std::span<const float> shares, float times, std::span<int> out) {
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const float share = times * shares[i] > 0 ? times * shares[i] : 0.0F;
        const float shown = root ? std::sqrt(share) : share;
        // floor is used because lround is a function call, and the numbers are small enough for floor
        out[i] = static_cast<int>(std::floor((shown < 1 ? shown : 1.0F) * 255 + 0.5F));
    }
}

/// Densities of all substances as drawn, one box after another. The last box is their sum, limited to 1.
struct Seen {
    Box box;
    std::span<float> all;

    static constexpr std::size_t count = fluid::max_substances;
    float* density(std::size_t s) const { return &all[s * box.size()]; }
    float* sum() const { return &all[count * box.size()]; }
};

void find_layer(const BrewPicture& picture, const BrewPlace& place, std::size_t j, std::size_t k,
                std::span<const Column> columns, const Seen& seen) {
    const double depth = -(corner_of(picture, place).y + (static_cast<double>(j) + 0.5) * picture.lattice.h);
    const auto transmitted =
        static_cast<float>(fluid::transmitted(picture.surface.settings, std::max(depth, 0.0), 1));
    const auto row = seen.box.row(j, k);
    float* sum = seen.sum() + row;
    for (std::size_t s = 0; s < Seen::count; ++s) {
        if (picture.densities[s].empty()) continue;
        float* out = seen.density(s) + row;
        lift_row(picture.densities[s], picture.lattice, j, k, columns, transmitted, out);
        for (std::size_t i = 0; i < seen.box.x; ++i) sum[i] = std::min(sum[i] + out[i], 1.0F);
    }
}

/// Light of one row. Sides of a cloud that face the light are brighter, other sides darker.
void light_row(const Seen& seen, std::size_t j, std::size_t k, float per_two_h, const float* column_light,
               std::span<float> out) {
    const auto& box = seen.box;
    const auto row = [&](std::size_t y, std::size_t z) { return seen.sum() + box.row(y, z); };
    // At the border, where one neighbour is missing, the difference is one-sided.
    const auto before = [](std::size_t n) { return n == 0 ? 0 : n - 1; };
    const float *here = row(j, k), *below = row(before(j), k), *above = row(std::min(j + 1, box.y - 1), k),
                *behind = row(j, before(k)), *ahead = row(j, std::min(k + 1, box.z - 1));
    for (std::size_t i = 0; i < box.x; ++i) {
        const float x = per_two_h * (here[std::min(i + 1, box.x - 1)] - here[before(i)]),
                    y = per_two_h * (above[i] - below[i]), z = per_two_h * (ahead[i] - behind[i]);
        const float length = std::sqrt(x * x + y * y + z * z);
        const float towards = x * towards_light.x + y * towards_light.y + z * towards_light.z;
        out[i] = column_light[i] * glm::mix(base_light, substance_light, here[i]) *
                 (1 - relief * towards / std::max(length, steepest));
    }
}

/// Height, slopes and speed of the surface at a point.
struct SkinPoint {
    float height{}, slope_x{}, slope_z{}, speed{};
};

SkinPoint node(const fluid::SpringSurface& surface, std::size_t x, std::size_t z) {
    const auto& s = surface.settings;
    const std::size_t last = s.nodes - 1;
    const std::size_t x0 = x == 0 ? 0 : x - 1, x1 = std::min(x + 1, last), z0 = z == 0 ? 0 : z - 1,
                      z1 = std::min(z + 1, last);
    const auto at = [&](std::size_t i, std::size_t j) {
        return surface.height[fluid::surface_node_index(s, i, j)];
    };
    const double spacing = fluid::surface_node_spacing(s);
    return {static_cast<float>(at(x, z)),
            static_cast<float>((at(x1, z) - at(x0, z)) / (static_cast<double>(x1 - x0) * spacing)),
            static_cast<float>((at(x, z1) - at(x, z0)) / (static_cast<double>(z1 - z0) * spacing)),
            static_cast<float>(std::abs(surface.velocity[fluid::surface_node_index(s, x, z)]))};
}

/// All nodes of the simulated surface's grid, row by row along x. Empty for a surface at rest.
std::vector<SkinPoint> nodes_of(const fluid::SpringSurface& surface) {
    std::vector<SkinPoint> out;
    if (surface.asleep != 0 || surface.height.empty()) return out;
    for (std::size_t z = 0; z < surface.settings.nodes; ++z) {
        for (std::size_t x = 0; x < surface.settings.nodes; ++x) {
            const auto n = node(surface, x, z);
            const bool is_one = std::isfinite(n.height + n.slope_x + n.slope_z + n.speed);
            out.push_back(is_one ? n : SkinPoint{});
        }
    }
    return out;
}

/// Interpolates the nodes at the point `from`, relative to the middle (m). Points outside are clamped to the
/// border.
SkinPoint point(const fluid::SpringSurfaceSettings& s, std::span<const SkinPoint> nodes, vec2 from) {
    if (nodes.empty()) return {};
    const vec2 at =
        glm::clamp((from + s.side / 2) / fluid::surface_node_spacing(s), vec2(0), vec2(s.nodes - 1));
    const auto x = std::min(static_cast<std::size_t>(at.x), std::size_t{s.nodes} - 2),
               z = std::min(static_cast<std::size_t>(at.y), std::size_t{s.nodes} - 2);
    const auto px = static_cast<float>(at.x - static_cast<double>(x)),
               pz = static_cast<float>(at.y - static_cast<double>(z));
    SkinPoint sum;
    for (const std::size_t j : {0U, 1U}) {
        for (const std::size_t i : {0U, 1U}) {
            const auto& n = nodes[(z + j) * s.nodes + x + i];
            const float weight = (i == 0 ? 1 - px : px) * (j == 0 ? 1 - pz : pz);
            sum.height += weight * n.height;
            sum.slope_x += weight * n.slope_x;
            sum.slope_z += weight * n.slope_z;
            sum.speed += weight * n.speed;
        }
    }
    return sum;
}

/// Amount of foam. Foam appears where the surface is steep or moves fast.
float foam_of(const SkinPoint& p) {
    return std::min(smooth(0.25F, 0.8F, std::hypot(p.slope_x, p.slope_z)) + smooth(0.35F, 1.5F, p.speed),
                    1.0F);
}

/// Radius of the brew's surface at rest (m).
double surface_radius(const BrewPlace& place) { return width_at(place.basin, 0); }

render::SkinVertex skin_vertex(const SkinPoint& p, const BrewPlace& place, vec2 from) {
    // Foam along the wall.
    const float rim =
        rim_foam * smooth(0.93F, 0.99F, static_cast<float>(glm::length(from) / surface_radius(place)));
    return {.position = fvec3(place.middle + vec3(from.x, p.height, from.y)),
            .normal = glm::normalize(fvec3(-p.slope_x, 1, -p.slope_z)),
            .foam = std::max(foam_of(p), rim)};
}

}  // namespace

vec3 corner_of(const BrewPicture& picture, const BrewPlace& place) {
    return {-place.basin.radius, -picture.lattice.h * picture.lattice.cells[1], -place.basin.radius};
}

void mix(const BrewColours& colours, const Rows& densities, Rows& out) {
    const std::size_t count = densities[0].size();
    const float *a = densities[0].data(), *b = densities[1].data(), *c = densities[2].data();
    for (int channel = 0; channel < 3; ++channel) {
        const auto of = [&](std::size_t s) { return colours.substances[s][channel]; };
        const float base = colours.base[channel], of_a = of(0), of_b = of(1), of_c = of(2);
        auto& row = out[static_cast<std::size_t>(channel)];
        row.resize(count);
        float* to = row.data();
        for (std::size_t i = 0; i < count; ++i) {
            const float most = std::max(std::max(a[i], b[i]), std::max(c[i], 1e-20F));
            const float all = std::min(a[i] + b[i] + c[i], 1.0F);
            to[i] = base + all * ((a[i] * of_a + b[i] * of_b + c[i] * of_c) / most - base);
        }
    }
}

namespace {

/// Working memory for one row of texels.
struct RowMemory {
    std::vector<Column> columns;
    std::vector<float> lit, cover;
    Rows densities, colours;
    std::array<std::vector<int>, 4> bytes;

    explicit RowMemory(std::size_t n) : columns(n), lit(n), cover(n) {
        for (auto& row : densities) row.resize(n);
        for (auto& row : bytes) row.resize(n);
    }
};

void make_row(const Seen& seen, const BrewColours& colours, std::size_t j, std::size_t k, float per_two_h,
              const float* column_light, RowMemory& memory, render::Texel* out) {
    const auto row = seen.box.row(j, k);
    light_row(seen, j, k, per_two_h, column_light, memory.lit);
    for (std::size_t s = 0; s < Seen::count; ++s)
        std::copy_n(seen.density(s) + row, seen.box.x, memory.densities[s].begin());
    mix(colours, memory.densities, memory.colours);
    shine(memory.lit, memory.colours);
    for (std::size_t i = 0; i < seen.box.x; ++i)
        memory.cover[i] = glm::mix(base_cover, 1.0F, seen.sum()[row + i]);
    for (std::size_t c = 0; c < 3; ++c)
        to_bytes<true>(memory.colours[c], 1 / brew_brightest, memory.bytes[c]);
    to_bytes<false>(memory.cover, 1, memory.bytes[3]);
    const auto& [r, g, b, a] = memory.bytes;
    for (std::size_t i = 0; i < seen.box.x; ++i) {
        out[i] = {static_cast<std::uint8_t>(r[i]), static_cast<std::uint8_t>(g[i]),
                  static_cast<std::uint8_t>(b[i]), static_cast<std::uint8_t>(a[i])};
    }
}

}  // namespace

void make_texels(const BrewPicture& picture, const BrewPlace& place, std::vector<float>& scratch,
                 std::vector<render::Texel>& out) {
    const auto box = box_of(picture.lattice);
    scratch.assign((Seen::count + 1) * box.size(), 0.0F);
    out.resize(box.size());
    const Seen seen{box, scratch};
    RowMemory memory(box.x);
    std::vector<float> light(box.x * box.z);
    for (std::size_t k = 0; k < box.z; ++k) {
        find_columns(picture, place, k, memory.columns);
        for (std::size_t i = 0; i < box.x; ++i) light[k * box.x + i] = memory.columns[i].light;
        for (std::size_t j = 0; j < box.y; ++j) find_layer(picture, place, j, k, memory.columns, seen);
    }
    const auto per_two_h = static_cast<float>(0.5 / picture.lattice.h);
    for (std::size_t k = 0; k < box.z; ++k) {
        for (std::size_t j = 0; j < box.y; ++j)
            make_row(seen, picture.colours, j, k, per_two_h, &light[k * box.x], memory, &out[box.row(j, k)]);
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

void make_skin(const fluid::SpringSurface& surface, const BrewPlace& place,
               std::vector<render::SkinVertex>& out) {
    // The drawn surface extends a little into the bowl's wall, so that no gap shows.
    const double drawn = 1.02 * surface_radius(place);
    const auto nodes = nodes_of(surface);
    const auto add = [&](vec2 from) {
        out.push_back(skin_vertex(point(surface.settings, nodes, from), place, from));
    };
    std::array<vec2, sectors> ways;
    for (int sector = 0; sector < sectors; ++sector) {
        const double angle = 2 * pi * sector / sectors;
        ways[static_cast<std::size_t>(sector)] = {std::cos(angle), -std::sin(angle)};
    }
    out.clear();
    add(vec2(0));
    for (int ring = 1; ring <= rings; ++ring) {
        for (const vec2 way : ways) add(drawn * ring / rings * way);
    }
}

}  // namespace thaum::game::inline scene
