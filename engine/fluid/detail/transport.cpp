#include "fluid/detail/transport.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "fluid/detail/ceiling.h"
#include "fluid/detail/split.h"
#include "fluid/detail/sums.h"
#include "fluid/detail/transport_rows.h"
#include "fluid/floats8.h"
#include "fluid/ghosts.h"

// One array of fluxes for each axis is enough, because the lattice is processed layer by layer: first the
// fluxes through the faces of a layer, then, when those of the layer above are ready, the new densities of
// the layer. Threads take slices of several layers. The last layer of a slice waits until all slices have
// their fluxes, because it needs those of the next slice's first faces.
namespace thaum::fluid {
namespace {

/// Largest sharpness, the factor of the extra flux that keeps edges sharp (transport_rows.h). With this
/// value, a sphere on a grid of 64^3 cells returns from LeVeque's deforming flow with an error of 0.31. A
/// sharpness of 0.15 gives 0.35, and a sharpness of 0 gives 0.60. A larger one deforms slots and corners that
/// are a few cells wide.
constexpr double max_sharpness = 0.25;
/// Intensity of segregation, 0 to 1: how nearly each cell is either empty or at the highest density (sums.h).
/// Edges are kept sharp in part from segregation_of_blurred on, and fully from segregation_of_sharp on. A
/// Gaussian has at most 0.41 in a flow that stretches it. From 0.5 on, more of a body lies in its inside than
/// on its edge.
constexpr double segregation_of_blurred = 0.5, segregation_of_sharp = 0.6;

// ---- fluxes over the whole lattice -----------------------------------------------------------------------

/// Input and work arrays shared by all functions of one sub-step: flow, density at the start, scratch arrays.
struct SubstepContext {
    const Lattice& lattice;
    const FaceFlow& face_flow;
    SubstepScale scale;
    const Samples& start;
    TransportScratch& scratch;
    Team& team;
    Split split;  ///< slices of the layers

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

constexpr auto nothing = [] {};

/// Calls `faces(axis, k)` for the faces of all layers, `cells(k)` when the fluxes of layer k and of the layer
/// above it are ready, and `end(layers)` for slices of layers whose cells are done.
/// `beside` is called once, at the same time as the first faces.
template <class Faces, class CellsOfLayer, class End, class Beside>
void each_layer(const SubstepContext& c, Faces faces, CellsOfLayer cells, End end, Beside beside) {
    c.team.each(c.split.slices + 1, [&](int slice, unsigned) {
        if (slice == 0) return beside();
        const Layers layers = c.split[slice - 1];
        for (int k = layers.first; k < layers.end; ++k) {
            faces(2, k);
            if (k > layers.first) cells(k - 1);
            faces(0, k);
            faces(1, k);
        }
    });
    each_slice(c.team, c.split, [&](Layers layers, unsigned) {
        cells(layers.end - 1);
        end(layers);
    });
}

/// Computes all fluxes of a stage and calls `cells(k)` when those of layer k are ready, then `end`. Rows are
/// extended to whole vectors; the extra values are never read.
template <StageIndex stage, TransportTerms terms, class CellsOfLayer, class End, class Beside>
void each_layer_of_stage(const SubstepContext& c, const Samples& value, CellsOfLayer cells, End end,
                         Beside beside) {
    const auto faces = [&](std::size_t axis, int k) {
        flux_rows<stage, terms>(c, value, axis, k);
        copy_last_faces(c.lattice, axis, k, c.scratch.flux[axis]);
        if (stage == StageIndex::third) copy_last_faces(c.lattice, axis, k, c.scratch.donors[axis]);
    };
    each_layer(c, faces, cells, end, beside);
}

/// Computes the density of the next Runge-Kutta stage: the density at the start of the sub-step, changed by
/// `part` times the sum of the fluxes of the stages so far.
template <StageIndex stage, TransportTerms terms, class Beside>
void take_stage(const SubstepContext& c, const Samples& value, float part, Samples& next, Beside beside) {
    const auto cells = [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            const Fluxes fluxes = c.at(c.scratch.flux, row.at);
            for (std::ptrdiff_t i = 0; i < row.count; i += 8)
                store(next.data() + row.at + i,
                      load(c.start.data() + row.at + i) - part * net_outflow(fluxes, i));
        });
    };
    each_layer_of_stage<stage, terms>(
        c, value, cells, [&](Layers layers) { fill_ghosts(c.rows(), layers, all_even, next); }, beside);
}

/// Index of row j of layer k.
std::size_t row_index(const Lattice& lattice, int j, int k) {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(lattice.cells[1]) +
           static_cast<std::size_t>(j);
}

/// Limits the differences between fluxes of fifth and of first order through the faces of a layer, so that no
/// cell leaves its bounds. If `levels` is not null, finds the amounts that cross the faces: across x they are
/// added to `levels`, across y and z they are kept row by row.
void limit_layer(const SubstepContext& c, std::size_t axis, int k, Levels* levels) {
    const std::ptrdiff_t s = c.lattice.stride[axis];
    float* difference = c.scratch.flux[axis].data();
    for (int j = 0; j < c.lattice.cells[1]; ++j) {
        const Row row = c.rows().at(j, k);
        if (row.count == 0) continue;
        limit_fluxes(c.scratch.part.data() + row.at, c.scratch.room.data() + row.at, s, row.count,
                     difference + row.at);
        if (levels == nullptr) continue;
        const CrossedRow crossed{.donors = c.scratch.donors[axis].data() + row.at,
                                 .limited = difference + row.at,
                                 .courant = c.face_flow.courant[axis].data() + row.at,
                                 .start = c.start.data() + row.at,
                                 .step = s};
        if (axis == 0)
            add_crossed(c.scale.courant, crossed, row.count,
                        levels->data() + (row.at - c.lattice.at(0, j, k)));
        else
            c.scratch.crossed[axis][row_index(c.lattice, j, k)] =
                crossed_in_row(c.scale.courant, crossed, row.count);
    }
    copy_last_faces(c.lattice, axis, k, c.scratch.flux[axis]);
}

/// Density that crossed all faces across an axis, positive in the direction of the axis. Across y and z the
/// rows of each level are summed here.
double sum_of_levels(const SubstepContext& c, std::size_t axis, Levels& levels) {
    const int ny = c.lattice.cells[1];
    const int others = axis == 1 ? c.lattice.cells[2] : ny;
    if (axis != 0)
        each_slice(c.team, Split(c.team, c.lattice.cells[axis]), [&](Layers slice, unsigned) {
            for (int level = slice.first; level < slice.end; ++level)
                for (int other = 0; other < others; ++other) {
                    const int j = axis == 1 ? level : other, k = axis == 1 ? other : level;
                    if (c.rows().at(j, k).count == 0) continue;
                    const CrossedSums& row = c.scratch.crossed[axis][row_index(c.lattice, j, k)];
                    for (std::ptrdiff_t lane = 0; lane < 8; ++lane)
                        levels[static_cast<std::size_t>(level)].add(row.density[lane], row.flow[lane],
                                                                    row.either[lane], row.carried[lane]);
                }
        });
    double sum = 0;
    for (const LevelCrossing& level : levels) sum += level.beyond_mean();
    return sum;
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
    const auto cells = [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            const Fluxes limited = c.at(c.scratch.flux, row.at);
            for (std::ptrdiff_t i = 0; i < row.count; i += 8) {
                const Floats8 current = load(left.data() + row.at + i) - net_outflow(limited, i);
                store(density.data() + row.at + i, current < min_density ? zero8 : current);
            }
        });
    };
    each_layer(
        c, faces, cells, [&](Layers layers) { fill_ghosts(c.rows(), layers, all_even, density); }, nothing);
    vec3 moved(0);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (levels[axis]) moved[static_cast<int>(axis)] = sum_of_levels(c, axis, *levels[axis]);
    return moved;
}

