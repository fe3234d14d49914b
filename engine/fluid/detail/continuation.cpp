#include "fluid/detail/continuation.h"

#include <algorithm>
#include <cmath>

#include "fluid/ghosts.h"
#include "fluid/sample.h"

namespace thaum::fluid {
namespace {

/// Distance along each axis within which a fit (linear function through known velocities) uses faces (cells).
/// With a shorter range the fit has too few faces: it follows noise, and the flow gains energy.
constexpr int reach = 2;
/// Added to the variance of the positions of the faces that a fit uses, so that the fit has a solution even
/// if all faces lie in one plane (cells^2).
constexpr double min_spread = 1e-6;
/// Largest sum of the absolute weights with which a fit combines velocities; larger ones magnify noise. This
/// value and upwind_share were chosen by trials in turning and stirred bowls of 16 to 64 cells: with a limit
/// of 6, flows gained energy.
constexpr double max_weights = 4;
/// Share of upwind differences in the advection beside solids, where velocities are read that continue the
/// flow into the solid. With a smaller share, flows gained energy in some trials; with 1 a turning flow lost
/// twice as much energy.
constexpr float upwind_share = 0.5F;
/// A velocity that continues the flow into a solid is a weighted sum of many others. This is the number of
/// partial sums in which its terms are added. In a single sum each addition would wait for the one before.
constexpr std::uint32_t sums_at_once = 4;

/// The faces across one axis, on which one component of the velocity is sampled.
struct Faces {
    const Lattice& lattice;
    const Solids& solids;
    std::size_t axis;
    std::vector<vec3> off;  ///< centre of the open part, relative to the centre of the face (cells)

    float open(std::size_t at) const { return solids.open()[axis][at]; }
    std::size_t at(const Cells& c) const { return static_cast<std::size_t>(lattice.at(c[0], c[1], c[2])); }
    bool is_inside(const Cells& c) const {
        bool result = true;
        for (std::size_t a = 0; a < 3; ++a) result = result && c[a] >= 0 && c[a] < lattice.cells[a];
        return result;
    }
};

Faces faces_across(const Lattice& lattice, const Solids& solids, std::size_t axis) {
    Faces result{lattice, solids, axis, std::vector<vec3>(lattice.size, vec3(0))};
    const auto& cut = solids.cut_faces(axis);
    each_cell(lattice, [&](int i, int j, int k, std::size_t at) {
        const auto face = std::ranges::lower_bound(cut, at, {}, &CutFace::at);
        if (face != cut.end() && face->at == at)
            result.off[at] = face->middle / lattice.h - (vec3(i, j, k) + face_place(axis));
    });
    return result;
}

/// Whether advection may read the velocity of this face although a solid covers it in part or wholly.
bool is_read(const Faces& faces, const Cells& cell) {
    const std::size_t at = faces.at(cell);
    const auto step = [&](std::size_t axis) { return static_cast<std::size_t>(faces.lattice.stride[axis]); };
    // The velocity on the walls of the box is set together with the ghost cells, so those faces need no
    // velocity that is fitted to their neighbours.
    const bool on_wall = cell[faces.axis] == 0 && faces.lattice.edges[faces.axis] != Edge::periodic;
    if (faces.open(at) >= 1 || on_wall) return false;
    bool result = faces.solids.holds_fluid(at) || faces.solids.holds_fluid(at - step(faces.axis));
    for (std::size_t a = 0; a < 3; ++a)
        result = result || faces.open(at - step(a)) > 0 || faces.open(at + step(a)) > 0;
    return result;
}

/// An open face near a solid, one of those from whose velocities that of a covered face is fitted.
struct FittedFace {
    std::size_t at{};
    vec3 apart{};     ///< place relative to the centre of the face whose velocity is fitted (cells)
    double weight{};  ///< weight in the fit, later weight in the fitted velocity
};

std::vector<FittedFace> open_faces_around(const Faces& faces, const Cells& centre) {
    std::vector<FittedFace> result;
    for (int k = -reach; k <= reach; ++k)
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i) {
                const Cells cell{centre[0] + i, centre[1] + j, centre[2] + k};
                if (!faces.is_inside(cell)) continue;
                const std::size_t at = faces.at(cell);
                const double open{faces.open(at)};
                if (!(open > 0)) continue;
                const vec3 apart = vec3(i, j, k) + faces.off[at];
                const double near = open / (glm::dot(apart, apart) + 0.25);
                result.push_back({at, apart, near * near});
            }
    return result;
}

/// Solves the least-squares fit of a linear function to the velocities of these open faces. Replaces the
/// weight that each face has in the fit by its weight in the value of the function at the centre of the face
/// in question, which is the fitted velocity. If that centre lies so far from the open faces that the weights
/// would magnify noise, the slope of the function is reduced (max_weights).
void solve_fit(std::vector<FittedFace>& faces) {
    double total = 0;
    vec3 mean(0);
    for (const FittedFace& f : faces) total += f.weight;
    for (FittedFace& f : faces) {
        f.weight /= total;
        mean += f.weight * f.apart;
    }
    mat3 spread(min_spread);
    for (const FittedFace& f : faces) spread += f.weight * glm::outerProduct(f.apart - mean, f.apart - mean);
    const vec3 slope = glm::inverse(spread) * mean;
    double part = 1;
    const auto weight = [&](const FittedFace& f) {
        return f.weight * (1 - part * glm::dot(slope, f.apart - mean));
    };
    const auto sum = [&] {
        double result = 0;
        for (const FittedFace& f : faces) result += std::abs(weight(f));
        return result;
    };
    for (int i = 0; i < 20 && sum() > max_weights; ++i) part *= 0.9;
    for (FittedFace& f : faces) f.weight = weight(f);
}

}  // namespace

