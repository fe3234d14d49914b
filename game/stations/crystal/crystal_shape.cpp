#include "game/stations/crystal/crystal_shape.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace thaum::game::inline stations {
namespace {

/// Number of voxels along an edge of the body for which the sizes of parts are given.
constexpr double usual_voxels = 48;
/// Half the thickness of the key's bits, the teeth at its end (voxels).
constexpr double bit_thick = 2.4;
/// Half the thickness of the key's collar, the disc around its shaft (voxels).
constexpr double collar_thick = 1.3;
/// Density from which a voxel counts as solid.
constexpr float solid = 0.5F;
/// Minimum share of the key's volume that bites, which are balls cut out of the body, remove. Overlap of body
/// and key below which no more lumps, which are balls added to the body, are added.
constexpr double bitten = 0.2, rough_overlap = 0.52;

/// A box, relative to the body's middle, in voxels of a body with `usual_voxels` along each edge.
struct Bounds {
    vec3 low{}, high{};
};

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// Adds solid parts to a body of densities, or subtracts them. Only voxels within a part's bounds are
/// visited.
class Sculptor {
public:
    Sculptor(std::span<float> density, int voxels)
        : density_(density), count_(voxels), scale_(usual_voxels / voxels) {}

    /// Calls change(density, share) for each voxel near a part. The share is 0 outside of the part and 1
    /// inside.
    template <class Depth, class Change>
    void visit(const Bounds& bounds, Depth depth, Change change) {
        const auto low = first_voxel(bounds.low - scale_), high = first_voxel(bounds.high + 2 * scale_);
        for (int k = low[2]; k < high[2]; ++k) {
            for (int j = low[1]; j < high[1]; ++j) {
                for (int i = low[0]; i < high[0]; ++i) {
                    const double share = std::clamp(0.5 + depth(place(i, j, k)) / (2 * scale_), 0.0, 1.0);
                    if (share > 0) change(density_[at(i, j, k)], static_cast<float>(share), at(i, j, k));
                }
            }
        }
    }
    template <class Depth>
    void add(const Bounds& bounds, Depth depth) {
        visit(bounds, depth, [](float& d, float share, std::size_t) { d = std::max(d, share); });
    }

private:
    std::size_t at(int i, int j, int k) const {
        const auto n = static_cast<std::size_t>(count_);
        return static_cast<std::size_t>(i) +
               n * (static_cast<std::size_t>(j) + n * static_cast<std::size_t>(k));
    }
    vec3 place(int i, int j, int k) const { return scale_ * (vec3(i, j, k) - 0.5 * (count_ - 1)); }
    std::array<int, 3> first_voxel(vec3 from) const {
        std::array<int, 3> voxel{};
        for (int axis = 0; axis < 3; ++axis) {
            const double x = std::ceil(from[axis] / scale_ + 0.5 * (count_ - 1));
            voxel[static_cast<std::size_t>(axis)] = static_cast<int>(std::clamp(x, 0.0, double(count_)));
        }
        return voxel;
    }

    std::span<float> density_;
    int count_;
    /// edge length of this body's voxels, in voxels of a body with `usual_voxels` on each edge
    double scale_;
};

void add_ring(const KeyShape& key, Sculptor& sculptor) {
    const double out = key.ring_radius + key.ring_thick;
    const vec3 reach(out, out * std::max(1.0, key.ring_high), key.ring_thick), middle(key.ring_x, 0, 0);
    sculptor.add({middle - reach, middle + reach}, [&](vec3 p) {
        const double off = length_of(p.x - key.ring_x, p.y / key.ring_high) - key.ring_radius;
        return key.ring_thick - length_of(off, p.z);
    });
}

void add_shaft(const KeyShape& key, Sculptor& sculptor) {
    const double begin = key.ring_x + key.ring_radius, end = key.shaft_end - key.shaft_thick;
    const double r = key.shaft_thick;
    sculptor.add({{begin - r, -r, -r}, {end + r, r, r}}, [&](vec3 p) {
        const double past = p.x - std::clamp(p.x, begin, end);
        return r - std::sqrt(past * past + p.y * p.y + p.z * p.z);
    });
    const double x = key.collar_x;
    sculptor.add(
        {{x - collar_thick, -key.collar, -key.collar}, {x + collar_thick, key.collar, key.collar}},
        [&](vec3 p) { return std::min(key.collar - length_of(p.y, p.z), collar_thick - std::abs(p.x - x)); });
}

void add_bit(const KeyShape& key, const KeyBit& bit, Sculptor& sculptor) {
    const vec3 middle(bit.along, key.side * bit.deep / 2, 0), half(bit.half, bit.deep / 2, bit_thick);
    sculptor.add({middle - half, middle + half}, [&](vec3 p) {
        const vec3 in = half - glm::abs(p - middle);
        return std::min({in.x, in.y, in.z});
    });
}

/// A ball of material that is added to, or removed from, the crystal's uncarved shape (the rough body).
struct Ball {
    vec3 middle{};
    double radius{};
};

/// A ball near a random point of the key. The point is on the middle line of ring, shaft or bits. The ball is
/// then displaced by up to `off` voxels along each axis.
Ball ball_at(const KeyShape& key, Random& random, double off) {
    vec3 on;
    const double which = random.uniform();
    if (which < 0.45) {  // on the ring: a random direction, made without trigonometric functions
        vec2 way;
        do way = {random.uniform(-1, 1), random.uniform(-1, 1)};
        while (!(glm::dot(way, way) > 0.01 && glm::dot(way, way) <= 1));
        way *= key.ring_radius / length_of(way.x, way.y);
        on = {key.ring_x + way.x, way.y * key.ring_high, 0};
    } else if (which < 0.7) {
        on = {random.uniform(key.ring_x + key.ring_radius, key.shaft_end), 0, 0};
    } else {
        const auto& bit = key.bits[static_cast<std::size_t>(random.below(key.bit_count))];
        on = {bit.along, key.side * random.uniform(0.3, 1) * bit.deep, 0};
    }
    vec3 away;
    for (int axis = 2; axis >= 0; --axis) away[axis] = random.uniform(-off, off);
    return {on + away, random.uniform(3.0, 4.4)};
}

/// The crystal's uncarved shape (the rough body) while it is being made, with its present overlap with the
/// key.
class RoughBody {
public:
    /// `density` gets the body's densities.
    RoughBody(std::span<const float> key, int voxels, std::span<float> density)
        : key_(key), sculptor_(density, voxels) {
        std::copy(key.begin(), key.end(), density.begin());
        for (const float d : key) either_ += d >= solid ? 1 : 0;
        both_ = volume_ = either_;
    }

