#include "fluid/detail/transport.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "fluid/detail/ceiling.h"
#include "fluid/detail/sums.h"
#include "fluid/detail/transport_rows.h"
#include "fluid/floats8.h"
#include "fluid/ghosts.h"

// One array of fluxes for each axis is enough, because the lattice is processed layer by layer: first the
// fluxes through the faces of a layer, then, when those of the layer above are ready, the new densities of
// the layer.
namespace thaum::fluid {
namespace {

/// Largest sharpness, the factor of the extra flux that keeps edges sharp (transport_rows.h). With this
/// value, a sphere on a grid of 64^3 cells returns from LeVeque's deforming flow with an error of 0.31. A
/// sharpness of 0.15 gives 0.35, and a sharpness of 0 gives 0.60. A larger one deforms slots and corners that
/// are a few cells wide.
constexpr double max_sharpness = 0.25;
/// Intensity of segregation, 0 to 1: how nearly each cell is either empty or at the highest density (sums.h).
/// From the first value on, edges are kept sharp in part, from the second on fully. A Gaussian has at most
/// 0.41 in a flow that stretches it. At 0.5 and above, more of a body lies in its inside than on its edge.
constexpr double segregation_of_blurred = 0.5, segregation_of_sharp = 0.6;

// ---- fluxes over the whole lattice -----------------------------------------------------------------------

/// What all functions of one sub-step need: the flow, the density at the start, and the arrays to work in.
struct SubstepContext {
    const Lattice& lattice;
    const FaceFlow& face_flow;
    SubstepScale scale;
    const Samples& start;
    TransportScratch& scratch;

    const Rows& rows() const { return face_flow.rows(); }

    FaceRow face(std::size_t axis, std::ptrdiff_t at) const {
        FaceRow row{face_flow.courant[axis].data() + at, nullptr, nullptr, nullptr, lattice.stride[axis]};
        if (const FaceApertures* open = face_flow.face_apertures; open != nullptr) {
            row.aperture = open->aperture[axis].data() + at;
            row.third = open->third[axis].data() + at;
            row.fifth = open->fifth[axis].data() + at;
        }
        return row;
    }
    Fluxes at(const std::array<Samples, 3>& f, std::ptrdiff_t at) const {
        return {{f[0].data() + at, f[1].data() + at, f[2].data() + at}, lattice.stride};
    }
};

template <StageIndex stage, TransportTerms terms>
[[gnu::noinline]] void flux_rows(const SubstepContext& c, const Samples& value, std::size_t axis, int k) {
    each_row(c.rows(), k, [&](Row row) {
        flux_row<stage, terms>(c.scale, c.face(axis, row.at), row.count,
                               {.value = value.data() + row.at,
                                .start = c.start.data() + row.at,
                                .sum = c.scratch.flux[axis].data() + row.at,
                                .donors = c.scratch.donors[axis].data() + row.at});
    });
}

/// Copies the first faces across an axis to the last ones at periodic sides. The last faces at walls and
/// after the last cell before a solid are closed: their flux is never written and stays 0.
void copy_last_faces(const Lattice& lattice, std::size_t axis, int k, Samples& flux) {
    if (lattice.edges[axis] != Edge::periodic) return;
    const auto [nx, ny, nz] = lattice.cells;
    const auto first = [&](int j, int layer) { return flux.data() + lattice.at(0, j, layer); };
    for (int j = 0; axis == 0 && j < ny; ++j) first(j, k)[nx] = *first(j, k);
    if (axis == 1) std::copy_n(first(0, k), nx, first(ny, k));
    for (int j = 0; axis == 2 && k == 0 && j < ny; ++j) std::copy_n(first(j, 0), nx, first(j, nz));
}

/// Calls `faces(axis, k)` for the faces of all layers, and `cells(k)` when the fluxes of layer k and of the
/// layer above it are ready.
template <class Faces, class CellsOfLayer>
void each_layer(const Lattice& lattice, Faces faces, CellsOfLayer cells) {
    const int nz = lattice.cells[2];
    for (int k = 0; k < nz; ++k) {
        faces(2, k);
        if (k > 0) cells(k - 1);
        faces(0, k);
        faces(1, k);
    }
    cells(nz - 1);
}

/// Computes all fluxes of a stage and calls `cells(k)` when those of layer k are ready. Rows are extended to
/// whole vectors; the extra values are never read.
template <StageIndex stage, TransportTerms terms, class CellsOfLayer>
void each_layer_of_stage(const SubstepContext& c, const Samples& value, CellsOfLayer cells) {
    const auto faces = [&](std::size_t axis, int k) {
        flux_rows<stage, terms>(c, value, axis, k);
        copy_last_faces(c.lattice, axis, k, c.scratch.flux[axis]);
        if (stage == StageIndex::third) copy_last_faces(c.lattice, axis, k, c.scratch.donors[axis]);
    };
    each_layer(c.lattice, faces, cells);
}

/// Computes the density of the next Runge-Kutta stage: the density at the start of the sub-step, changed by
/// `part` times the sum of the fluxes of the stages so far.
template <StageIndex stage, TransportTerms terms>
void take_stage(const SubstepContext& c, const Samples& value, float part, Samples& next) {
    each_layer_of_stage<stage, terms>(c, value, [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            const Fluxes fluxes = c.at(c.scratch.flux, row.at);
            for (std::ptrdiff_t i = 0; i < row.count; i += 8)
                store(next.data() + row.at + i,
                      load(c.start.data() + row.at + i) - part * net_outflow(fluxes, i));
        });
    });
    fill_ghosts(c.rows(), all_even, next);
}