Continuation::Continuation(const Lattice& lattice, const Solids& solids) : lattice_(lattice) {
    for (std::size_t axis = 0; axis < 3; ++axis) find_targets(solids, axis);
    find_faces_beside(solids);
}

void Continuation::find_targets(const Solids& solids, std::size_t axis) {
    const Faces faces = faces_across(lattice_, solids, axis);
    auto& targets = components_[axis].targets;
    auto& sources = components_[axis].sources;
    const auto add = [&](std::size_t at) {
        targets.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(sources.size())});
    };
    each_cell(lattice_, [&](int i, int j, int k, std::size_t at) {
        if (!is_read(faces, {i, j, k})) return;
        auto around = open_faces_around(faces, {i, j, k});
        if (around.empty()) return;
        solve_fit(around);
        add(at);
        for (const FittedFace& f : around)
            sources.push_back({static_cast<std::uint32_t>(f.at), static_cast<float>(f.weight)});
        while (sources.size() % sums_at_once != 0) sources.push_back({static_cast<std::uint32_t>(at), 0});
    });
    values_.resize(std::max(values_.size(), targets.size()));
    add(0);
}

void Continuation::find_faces_beside(const Solids& solids) {
    std::array<Samples, 3> continued;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        continued[axis] = make_samples(lattice_);
        const auto& targets = components_[axis].targets;
        for (std::size_t t = 0; t + 1 < targets.size(); ++t) continued[axis][targets[t].at] = 1;
        fill_ghosts(lattice_, all_even, continued[axis]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        each_cell(lattice_, [&](int, int, int, std::size_t at) {
            if (!(solids.open()[axis][at] > 0)) return;
            const auto along = static_cast<std::size_t>(lattice_.stride[axis]);
            float found = 0;
            for (std::size_t by = 0; by < 3; ++by) {
                const auto step = static_cast<std::size_t>(lattice_.stride[by]);
                found += continued[axis][at - step] + continued[axis][at + step];
                for (const std::size_t low : {at, at - along})
                    found += continued[by][low] + continued[by][low + step];
            }
            if (found > 0) components_[axis].beside.push_back(static_cast<std::uint32_t>(at));
        });
}

void Continuation::apply(std::array<Samples, 3>& velocity) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float* u = velocity[axis].data();
        const auto& targets = components_[axis].targets;
        const auto& sources = components_[axis].sources;
        for (std::size_t t = 0; t + 1 < targets.size(); ++t) {
            std::array<float, sums_at_once> sums{};
            for (std::uint32_t s = targets[t].first; s < targets[t + 1].first; s += sums_at_once)
                for (std::uint32_t part = 0; part < sums_at_once; ++part)
                    sums[part] += sources[s + part].weight * u[sources[s + part].at];
            values_[t] = (sums[0] + sums[1]) + (sums[2] + sums[3]);
        }
        for (std::size_t t = 0; t + 1 < targets.size(); ++t) u[targets[t].at] = values_[t];
    }
}

void Continuation::correct(const RungeKuttaStage& stage) const {
    // Below, `low` and `high` are twice the advecting velocity on the two sides of the face. The terms of
    // outflow and of upwind differences have another factor 1/2, from means of two advected velocities. With
    // 1 / h, the common factor is 1 / 4 h.
    const auto factor = static_cast<float>(0.25 / lattice_.h);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto along = static_cast<std::size_t>(lattice_.stride[axis]);
        const float* q = stage.from[axis].data();
        for (const std::uint32_t at : components_[axis].beside) {
            float outflow = 0, upwind = 0;
            for (std::size_t by = 0; by < 3; ++by) {
                const auto step = static_cast<std::size_t>(lattice_.stride[by]);
                const float* u = stage.from[by].data();
                const float low = u[at] + u[at - along], high = u[at + step] + u[at + step - along];
                outflow += high - low;
                upwind += std::abs(high) * (q[at + step] - q[at]) - std::abs(low) * (q[at] - q[at - step]);
            }
            const float rate = factor * (q[at] * outflow + upwind_share * upwind);
            stage.sum[axis][at] += stage.sum_part * rate;
            if (stage.next != nullptr) (*stage.next)[axis][at] += stage.next_part * rate;
        }
    }
}

}  // namespace thaum::fluid
