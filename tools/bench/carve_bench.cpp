// Benchmarks carving (engine/field/carving.h): time of an edit by radius and body size, its error against a
// plain computation in double, and the time of hashes and snapshots of a match's crystal.
#include <array>
#include <cmath>

#include "core/hash.h"
#include "core/random.h"
#include "core/text.h"
#include "field/carving.h"
#include "field/carving_history.h"
#include "field/voxel_overlap.h"
#include "field/voxel_state.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using field::Dab;
using field::Tool;
using field::Voxels;

constexpr std::array body_sizes{64, 256};
constexpr std::array radii{3, 12};
constexpr std::array tool_names{"melt", "squirt", "cut"};
constexpr std::size_t number_of_dabs = 256;
constexpr double seconds_per_edit = 0.016;

field::Operation melting(double radius) {
    return {.method = field::Method::filter,
            .extent = {.shape = field::ExtentShape::gaussian, .half = vec3(radius)},
            .changes = {.density = true},
            .rate = 12};
}

/// A tool that changes voxels by one, two or three operations, all with this radius.
Tool tool_of(std::string_view name, double radius) {
    field::Operation first = melting(radius);
    if (name == "cut") {
        first.method = field::Method::constant;
        first.extent = {.shape = field::ExtentShape::plate, .half = {1, radius, radius}};
    }
    if (name != "squirt") return {std::string(name), {first}};
    first.density = 0.5;
    field::Operation colour = melting(radius), material = melting(radius);
    colour.changes = {.colour = true};
    colour.colour = {230, 180, 60};
    material.method = field::Method::constant;
    material.changes = {.material = true};
    material.material = 2;
    return {"squirt", {first, colour, material}};
}

field::Operation refilling(double radius) {
    field::Operation operation = melting(radius);
    operation.density = 1;
    return operation;
}

/// A body of n voxels along each axis, most of which is filled by a ball.
Voxels ball(int n) {
    Voxels body = field::make_voxels({n, n, n}, vec3(0.6 / n));
    const double middle = 0.5 * (n - 1), radius = 0.45 * n;
    field::for_each_row(body.view(), body.view().all(), [&](std::size_t first, std::size_t row) {
        const int rows = static_cast<int>(row), layer = rows / n;
        const double j = rows % n - middle, k = layer - middle;
        for (int i = 0; i < n; ++i) {
            const double r = glm::length(vec3(i - middle, j, k));
            body.density[first + static_cast<std::size_t>(i)] =
                static_cast<float>(std::clamp(radius - r + 0.5, 0.0, 1.0));
        }
    });
    return body;
}

/// Random dabs (places where a tool is applied), at most 16 voxels from the middle along each axis.
std::vector<Dab> random_dabs(double spacing) {
    Random random = random_stream(24, 1);
    std::vector<Dab> dabs(number_of_dabs);
    std::uint64_t tick = 0;
    for (Dab& dab : dabs) {
        dab.place = 16 * spacing * vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        dab.seconds = seconds_per_edit;
        dab.seed = tick++;
    }
    return dabs;
}

/// The tool that melts a body, computed by its formula in double, for the voxels around the body's middle.
class PlainMelting {
public:
    PlainMelting(const Voxels& body, double radius)
        : n_(body.count[0]), radius_(radius), low_((n_ - size) / 2) {
        for_each([&](int i, int j, int k) { density_.push_back(at(body, i, j, k)); });
    }

    void melt(const Dab& dab, double spacing) {
        const double rim = std::exp(-4.5);
        std::size_t voxel = 0;
        for_each([&](int i, int j, int k) {
            const vec3 off = vec3(i, j, k) - 0.5 * (n_ - 1) - dab.place / spacing;
            const double r = glm::length(off) / radius_;
            const double weight = r < 1 ? (std::exp(-4.5 * r * r) - rim) / (1 - rim) : 0;
            density_[voxel++] *= std::exp(-12 * weight * dab.seconds);
        });
    }

    double max_error(const Voxels& body) const {
        double worst = 0;
        std::size_t voxel = 0;
        for_each([&](int i, int j, int k) {
            worst = std::max(worst, std::abs(at(body, i, j, k) - density_[voxel++]));
        });
        return worst;
    }

private:
    static constexpr int size = 60;  // number of voxels along each edge of the compared part

    template <class Visit>
    void for_each(Visit visit) const {
        for (int k = low_; k < low_ + size; ++k) {
            for (int j = low_; j < low_ + size; ++j) {
                for (int i = low_; i < low_ + size; ++i) visit(i, j, k);
            }
        }
    }

    double at(const Voxels& body, int i, int j, int k) const {
        const int voxel = i + n_ * (j + n_ * k);
        return static_cast<double>(body.density[static_cast<std::size_t>(voxel)]);
    }

    int n_;
    double radius_;
    int low_;
    std::vector<double> density_;
};

double error_of_melting(int n, double radius) {
    Voxels body = ball(n);
    PlainMelting plain(body, radius);
    const Tool tool = tool_of("melt", radius);
    for (const Dab& dab : random_dabs(body.spacing.x)) {
        edit(body.view(), tool, dab);
        plain.melt(dab, body.spacing.x);
    }
    return plain.max_error(body);
}

/// Edits one body repeatedly with one tool. Before each edit, the place of the last edit is filled again, so
/// that the body stays whole.
struct Carver {
    int n;
    double radius;
    Tool tool;
    bool with_history;
    Voxels* body;
    std::vector<Dab> dabs;
    Tool refill{"refill", {refilling(radius)}};
    field::CarvingHistory history{};
    std::size_t next = 0;