/// Limits the differences between fluxes of fifth and of first order through the faces of a layer, so that no
/// cell leaves its bounds. If `levels` is not null, adds to it what crosses the faces.
void limit_layer(const SubstepContext& c, std::size_t axis, int k, Levels* levels) {
    const std::ptrdiff_t s = c.lattice.stride[axis];
    float* difference = c.scratch.flux[axis].data();
    for (int j = 0; j < c.lattice.cells[1]; ++j) {
        const Row row = c.rows().at(j, k);
        if (row.count == 0) continue;
        limit_fluxes(c.scratch.part.data() + row.at, c.scratch.room.data() + row.at, s, row.count,
                     difference + row.at);
        if (levels == nullptr) continue;
        const auto first = row.at - c.lattice.at(0, j, k);
        const auto level = static_cast<std::size_t>(axis == 0 ? first : axis == 1 ? j : k);
        add_crossed(c.scale.courant,
                    {.donors = c.scratch.donors[axis].data() + row.at,
                     .limited = difference + row.at,
                     .courant = c.face_flow.courant[axis].data() + row.at,
                     .start = c.start.data() + row.at,
                     .step = s},
                    row.count, axis == 0 ? 1 : 0, levels->data() + level);
    }
    copy_last_faces(c.lattice, axis, k, c.scratch.flux[axis]);
}

/// Applies the differences between fluxes of fifth and of first order, limited, to the density after the
/// fluxes of first order, which is in `left`. For each axis along which `along` is not 0, returns the density
/// that crossed all faces, positive in the direction of the axis.
vec3 apply_limited(const SubstepContext& c, const Samples& left, const vec3& along, Samples& density) {
    std::array<std::optional<Levels>, 3> levels;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (along[static_cast<int>(axis)] != 0) levels[axis].emplace();
    const auto faces = [&](std::size_t axis, int k) {
        limit_layer(c, axis, k, levels[axis] ? &*levels[axis] : nullptr);
    };
    each_layer(c.lattice, faces, [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            const Fluxes limited = c.at(c.scratch.flux, row.at);
            for (std::ptrdiff_t i = 0; i < row.count; i += 8) {
                const Floats8 current = load(left.data() + row.at + i) - net_outflow(limited, i);
                store(density.data() + row.at + i, current < min_density ? zero8 : current);
            }
        });
    });
    vec3 moved(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!levels[axis]) continue;
        for (const LevelCrossing& level : *levels[axis]) moved[static_cast<int>(axis)] += level.beyond_mean();
    }
    return moved;
}

template <TransportTerms terms>
vec3 substep(const Lattice& lattice, const FaceFlow& face_flow, SubstepScale scale, const vec3& along,
             Samples& density, TransportScratch& scratch) {
    const SubstepContext c{lattice, face_flow, scale, density, scratch};
    Samples& first = scratch.first;
    Samples& second = scratch.second;
    take_stage<StageIndex::first, terms>(c, density, 1, first);
    take_stage<StageIndex::second, terms>(c, first, 0.25F, second);
    Samples& left = first;  // uses the memory of the first stage, which is no longer needed
    const float ceiling = density_ceiling(
        face_flow.rows(), face_flow.face_apertures != nullptr ? &face_flow.face_apertures->aperture : nullptr,
        density);
    each_layer_of_stage<StageIndex::third, terms>(c, second, [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            const std::ptrdiff_t at = row.at;
            limit_row(c.at(scratch.donors, at), c.at(scratch.flux, at), density.data() + at, ceiling,
                      row.count, {left.data() + at, scratch.part.data() + at, scratch.room.data() + at});
        });
    });
    // Shares beyond walls are never used, because the flux difference through a wall is 0.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (lattice.edges[axis] != Edge::periodic) continue;
        fill_ghosts_across(c.rows(), axis, GhostRule::even, scratch.part);
        fill_ghosts_across(c.rows(), axis, GhostRule::even, scratch.room);
    }
    const vec3 moved = apply_limited(c, left, along, density);
    fill_ghosts(c.rows(), all_even, density);
    return moved;
}