    void bite(const Ball& ball) {
        apply(ball, [](float d, float share) { return std::min(d, 1 - share); });
    }
    void grow(const Ball& ball) {
        apply(ball, [](float d, float share) { return std::max(d, share); });
    }
    double overlap() const { return static_cast<double>(both_) / static_cast<double>(either_); }
    /// Share of the key's volume that is still solid.
    double left() const { return static_cast<double>(both_) / static_cast<double>(volume_); }

private:
    template <class Change>
    void apply(const Ball& ball, Change change) {
        const vec3 r(ball.radius);
        const auto depth = [&](vec3 p) { return ball.radius - glm::length(p - ball.middle); };
        sculptor_.visit({ball.middle - r, ball.middle + r}, depth,
                        [&](float& d, float share, std::size_t voxel) {
                            const bool wanted = key_[voxel] >= solid;
                            const bool before = d >= solid;
                            d = change(d, share);
                            if (before == (d >= solid)) return;
                            if (wanted) before ? --both_ : ++both_;
                            if (!wanted) before ? --either_ : ++either_;
                        });
    }

    std::span<const float> key_;
    Sculptor sculptor_;
    std::size_t both_{}, either_{}, volume_{};
};

}  // namespace

KeyShape key_shape(std::uint64_t seed) {
    auto random = random_stream(seed, 1);
    KeyShape key;
    key.ring_radius = random.uniform(6.5, 8);
    key.ring_thick = random.uniform(2.5, 3.1);
    key.ring_high = random.uniform(0.85, 1.1);
    key.ring_x = -17 + key.ring_radius + key.ring_thick;
    key.shaft_end = 17;
    key.shaft_thick = random.uniform(2.3, 2.8);
    key.collar_x = key.ring_x + key.ring_radius + key.ring_thick + random.uniform(0.5, 1.5);
    key.collar = key.shaft_thick + random.uniform(1.2, 1.8);
    key.side = random.below(2) == 0 ? 1 : -1;
    key.bit_count = 2 + static_cast<std::size_t>(random.below(2));
    double end = key.shaft_end - random.uniform(0.6, 1.6);
    for (std::size_t i = 0; i < key.bit_count; ++i) {
        const double half = random.uniform(1.3, key.bit_count == 2 ? 2.2 : 1.7);
        key.bits[i] = {.along = end - half, .half = half, .deep = random.uniform(6.5, 10)};
        end -= 2 * half + random.uniform(1.6, 2.4);
    }
    return key;
}

void write_key_density(std::uint64_t seed, int voxels, std::span<float> density) {
    std::fill(density.begin(), density.end(), 0.0F);
    Sculptor sculptor(density, voxels);
    const auto key = key_shape(seed);
    add_ring(key, sculptor);
    add_shaft(key, sculptor);
    for (std::size_t i = 0; i < key.bit_count; ++i) add_bit(key, key.bits[i], sculptor);
}

std::vector<float> key_density(std::uint64_t seed, int voxels) {
    const auto n = static_cast<std::size_t>(voxels);
    std::vector<float> density(n * n * n);
    write_key_density(seed, voxels, density);
    return density;
}

void write_rough_density(std::uint64_t seed, std::span<const float> key, int voxels,
                         std::span<float> density) {
    constexpr double bite_off = 3.2, lump_off = 4.2;
    constexpr int max_balls = 200;
    auto random = random_stream(seed, 2);
    const auto shape = key_shape(seed);
    RoughBody rough(key, voxels, density);
    for (int i = 0; i < max_balls && rough.left() > 1 - bitten; ++i)
        rough.bite(ball_at(shape, random, bite_off));
    for (int i = 0; i < max_balls && rough.overlap() > rough_overlap; ++i)
        rough.grow(ball_at(shape, random, lump_off));
}

std::vector<float> rough_density(std::uint64_t seed, std::span<const float> key, int voxels) {
    std::vector<float> density(key.size());
    write_rough_density(seed, key, voxels, density);
    return density;
}

}  // namespace thaum::game::inline stations