/// Fills the ghosts of the shares of flux that cells allow. Those beyond walls are never used, because the
/// flux difference through a wall is 0.
void fill_shares(const SubstepContext& c, Layers layers) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (c.lattice.edges[axis] != Edge::periodic) continue;
        fill_ghosts_across(c.rows(), layers, axis, GhostRule::even, c.scratch.part);
        fill_ghosts_across(c.rows(), layers, axis, GhostRule::even, c.scratch.room);
    }
}

template <TransportTerms terms>
vec3 substep(const SubstepContext& c, const vec3& along, Samples& density) {
    TransportScratch& scratch = c.scratch;
    Samples& first = scratch.first;
    Samples& second = scratch.second;
    const auto* open = c.face_flow.face_apertures;
    float ceiling = 0;
    take_stage<StageIndex::first, terms>(c, density, 1, first, [&] {
        ceiling = density_ceiling(c.rows(), open != nullptr ? &open->aperture : nullptr, density);
    });
    take_stage<StageIndex::second, terms>(c, first, 0.25F, second, nothing);
    Samples& left = first;  // uses the memory of the first stage, which is no longer needed
    const auto limit = [&](int k) {
        each_row(c.rows(), k, [&](Row row) {
            const std::ptrdiff_t at = row.at;
            limit_row(c.at(scratch.donors, at), c.at(scratch.flux, at), density.data() + at, ceiling,
                      row.count, {left.data() + at, scratch.part.data() + at, scratch.room.data() + at});
        });
    };
    each_layer_of_stage<StageIndex::third, terms>(
        c, second, limit, [&](Layers layers) { fill_shares(c, layers); }, nothing);
    return apply_limited(c, left, along, density);
}