using Substep = vec3 (*)(const Lattice&, const FaceFlow&, SubstepScale, const vec3&, Samples&,
                         TransportScratch&);

template <bool solids>
Substep substep_of(SubstepScale scale) {
    if (scale.diffusion > 0) return substep<TransportTerms{solids, true, false}>;
    if (scale.sharpness > 0) return substep<TransportTerms{solids, false, true}>;
    return substep<TransportTerms{solids, false, false}>;
}

// ---- number of sub-steps ---------------------------------------------------------------------------------

struct Schedule {
    int substeps;
    double carried, spread;
};

/// Divides a time into at most `most` sub-steps. `outflow`, the part of a cell that flows out of it, and
/// `diffusion` (k dt / h^2) are for the whole time. If the sub-steps are not enough, only parts of both are
/// done.
Schedule schedule(double outflow, double diffusion, int most) {
    const double spreading = 6 * diffusion;
    const double wanted = std::max(1.0, std::ceil((outflow + spreading) / max_courant));
    if (wanted <= most) return {static_cast<int>(wanted), 1, 1};
    const double room = max_courant * most;
    const double spread = std::min(spreading, std::max(room / 2, room - outflow));
    const double carried = std::min(outflow, room - spread);
    return {most, outflow > 0 ? carried / outflow : 1, spreading > 0 ? spread / spreading : 1};
}

bool is_empty(const Rows& rows, const Samples& density) {
    return std::ranges::all_of(rows.rows, [&](Row row) {
        Magnitudes8 bits{};
        for (std::ptrdiff_t i = 0; i < row.count; i += 8)
            bits |= std::bit_cast<Magnitudes8>(load(density.data() + row.at + i));
        return !any_of(bits);
    });
}

/// Sharpness of a substance's edges, the factor of the flux that keeps them sharp: 0 if the substance has no
/// region of uniform density, and 0 if it diffuses.
float sharpness_of(const FaceFlow& face_flow, double diffusion, const Samples& density) {
    if (diffusion > 0) return 0;
    const Cells n = face_flow.rows().lattice.cells;
    const double cells =
        face_flow.face_apertures != nullptr ? face_flow.face_apertures->cells : double(n[0]) * n[1] * n[2];
    const double share = (segregation(face_flow.rows(), cells, density) - segregation_of_blurred) /
                         (segregation_of_sharp - segregation_of_blurred);
    // Rounding the share to sixteenths hides the rounding errors of the sums, so that the symmetry of the
    // flow is kept.
    return static_cast<float>(max_sharpness * std::round(16 * std::clamp(share, 0.0, 1.0)) / 16);
}

/// The largest part of a cell's content that the flow carries out of it, over all cells.
float largest_outflow(const Lattice& lattice, const FaceFlow& face_flow) {
    Floats8 most{};
    const auto& c = face_flow.courant;
    each_row(face_flow.rows(), [&](Row row) {
        const Fluxes courant{{c[0].data() + row.at, c[1].data() + row.at, c[2].data() + row.at},
                             lattice.stride};
        const std::ptrdiff_t whole = row.count / 8 * 8;
        for (std::ptrdiff_t i = 0; i < whole; i += 8) most = larger(outflow(courant, i), most);
        if (whole == row.count) return;
        const Floats8 last = outflow(courant, whole);
        for (std::ptrdiff_t lane = 0; lane < row.count - whole; ++lane)
            most[lane] = last[lane] > most[lane] ? last[lane] : most[lane];
    });
    float result = 0;
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane) result = std::max(result, float{most[lane]});
    return result;
}

}  // namespace

