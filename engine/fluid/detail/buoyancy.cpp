#include "fluid/detail/buoyancy.h"

#include <algorithm>
#include <numeric>

#include "fluid/detail/split.h"

namespace thaum::fluid {
namespace {

/// Rate of change of a row of values by advection along one axis, times -2 h (m/s for values without unit).
struct AxisAdvection {
    const float* velocity;
    const float* open;  ///< shares of the faces that no solid covers; null: all faces are open
    std::ptrdiff_t step;

    Floats8 flow(std::ptrdiff_t i) const {
        return open != nullptr ? load(velocity + i) * load(open + i) : load(velocity + i);
    }
    Floats8 change(const float* value, std::ptrdiff_t i) const {
        const Floats8 here = load(value + i);
        return flow(i + step) * (load(value + i + step) - here) + flow(i) * (here - load(value + i - step));
    }
};

/// The open faces (not wholly covered by a solid) across one axis, in a range of cells: those of one level
/// (cells at one height), or of all levels if the axis is x.
struct LevelFaces {
    const Rows& rows;
    std::size_t axis;
    Cells first, end;
    int order;
    const float* weight;
    const float* open;  ///< open shares of the faces; null: all faces are open

    /// Calls `visit` with the index of each group of eight faces, and its position along x.
    template <class Visit>
    void each_8(const Visit& visit) const {
        for (int k = first[2]; k < end[2]; ++k) {
            for (int j = first[1]; j < end[1]; ++j) {
                const Row row = rows.at(j, k);
                const auto x = row.at - rows.lattice.at(0, j, k);
                for (std::ptrdiff_t i = 0; i < row.count; i += 8) visit(row.at + i, x + i);
            }
        }
    }
    Floats8 open_at(std::ptrdiff_t at) const { return open != nullptr ? load(open + at) : zero8 + 1.0F; }
    /// Sum of the weights of the substances on both sides of a face. At order 4 the flow through a face is
    /// (26 u[0] - u[-1] - u[1]) / 24, so the densities beside the face are weighted in the same way. Force
    /// times velocity then equals the potential energy that the flow carries down.
    Floats8 both_sides(std::ptrdiff_t at) const {
        const auto s = rows.lattice.stride[axis];
        const Floats8 near = load(weight + at) + load(weight + at - s);
        if (order == 2) return near;
        return (25.0F / 24) * near - (1.0F / 24) * (load(weight + at + s) + load(weight + at - 2 * s));
    }
};

/// For each position along x, the mean over the open faces of one level (cells at one height) of the sum of
/// the weights on both sides of a face. If the levels do not lie across x, all positions have the same mean.
using LevelMeans = std::array<float, max_cells>;

LevelMeans means_of(const LevelFaces& faces) {
    std::array<double, max_cells> sums{};
    std::array<float, max_cells> counts{};  // number of open faces at each position along x
    faces.each_8([&](std::ptrdiff_t at, std::ptrdiff_t x) {
        const Floats8 share = faces.open_at(at);
        const Floats8 both = share > zero8 ? faces.both_sides(at) : zero8;
        for (std::ptrdiff_t lane = 0; lane < 8; ++lane)
            sums[static_cast<std::size_t>(x + lane)] += static_cast<double>(both[lane]);
        float* count = counts.data() + x;
        store(count, load(count) + (share > zero8 ? zero8 + 1.0F : zero8));
    });
    const auto nx = faces.rows.lattice.cells[0];
    if (faces.axis != 0) {
        std::fill_n(sums.begin(), nx, std::accumulate(sums.begin(), sums.begin() + nx, 0.0));
        std::fill_n(counts.begin(), nx, std::accumulate(counts.begin(), counts.begin() + nx, 0.0F));
    }
    LevelMeans means{};
    std::transform(sums.begin(), sums.begin() + nx, counts.begin(), means.begin(),
                   [](double sum, float count) {
                       return count > 0 ? static_cast<float>(sum / static_cast<double>(count)) : 0.0F;
                   });
    return means;
}

/// Adds the weight of the substances to the forces on the faces, minus its mean over each level (cells at one
/// height), because pressure balances that mean.
void add_weight_of(const LevelFaces& faces, float pull, const LevelMeans& means, float* force) {
    faces.each_8([&](std::ptrdiff_t at, std::ptrdiff_t x) {
        const Floats8 more = 0.5F * pull * (faces.both_sides(at) - load(means.data() + x));
        store(force + at, load(force + at) + (faces.open_at(at) > zero8 ? more : zero8));
    });
}

}  // namespace

void add_weight(const Rows& rows, int order, const std::array<Samples, 3>* open, const vec3& gravity,
                const Samples& weight, std::array<Samples, 3>& force, Team& team) {
    const std::size_t down = gravity.y != 0 ? 1 : gravity.z != 0 ? 2 : 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto pull = static_cast<float>(gravity[static_cast<int>(axis)]);
        if (pull == 0) continue;
        const LevelFaces all{.rows = rows,
                             .axis = axis,
                             .first = {},
                             .end = rows.lattice.cells,
                             .order = order,
                             .weight = weight.data(),
                             .open = open != nullptr ? (*open)[axis].data() : nullptr};
        // The work is divided into groups of rows. For axes y and z, a group is one level (cells at one
        // position along the axis). A row along x crosses all levels of x, so all rows are then one group.
        const int groups = axis == 0 ? 1 : rows.lattice.cells[axis];
        each_slice(team, Split(team, groups), [&](Layers slice, unsigned) {
            for (int group = slice.first; group < slice.end; ++group) {
                LevelFaces faces = all;
                if (axis != 0) {
                    faces.first[axis] = group;
                    faces.end[axis] = group + 1;
                }
                add_weight_of(faces, pull, axis == down ? means_of(faces) : LevelMeans{}, force[axis].data());
            }
        });
    }
}

void predict_weight(const Rows& rows, Layers layers, const std::array<Samples, 3>& velocity,
                    const std::array<Samples, 3>* open, double time, const Samples& weight, Samples& moved) {
    const auto part = static_cast<float>(time / (2 * rows.lattice.h));
    each_row(rows, layers, [&](Row row) {
        const auto across = [&](std::size_t axis) {
            return AxisAdvection{velocity[axis].data() + row.at,
                                 open != nullptr ? (*open)[axis].data() + row.at : nullptr,
                                 rows.lattice.stride[axis]};
        };
        const AxisAdvection x = across(0), y = across(1), z = across(2);
        const float* value = weight.data() + row.at;
        for (std::ptrdiff_t i = 0; i < row.count; i += 8) {
            const Floats8 change = (x.change(value, i) + y.change(value, i)) + z.change(value, i);
            store(moved.data() + row.at + i, load(value + i) - part * change);
        }
    });
}

double lifted_by_diffusion(const Rows& rows, const std::array<Samples, 3>* open, const vec3& gravity,
                           const Samples& weight) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double pull = gravity[static_cast<int>(axis)];
        if (pull == 0) continue;
        const std::ptrdiff_t step = rows.lattice.stride[axis];
        double rise = 0;
        each_row(rows, [&](Row row) {
            const float* value = weight.data() + row.at;
            const float* share = open != nullptr ? (*open)[axis].data() + row.at : nullptr;
            for (std::ptrdiff_t i = 0; i < row.count; ++i) {
                const double jump = static_cast<double>(value[i]) - static_cast<double>(value[i - step]);
                rise += share != nullptr ? static_cast<double>(share[i]) * jump : jump;
            }
        });
        sum += pull * rise;
    }
    return sum / rows.lattice.h;
}

}  // namespace thaum::fluid