using Substep = vec3 (*)(const SubstepContext&, const vec3&, Samples&);

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
/// region of uniform density, and 0 if it diffuses. The sums of its rows are in `of_rows`.
float sharpness_of(const FaceFlow& face_flow, double diffusion, std::span<const SegregationOfRow> of_rows) {
    if (diffusion > 0) return 0;
    const Cells n = face_flow.rows().lattice.cells;
    const double cells =
        face_flow.face_apertures != nullptr ? face_flow.face_apertures->cells : double(n[0]) * n[1] * n[2];
    const double share = (segregation(face_flow.rows(), cells, of_rows) - segregation_of_blurred) /
                         (segregation_of_sharp - segregation_of_blurred);
    // Rounding the share to sixteenths hides the rounding errors of the sums, so that the symmetry of the
    // flow is kept.
    return static_cast<float>(max_sharpness * std::round(16 * std::clamp(share, 0.0, 1.0)) / 16);
}

/// The largest part of a cell's content that the flow carries out of it, over all cells of some layers.
float largest_outflow_in(const Lattice& lattice, const FaceFlow& face_flow, Layers layers) {
    Floats8 most{};
    const auto& c = face_flow.courant;
    each_row(face_flow.rows(), layers, [&](Row row) {
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

float largest_outflow(const Lattice& lattice, const FaceFlow& face_flow, Team& team) {
    const Split split(team, lattice.cells[2]);
    std::array<float, max_cells> most{};
    team.each(split.slices, [&](int slice, unsigned) {
        most[static_cast<std::size_t>(slice)] = largest_outflow_in(lattice, face_flow, split[slice]);
    });
    return *std::max_element(most.begin(), most.begin() + split.slices);
}

/// Sets the flow across one axis in the given rows, to the mean of two velocities.
void set_flow_in(const FaceApertures& open, Layers layers, std::size_t axis, const Samples& before,
                 const Samples& after, float factor, Samples& to) {
    const float *const first = before.data(), *const second = after.data();
    const float* const aperture = open.aperture[axis].data();
    each_row(open.rows, layers, [&](Row row) {
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8)
            store(to.data() + i, 0.5F * (load(first + i) + load(second + i)) * factor * load(aperture + i));
    });
}

/// Sets the flow across one axis at all indices from `from` to `end` - 1, where all faces are open.
void set_open_flow(const Lattice& lattice, Layers indices, std::size_t axis, const Samples& before,
                   const Samples& after, float factor, int order, Samples& flow) {
    const float *const first = before.data(), *const second = after.data();
    float* const to = flow.data();
    const auto mean = [=](std::size_t i) { return 0.5F * (first[i] + second[i]); };
    const auto s = static_cast<std::size_t>(lattice.stride[axis]);
    auto from = static_cast<std::size_t>(indices.first), end = static_cast<std::size_t>(indices.end);
    if (order == 4) {
        from = std::max(from, s);
        end = std::min(end, lattice.size - s);
        for (std::size_t i = from; i < end; ++i)
            to[i] = factor * (mean(i) * (26.0F / 24) - (mean(i - s) + mean(i + s)) * (1.0F / 24));
    } else {
        for (std::size_t i = from; i < end; ++i) to[i] = mean(i) * factor;
    }
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
    const std::size_t rows = row_index(lattice, 0, lattice.cells[2]);
    scratch.segregation.resize(rows);
    for (const std::size_t axis : {1U, 2U}) scratch.crossed[axis].resize(rows);
    return scratch;
}

void set_face_flow(const Lattice& lattice, const std::array<Samples, 3>& before,
                   const std::array<Samples, 3>& after, const FaceApertures* face_apertures, double dt,
                   FaceFlow& face_flow, Team& team, int order) {
    const auto factor = static_cast<float>(dt / lattice.h);
    if (face_apertures != nullptr) {
        each_slice(team, Split(team, lattice.cells[2]), [&](Layers layers, unsigned) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                set_flow_in(*face_apertures, layers, axis, before[axis], after[axis], factor,
                            face_flow.courant[axis]);
        });
        // The last faces of a periodic lattice are copies of the first.
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (lattice.edges[axis] == Edge::periodic)
                fill_ghosts_across(face_apertures->rows, axis, GhostRule::even, face_flow.courant[axis]);
    } else {
        each_slice(team, Split(team, static_cast<int>(lattice.size)), [&](Layers indices, unsigned) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                set_open_flow(lattice, indices, axis, before[axis], after[axis], factor, order,
                              face_flow.courant[axis]);
        });
    }
    face_flow.face_apertures = face_apertures;
    face_flow.dt = dt;
    face_flow.outflow = largest_outflow(lattice, face_flow, team);
}

