// Part of the area `field`: reading volumes. Cost of the value alone, of value and gradient, and of the curl,
// for each kernel and size, together with the error against the formula from which the samples were computed.
//
// Places are "near" one another, 0.1 samples apart like those of a moving hand, or "anywhere" in the volume.
// Near places stay in the cache; places anywhere do so only in a small volume.
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/hash.h"
#include "core/random.h"
#include "core/text.h"
#include "field/analytic.h"
#include "field/volume.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using field::Kernel;

constexpr std::size_t places_in_a_run = 512;
constexpr double side = 0.2;  ///< length of a volume's edges (m)

enum class Quantity : std::uint8_t { value, gradient, curl };
constexpr std::array quantities{Quantity::value, Quantity::gradient, Quantity::curl};
constexpr std::array case_names{"sample_value", "sample_gradient", "sample_curl"};

const field::Gyroid gyroid{.period = side / 2};
const field::BeltramiFlow flow{.strength = {1, 0.8, 0.6}, .wave = 4 * pi / side};

/// Reads one quantity at many places. A scalar quantity is the first component of its result.
struct Sampling {
    Quantity quantity{};
    Kernel kernel{};
    int n{};
    bool near{};
    field::Grid grid{};
    field::StaggeredGrid grids{};
    std::shared_ptr<const std::vector<vec3>> places;
    std::size_t next = 0;

    vec3 read(vec3 place) const {
        switch (quantity) {
            case Quantity::value: return {grid.value(place), 0, 0};
            case Quantity::gradient: return field::field_of<field::Scalar>(grid)(place).gradient;
            case Quantity::curl: return curl(field::field_of<field::Vector>(grids)(place));
        }
        return {};
    }
    vec3 exact(vec3 place) const {
        switch (quantity) {
            case Quantity::value: return {gyroid(place).value, 0, 0};
            case Quantity::gradient: return gyroid(place).gradient;
            case Quantity::curl: return curl(flow(place));
        }
        return {};
    }

    /// One loop for each quantity, so that choosing the quantity costs no time in the loop.
    void run() {
        const auto read_all = [&](auto one) {
            for (std::size_t i = 0; i < places_in_a_run; ++i) do_not_optimise(one((*places)[next + i]));
        };
        switch (quantity) {
            case Quantity::value: read_all([&](vec3 p) { return grid.value(p); }); break;
            case Quantity::gradient: read_all(field::field_of<field::Scalar>(grid)); break;
            case Quantity::curl: {
                const auto flow_field = field::field_of<field::Vector>(grids);
                read_all([&](vec3 p) { return curl(flow_field(p)); });
            }
        }
        next = (next + places_in_a_run) % places->size();
    }
};

using Places = std::shared_ptr<const std::vector<vec3>>;

/// Places in the inner nine tenths of a volume of n samples along each axis.
Places places_of(int n, bool near) {
    Random random = random_stream(4, static_cast<std::uint64_t>(n));
    const double half = 0.45 * side, step = near ? 0.1 * side / n : side;
    std::vector<vec3> places(32 * places_in_a_run);
    vec3 place(0);
    for (vec3& one : places) {
        for (int axis = 0; axis < 3; ++axis) {
            place[axis] = near ? std::clamp(place[axis] + random.uniform(-step, step), -half, half)
                               : random.uniform(-half, half);
        }
        one = place;
    }
    return std::make_shared<const std::vector<vec3>>(std::move(places));
}

Row row_of(const Sampling& sampling, std::vector<double> us) {
    for (double& one : us) one /= places_in_a_run;
    double square = 0, square_off = 0;
    std::uint64_t hash = 0;
    for (const vec3 place : *sampling.places) {
        const vec3 found = sampling.read(place), exact = sampling.exact(place);
        square += glm::dot(exact, exact);
        square_off += glm::dot(found - exact, found - exact);
        hash = hash_combine(hash, hash_value(found));
    }
    const Times each = times(us);
    const bool linear = sampling.kernel == Kernel::linear;
    return {.area = "field",
            .name = case_names[static_cast<std::size_t>(sampling.quantity)],
            .setting = {{"kernel", linear ? "linear" : "catmull_rom"},
                        {"n", std::int64_t{sampling.n}},
                        {"places", sampling.near ? "near" : "anywhere"}},
            .time_us = each,
            .error = ErrorMeasure{"relative_l2", std::sqrt(square_off / square)},
            .is_default = !linear && sampling.n == 128 && sampling.near,
            .metrics = {{"ns_per_sample", 1e3 * each.median}},
            .hash = hex(hash)};
}

/// Measures all quantities at one size. Volumes of different sizes are not in memory at the same time.
void measure_size(int n, const Options& options, Report& report) {
    const std::array<int, 3> count{n, n, n};
    const vec3 spacing(side / (n - 1));
    const field::Volume scalar = sampled(field::field_of<field::Scalar>(gyroid), count, spacing);
    const field::Volume vector = sampled(field::field_of<field::Vector>(flow), count, spacing);
    std::vector<Sampling> samplings;
    for (const bool near : {true, false}) {
        const Places places = places_of(n, near);
        for (const Quantity quantity : quantities) {
            for (const Kernel kernel : {Kernel::linear, Kernel::catmull_rom})
                samplings.push_back(
                    {quantity, kernel, n, near, scalar.grid(kernel), vector.vector_grid(kernel), places});
        }
    }
    std::vector<Contestant> contestants;
    for (Sampling& sampling : samplings) contestants.push_back({{}, [&sampling] { sampling.run(); }});
    const auto us = measure(contestants, {.seconds = options.quick ? 0.3 : 2.0, .least = 21});
    for (std::size_t i = 0; i < samplings.size(); ++i) report.rows.push_back(row_of(samplings[i], us[i]));
}

}  // namespace

void field_samples(const Options& options, Report& report) {
    for (const int n : {24, options.quick ? 64 : 128, options.quick ? 96 : 256})
        measure_size(n, options, report);
}

}  // namespace thaum::bench