FaceApertures make_face_apertures(const Lattice& lattice, const std::array<Samples, 3>& aperture) {
    FaceApertures result{.aperture = aperture};
    const Cells n = lattice.cells;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::ptrdiff_t step = lattice.stride[axis];
        const bool round = lattice.edges[axis] == Edge::periodic;
        result.third[axis] = result.fifth[axis] = make_samples(lattice);
        for (int k = 0; k <= n[2]; ++k) {
            for (int j = 0; j <= n[1]; ++j) {
                for (int i = 0; i <= n[0]; ++i) {
                    const std::array<int, 3> cell{i, j, k};
                    const std::ptrdiff_t at = lattice.at(i, j, k), from = at - cell[axis] * step;
                    const auto open = [&](int farther) {
                        const int face = cell[axis] + farther;
                        if (round)
                            return aperture[axis][static_cast<std::size_t>(from + (face + n[axis]) % n[axis] *
                                                                                      step)] > 0;
                        return face <= 0 || face >= n[axis] ||
                               aperture[axis][static_cast<std::size_t>(from + face * step)] > 0;
                    };
                    const bool third = open(-1) && open(0) && open(1);
                    const auto to = static_cast<std::size_t>(at);
                    result.third[axis][to] = third ? 5.0F : 0.0F;
                    result.fifth[axis][to] = third && open(-2) && open(2) ? 1.0F : 0.0F;
                    if (round && cell[axis] == n[axis])
                        result.aperture[axis][to] = aperture[axis][static_cast<std::size_t>(from)];
                }
            }
        }
    }
    const Samples open = openness(lattice, result.aperture);
    result.rows = rows_above_zero(lattice, open);
    each_cell(lattice, [&](int, int, int, std::size_t at) { result.cells += open[at] > 0 ? 1 : 0; });
    return result;
}

FaceFlow make_face_flow(const Lattice& lattice) {
    FaceFlow face_flow{.whole = whole_rows(lattice)};
    for (Samples& samples : face_flow.courant) samples = make_samples(lattice);
    return face_flow;
}

TransportScratch make_transport_scratch(const Lattice& lattice) {
    TransportScratch scratch{.first = make_samples(lattice),
                             .second = make_samples(lattice),
                             .part = make_samples(lattice),
                             .room = make_samples(lattice)};
    for (auto* fluxes : {&scratch.flux, &scratch.donors}) fluxes->fill(make_samples(lattice));
    return scratch;
}

void set_face_flow(const Lattice& lattice, const std::array<Samples, 3>& before,
                   const std::array<Samples, 3>& after, const FaceApertures* face_apertures, double dt,
                   FaceFlow& face_flow, int order) {
    const auto factor = static_cast<float>(dt / lattice.h);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float *const first = before[axis].data(), *const second = after[axis].data();
        float* const to = face_flow.courant[axis].data();
        const auto mean = [=](std::size_t i) { return 0.5F * (first[i] + second[i]); };
        if (order == 4) {
            const auto s = static_cast<std::size_t>(lattice.stride[axis]);
            for (std::size_t i = s; i < lattice.size - s; ++i)
                to[i] = factor * (mean(i) * (26.0F / 24) - (mean(i - s) + mean(i + s)) * (1.0F / 24));
        } else if (face_apertures != nullptr) {
            const float* const aperture = face_apertures->aperture[axis].data();
            each_row(face_apertures->rows, [&](Row row) {
                for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8)
                    store(to + i, 0.5F * (load(first + i) + load(second + i)) * factor * load(aperture + i));
            });
            // The last faces of a periodic lattice are copies of the first.
            if (lattice.edges[axis] == Edge::periodic)
                fill_ghosts_across(face_apertures->rows, axis, GhostRule::even, face_flow.courant[axis]);
        } else {
            for (std::size_t i = 0; i < lattice.size; ++i) to[i] = mean(i) * factor;
        }
    }
    face_flow.face_apertures = face_apertures;
    face_flow.dt = dt;
    face_flow.outflow = largest_outflow(lattice, face_flow);
}

TransportReport transport(const Lattice& lattice, const FaceFlow& face_flow,
                          const TransportSettings& settings, Samples& density, TransportScratch& scratch) {
    const double diffusion = settings.diffusion * face_flow.dt / (lattice.h * lattice.h);
    if ((face_flow.outflow == 0 && diffusion == 0) || is_empty(face_flow.rows(), density)) return {};
    const auto [substeps, carried, spread] = schedule(face_flow.outflow, diffusion, settings.max_substeps);
    const SubstepScale scale{static_cast<float>(carried / substeps),
                             static_cast<float>(diffusion * spread / substeps),
                             sharpness_of(face_flow, diffusion, density)};
    fill_ghosts(face_flow.rows(), all_even, density);
    const auto step =
        face_flow.face_apertures != nullptr ? substep_of<true>(scale) : substep_of<false>(scale);
    vec3 moved(0);
    for (int i = 0; i < substeps; ++i)
        moved += step(lattice, face_flow, scale, settings.moved_along, density, scratch);
    const auto [nx, ny, nz] = lattice.cells;
    return {substeps, carried, spread, moved, std::int64_t{nx} * ny * nz * substeps};
}

}  // namespace thaum::fluid