TransportReport transport(const Lattice& lattice, const FaceFlow& face_flow,
                          const TransportSettings& settings, Samples& density, TransportScratch& scratch,
                          Team& team) {
    const double diffusion = settings.diffusion * face_flow.dt / (lattice.h * lattice.h);
    if ((face_flow.outflow == 0 && diffusion == 0) || is_empty(face_flow.rows(), density)) return {};
    const auto [substeps, carried, spread] = schedule(face_flow.outflow, diffusion, settings.max_substeps);
    Split split(team, lattice.cells[2]);
    each_slice(team, split, [&](Layers layers, unsigned) {
        if (diffusion == 0) segregation_of_rows(face_flow.rows(), layers, density, scratch.segregation);
        fill_ghosts(face_flow.rows(), layers, all_even, density);
    });
    const SubstepScale scale{static_cast<float>(carried / substeps),
                             static_cast<float>(diffusion * spread / substeps),
                             sharpness_of(face_flow, diffusion, scratch.segregation)};
    // The flow along x through each level (cells with one x) is a sum over all rows. One thread computes it,
    // so that the order of the sum, and its rounding, is always the same.
    if (settings.moved_along.x != 0) split.slices = 1;
    const SubstepContext context{lattice, face_flow, scale, density, scratch, team, split};
    const auto step =
        face_flow.face_apertures != nullptr ? substep_of<true>(scale) : substep_of<false>(scale);
    vec3 moved(0);
    for (int i = 0; i < substeps; ++i) moved += step(context, settings.moved_along, density);
    const auto [nx, ny, nz] = lattice.cells;
    return {substeps, carried, spread, moved, std::int64_t{nx} * ny * nz * substeps};
}

}  // namespace thaum::fluid
