// Benchmarks fields between their samples (engine/field/field.h): time of a value with its gradient, and the
// errors of both, by kernel and number of samples. The fields are those of a fluid on its lattice, including
// ghost cells.
#include <array>
#include <cmath>

#include "core/hash.h"
#include "core/maths.h"
#include "core/random.h"
#include "core/text.h"
#include "fluid/fields.h"
#include "fluid/ghosts.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using field::Kernel;
using field::Scalar;
using field::Vector;
using fluid::Edge;
using fluid::Samples;

constexpr std::array kernel_names{"linear", "catmull_rom"};
constexpr std::array kernels{Kernel::linear, Kernel::catmull_rom};
constexpr std::array grid_sizes{16, 32, 64};
constexpr std::size_t places_in_a_call = 256;

/// A scalar of period 1 with one wave in the box along each axis.
Scalar waves_at(vec3 p) {
    const vec3 x = 2 * pi * p;
    const double sx = det::sin(x.x), cx = det::cos(x.x), sy = det::sin(x.y), cy = det::cos(x.y);
    const double sz = det::sin(x.z), cz = det::cos(x.z);
    return {1 + 0.5 * sx * cy * cz, pi * vec3(cx * cy * cz, -sx * sy * cz, -sx * cy * sz)};
}

/// The Taylor-Green vortex, of period 1.
Vector vortex_at(vec3 p) {
    const vec3 x = 2 * pi * p;
    const double sx = det::sin(x.x), cx = det::cos(x.x), sy = det::sin(x.y), cy = det::cos(x.y), k = 2 * pi;
    return {{sx * cy, -cx * sy, 0},
            {vec3{k * cx * cy, -k * sx * sy, 0}, {k * sx * sy, -k * cx * cy, 0}, {0, 0, 0}}};
}

struct SampledFluid {
    fluid::Lattice lattice;
    Samples density;
    std::array<Samples, 3> velocity;
};

SampledFluid sampled(int n) {
    const fluid::Lattice l =
        fluid::make_lattice({n, n, n}, 1.0 / n, {Edge::periodic, Edge::periodic, Edge::periodic});
    SampledFluid f{l, make_samples(l), {make_samples(l), make_samples(l), make_samples(l)}};
    for (int k = 0; k < n; ++k) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const auto at = static_cast<std::size_t>(l.at(i, j, k));
                f.density[at] = static_cast<float>(waves_at(l.h * vec3(i + 0.5, j + 0.5, k + 0.5)).value);
                f.velocity[0][at] = static_cast<float>(vortex_at(l.h * vec3(i, j + 0.5, k + 0.5)).value.x);
                f.velocity[1][at] = static_cast<float>(vortex_at(l.h * vec3(i + 0.5, j, k + 0.5)).value.y);
            }
        }
    }
    fill_ghosts(l, {}, f.density);
    for (Samples& samples : f.velocity) fill_ghosts(l, {}, samples);
    return f;
}

std::vector<vec3> random_places() {
    Random random = random_stream(3, 9);
    std::vector<vec3> places(16 * places_in_a_call);
    for (vec3& place : places) place = {random.uniform(), random.uniform(), random.uniform()};
    return places;
}

/// Sums of the squared errors and of the squared exact values. For the scalar only the varying part of the
/// exact value counts.
struct Squares {
    double value{}, value_off{}, gradient{}, gradient_off{};
};

void add(Squares& sum, const Scalar& found, const Scalar& exact) {
    const vec3 off = found.gradient - exact.gradient;
    sum.value += (exact.value - 1) * (exact.value - 1);
    sum.value_off += (found.value - exact.value) * (found.value - exact.value);
    sum.gradient += glm::dot(exact.gradient, exact.gradient);
    sum.gradient_off += glm::dot(off, off);
}

void add(Squares& sum, const Vector& found, const Vector& exact) {
    const vec3 off = found.value - exact.value;
    sum.value += glm::dot(exact.value, exact.value);
    sum.value_off += glm::dot(off, off);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const vec3 slope_off = found.gradient[axis] - exact.gradient[axis];
        sum.gradient += glm::dot(exact.gradient[axis], exact.gradient[axis]);
        sum.gradient_off += glm::dot(slope_off, slope_off);
    }
}

/// Reads a field through the interface field::Field, so that the cost of its indirect call is included.
template <class Sample>
struct Reader {
    const char* name;
    std::string kernel;
    int n;  ///< number of samples along each axis; 0: the field is a formula
    field::Field<Sample> read;
    Sample (*exact)(vec3);
    const std::vector<vec3>* places;
    std::size_t next = 0;

    void run() {
        for (std::size_t i = 0; i < places_in_a_call; ++i) do_not_optimise(read((*places)[next + i]));
        next = (next + places_in_a_call) % places->size();
    }
};

template <class Sample>
Row row_of(const Reader<Sample>& reader, std::vector<double> us) {
    for (double& one : us) one /= places_in_a_call;
    Squares sum;
    std::uint64_t hash = 0;
    for (const vec3 place : *reader.places) {
        const Sample found = reader.read(place);
        add(sum, found, reader.exact(place));
        hash = hash_combine(hash, hash_value(found));
    }
    const Times each = times(us);
    return {.area = "field",
            .name = reader.name,
            .setting = {{"kernel", reader.kernel}, {"n", std::int64_t{reader.n}}},
            .time_us = each,
            .error = ErrorMeasure{"relative_l2_gradient", std::sqrt(sum.gradient_off / sum.gradient)},
            .is_default = reader.kernel == kernel_names[static_cast<std::size_t>(field::Grid{}.kernel)] &&
                          reader.n == 32,
            .metrics = {{"relative_l2_value", std::sqrt(sum.value_off / sum.value)},
                        {"ns_per_sample", 1e3 * each.median}},
            .hash = hex(hash)};
}

template <class Sample>
void read_all(std::vector<Reader<Sample>>& readers, const Options& options, Report& report) {
    std::vector<Contestant> contestants;
    for (auto& reader : readers) contestants.push_back({{}, [&reader] { reader.run(); }});
    const auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 3.0, .least = 21});
    for (std::size_t i = 0; i < readers.size(); ++i) report.rows.push_back(row_of(readers[i], samples[i]));
}

}  // namespace

void field(const Options& options, Report& report) {
    const std::vector<vec3> places = random_places();
    std::vector<SampledFluid> fluids;
    for (const int n : grid_sizes) fluids.push_back(sampled(n));
    std::vector<field::Grid> grids;
    std::vector<field::StaggeredGrid> staggered;
    std::vector<Reader<Scalar>> scalars;
    std::vector<Reader<Vector>> vectors;
    const std::size_t count = kernels.size() * grid_sizes.size();
    grids.reserve(count);
    staggered.reserve(count);
    for (std::size_t k = 0; k < kernels.size(); ++k) {
        for (const SampledFluid& f : fluids) {
            grids.push_back(cell_grid(f.lattice, f.density, kernels[k]));
            staggered.push_back(face_grid(f.lattice, f.velocity, kernels[k]));
            const int n = f.lattice.cells[0];
            scalars.push_back(
                {"density", kernel_names[k], n, field::field_of<Scalar>(grids.back()), waves_at, &places});
            vectors.push_back({"velocity", kernel_names[k], n, field::field_of<Vector>(staggered.back()),
                               vortex_at, &places});
        }
    }
    read_all(scalars, options, report);
    read_all(vectors, options, report);
    field_samples(options, report);
    volume_files(options, report);
    carving(options, report);
}

}  // namespace thaum::bench
