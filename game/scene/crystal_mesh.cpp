#include "game/scene/crystal_mesh.h"

#include <array>
#include <utility>
#include <vector>

// Surface nets (Gibson 1998, "Constrained elastic surface nets"): each cell of samples through which the
// surface passes has one vertex, in the middle of the places where the surface cuts the cell's edges. Each
// edge between samples that is cut has a quad between the four cells around it.
namespace thaum::game::inline scene {
namespace {

using ivec3 = glm::ivec3;

constexpr float level = 0.5F;

/// Index of a position in the array of a cube with `side` elements along each axis, x contiguous.
std::size_t place_in(int side, ivec3 at) {
    const auto n = static_cast<std::size_t>(side), x = static_cast<std::size_t>(at.x),
               y = static_cast<std::size_t>(at.y), z = static_cast<std::size_t>(at.z);
    return x + n * (y + n * z);
}

struct Sample {
    float density{};
    fvec3 colour{};
};

/// Densities of the crystal at half the resolution, surrounded by empty samples.
class Samples {
public:
    Samples(std::span<const float> density, std::span<const field::Rgb8> colours, int side)
        : count_(side / 2 + 2) {
        all_.resize(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_) *
                    static_cast<std::size_t>(count_));
        for (int z = 0; z < side; ++z)
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) {
                    const auto from = place_in(side, {x, y, z});
                    auto& to = all_[index(x / 2 + 1, y / 2 + 1, z / 2 + 1)];
                    const fvec3 root = fvec3(colours[from].r, colours[from].g, colours[from].b) / 255.0F;
                    to.density += density[from] / 8;
                    to.colour += root * root / 8.0F;
                }
    }
    int count() const { return count_; }
    const Sample& operator()(int x, int y, int z) const { return all_[index(x, y, z)]; }
    std::size_t index(int x, int y, int z) const { return place_in(count_, {x, y, z}); }

private:
    int count_;
    std::vector<Sample> all_;
};

/// Corner of a cell: bit 0 is x, bit 1 is y, bit 2 is z.
ivec3 corner_of_cell(int i) { return {i & 1, (i >> 1) & 1, (i >> 2) & 1}; }

/// The vertex of a cell through which the surface passes. Its normal points towards lower density.
render::Vertex vertex_of(const Samples& samples, ivec3 cell) {
    std::array<float, 8> density{};
    fvec3 sum(0), slope(0), colour(0);
    float cuts = 0, inside = 0;
    for (int i = 0; i < 8; ++i) {
        const ivec3 c = corner_of_cell(i), at = cell + c;
        const auto& sample = samples(at.x, at.y, at.z);
        density.at(static_cast<std::size_t>(i)) = sample.density;
        slope += sample.density * (2.0F * fvec3(c) - 1.0F);
        if (sample.density < level) continue;
        colour += sample.colour;
        ++inside;
    }
    for (int i = 0; i < 8; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (corner_of_cell(i)[axis] != 0) continue;
            const float a = density.at(static_cast<std::size_t>(i)),
                        b = density.at(static_cast<std::size_t>(i) +
                                       (std::size_t{1} << static_cast<unsigned>(axis)));
            if ((a < level) == (b < level)) continue;
            fvec3 at(corner_of_cell(i));
            at[axis] = (level - a) / (b - a);
            sum += at;
            ++cuts;
        }
    }
    const float steep = glm::length(slope);
    return {.position = fvec3(cell) + sum / cuts,
            .normal = steep > 0 ? -slope / steep : fvec3(0, 1, 0),
            .colour = colour / inside};
}

/// Calls visit(x, y, z) for all positions below `count` along each axis.
template <class Visit>
void each_place(int count, Visit visit) {
    for (int z = 0; z < count; ++z)
        for (int y = 0; y < count; ++y)
            for (int x = 0; x < count; ++x) visit(ivec3(x, y, z));
}

class Net {
public:
    explicit Net(const Samples& samples) : samples_(samples) {
        vertices_.assign(samples.index(0, 0, samples.count()), none);
        each_place(samples.count() - 1, [&](ivec3 cell) {
            int inside = 0;
            for (int i = 0; i < 8; ++i) inside += is_inside(cell + corner_of_cell(i)) ? 1 : 0;
            if (inside == 0 || inside == 8) return;
            vertices_[at(cell)] = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(vertex_of(samples_, cell));
        });
        each_place(samples.count() - 1, [&](ivec3 from) {
            for (int axis = 0; axis < 3; ++axis) add_quad(from, axis);
        });
    }

    render::MeshData mesh;

private:
    static constexpr std::uint32_t none = 0xFFFF'FFFF;

    bool is_inside(ivec3 p) const { return samples_(p.x, p.y, p.z).density >= level; }
    std::size_t at(ivec3 p) const { return samples_.index(p.x, p.y, p.z); }

    /// Adds the quad for the edge that starts at a sample and runs along an axis, if the surface cuts this
    /// edge.
    void add_quad(ivec3 from, int axis) {
        ivec3 along(0), u(0), v(0);
        along[axis] = u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
        const bool inside = is_inside(from);
        if (inside == is_inside(from + along)) return;
        std::array corners{vertices_[at(from - u - v)], vertices_[at(from - v)], vertices_[at(from)],
                           vertices_[at(from - u)]};
        if (!inside) std::swap(corners[1], corners[3]);
        mesh.indices.insert(mesh.indices.end(),
                            {corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]});
    }

    const Samples& samples_;
    std::vector<std::uint32_t> vertices_;
};

}  // namespace

render::MeshData crystal_mesh(std::span<const float> density, std::span<const field::Rgb8> colours, int side,
                              float spacing) {
    const Samples samples(density, colours, side);
    Net net(samples);
    const float half_way = 0.5F * static_cast<float>(samples.count() - 1);
    for (auto& vertex : net.mesh.vertices) vertex.position = 2 * spacing * (vertex.position - half_way);
    return std::move(net.mesh);
}

}  // namespace thaum::game::inline scene