    const Dab& dab() const { return dabs[next % dabs.size()]; }
    void prepare() {
        edit(body->view(), refill, dab());
        ++next;
    }
    void run() {
        if (!with_history) return do_not_optimise(edit(body->view(), tool, dab()));
        do_not_optimise(edit(body->view(), tool, dab(), history));
        if (next % 16 == 0) end_step(history, body->view());
    }
};

struct EditSizes {
    /// Means over the edits: number of changed voxels, number of changed bricks (blocks of voxels), and
    /// density removed and added, each integrated over the volume (density times m^3).
    double voxels{}, bricks{}, removed{}, added{};
    std::uint64_t hash{};
};

EditSizes sizes_of(int n, double radius, std::string_view tool_name) {
    Voxels body = ball(n);
    const Tool tool = tool_of(tool_name, radius);
    EditSizes sum;
    for (const Dab& dab : random_dabs(body.spacing.x)) {
        const field::Edit e = edit(body.view(), tool, dab);
        sum.voxels += static_cast<double>(e.voxels) / number_of_dabs;
        sum.bricks += static_cast<double>(e.bricks) / number_of_dabs;
        sum.removed += e.removed / number_of_dabs;
        sum.added += e.added / number_of_dabs;
    }
    field::BrickHashes hashes;
    sum.hash = voxel_hash(body.view(), hashes);
    return sum;
}

Row row_of(const Carver& carver, const std::vector<double>& us) {
    const EditSizes sizes = sizes_of(carver.n, carver.radius, carver.tool.name);
    const bool melt = carver.tool.name == "melt";
    return {.area = "field",
            .name = "carve",
            .setting = {{"tool", carver.tool.name},
                        {"n", std::int64_t{carver.n}},
                        {"radius", static_cast<std::int64_t>(carver.radius)},
                        {"undo", std::string(carver.with_history ? "yes" : "no")}},
            .time_us = times(us),
            .error = melt ? std::optional(
                                ErrorMeasure{"largest_density", error_of_melting(carver.n, carver.radius)})
                          : std::nullopt,
            .is_default = melt && carver.n == 256 && carver.with_history,
            .metrics = {{"voxels", sizes.voxels},
                        {"bricks", sizes.bricks},
                        {"removed_m3", sizes.removed},
                        {"added_m3", sizes.added}},
            .hash = hex(sizes.hash)};
}

void carve_edits(const Options& options, Report& report) {
    std::vector<Voxels> bodies;
    for (const int n : body_sizes) bodies.push_back(ball(n));
    std::vector<Carver> carvers;
    for (Voxels& body : bodies) {
        for (const int radius : radii) {
            for (const char* tool : tool_names) {
                for (const bool undo : {false, true}) {
                    carvers.push_back({body.count[0], static_cast<double>(radius), tool_of(tool, radius),
                                       undo, &body, random_dabs(body.spacing.x)});
                    if (undo) carvers.back().history = field::make_history(body.view());
                }
            }
        }
    }
    std::vector<Contestant> contestants;
    for (Carver& carver : carvers) {
        contestants.push_back({[&carver] { carver.prepare(); }, [&carver] { carver.run(); }});
    }
    const auto samples =
        measure(contestants, {.seconds = options.quick ? 2.0 : 8.0, .least = 101, .most = 4000});
    for (std::size_t i = 0; i < carvers.size(); ++i) report.rows.push_back(row_of(carvers[i], samples[i]));
}

/// A crystal of a match, with everything that is computed for it besides the edits.
struct Crystal {
    Voxels body = ball(48);
    std::vector<float> key = body.density;
    field::VoxelOverlap overlap = overlap_with(body.view(), key, 0.5F);
    field::BrickHashes hashes{};
    Tool tool = tool_of("melt", 3);
    std::vector<Dab> dabs = random_dabs(body.spacing.x);
    std::size_t next = 0;
    field::VoxelBox changed{};
    Bytes saved{};

    void carve() { changed = edit(body.view(), tool, dabs[next++ % dabs.size()]).changed; }
    /// Eight edits, as many as in 128 ticks of a match: one in each fluid step (16 ticks).
    void carve_eight() {
        for (int i = 0; i < 8; ++i) carve();
    }
    void save_all() {
        saved.clear();
        save(body.view(), saved);
    }
    void restore_all() {
        ByteReader reader(saved);
        do_not_optimise(restore(body.view(), reader).has_value());
    }
};

void crystal_state(const Options& options, Report& report) {
    Crystal c;
    const std::array<const char*, 6> names{"overlap_of_edit", "overlap_all", "hash_of_8_edits",
                                           "hash_all",        "save",        "restore"};
    const std::vector<Contestant> contestants{
        {[&] { c.carve(); }, [&] { recount(c.overlap, c.body.view(), c.changed); }},
        {{}, [&] { do_not_optimise(overlap_with(c.body.view(), c.key, 0.5F).both); }},
        {[&] { c.carve_eight(); }, [&] { do_not_optimise(voxel_hash(c.body.view(), c.hashes)); }},
        {{},
         [&] {
             field::BrickHashes none;
             do_not_optimise(voxel_hash(c.body.view(), none));
         }},
        {{}, [&] { c.save_all(); }},
        {[&] { c.carve_eight(); }, [&] { c.restore_all(); }}};
    const auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 2.0, .least = 21});
    for (std::size_t i = 0; i < names.size(); ++i) {
        report.rows.push_back({.area = "field",
                               .name = "crystal",
                               .setting = {{"part", std::string(names[i])}, {"n", std::int64_t{48}}},
                               .time_us = times(samples[i]),
                               .is_default = true,
                               .metrics = {{"snapshot_bytes", static_cast<double>(c.saved.size())}}});
    }
}

}  // namespace

void carving(const Options& options, Report& report) {
    carve_edits(options, report);
    crystal_state(options, report);
}

}  // namespace thaum::bench
